// Fuzz target: any text of a measured table is refused in one line, or read with values that can be measured.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "command/measured_table.h"

using rubber_suspension::fit::TablePoint;

namespace {

void require(bool condition, const char* what) {
  if (!condition) {
    std::fprintf(stderr, "violated: %s\n", what);
    std::abort();
  }
}

bool isPossible(const TablePoint& point) {
  return point.frequency > 0.0 && point.amplitude > 0.0 && point.stiffness > 0.0 &&
         std::isfinite(point.frequency + point.amplitude + point.stiffness + point.loss_angle + point.mean) &&
         std::isfinite(point.temperature.value_or(0.0));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const auto table = rubber_suspension::command::parseTable(std::string(data, data + size), "fuzz.csv");
    for (const TablePoint& point : table.points) {
      require(isPossible(point), "a row that is taken can be measured");
    }
  } catch (const std::runtime_error& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "an error is one line");
  }
  return 0;
}
