// Numbers as a component file has them.
#include "diagnosis/results/rounding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "diagnosis/words/text.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr int kMostDigits = 15;

const SizedValue* at(const std::vector<SizedValue>& written, const std::string& place) {
  const auto found =
      std::find_if(written.begin(), written.end(), [&](const SizedValue& size) { return size.name == place; });
  return found == written.end() ? nullptr : &*found;
}

bool isAsConfigured(const SizedValue& size) { return size.value == size.configured; }

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

std::string roundedText(const SizedValue& size, double value, const std::string& unit, int finer) {
  const log::UnitConversion convert(size.unit, unit.empty() ? size.unit : unit);
  const double half = 0.5 * std::abs(convert(size.interval_95[1]) - convert(size.interval_95[0]));
  const int decimals = half > 0.0 ? static_cast<int>(std::ceil(-std::log10(0.1 * half))) + finer : kMostDigits + 1;
  return toDecimals(convert(value), decimals) + (unit.empty() ? "" : " " + unit);
}

// Writes each number in the unit of its kind in the configured file.
io::YamlStyle styleOf(const io::ComponentDescription& component, const std::vector<SizedValue>& written, int finer) {
  io::YamlStyle style;
  style.number = [&, finer](const std::string& place, double value) {
    const SizedValue* const size = at(written, place);
    if (size == nullptr) {
      return fmt::format("{}", value);
    }
    const std::string unit = unitOf(component, *size);
    return isAsConfigured(*size) ? exactly(value, size->unit, unit) : roundedText(*size, value, unit, finer);
  };
  return style;
}

std::string logsOf(const Diagnosis& d) {
  std::vector<std::string> names;
  for (const Admission& log : d.admission) {
    names.push_back(log.log + (log.hold_out ? " (held out)" : ""));
  }
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string originOf(const Diagnosis& d, double gap) {
  const std::string by =
      d.run.version.empty() ? "" : fmt::format("rubber_suspension {}, {}; ", d.run.version, d.run.date);
  return fmt::format(
      "# Diagnosis of {}: {}{}.\n# Logs: {}.\n# Gap {} as configured, {} re-estimated, {} with this file; "
      "noise floor {}.\n",
      d.component, by, toString(d.verdict), log::oneLine(logsOf(d)), words::percent(d.gap.as_configured),
      words::percent(d.gap.re_estimated), words::percent(gap), words::percent(d.gap.noise_floor));
}

}  // namespace

io::ComponentDescription rounded(const io::ComponentDescription& exact, const std::vector<SizedValue>& written,
                                 int finer) {
  io::ComponentDescription result =
      io::parseComponentFile(io::toYaml({exact}, styleOf(exact, written, finer)), "augmented").front();
  result.units = exact.units;
  return result;
}

io::YamlStyle augmentedStyle(const Diagnosis& d) {
  io::YamlStyle style = styleOf(d.augmented, d.written, d.finer);
  style.note = [&](const std::string& place) {
    const SizedValue* const size = at(d.written, place);
    return size == nullptr || isAsConfigured(*size) || !(size->interval_95[0] < size->interval_95[1]) ? ""
           : std::isfinite(size->configured) ? fmt::format("95 %: {}; was {}", words::intervalText(*size),
                                                           words::quantity(size->configured, size->unit))
                                             : "95 %: " + words::intervalText(*size);
  };
  return style;
}

std::string augmentedYaml(const Diagnosis& d) {
  io::YamlStyle style = augmentedStyle(d);
  style.head = originOf(d, d.gap.augmented);
  style.head += d.turns ? "# A rotation as a component of one direction: m stands for rad, N for N m.\n" : "";
  return io::toYaml({d.augmented}, style);
}

std::string fullYaml(const Diagnosis& d) {
  io::YamlStyle style;
  style.head = originOf(d, d.gap_of_full_law);
  return io::toYaml({d.augmented_full}, style);
}

}  // namespace rubber_suspension::diagnosis::results
