// The paper's figures: the curves pass through every number that is known of them, to its digits.
#include "command/paper_figures.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "rubber_suspension/element/constants.h"
#include "support/files.h"

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

/// A model of the paper by its numbers in kN, mm and s, integrated here by other means than those of the package.
struct OwnModel {
  double k0, c0, k1, break_frequency, maximum_force, z2;
};

constexpr OwnModel kOwn[] = {{4.2, 0.016711, 0, 1, 0, 1},               // M1
                             {3.0, 0, 1.329463, 1.43, 0, 1},            // M2
                             {3.0, 0.01076, 1.198, 0.5, 0, 1},          // M3
                             {3.0, 0, 0, 1, 6.0475, 2.1760},            // M4
                             {3.0, 0.003326, 0, 1, 7.4700, 3.1976},     // M5
                             {3.0, 0, 0.26087, 1.45, 4.9209, 2.2109}};  // M6

/// Berg's two branches of a settled loop, by the equations of 1997.
double ownFriction(const OwnModel& model, double z, double amplitude, bool upwards) {
  if (model.maximum_force == 0.0) {
    return 0.0;
  }
  const double z2 = model.z2;
  const double peak = model.maximum_force / (2.0 * z2) *
                      (std::sqrt(z2 * z2 + amplitude * amplitude + 6.0 * z2 * amplitude) - z2 - amplitude);
  const double mu = peak / model.maximum_force;
  const double travel = upwards ? z + amplitude : amplitude - z;
  const double force = -peak + travel * (model.maximum_force + peak) / (z2 * (1.0 + mu) + travel);
  return upwards ? force : -force;
}

/// K [kN/mm] and loss angle [deg] of Eqs. 1 and 2 under a sine, the Maxwell element by the midpoint rule.
std::pair<double, double> integrated(const OwnModel& model, double frequency, double amplitude) {
  constexpr int kSteps = 4000;
  const double omega = 2.0 * element::kPi * frequency;
  const double dt = 1.0 / (frequency * kSteps);
  const double rate = 2.0 * element::kPi * model.break_frequency;
  const int cycles = 2 + static_cast<int>(20.0 * frequency / rate);
  double maxwell = 0.0;
  double lowest = 0.0;
  double highest = 0.0;
  double area = 0.0;
  for (int i = 0; i < cycles * kSteps; ++i) {
    const double phase = 2.0 * element::kPi * (i + 1) / kSteps;
    const double z = -amplitude * std::cos(phase);
    const double velocity = omega * amplitude * std::sin(phase);
    const double middle = omega * amplitude * std::sin(phase - element::kPi / kSteps);
    maxwell = (maxwell * (1.0 - 0.5 * rate * dt) + model.k1 * middle * dt) / (1.0 + 0.5 * rate * dt);
    if (i >= (cycles - 1) * kSteps) {
      const double force =
          model.k0 * z + model.c0 * velocity + maxwell + ownFriction(model, z, amplitude, velocity >= 0.0);
      lowest = std::min(lowest, force);
      highest = std::max(highest, force);
      area += force * velocity * dt;
    }
  }
  const double range = highest - lowest;
  return {range / (2.0 * amplitude), degrees(std::asin(area / (0.25 * element::kPi * range * 2.0 * amplitude)))};
}

/// The numbers above have four or five digits.
void expectOwn(const response::SweepPoint& point, const OwnModel& model, const std::string& label) {
  const auto [stiffness, angle] = integrated(model, point.frequency, 1e3 * point.amplitude);
  EXPECT_NEAR(point.characteristics.stiffness * 1e-6, stiffness, 5e-4 * stiffness)
      << label << ' ' << point.frequency << " Hz " << point.amplitude;
  EXPECT_NEAR(degrees(point.characteristics.loss_angle), angle, 5e-3 * angle)
      << label << ' ' << point.frequency << " Hz " << point.amplitude;
}

void expectOwn(const command::PaperCurve& curve, const OwnModel& model, std::size_t stride) {
  for (std::size_t i = stride / 2; i < curve.points.size(); i += stride) {
    expectOwn(curve.points[i], model, curve.label);
  }
}

TEST(PaperFigures, Figure3AreSurfacesOfFourModels) {
  ASSERT_EQ(figure(3).curves.size(), 4u);
  const int models[] = {0, 1, 3, 5};
  for (std::size_t i = 0; i < 4; ++i) {
    expectOwn(figure(3).curves[i], kOwn[models[i]], 79);
  }
  ASSERT_EQ(figure(3).figure.axes.size(), 8u);
  for (const io::Axes& axes : figure(3).figure.axes) {
    ASSERT_EQ(axes.maps.size(), 1u);
    EXPECT_EQ(axes.maps[0].values.size(), 625u);
  }
  for (const std::size_t linear : {0, 1}) {
    const auto& points = figure(3).curves[linear].points;
    EXPECT_NEAR(points[7].characteristics.stiffness, points[607].characteristics.stiffness, 1e-6)
        << "another amplitude";
  }
}

TEST(PaperFigures, Figure4HasAllModelsOverFrequencyAndOverAmplitude) {
  ASSERT_EQ(figure(4).curves.size(), 12u);
  ASSERT_EQ(figure(4).figure.axes.size(), 4u);
  for (std::size_t i = 0; i < 6; ++i) {
    expectOwn(figure(4).curves[i], kOwn[i], 17);
    expectOwn(figure(4).curves[6 + i], kOwn[i], 17);
    EXPECT_EQ(figure(4).curves[i].points.front().amplitude, 2e-3);
    EXPECT_EQ(figure(4).curves[6 + i].points.front().frequency, 4.0);
  }
}

// M1 has K_n as storage stiffness (0.5 % more in all), M5 has it between the turning points (0.03 % more at the peak).
TEST(PaperFigures, Figure4MeetsTheWorkingPoint) {
  const double accuracy[] = {6e-3, 1e-5, 1e-5, 1e-5, 4e-4, 1e-5};
  for (std::size_t i = 0; i < 6; ++i) {
    const response::Characteristics characteristics = pointAt(figure(4).curves[i], 4.0).characteristics;
    // M2 was given a rounded break frequency, so it meets the loss angle to two digits.
    EXPECT_NEAR(characteristics.stiffness / 4.2e6, 1.0, accuracy[i]) << i;
    EXPECT_NEAR(degrees(characteristics.loss_angle), 5.71, i == 1 ? 0.06 : 0.01) << i;
  }
}

TEST(PaperFigures, Figure5IsAtConstantProduct) {
  ASSERT_EQ(figure(5).curves.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    expectOwn(figure(5).curves[i], kOwn[i], 17);
    for (const response::SweepPoint& point : figure(5).curves[i].points) {
      EXPECT_NEAR(point.frequency * point.amplitude, 8e-3, 1e-15);
    }
  }
  const std::pair<int, double> rows[] = {{1, 4.32e6}, {3, 5.10e6}, {4, 4.92e6}, {5, 4.95e6}};
  for (const auto& [curve, stiffness] : rows) {
    EXPECT_NEAR(pointAt(figure(5).curves.at(curve), 20.0).characteristics.stiffness, stiffness, 0.005e6) << curve;
  }
}

TEST(PaperFigures, Figure6IsOneMaxwellElementForSixBreakFrequencies) {
  const double break_frequencies[] = {0.5, 1.0, 1.43, 2.0, 4.0, 8.0};
  const double stiffnesses[] = {1.2160, 1.2638, 1.329463, 1.4497, 2.1264, 4.2250};
  const double angles[] = {2.04, 4.06, 5.76, 7.94, 14.66, 23.73};
  ASSERT_EQ(figure(6).curves.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    const command::PaperCurve& curve = figure(6).curves[i];
    expectOwn(curve, {3.0, 0, stiffnesses[i], break_frequencies[i], 0, 1}, 17);
    EXPECT_NEAR(degrees(pointAt(curve, 4.0).characteristics.loss_angle), angles[i], 0.005);
    EXPECT_NEAR(pointAt(curve, 4.0).characteristics.stiffness, 4.2e6, 1.0);
  }
}

// One element from K_max: f_b = 4 sqrt((4.9^2 - 4.2^2)/(4.2^2 - 3^2)) Hz, k = 1.9.
TEST(PaperFigures, Figure8BeginsWithOneElement) {
  ASSERT_EQ(figure(8).curves.size(), 4u);
  expectOwn(figure(8).curves[0], {3.0, 0, 1.9, 4.0 * std::sqrt((4.9 * 4.9 - 4.2 * 4.2) / (4.2 * 4.2 - 9.0)), 0, 1}, 17);
  expectOwn(figure(8).curves[3], kOwn[5], 17);
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
      const response::SweepPoint& point = pointAt(figure(8).curves.at(curve + 1), frequencies[i]);
      EXPECT_NEAR(point.characteristics.stiffness, rows[curve].stiffness[i] * 1e6, 0.005e6);
      const double known = rows[curve].angle[i];
      EXPECT_NEAR(degrees(point.characteristics.loss_angle), known, known >= 10.0 ? 0.05 : 0.005);
    }
  }
}

TEST(PaperFigures, AreWritten) {
  const auto folder = std::filesystem::temp_directory_path() / ("paper_figures_" + std::to_string(getpid()));
  const auto paths = command::writePaperFigures({figure(3), figure(8)}, folder.string());
  EXPECT_EQ(paths.size(), 6u);
  for (const std::string& path : paths) {
    EXPECT_GT(std::filesystem::file_size(path), 1000u) << path;
  }
  EXPECT_EQ(firstLine(folder / "figure_3.csv"), "curve,frequency_hz,amplitude_m,stiffness_n_per_m,loss_angle_rad");
  EXPECT_EQ(firstLine(folder / "figure_8.csv"), "curve,frequency_hz,amplitude_m,stiffness_n_per_m,loss_angle_rad");
  std::filesystem::remove_all(folder);
  EXPECT_THROW(command::writePaperFigures({figure(6)}, "/proc/nowhere"), std::runtime_error);
}

}  // namespace
}  // namespace rubber_suspension
