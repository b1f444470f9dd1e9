// From entries of a component file to the numbers that engineers say.
#include "diagnosis/headline.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "element/each.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/iwan.h"

namespace rubber_suspension::diagnosis {
namespace {

bool isSlider(const element::ElementDescription& entry) {
  return entry.type == "iwan_table" || entry.type == "variable_friction" || entry.type == "viscoplastic_friction";
}

// Laws of a force with a limit: the terms of one friction.
bool yields(const element::ElementDescription& entry) {
  return isSlider(entry) || entry.type == "friction" || entry.type == "iwan";
}

bool isStop(const element::ElementDescription& entry) { return entry.type == "bump_stop"; }

bool followsTemperature(const element::ElementDescription& entry) { return entry.values.count("reference") != 0; }

double valueOr(const element::ElementDescription& entry, const std::string& name, double otherwise) {
  return entry.values.count(name) != 0 ? entry.value(name) : otherwise;
}

// Force of an entry that is moved from rest; at an infinite displacement its limit. Limits that grow or wear count as
// they begin, those that a rate brings up as they end.
double frictionAt(const element::ElementDescription& entry, double z) {
  if (entry.type == "friction") {
    return entry.value("maximum_force") / (1.0 + entry.value("displacement") / z);
  }
  const std::vector<element::JenkinsSlider> sliders =
      entry.type == "iwan" ? element::iwanSliders(entry.value("maximum_force"), entry.value("displacement"),
                                                  static_cast<int>(element::complete(entry).value("sliders")))
                           : element::slidersFromTable(entry);
  return std::accumulate(sliders.begin(), sliders.end(), 0.0, [&](double force, const element::JenkinsSlider& slider) {
    return force + slider.stiffness * std::min(z, slider.yield_displacement);
  });
}

// Limit of all together, and the displacement from rest at half of it.
std::vector<HeadlineValue> frictionOf(const std::vector<element::ElementDescription>& entries) {
  const auto at = [&](double z) {
    return std::accumulate(entries.begin(), entries.end(), 0.0,
                           [&](double sum, const auto& entry) { return sum + frictionAt(entry, z); });
  };
  const double maximum = at(std::numeric_limits<double>::infinity());
  double low = 0.0;
  double high = 1e-9;
  while (at(high) < 0.5 * maximum) {
    low = std::exchange(high, 2.0 * high);
  }
  for (int halving = 0; halving < 60; ++halving) {
    const double middle = 0.5 * (low + high);
    (at(middle) < 0.5 * maximum ? low : high) = middle;
  }
  return {{"maximum_force", "N", maximum, true}, {"displacement", "m", high, false}};
}

// Where the force of each side begins, and how it rises once all stops of that side are met.
std::vector<HeadlineValue> stopsOf(const std::vector<element::ElementDescription>& stops) {
  std::vector<HeadlineValue> result;
  for (const auto& [side, suffix] :
       {std::pair(0.0, ""), std::pair(1.0, "_in_tension"), std::pair(-1.0, "_in_compression")}) {
    double gap = std::numeric_limits<double>::infinity();
    double stiffness = 0.0;
    for (const element::ElementDescription& stop : stops) {
      if (valueOr(stop, "side", 0.0) == side) {
        gap = std::min(gap, stop.value("gap"));
        stiffness += stop.value("stiffness");
      }
    }
    if (stiffness > 0.0) {
      result.push_back({std::string("gap") + suffix, "m", gap, false});
      result.push_back({std::string("stiffness") + suffix, "N/m", stiffness, true});
    }
  }
  return result;
}

// Derivatives by the temperature at the reference.
std::vector<HeadlineValue> changesWithTemperature(const std::vector<element::ElementDescription>& entries) {
  constexpr double kGas = 8.314462618;  // [J/(mol K)]
  constexpr double kZero = 273.15;      // [K]
  double stiffness = 0.0;
  double rates = 0.0;
  for (const element::ElementDescription& entry : entries) {
    const double reference = entry.value("reference") + kZero;
    stiffness += valueOr(entry, "coefficient", 0.0) + valueOr(entry, "vertical", 0.0) -
                 valueOr(entry, "share", 0.0) / valueOr(entry, "width", 1.0);
    rates += valueOr(entry, "activation_energy", 0.0) / (kGas * reference * reference) +
             std::log(10.0) * valueOr(entry, "c1", 0.0) / valueOr(entry, "c2", 1.0);
  }
  std::vector<HeadlineValue> result;
  for (const auto& [name, value] : {std::pair("stiffness", stiffness), std::pair("rates", rates)}) {
    if (value != 0.0) {
      result.push_back(
          {fmt::format("change_of_{}_at_{:g}_degC", name, entries.front().value("reference")), "1/K", value, true});
    }
  }
  return result;
}

// The numbers that a fit moves of entries of one type; of several, their sum, and of softenings, which act one after
// the other, what all together take.
std::vector<HeadlineValue> movedOf(const std::vector<element::ElementDescription>& group) {
  std::vector<HeadlineValue> result;
  const std::vector<element::ParameterInfo>& table = element::findElementType(group.front().type)->parameters;
  for (const element::ParameterInfo& parameter : table) {
    const bool is_size = &parameter == &table.front();  // the first of a table is how much there is of the law
    const bool in_turn = parameter.name == "reduction";
    double sum = 0.0;
    bool given = false;
    for (const element::ElementDescription& entry : group) {
      const auto found = entry.values.find(parameter.name);
      given = given || (found != entry.values.end() && element::isFree(parameter, found->second));
      const double value = found == entry.values.end() ? 0.0 : found->second.at(0);
      sum += in_turn ? (1.0 - sum) * value : value;
    }
    if (given && (group.size() == 1 || is_size)) {
      result.push_back({(group.size() > 1 ? "total_" : "") + parameter.name, parameter.unit, sum,
                        is_size || parameter.role == element::Role::scale});
    }
  }
  return result;
}

// The motion that dead zones lose one after the other once it is beyond all of them.
std::vector<HeadlineValue> playsOf(const std::vector<element::ElementDescription>& group) {
  const double lost = std::accumulate(group.begin(), group.end(), 0.0, [](double sum, const auto& entry) {
    return sum + valueOr(entry, "share", 1.0) * entry.value("gap");
  });
  return {{group.size() > 1 ? "total_gap" : "gap", "m", lost, true}};
}

// Stiffnesses in series do not add up.
std::vector<HeadlineValue> compliancesOf(const std::vector<element::ElementDescription>& group) {
  std::vector<HeadlineValue> result;
  for (const element::ElementDescription& entry : group) {
    for (HeadlineValue value : movedOf({entry})) {
      const double side = valueOr(entry, "side", 0.0);
      value.name += side > 0.0 ? "_in_tension" : side < 0.0 ? "_in_compression" : "";
      value.name += entry.values.count("closing_force") != 0 && group.size() > 1 ? "_that_closes" : "";
      result.push_back(value);
    }
  }
  return result;
}

// The side on which a contact is slack says as much as what holds it there, mostly nothing.
std::vector<HeadlineValue> contactsOf(const std::vector<element::ElementDescription>& group) {
  return element::each(group, [](const element::ElementDescription& entry) -> HeadlineValue {
    return {entry.value("side") > 0.0 ? "slack_stiffness_in_compression" : "slack_stiffness_in_tension", "N/m",
            valueOr(entry, "slack_stiffness", 0.0), false};
  });
}

}  // namespace

std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries) {
  std::map<std::string, std::vector<element::ElementDescription>> groups;
  for (const element::ElementDescription& entry : entries) {
    groups[yields(entry) ? "" : followsTemperature(entry) ? "temperature" : entry.type].push_back(entry);
  }
  std::vector<HeadlineValue> result;
  for (const auto& [name, group] : groups) {
    const auto values = yields(group.front())               ? frictionOf(group)
                        : isStop(group.front())             ? stopsOf(group)
                        : followsTemperature(group.front()) ? changesWithTemperature(group)
                        : name == "free_play"               ? playsOf(group)
                        : name == "series_compliance"       ? compliancesOf(group)
                        : name == "lift_off"                ? contactsOf(group)
                                                            : movedOf(group);
    for (HeadlineValue value : values) {
      const bool taken = std::any_of(result.begin(), result.end(), [&](const auto& v) { return v.name == value.name; });
      value.name += taken ? "_of_" + name : "";
      result.push_back(std::move(value));
    }
  }
  return result;
}

std::map<std::string, double> headlineOf(const std::vector<element::ElementDescription>& entries) {
  std::map<std::string, double> result;
  for (const HeadlineValue& value : headlineValuesOf(entries)) {
    result[value.name] = value.value;
  }
  return result;
}

}  // namespace rubber_suspension::diagnosis
