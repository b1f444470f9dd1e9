// Units of UDUNITS spelling: symbols with exponents, multiplied by blanks and divided by slashes.
#include "fmi/units.h"

#include <algorithm>

#include "element/refuse.h"
#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::fmi {
namespace {

const std::map<std::string, BaseUnit>& symbols() {
  static const std::map<std::string, BaseUnit> table = {
      {"1", {}},
      {"kg", {{"kg", 1}}},
      {"m", {{"m", 1}}},
      {"s", {{"s", 1}}},
      {"A", {{"A", 1}}},
      {"K", {{"K", 1}}},
      {"rad", {{"rad", 1}}},
      {"mol", {{"mol", 1}}},
      {"degC", {{"K", 1}}},
      {"Hz", {{"s", -1}}},
      {"N", {{"kg", 1}, {"m", 1}, {"s", -2}}},
      {"Pa", {{"kg", 1}, {"m", -1}, {"s", -2}}},
      {"J", {{"kg", 1}, {"m", 2}, {"s", -2}}},
      {"W", {{"kg", 1}, {"m", 2}, {"s", -3}}},
  };
  return table;
}

}  // namespace

BaseUnit baseUnitOf(const std::string& unit) {
  BaseUnit sum;
  int sign = 1;
  for (std::size_t begin = 0; begin <= unit.size();) {
    const std::size_t end = std::min(unit.find_first_of(" /", begin), unit.size());
    const std::string factor = unit.substr(begin, end - begin);  // "m^3": three times those of the metre
    const std::size_t caret = factor.find('^');
    const auto symbol = symbols().find(factor.substr(0, caret));
    const std::string power = caret == std::string::npos ? "1" : factor.substr(caret + 1);
    element::refuseIf(
        symbol == symbols().end() || power.empty() || power.find_first_not_of("0123456789") != std::string::npos,
        "unit '{}': '{}' has no base units here", unit, factor);
    for (const auto& [base, exponent] : symbol->second) {
      if ((sum[base] += sign * std::stoi(power) * exponent) == 0) {
        sum.erase(base);
      }
    }
    sign = end < unit.size() && unit[end] == '/' ? -1 : 1;
    begin = end + 1;
  }
  return sum;
}

double offsetOf(const std::string& unit) { return unit == "degC" ? element::kZeroCelsius : 0.0; }

}  // namespace rubber_suspension::fmi
