// A report's note on effects that a temperature nobody recorded may look like.
#include "diagnosis/report/temperature_note.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>

namespace rubber_suspension::diagnosis {
namespace {

// Stiffness that falls in the course of logs, as it does where a room warms.
bool mayBeTemperature(const std::string& effect) { return effect == "self_heating" || effect == "stress_softening"; }

}  // namespace

std::string temperatureNote(const std::vector<std::string>& effects, const fit::Excitation& excitation) {
  std::vector<std::string> doubtful;
  std::copy_if(effects.begin(), effects.end(), std::back_inserter(doubtful), mayBeTemperature);
  if (excitation.has_temperature || doubtful.empty()) {
    return "";
  }
  return fmt::format(
      "Without a recorded temperature {} is not certain: rubber that warmed by itself would look alike. Logs with the "
      "column temperature_degC would settle it.",
      fmt::join(doubtful, " and "));
}

}  // namespace rubber_suspension::diagnosis
