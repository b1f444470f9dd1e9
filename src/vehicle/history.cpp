// The result of a simulation of the vehicle.
#include "vehicle/history.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "log/new_file.h"

namespace rubber_suspension::vehicle {
namespace {

void checkSizes(std::size_t size, std::size_t reference) {
  if (size != reference || size == 0) {
    throw std::invalid_argument(
        fmt::format("runs of {} and {} samples; accepted: as many, at least one", size, reference));
  }
}

// A CSV file that `write` fills.
template <class Write>
void writeCsv(const std::string& path, Write write) {
  log::NewFile new_file(path);
  std::ofstream file(new_file.writingPath());
  write(file);
  file.close();
  if (!file) {
    throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
  }
  new_file.commit();
}

// Behind others, to the last bit.
template <class Numbers>
void writeNumbers(std::ofstream& file, const Numbers& numbers) {
  for (const double number : numbers) {
    file << fmt::format(",{:.17g}", number);
  }
}

}  // namespace

PerStrut displacementDifference(const History& history, const History& reference) {
  checkSizes(history.size(), reference.size());
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

PerBush<double> displacementDifference(const PerBush<component::SixDirections>& components,
                                       const BushedHistory& history, const BushedHistory& reference) {
  checkSizes(history.size(), reference.size());
  PerBush<double> result;
  for (std::size_t i = 0; i < components.size(); ++i) {
    double difference = 0.0;
    double size = 0.0;
    for (std::size_t n = 0; n < history.size(); ++n) {
      const Eigen::Vector3d expected = components[i].coordinates(reference.pose[n][i]).head<3>();
      difference += (components[i].coordinates(history.pose[n][i]).head<3>() - expected).squaredNorm();
      size += expected.squaredNorm();
    }
    result.push_back(std::sqrt(difference / size));
  }
  return result;
}

void writeHistoryCsv(const std::string& path, const History& history) {
  writeCsv(path, [&](std::ofstream& file) {
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
  });
}

void writeHistoryCsv(const std::string& path, const PerBush<std::string>& names,
                     const PerBush<component::SixDirections>& components, const BushedHistory& history) {
  writeCsv(path, [&](std::ofstream& file) {
    file << "time_s";
    for (const std::string& name : names) {
      for (const char* column :
           {"x_m", "y_m", "z_m", "rx_rad", "ry_rad", "rz_rad", "Fx_N", "Fy_N", "Fz_N", "Mx_Nm", "My_Nm", "Mz_Nm"}) {
        file << ',' << name << '_' << column;
      }
    }
    file << '\n';
    for (std::size_t n = 0; n < history.size(); ++n) {
      file << fmt::format("{:.9f}", history.time[n]);
      for (std::size_t i = 0; i < components.size(); ++i) {
        const component::SixNumbers q = components[i].coordinates(history.pose[n][i]);
        const component::Wrench& wrench = history.wrench[n][i];
        writeNumbers(file, q);
        writeNumbers(file, wrench.force);
        writeNumbers(file, wrench.moment);
      }
      file << '\n';
    }
  });
}

io::Figure historyFigure(const History& history, const History& reference, const std::string& title) {
  io::Figure figure{title};
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
