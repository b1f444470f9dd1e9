// Computes the law that is written: its fit, its sizes, its rounding and its gap.
#include "diagnosis/results/written_law.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "diagnosis/results/simplest_law.h"
#include "diagnosis/results/sizes.h"
#include "gap/simulate.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr int kMostFiner = 8;
// Share by which rounding may increase a gap.
constexpr double kShows = 0.01;

struct Rounded {
  io::ComponentDescription component;
  std::vector<SizedValue> written;
};

// Rounds the numbers of a component as far as the gap on the logs of the fit allows.
Rounded roundTo(const io::ComponentDescription& exact, const std::vector<gap::PreparedRecord>& records,
                const std::vector<SizedValue>& written) {
  const auto gapOf = [&](const io::ComponentDescription& component) {
    return gap::gapOfParts(gap::partErrors(records, gap::simulate(component.allElements(), records, gap::asRecorded)));
  };
  const double allowed = (1.0 + kShows) * gapOf(exact);
  for (int finer = 0; finer < kMostFiner; ++finer) {
    Rounded result{{}, rounded(written, exact, finer)};
    try {
      result.component = asWritten(exact, result.written);
      if (gapOf(result.component) <= allowed) {
        return result;
      }
    } catch (const std::invalid_argument&) {
      continue;  // a component with numbers this coarse is invalid
    }
  }
  return {exact, written};
}

// Copies the properties of a component that no fit changes.
void copyProperties(const io::ComponentDescription& from, io::ComponentDescription& to) {
  to.valid_displacement = from.valid_displacement;
  to.excluded_effects = from.excluded_effects;
  to.tolerance = from.tolerance;
  to.holds_fluid = from.holds_fluid;
  to.units = from.units;
}

io::ComponentDescription componentOf(const hypotheses::PreparedCase& prepared, const FittedLaw& fitted) {
  io::ComponentDescription result = prepared.model.apply(fitted.fit.parameters.model);
  for (const Entries& entries : fitted.law.at(fitted.fit.parameters.scales)) {
    result.add.insert(result.add.end(), entries.begin(), entries.end());
  }
  copyProperties(prepared.component, result);
  return result;
}

// Returns the effect of each entry of a law.
std::vector<std::string> ownersOf(const FittedLaw& fitted, const std::vector<fit::Candidate>& candidates) {
  std::vector<std::string> owners;
  const std::vector<Entries> of_members = fitted.law.at(fitted.fit.parameters.scales);
  for (std::size_t m = 0; m < of_members.size(); ++m) {
    const auto candidate = static_cast<std::size_t>(fitted.law.members[m].member);
    owners.insert(owners.end(), of_members[m].size(), candidates[candidate].effect);
  }
  return owners;
}

constexpr int kMostDigits = 15;

// Rounds a number to `decimals`, which may be negative. Large numbers and numbers with many decimals get an exponent.
std::string toDecimals(double value, int decimals) {
  constexpr double kMostFixed = 1e12;
  if (std::abs(value) > kMostFixed || decimals > kMostDigits) {
    const int digits = value == 0.0 ? 1 : static_cast<int>(std::floor(std::log10(std::abs(value)))) + 1 + decimals;
    return digits > kMostDigits ? fmt::format("{}", value) : fmt::format("{:.{}e}", value, std::max(digits, 1) - 1);
  }
  const double step = std::pow(10.0, -decimals);
  const double rounded = decimals < 0 ? std::round(value / step) * step : value;
  const std::string text = fmt::format("{:.{}f}", rounded, std::max(decimals, 0));
  return std::stod(text) == 0.0 ? fmt::format("{:.1g}", value) : text;  // no number is rounded to 0
}

// Returns the unit in the configured file. If the file has units but none of this kind, returns a usual unit.
std::string unitOf(const io::ComponentDescription& component, const SizedValue& size) {
  const auto given = component.units.find(size.unit);
  if (given != component.units.end() || component.units.empty()) {
    return given == component.units.end() ? "" : given->second;
  }
  return size.unit == "m" ? "mm" : size.unit == "N/m" ? "kN/mm" : size.unit == "N" ? "N" : "";
}

// Returns a text in this unit that is read back as exactly the same number. If that is impossible, returns it in SI.
std::string exactly(double value, const std::string& si, const std::string& unit) {
  const std::string text = unit.empty() ? "" : fmt::format("{:.12g} {}", log::UnitConversion(si, unit)(value), unit);
  return !text.empty() && log::parseQuantity(text, si) == value ? text : fmt::format("{}", value);
}

std::string roundedText(const SizedValue& size, const std::string& unit, int finer) {
  const log::UnitConversion convert(size.unit, unit.empty() ? size.unit : unit);
  const double half = 0.5 * std::abs(convert(size.interval_95[1]) - convert(size.interval_95[0]));
  const std::string number =
      half > 0.0 ? toDecimals(convert(size.value), static_cast<int>(std::ceil(-std::log10(0.1 * half))) + finer)
                 : fmt::format("{}", convert(size.value));
  return number + (unit.empty() ? "" : " " + unit);
}

// Returns the number that is read back from the text with this name, or `value` if there is no such text.
double readBack(const std::vector<SizedValue>& written, const std::string& place, double value) {
  const auto size = std::find_if(written.begin(), written.end(), [&](const auto& one) { return one.name == place; });
  return size == written.end() || size->text.empty() ? value : log::parseQuantity(size->text, size->unit);
}

Entries readBack(const std::vector<SizedValue>& written, const std::string& list, Entries entries) {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    for (auto& [key, numbers] : entries[i].values) {
      for (std::size_t j = 0; j < numbers.size(); ++j) {
        const int index = numbers.size() == 1 ? -1 : static_cast<int>(j);
        numbers[j] = readBack(written, io::numberPlace(fmt::format("{}[{}]", list, i), key, index), numbers[j]);
      }
    }
  }
  return entries;
}

}  // namespace

MeasuredLaw writtenLaw(const hypotheses::PreparedCase& prepared, const hypotheses::Search& search,
                       const hypotheses::FittedHypothesis& judged, double before, const DiagnosisOptions& options) {
  const SimplestLaw chosen =
      simplestLaw(prepared.fitter, search.candidates, judged, prepared.held_out, before, options.threads);
  const FittedLaw& simple = chosen.fitted;
  const FittedLaw full = fullLaw(judged);
  std::vector<WeighedLaw> laws = {{simple}};
  laws.insert(laws.end(), chosen.others.begin(), chosen.others.end());
  Sizes sizes = sizesOf(prepared.fitter, laws, chosen.form_error, search, options);
  Rounded rounded = roundTo(componentOf(prepared, simple), prepared.training, sizes.written);
  Replayed errors = replayed(prepared.fitter, simple, rounded.component.allElements(), prepared.held_out);
  io::ComponentDescription of_full = componentOf(prepared, full);
  const double gap_of_full =
      gap::gapOfParts(unseenErrors(prepared.fitter, full, of_full.allElements(), prepared.held_out));
  return {{std::move(rounded.component),
           std::move(of_full),
           gap_of_full,
           ownersOf(simple, search.candidates),
           std::move(rounded.written),
           std::move(sizes.model),
           std::move(sizes.effects),
           {},
           {}},
          std::move(errors),
          simple};
}

std::vector<SizedValue> rounded(std::vector<SizedValue> written, const io::ComponentDescription& component, int finer) {
  for (SizedValue& size : written) {
    const std::string unit = unitOf(component, size);
    size.text = size.value == size.configured ? exactly(size.value, size.unit, unit) : roundedText(size, unit, finer);
  }
  return written;
}

io::ComponentDescription asWritten(const io::ComponentDescription& exact, const std::vector<SizedValue>& written) {
  const bool listed = exact.model() == estimation::Model::elements;
  io::ComponentDescription result =
      listed ? io::ComponentDescription(exact.name, readBack(written, "elements", exact.elements())) : exact;
  result.add = readBack(written, "add", exact.add);
  if (!listed) {
    estimation::Specification specification = exact.specification();
    for (const auto& [name, value] : exact.specification().values()) {
      specification.set(name, readBack(written, "specification." + name, value));
    }
    if (!exact.add.empty() || specification.describes() != estimation::Describes::unsaid) {
      specification.describe(estimation::Describes::base);
    }
    result.specify(std::move(specification));
  }
  result.rig = exact.rig;
  result.temperature = exact.temperature;
  copyProperties(exact, result);
  result.makeComponent();  // throws if a number is out of its range
  return result;
}

}  // namespace rubber_suspension::diagnosis::results
