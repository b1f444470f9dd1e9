// From a fitted hypothesis to a component description.
#include "diagnosis/results/augmented.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::diagnosis {
namespace {

// What series compliances of either side have in common as one, and one for the rest of the softer side.
void writeCommonCompliance(std::vector<element::ElementDescription>& entries) {
  const auto ofSide = [&](double side) {
    return std::find_if(entries.begin(), entries.end(), [&](const element::ElementDescription& entry) {
      return entry.type == "series_compliance" && entry.values.count("side") != 0 && entry.value("side") == side;
    });
  };
  auto stiff = ofSide(1.0);
  auto soft = ofSide(-1.0);
  if (stiff == entries.end() || soft == entries.end()) {
    return;
  }
  if (stiff->value("stiffness") < soft->value("stiffness")) {
    std::swap(stiff, soft);
  }
  const double rest = 1.0 / soft->value("stiffness") - 1.0 / stiff->value("stiffness");
  stiff->values.erase("side");
  if (rest > 0.0) {
    soft->values["stiffness"] = {1.0 / rest};
  } else {
    entries.erase(soft);
  }
}

// Laws of a spring that yields at a displacement: the terms of one friction.
bool yields(const element::ElementDescription& entry) {
  return entry.type == "iwan_table" || entry.type == "variable_friction" || entry.type == "viscoplastic_friction";
}

// Force and displacement at half force of springs in parallel that yield, from rest: F(z) = sum k_i min(z, y_i). Limits
// that grow or wear count as they begin, those that a rate brings up as they end.
struct SliderFriction {
  double maximum_force = 0.0;
  double displacement = 0.0;
};

SliderFriction frictionOf(const std::vector<element::ElementDescription>& entries) {
  std::vector<std::pair<double, double>> sliders;  // yield displacement, stiffness
  SliderFriction friction;
  double slope = 0.0;
  for (const element::ElementDescription& entry : entries) {
    for (std::size_t i = 0; yields(entry) && i < entry.list("stiffness").size(); ++i) {
      sliders.emplace_back(entry.list("yield_displacement")[i], entry.list("stiffness")[i]);
      friction.maximum_force += sliders.back().first * sliders.back().second;
      slope += sliders.back().second;
    }
  }
  std::sort(sliders.begin(), sliders.end());
  double force = 0.0;
  double travel = 0.0;
  for (const auto& [yield, stiffness] : sliders) {
    const double next = force + slope * (yield - travel);
    if (next >= 0.5 * friction.maximum_force) {
      break;
    }
    force = next;
    travel = yield;
    slope -= stiffness;
  }
  friction.displacement = slope > 0.0 ? travel + (0.5 * friction.maximum_force - force) / slope : travel;
  return friction;
}

}  // namespace

std::vector<element::ElementDescription> entriesOf(const FittedHypothesis& fitted) {
  const std::vector<fit::BasisTerm>& terms = fitted.hypothesis.terms;
  std::vector<element::ElementDescription> entries;
  element::ElementDescription sliders{"iwan_table", {{"yield_displacement", {}}, {"stiffness", {}}}};
  for (std::size_t t = 0; t < terms.size(); ++t) {
    const double scale = fitted.fit.parameters.scales[static_cast<Eigen::Index>(t)];
    if (scale == 0.0) {
      continue;
    }
    const element::ElementDescription entry = terms[t].at(scale);
    if (entry.type == sliders.type) {
      for (auto& [name, values] : sliders.values) {
        values.push_back(entry.value(name));
      }
    } else {
      entries.push_back(entry);
    }
  }
  if (!sliders.values["stiffness"].empty()) {
    entries.insert(entries.begin(), sliders);
  }
  writeCommonCompliance(entries);
  return entries;
}

std::vector<HeadlineValue> headlineValuesOf(const std::vector<element::ElementDescription>& entries) {
  std::vector<HeadlineValue> result;
  const auto add = [&](const std::string& name, const element::ParameterInfo& parameter, double value) {
    const auto taken = [&](const std::string& key) {
      return std::any_of(result.begin(), result.end(), [&](const HeadlineValue& other) { return other.name == key; });
    };
    std::string key = name;
    for (int i = 2; taken(key); ++i) {
      key = fmt::format("{}_{}", name, i);
    }
    result.push_back({key, parameter.unit, value, parameter.role == element::Role::scale});
  };
  if (std::any_of(entries.begin(), entries.end(), yields)) {
    const SliderFriction friction = frictionOf(entries);
    result.push_back({"maximum_force", "N", friction.maximum_force, true});
    result.push_back({"displacement", "m", friction.displacement, false});
  }
  for (const element::ElementDescription& entry : entries) {
    if (entry.type == "iwan_table") {
      continue;
    }
    for (const element::ParameterInfo& parameter : element::findElementType(entry.type)->parameters) {
      const auto found = entry.values.find(parameter.name);
      if (found != entry.values.end()) {
        add(parameter.name, parameter, found->second.at(0));
      }
    }
  }
  return result;
}

std::vector<HeadlineValue> shortHeadlineOf(const std::vector<element::ElementDescription>& entries) {
  std::map<std::string, std::vector<element::ElementDescription>> by_type;
  std::vector<HeadlineValue> result;
  for (const element::ElementDescription& entry : entries) {
    if (!yields(entry)) {
      by_type[entry.type].push_back(entry);
    } else if (result.empty()) {
      const SliderFriction friction = frictionOf(entries);
      result = {{"maximum_force", "N", friction.maximum_force, true},
                {"displacement", "m", friction.displacement, false}};
    }
  }
  for (const auto& [type, group] : by_type) {
    if (type == "series_compliance") {  // stiffnesses in series do not add up
      const auto values = headlineValuesOf(group);
      result.insert(result.end(), values.begin(), values.end());
      continue;
    }
    const std::vector<element::ParameterInfo>& table = element::findElementType(type)->parameters;
    for (const element::ParameterInfo& parameter : table) {
      const bool is_size = &parameter == &table.front();  // the first of a table is how much there is of the law
      const bool is_moved = parameter.role == element::Role::scale || parameter.role == element::Role::shape;
      if (!is_moved || (group.size() > 1 && !is_size)) {
        continue;
      }
      double sum = 0.0;
      bool given = false;
      for (const element::ElementDescription& entry : group) {
        const auto found = entry.values.find(parameter.name);
        given = given || (found != entry.values.end() && element::isFree(parameter, found->second));
        sum += found == entry.values.end() ? 0.0 : found->second.at(0);
      }
      if (given) {
        result.push_back({(group.size() > 1 ? "total_" : "") + parameter.name, parameter.unit, sum,
                          is_size || parameter.role == element::Role::scale});
      }
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

io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted) {
  io::ComponentDescription result = model.apply(fitted.fit.parameters.model);
  const auto entries = entriesOf(fitted);
  result.add.insert(result.add.end(), entries.begin(), entries.end());
  return result;
}

}  // namespace rubber_suspension::diagnosis
