// Formats the values of the model before and after the fit.
#include "diagnosis/words/model_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "diagnosis/effect.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::words {
namespace {

bool isChanged(const SizedValue& size) {
  constexpr double kWorthSaying = 0.02;  // logarithm of a ratio; smaller changes are within the accuracy of a bench
  return size.configured > 0.0 && size.value > 0.0 && farOff(size) > kWorthSaying &&
         (size.configured < size.interval_95[0] || size.configured > size.interval_95[1]);
}

std::string boundText(const SizedValue& size) {
  return isAtBound(size) ? ", which is a bound of the fit: these logs do not determine this value" : "";
}

// If an effect depends on the temperature, all values are valid at its reference temperature.
std::string referenceText(const Diagnosis& d) {
  const auto& added = d.law.augmented.add;
  const auto found = std::find_if(added.begin(), added.end(), [](const element::ElementDescription& entry) {
    return entry.values.count("reference") != 0;
  });
  return found == added.end() ? "" : fmt::format(" at {:g} °C", found->value("reference"));
}

}  // namespace

std::string valueName(const SizedValue& size) {
  return size.owner == "specification" ? symbolOf(size.name) : spoken(size.owner) + " " + spoken(size.name);
}

bool isAtBound(const SizedValue& size) {
  return (size.at_bound[0] && size.value == size.interval_95[0]) ||
         (size.at_bound[1] && size.value == size.interval_95[1]);
}

double farOff(const SizedValue& size) { return std::abs(std::log(size.value / size.configured)); }

bool mayBeHeadline(const SizedValue& size) {
  return size.name != "high_frequency" && size.name != "low_frequency" && !isAtBound(size);
}

std::vector<const SizedValue*> changedValues(const Diagnosis& d) {
  std::vector<const SizedValue*> changed;
  for (const SizedValue& size : d.law.model_sizes) {
    if (isChanged(size)) {
      changed.push_back(&size);
    }
  }
  std::sort(changed.begin(), changed.end(),
            [](const SizedValue* a, const SizedValue* b) { return farOff(*a) > farOff(*b); });
  return changed;
}

const SizedValue* headlineValue(const Diagnosis& d) {
  const std::vector<const SizedValue*> changed = changedValues(d);
  const auto found =
      std::find_if(changed.begin(), changed.end(), [](const SizedValue* size) { return mayBeHeadline(*size); });
  return found == changed.end() ? nullptr : *found;
}

std::string wholeText(const Diagnosis& d) {
  if (!d.whole) {
    return "";
  }
  constexpr double kDegree = 180.0 / element::kPi;
  const WholeStiffness& whole = *d.whole;
  return fmt::format(
      "At {:.3g} Hz and {}{}{} the whole component has K = {} ({} as configured) and a loss angle of "
      "{:.1f}° ({:.1f}°).",
      whole.frequency, quantity(whole.amplitude, unitOf(d, "m")),
      whole.nominal_amplitude ? "" : " (median amplitude of the logs)", referenceText(d),
      quantity(whole.stiffness[1], unitOf(d, "N/m")), quantity(whole.stiffness[0], unitOf(d, "N/m")),
      kDegree * whole.loss_angle[1], kDegree * whole.loss_angle[0]);
}

std::string offText(const SizedValue& size) {
  const double off = size.configured / size.value - 1.0;
  return fmt::format("{} is {} % too {} in the component file ({} instead of {}{})", valueName(size),
                     wholePercent(std::abs(off)), off < 0.0 ? "low" : "high", quantity(size.configured, size.unit),
                     quantity(size.value, size.unit), boundText(size));
}

std::string signedQuantity(const Diagnosis& d, const SizedValue& size) {
  if (size.name.rfind("change_of_", 0) == 0) {
    return (size.value < 0.0 ? "falls by " : "rises by ") + quantity(std::abs(size.value), size.unit);
  }
  if (size.value < 0.0 && (size.unit == unitOf(d, "N") || size.unit == unitOf(d, "m"))) {
    return quantity(-size.value, size.unit) + " in compression";
  }
  return (size.value < 0.0 ? "minus " : "") + quantity(std::abs(size.value), size.unit);
}

std::vector<std::string> addedTexts(const Diagnosis& d) {
  std::map<std::string, std::vector<element::ElementDescription>> by_type;
  for (std::size_t i = d.configured.add.size(); i < d.law.augmented.add.size(); ++i) {
    by_type[d.law.augmented.add[i].type].push_back(d.law.augmented.add[i]);
  }
  return element::each(by_type, [&](const auto& added) {
    const auto& [type, entries] = added;
    const bool sliders = type == "iwan_table";
    const std::string values = element::joined(headlineValuesOf(entries), ", ", [&](const HeadlineValue& value) {
      return (sliders && value.name == "displacement" ? "half of this force at" : labelOf(value.name)) + " " +
             quantity(value.value, unitOf(d, value.unit));
    });
    return "add: " + (entries.size() > 1 ? fmt::format("{} times ", entries.size()) : "") + type +
           (values.empty() ? "" : " (" + values + ")");
  });
}

}  // namespace rubber_suspension::diagnosis::words
