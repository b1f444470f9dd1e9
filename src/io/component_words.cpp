// Names and words of component files.
#include "io/component_words.h"

#include <algorithm>
#include <map>

#include "io/rotational_unit.h"

namespace rubber_suspension::io {

std::string rotationalUnit(const std::string& unit) {
  static const std::map<std::string, std::string> units = {
      {"m", "rad"},     {"N", "N m"},           {"N/m", "N m/rad"},    {"N s/m", "N m s/rad"},
      {"m/s", "rad/s"}, {"N/s", "N m/s"},       {"1/m", "1/rad"},      {"N/m^2", "N m/rad^2"},
      {"kg", "kg m^2"}, {"N/m^3", "N m/rad^3"}, {"N/m^5", "N m/rad^5"}};
  const auto found = units.find(unit);
  return found == units.end() ? unit : found->second;
}

bool isBaseName(const std::string& name) {
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  return !name.empty() && name.size() <= kMaximumNameLength && letter(name[0]) &&
         std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; });
}

const std::vector<ShiftLaw>& shiftLaws() {
  static const std::vector<ShiftLaw> laws = {{"wlf", "wlf_shift"}, {"arrhenius", "arrhenius_shift"}};
  return laws;
}
}  // namespace rubber_suspension::io
