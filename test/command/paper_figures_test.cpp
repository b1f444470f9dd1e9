// The paper's figures: the curves pass through every number that is known of them, to its digits.
#include "command/paper_figures.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension {
namespace {

const std::vector<command::PaperFigure>& figures() {
  static const std::vector<command::PaperFigure> all = command::paperFigures();
  return all;
}

const command::PaperFigure& figure(int number) {
  for (const command::PaperFigure& candidate : figures()) {
    if (candidate.number == number) {
      return candidate;
    }
  }
  throw std::out_of_range("no figure " + std::to_string(number));
}

const response::SweepPoint& pointAt(const command::PaperCurve& curve, double frequency) {
  for (const response::SweepPoint& point : curve.points) {
    if (point.frequency == frequency) {
      return point;
    }
  }
  throw std::out_of_range("no point");
}

double degrees(double angle) { return angle * 180.0 / element::kPi; }

TEST(PaperFigures, AreTheFiveOfThePaper) {
  std::vector<int> numbers;
  for (const command::PaperFigure& one : figures()) {
    numbers.push_back(one.number);
    for (const command::PaperCurve& curve : one.curves) {
      for (const response::SweepPoint& point : curve.points) {
        EXPECT_TRUE(point.settled);
      }
    }
  }
  EXPECT_EQ(numbers, (std::vector<int>{3, 4, 5, 6, 8}));
}

TEST(PaperFigures, Figure3LossAngleAtTheNominalFrequency) {
  const double angles[] = {2.04, 4.06, 7.94, 14.66, 23.73};
  for (int i = 0; i < 5; ++i) {
    const response::SweepPoint& point = pointAt(figure(3).curves.at(i), 4.0);
    EXPECT_NEAR(degrees(point.characteristics.loss_angle), angles[i], 0.005);
    EXPECT_NEAR(point.characteristics.stiffness, 4.2e6, 1.0);
  }
}

TEST(PaperFigures, Figure4StiffnessAtTwentyHertz) {
  const std::pair<int, double> rows[] = {{1, 4.32e6}, {3, 5.10e6}, {4, 4.92e6}, {5, 4.95e6}};
  for (const auto& [curve, stiffness] : rows) {
    EXPECT_NEAR(pointAt(figure(4).curves.at(curve), 20.0).characteristics.stiffness, stiffness, 0.005e6) << curve;
  }
}

TEST(PaperFigures, Figure5OnlyFrictionDependsOnAmplitude) {
  for (std::size_t i = 0; i < 6; ++i) {
    const auto& points = figure(5).curves.at(i).points;
    const double small = points.front().characteristics.stiffness;
    const double large = points.back().characteristics.stiffness;
    if (i < 3) {
      EXPECT_NEAR(small / large, 1.0, 1e-12) << figure(5).curves[i].label;
    } else {
      EXPECT_GT(small / large, 1.2) << figure(5).curves[i].label;
    }
  }
}

TEST(PaperFigures, Figure6LoopsMeetTheWorkingPoint) {
  // M1 has K_n as storage stiffness (0.5 % more in all), M5 has it between the turning points (0.03 % more at the
  // peak).
  const double accuracy[] = {6e-3, 1e-9, 1e-9, 1e-6, 4e-4, 1e-6};
  for (std::size_t i = 0; i < 6; ++i) {
    const response::Characteristics characteristics = figure(6).curves.at(i).loop.characteristics();
    // M2 was given a rounded break frequency, so it meets the loss angle to two digits.
    EXPECT_NEAR(characteristics.stiffness / 4.2e6, 1.0, std::max(accuracy[i], 1e-5)) << i;
    EXPECT_NEAR(degrees(characteristics.loss_angle), 5.71, i == 1 ? 0.06 : 0.01) << i;
  }
}

TEST(PaperFigures, Figure8Curves) {
  const double frequencies[] = {0.5, 1, 2, 4, 8, 12, 20};
  const struct {
    double stiffness[7], angle[7];
  } rows[] = {{{3.12, 3.38, 3.80, 4.20, 4.50, 4.63, 4.76}, {6.74, 10.2, 11.2, 9.55, 7.22, 5.87, 4.31}},
              {{3.64, 3.81, 3.99, 4.20, 4.41, 4.54, 4.69}, {5.58, 5.82, 5.97, 5.98, 5.61, 5.26, 4.40}},
              {{3.28, 3.51, 3.84, 4.20, 4.55, 4.74, 4.95}, {4.88, 6.45, 6.72, 5.71, 4.29, 3.45, 2.51}}};
  for (int curve = 0; curve < 3; ++curve) {
    for (int i = 0; i < 7; ++i) {
      const response::SweepPoint& point = pointAt(figure(8).curves.at(curve), frequencies[i]);
      EXPECT_NEAR(point.characteristics.stiffness, rows[curve].stiffness[i] * 1e6, 0.005e6);
      const double known = rows[curve].angle[i];
      EXPECT_NEAR(degrees(point.characteristics.loss_angle), known, known >= 10.0 ? 0.05 : 0.005);
    }
  }
}

std::string firstLine(const std::filesystem::path& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

TEST(PaperFigures, AreWritten) {
  const auto folder = std::filesystem::temp_directory_path() / ("paper_figures_" + std::to_string(getpid()));
  const auto paths = command::writePaperFigures({figure(6), figure(8)}, folder.string());
  EXPECT_EQ(paths.size(), 6u);
  for (const std::string& path : paths) {
    EXPECT_GT(std::filesystem::file_size(path), 1000u) << path;
  }
  EXPECT_EQ(firstLine(folder / "figure_6.csv"), "curve,displacement_m,force_n");
  EXPECT_EQ(firstLine(folder / "figure_8.csv"), "curve,frequency_hz,amplitude_m,stiffness_n_per_m,loss_angle_rad");
  std::filesystem::remove_all(folder);
  EXPECT_THROW(command::writePaperFigures({figure(6)}, "/proc/nowhere"), std::runtime_error);
}

}  // namespace
}  // namespace rubber_suspension
