// Wrenches over poses, as CSV.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "element/refuse.h"
#include "log/log_columns.h"
#include "log/new_file.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::log {

void writeWrenchCsv(const std::string& path, const PoseLog& log, const std::array<std::vector<double>, 6>& wrench) {
  try {
    NewFile file(path);
    std::ofstream stream(file.writingPath(), std::ios::binary);
    stream << "time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm\n";
    fmt::memory_buffer row;
    for (std::size_t i = 0; i < log.size(); ++i) {
      row.clear();
      fmt::format_to(std::back_inserter(row), "{}", formatStamp(log.stamp[i]));
      for (const auto* columns : {&log.coordinate, &wrench}) {
        for (const std::vector<double>& column : *columns) {
          fmt::format_to(std::back_inserter(row), ",{:.17g}", column[i]);
        }
      }
      row.push_back('\n');
      stream.write(row.data(), static_cast<std::streamsize>(row.size()));
    }
    stream.close();
    element::refuseIf<LogError>(!stream, "{}: cannot be written: {}", path, std::strerror(errno));
    file.commit();
  } catch (const LogError&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw LogError(error.what());
  }
}

}  // namespace rubber_suspension::log
