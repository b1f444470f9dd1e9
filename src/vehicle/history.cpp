// The result of a simulation of the vehicle.
#include "vehicle/history.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "element/refuse.h"
#include "log/new_file.h"

namespace rubber_suspension::vehicle {
namespace {

// RMS of the difference over the RMS of what is expected. `compare` gets a sample and adds the squares of both.
template <class Compare>
double relativeDifference(std::size_t size, std::size_t reference, Compare compare) {
  element::refuseIf(size != reference || size == 0, "runs of {} and {} samples; accepted: as many, at least one", size,
                    reference);
  double difference = 0.0;
  double expected = 0.0;
  for (std::size_t n = 0; n < size; ++n) {
    compare(n, difference, expected);
  }
  return std::sqrt(difference / expected);
}

// Behind others, to the last bit.
template <class Numbers>
std::string numbersText(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += fmt::format(",{:.17g}", number);
  }
  return text;
}

}  // namespace

PerStrut displacementDifference(const History& history, const History& reference) {
  PerStrut result{};
  for (std::size_t i = 0; i < kStruts; ++i) {
    result[i] =
        relativeDifference(history.size(), reference.size(), [&](std::size_t n, double& difference, double& expected) {
          difference += std::pow(history.compression[n][i] - reference.compression[n][i], 2);
          expected += std::pow(reference.compression[n][i], 2);
        });
  }
  return result;
}

PerBush<double> displacementDifference(const PerBush<component::SixDirections>& components,
                                       const BushedHistory& history, const BushedHistory& reference) {
  PerBush<double> result;
  for (std::size_t i = 0; i < components.size(); ++i) {
    const auto translation = [&](const BushedHistory& of, std::size_t n) -> Eigen::Vector3d {
      return components[i].coordinates(of.pose[n][i]).head<3>();
    };
    result.push_back(
        relativeDifference(history.size(), reference.size(), [&](std::size_t n, double& difference, double& expected) {
          difference += (translation(history, n) - translation(reference, n)).squaredNorm();
          expected += translation(reference, n).squaredNorm();
        }));
  }
  return result;
}

void writeHistoryCsv(const std::string& path, const History& history) {
  std::string text = "time_s,frame_m,pitch_rad,body_m";
  for (const std::string& name : strutNames()) {
    text += fmt::format(",{0}_displacement_m,{0}_force_N", name);
  }
  text += '\n';
  for (std::size_t n = 0; n < history.size(); ++n) {
    text += fmt::format("{:.9f}", history.time[n]) + numbersText(history.position[n]);
    for (std::size_t i = 0; i < kStruts; ++i) {
      text += fmt::format(",{:.17g},{:.17g}", history.compression[n][i], history.force[n][i]);
    }
    text += '\n';
  }
  log::writeNewFile(path, text);
}

void writeHistoryCsv(const std::string& path, const PerBush<std::string>& names,
                     const PerBush<component::SixDirections>& components, const BushedHistory& history) {
  std::string text = "time_s";
  for (const std::string& name : names) {
    for (const char* column :
         {"x_m", "y_m", "z_m", "rx_rad", "ry_rad", "rz_rad", "Fx_N", "Fy_N", "Fz_N", "Mx_Nm", "My_Nm", "Mz_Nm"}) {
      text += fmt::format(",{}_{}", name, column);
    }
  }
  text += '\n';
  for (std::size_t n = 0; n < history.size(); ++n) {
    text += fmt::format("{:.9f}", history.time[n]);
    for (std::size_t i = 0; i < components.size(); ++i) {
      const component::SixNumbers q = components[i].coordinates(history.pose[n][i]);
      const component::Wrench& wrench = history.wrench[n][i];
      text += numbersText(q) + numbersText(wrench.force) + numbersText(wrench.moment);
    }
    text += '\n';
  }
  log::writeNewFile(path, text);
}

io::Figure historyFigure(const History& history, const History& reference, const std::string& title) {
  io::Figure figure{title};
  for (std::size_t i = 0; i < kStruts; ++i) {
    io::Axes displacement{strutNames()[i], "time [s]", "displacement [mm]"};
    io::Curve with{"loop", history.time, {}, "-", 1};
    io::Curve without{"undelayed", reference.time, {}, "-", 0};
    io::Axes difference = displacement;
    difference.y_label = "difference [mm]";
    io::Curve gap{"", history.time, {}, "-", 4};
    for (std::size_t n = 0; n < history.size(); ++n) {
      with.y.push_back(1e3 * history.compression[n][i]);
      without.y.push_back(1e3 * reference.compression[n][i]);
      gap.y.push_back(with.y.back() - without.y.back());
    }
    displacement.curves = {without, with};
    difference.curves = {gap};
    figure.axes.push_back(displacement);
    figure.axes.push_back(difference);
  }
  return figure;
}

}  // namespace rubber_suspension::vehicle
