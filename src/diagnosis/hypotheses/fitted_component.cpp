// From a fitted hypothesis to a component description.
#include "diagnosis/hypotheses/fitted_component.h"

#include <algorithm>
#include <utility>

namespace rubber_suspension::diagnosis::hypotheses {
namespace {

// The common part of series compliances of either side as one, and one for the rest of the softer side.
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

io::ComponentDescription augmentedDescription(const fit::ModelParameters& model, const FittedHypothesis& fitted) {
  io::ComponentDescription result = model.apply(fitted.fit.parameters.model);
  const auto entries = entriesOf(fitted);
  result.add.insert(result.add.end(), entries.begin(), entries.end());
  return result;
}

}  // namespace rubber_suspension::diagnosis::hypotheses
