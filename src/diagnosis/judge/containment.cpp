// The table of containment.
#include "diagnosis/judge/containment.h"

#include <algorithm>
#include <map>

namespace rubber_suspension::diagnosis::judge {

const std::vector<std::string>& containedIn(const std::string& effect) {
  static const std::map<std::string, std::vector<std::string>> table = {
      {"backlash", {"friction"}},
      {"fluid_inertia", {"inertia"}},
      {"lift_off", {"series_compliance"}},
      {"rate_amplitude_coupling", {"friction", "relaxation"}},
  };
  static const std::vector<std::string> none;
  const auto found = table.find(effect);
  return found == table.end() ? none : found->second;
}

std::size_t mechanismsOf(const std::string& effect) { return std::max<std::size_t>(containedIn(effect).size(), 1); }

}  // namespace rubber_suspension::diagnosis::judge
