// What a simulation of the vehicle gave.
#include "vehicle/history.h"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "log/new_file.h"

namespace rubber_suspension::vehicle {

PerStrut displacementDifference(const History& history, const History& reference) {
  if (history.size() != reference.size() || history.size() == 0) {
    throw std::invalid_argument(
        fmt::format("runs of {} and {} samples; accepted: as many, at least one", history.size(), reference.size()));
  }
  PerStrut result{};
  for (std::size_t i = 0; i < kStruts; ++i) {
    double difference = 0.0;
    double size = 0.0;
    for (std::size_t n = 0; n < history.size(); ++n) {
      difference += std::pow(history.compression[n][i] - reference.compression[n][i], 2);
      size += std::pow(reference.compression[n][i], 2);
    }
    result[i] = std::sqrt(difference / size);
  }
  return result;
}

void writeHistoryCsv(const std::string& path, const History& history) {
  log::NewFile new_file(path);
  std::ofstream file(new_file.writingPath());
  file << "time_s,frame_m,pitch_rad,body_m";
  for (const std::string& name : strutNames()) {
    file << ',' << name << "_displacement_m," << name << "_force_N";
  }
  file << '\n';
  for (std::size_t n = 0; n < history.size(); ++n) {
    const auto& q = history.position[n];
    file << fmt::format("{:.9f},{:.17g},{:.17g},{:.17g}", history.time[n], q[0], q[1], q[2]);
    for (std::size_t i = 0; i < kStruts; ++i) {
      file << fmt::format(",{:.17g},{:.17g}", history.compression[n][i], history.force[n][i]);
    }
    file << '\n';
  }
  file.close();
  if (!file) {
    throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
  }
  new_file.commit();
}

io::Figure historyFigure(const History& history, const History& reference, const std::string& title) {
  io::Figure figure;
  figure.title = title;
  for (std::size_t i = 0; i < kStruts; ++i) {
    io::Axes displacement;
    displacement.title = strutNames()[i];
    displacement.x_label = "time [s]";
    displacement.y_label = "displacement [mm]";
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
