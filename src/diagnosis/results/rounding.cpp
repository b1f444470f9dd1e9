// Numbers as a component file has them.
#include "diagnosis/results/rounding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubber_suspension/log/units.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr int kMostDigits = 15;

// A number to so many decimals, which may be negative.
std::string toDecimals(double value, int decimals) {
  constexpr double kMostFixed = 1e12;
  if (std::abs(value) > kMostFixed || decimals > kMostDigits) {
    return fmt::format("{}", value);
  }
  const double step = std::pow(10.0, -decimals);
  const double rounded = decimals < 0 ? std::round(value / step) * step : value;
  const std::string text = fmt::format("{:.{}f}", rounded, std::max(decimals, 0));
  return std::stod(text) == 0.0 ? fmt::format("{:.1g}", value) : text;  // no number is rounded to none
}

// The unit of the configured file; where that has units, but none of this kind, the one that engineers use.
std::string unitOf(const io::ComponentDescription& component, const SizedValue& size) {
  const auto given = component.units.find(size.unit);
  if (given != component.units.end() || component.units.empty()) {
    return given == component.units.end() ? "" : given->second;
  }
  return size.unit == "m" ? "mm" : size.unit == "N/m" ? "kN/mm" : size.unit == "N" ? "N" : "";
}

// The shortest text in a unit that reads back as the same number; in SI where there is none.
std::string exactly(double value, const std::string& si, const std::string& unit) {
  const std::string text = unit.empty() ? "" : fmt::format("{:.12g} {}", log::UnitConversion(si, unit)(value), unit);
  return !text.empty() && log::parseQuantity(text, si) == value ? text : fmt::format("{}", value);
}

std::string roundedText(const SizedValue& size, const std::string& unit, int finer) {
  const log::UnitConversion convert(size.unit, unit.empty() ? size.unit : unit);
  const double half = 0.5 * std::abs(convert(size.interval_95[1]) - convert(size.interval_95[0]));
  const int decimals = half > 0.0 ? static_cast<int>(std::ceil(-std::log10(0.1 * half))) + finer : kMostDigits + 1;
  return toDecimals(convert(size.value), decimals) + (unit.empty() ? "" : " " + unit);
}

}  // namespace

std::vector<SizedValue> rounded(std::vector<SizedValue> written, const io::ComponentDescription& component, int finer) {
  for (SizedValue& size : written) {
    const std::string unit = unitOf(component, size);
    size.text = size.value == size.configured ? exactly(size.value, size.unit, unit) : roundedText(size, unit, finer);
  }
  return written;
}

io::YamlStyle styleOf(const std::vector<SizedValue>& written) {
  io::YamlStyle style;
  style.number = [&](const std::string& place, double value) {
    const auto size = std::find_if(written.begin(), written.end(), [&](const auto& one) { return one.name == place; });
    return size == written.end() || size->text.empty() ? fmt::format("{}", value) : size->text;
  };
  return style;
}

io::ComponentDescription asWritten(const io::ComponentDescription& exact, const std::vector<SizedValue>& written) {
  io::ComponentDescription result = io::parseComponentFile(io::toYaml({exact}, styleOf(written)), "augmented").front();
  result.units = exact.units;
  return result;
}

}  // namespace rubber_suspension::diagnosis::results
