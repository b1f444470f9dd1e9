// Units of UDUNITS spelling: symbols with exponents, multiplied by blanks and divided by slashes.
#include "fmi/units.h"

#include <fmt/format.h>

#include <array>
#include <map>
#include <stdexcept>

#include "rubber_suspension/element/temperature_shift.h"

namespace rubber_suspension::fmi {
namespace {

constexpr std::size_t kBases = 7;
using Exponents = std::array<int, kBases>;

const std::array<const char*, kBases>& baseNames() {
  static const std::array<const char*, kBases> names = {"kg", "m", "s", "A", "K", "rad", "mol"};
  return names;
}

const std::map<std::string, Exponents>& symbols() {
  static const std::map<std::string, Exponents> table = {
      {"1", {}},
      {"kg", {1}},
      {"m", {0, 1}},
      {"s", {0, 0, 1}},
      {"A", {0, 0, 0, 1}},
      {"K", {0, 0, 0, 0, 1}},
      {"rad", {0, 0, 0, 0, 0, 1}},
      {"mol", {0, 0, 0, 0, 0, 0, 1}},
      {"degC", {0, 0, 0, 0, 1}},
      {"Hz", {0, 0, -1}},
      {"N", {1, 1, -2}},
      {"Pa", {1, -1, -2}},
      {"J", {1, 2, -2}},
      {"W", {1, 2, -3}},
  };
  return table;
}

// "m^3": three times those of the metre.
void addFactor(Exponents& sum, const std::string& factor, int sign, const std::string& unit) {
  const std::size_t caret = factor.find('^');
  const auto symbol = symbols().find(factor.substr(0, caret));
  const std::string exponent = caret == std::string::npos ? "1" : factor.substr(caret + 1);
  if (symbol == symbols().end() || exponent.empty() || exponent.find_first_not_of("0123456789") != std::string::npos) {
    throw std::invalid_argument(fmt::format("unit '{}': '{}' has no base units here", unit, factor));
  }
  for (std::size_t i = 0; i < kBases; ++i) {
    sum[i] += sign * std::stoi(exponent) * symbol->second[i];
  }
}

}  // namespace

BaseUnit baseUnitOf(const std::string& unit) {
  Exponents sum{};
  int sign = 1;
  for (std::size_t begin = 0; begin <= unit.size();) {
    const std::size_t end = std::min(unit.find_first_of(" /", begin), unit.size());
    addFactor(sum, unit.substr(begin, end - begin), sign, unit);
    sign = end < unit.size() && unit[end] == '/' ? -1 : 1;
    begin = end + 1;
  }
  BaseUnit result;
  for (std::size_t i = 0; i < kBases; ++i) {
    if (sum[i] != 0) {
      result.emplace_back(baseNames()[i], sum[i]);
    }
  }
  return result;
}

double offsetOf(const std::string& unit) { return unit == "degC" ? element::kZeroCelsius : 0.0; }

}  // namespace rubber_suspension::fmi
