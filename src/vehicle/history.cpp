// The result of a simulation of the vehicle.
#include "vehicle/history.h"

#include <fmt/format.h>

#include <cmath>

#include "element/refuse.h"
#include "log/new_file.h"

namespace rubber_suspension::vehicle {
namespace {

// Returns text that appends numbers, with all digits, to a row of a CSV file.
template <class Numbers>
std::string numbersText(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += fmt::format(",{:.17g}", number);
  }
  return text;
}

std::string header(Kind kind) {
  static const std::vector<const char*> strut = {"displacement_m", "force_N"};
  static const std::vector<const char*> bush = {"x_m",  "y_m",  "z_m",  "rx_rad", "ry_rad", "rz_rad",
                                                "Fx_N", "Fy_N", "Fz_N", "Mx_Nm",  "My_Nm",  "Mz_Nm"};
  std::string text = kind == Kind::struts ? "time_s,frame_m,pitch_rad,body_m" : "time_s";
  for (const std::string& name : bushNames(kind)) {
    for (const char* column : kind == Kind::struts ? strut : bush) {
      text += fmt::format(",{}_{}", name, column);
    }
  }
  return text + '\n';
}

std::string bushText(Kind kind, const component::SixDirections& component, const Eigen::Isometry3d& pose,
                     const component::Wrench& wrench) {
  const component::SixNumbers q = component.coordinates(pose);
  if (kind != Kind::struts) {
    return numbersText(q) + numbersText(wrench.force) + numbersText(wrench.moment);
  }
  return fmt::format(",{:.17g},{:.17g}", q[component::kZ], component.directionForces(pose, wrench)[component::kZ]);
}

}  // namespace

PerBush<double> displacementDifference(const Bushes& components, const History& history, const History& reference) {
  element::refuseIf(history.size() != reference.size() || history.size() == 0,
                    "the runs have {} and {} samples; accepted: equal numbers, at least 1", history.size(),
                    reference.size());
  PerBush<double> result;
  for (std::size_t i = 0; i < components.size(); ++i) {
    double difference = 0.0;
    double expected = 0.0;
    for (std::size_t n = 0; n < history.size(); ++n) {
      const Eigen::Vector3d undelayed = components[i].coordinates(reference.pose[n][i]).head<3>();
      difference += (components[i].coordinates(history.pose[n][i]).head<3>() - undelayed).squaredNorm();
      expected += undelayed.squaredNorm();
    }
    result.push_back(std::sqrt(difference / expected));
  }
  return result;
}

void writeHistoryCsv(const std::string& path, Kind kind, const Bushes& components, const History& history) {
  std::string text = header(kind);
  for (std::size_t n = 0; n < history.size(); ++n) {
    text += fmt::format("{:.9f}", history.time[n]);
    text += kind == Kind::struts ? numbersText(history.position[n]) : "";
    for (std::size_t i = 0; i < components.size(); ++i) {
      text += bushText(kind, components[i], history.pose[n][i], history.wrench[n][i]);
    }
    text += '\n';
  }
  log::writeNewFile(path, text);
}

io::Figure historyFigure(Kind kind, const Bushes& components, const History& history, const History& reference,
                         const std::string& title) {
  io::Figure figure{title};
  for (std::size_t i = 0; i < components.size(); ++i) {
    io::Axes displacement{bushNames(kind)[i], "time [s]", "displacement [mm]"};
    io::Curve with{"loop", history.time, {}, "-", 1};
    io::Curve without{"undelayed", reference.time, {}, "-", 0};
    io::Axes difference = displacement;
    difference.y_label = "difference [mm]";
    io::Curve gap{"", history.time, {}, "-", 4};
    for (std::size_t n = 0; n < history.size(); ++n) {
      with.y.push_back(1e3 * components[i].coordinates(history.pose[n][i])[component::kZ]);
      without.y.push_back(1e3 * components[i].coordinates(reference.pose[n][i])[component::kZ]);
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
