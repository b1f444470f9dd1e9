// Writes the wrenches of a log of poses as CSV.
#include <fmt/format.h>

#include <iterator>

#include "log/log_columns.h"
#include "log/new_file.h"
#include "rubber_suspension/log/pose_log.h"

namespace rubber_suspension::log {

void writeWrenchCsv(const std::string& path, const PoseLog& log, const std::array<std::vector<double>, 6>& wrench) {
  NewFile file(path);
  file.line("time_s,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad,Fx_N,Fy_N,Fz_N,Mx_Nm,My_Nm,Mz_Nm");
  for (std::size_t i = 0; i < log.size(); ++i) {
    std::string row = formatStamp(log.stamp[i]);
    for (const auto* columns : {&log.coordinate, &wrench}) {
      for (const std::vector<double>& column : *columns) {
        fmt::format_to(std::back_inserter(row), ",{:.17g}", column[i]);
      }
    }
    file.line(row);
  }
  file.commit();
}

}  // namespace rubber_suspension::log
