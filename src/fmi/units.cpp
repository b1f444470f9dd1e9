// Units of UDUNITS spelling: symbols with exponents, multiplied by blanks and divided by slashes.
#include "fmi/units.h"

#include <algorithm>

#include "element/refuse.h"
#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::fmi {
namespace {

// What symbols stand for; base units for themselves.
const std::map<std::string, std::string> kSymbols = {
    {"kg", ""}, {"m", ""},     {"s", ""},         {"A", ""},       {"K", ""},    {"rad", ""},  {"mol", ""},
    {"1", "1"}, {"Hz", "1/s"}, {"N", "kg m/s^2"}, {"Pa", "N/m^2"}, {"J", "N m"}, {"W", "J/s"}, {"degC", "K"}};

}  // namespace

BaseUnit baseUnitOf(const std::string& unit) {
  BaseUnit sum;
  int sign = 1;
  for (std::size_t begin = 0; begin <= unit.size();) {
    const std::size_t end = std::min(unit.find_first_of(" /", begin), unit.size());
    const std::string factor = unit.substr(begin, end - begin);  // "m^3": three times those of the metre
    const std::size_t caret = factor.find('^');
    const auto symbol = kSymbols.find(factor.substr(0, caret));
    const std::string power = caret == std::string::npos ? "1" : factor.substr(caret + 1);
    element::refuseIf(
        symbol == kSymbols.end() || power.empty() || power.find_first_not_of("0123456789") != std::string::npos,
        "unit '{}': '{}' has no base units here", unit, factor);
    const auto& [name, meaning] = *symbol;
    for (const auto& [base, exponent] : meaning.empty()  ? BaseUnit{{name, 1}}
                                        : meaning == "1" ? BaseUnit{}
                                                         : baseUnitOf(meaning)) {
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
