// Writes component files with comments on their numbers.
#include "diagnosis/report/augmented_yaml.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "diagnosis/words/text.h"
#include "element/each.h"
#include "log/text.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::diagnosis::report {
namespace {

std::string logsOf(const Diagnosis& d) {
  return element::joined(d.logs.admission, ", ",
                         [](const Admission& log) { return log.log + (log.hold_out ? " (held out)" : ""); });
}

std::string originOf(const Diagnosis& d, double gap) {
  const std::string by =
      d.run.version.empty() ? "" : fmt::format("rubber_suspension {}, {}; ", d.run.version, d.run.date);
  return fmt::format(
      "# Diagnosis of {}: {}{}.\n# Logs: {}.\n# Gap {} as configured, {} re-estimated, {} with this file; "
      "noise floor {}.\n",
      d.component, by, toString(d.answer.verdict), log::oneLine(logsOf(d)), words::percent(d.gaps.unseen.as_configured),
      words::percent(d.gaps.unseen.re_estimated), words::percent(gap), words::percent(d.gaps.unseen.noise_floor));
}

// Returns the value with as many decimals as another number in the file.
std::string inDigitsOf(const std::string& number, double value) {
  const std::size_t point = number.find('.');
  const std::size_t exponent = std::min(number.find('e'), number.size());
  const int decimals = point == std::string::npos ? 0 : static_cast<int>(exponent - point) - 1;
  return exponent < number.size() ? fmt::format("{:.{}e}", value, decimals) : fmt::format("{:.{}f}", value, decimals);
}

// Returns the interval in the unit of the number in the file, with as many decimals.
std::string intervalInFile(const SizedValue& size) {
  const std::string text = size.text.empty() ? fmt::format("{}", size.value) : size.text;
  const std::string unit = log::unitOfQuantity(text);
  const log::UnitConversion convert(size.unit, unit.empty() ? size.unit : unit);
  const auto end = [&](std::size_t i) {
    return inDigitsOf(text.substr(0, text.find(' ')), convert(size.interval_95[i]));
  };
  const std::string shown = unit.empty() ? size.unit : unit;
  return words::intervalText(size, end(0), end(1), shown == "1" ? "" : " " + shown);
}

}  // namespace

io::YamlStyle augmentedStyle(const Diagnosis& d) {
  const auto written = [&numbers = d.law.numbers](const std::string& place) {
    return std::find_if(numbers.begin(), numbers.end(), [&](const auto& one) { return one.name == place; });
  };
  io::YamlStyle style;
  style.number = [=, &d](const std::string& place, double value) {
    const auto size = written(place);
    return size == d.law.numbers.end() || size->text.empty() ? fmt::format("{}", value) : size->text;
  };
  style.note = [=, &d](const std::string& place) {
    const auto size = written(place);
    return size == d.law.numbers.end() || size->value == size->configured ||
                   !(size->interval_95[0] < size->interval_95[1])
               ? ""
           : std::isfinite(size->configured)
               ? fmt::format("95 %: {}; was {}", intervalInFile(*size), words::quantity(size->configured, size->unit))
               : "95 %: " + intervalInFile(*size);
  };
  return style;
}

std::string augmentedYaml(const Diagnosis& d) {
  io::YamlStyle style = augmentedStyle(d);
  style.head = originOf(d, d.gaps.unseen.augmented);
  style.head += d.turns ? "# This component of one direction is a rotation: m stands for rad, and N for N m.\n" : "";
  return io::toYaml({d.law.augmented}, style);
}

std::string fullYaml(const Diagnosis& d) {
  io::YamlStyle style;
  style.head = originOf(d, d.law.gap_of_full);
  return io::toYaml({d.law.full}, style);
}

}  // namespace rubber_suspension::diagnosis::report
