// A model's own parameters as unknowns.
#include "rubber_suspension/diagnosis/own_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace rubber_suspension {
namespace {

bool isChoice(const std::string& key) {
  static const std::vector<std::string> choices = {"nominal_frequency", "nominal_amplitude", "maxwell_elements",
                                                   "viscous_share",     "dead_band",         "sliders",
                                                   "side",              "exponent",          "reference_frequency",
                                                   "low_frequency",     "high_frequency",    "reference_depth"};
  return std::find(choices.begin(), choices.end(), key) != choices.end();
}

ComponentDescription asElements(const ComponentDescription& description) {
  ComponentDescription result;
  result.name = description.name;
  result.model = Model::elements;
  result.elements = description.allElements();
  return result;
}

}  // namespace

double OwnParameters::bound() { return std::log(3.0); }

OwnParameters::OwnParameters(const ComponentDescription& description, Level level)
    : description_(level == Level::elements ? asElements(description) : description) {
  if (description_.model != Model::elements) {
    for (const auto& [key, value] : description_.specification.values()) {
      const bool choice = isChoice(key) && key != "high_frequency" && key != "low_frequency";
      const bool unused = description_.model == Model::kelvin_voigt && key == "static_stiffness";
      if (!choice && !unused && value != 0.0) {
        slots_.push_back({Slot::specification, 0, key, 0});
        names_.push_back(key);
      }
    }
  }
  addElements(description_.elements, Slot::element);
  addElements(description_.add, Slot::added);
}

void OwnParameters::addElements(const std::vector<ElementDescription>& elements, decltype(Slot::where) where) {
  for (std::size_t entry = 0; entry < elements.size(); ++entry) {
    for (const auto& [key, values] : elements[entry].values) {
      for (std::size_t position = 0; position < values.size(); ++position) {
        if (!isChoice(key) && values[position] != 0.0) {
          slots_.push_back({where, entry, key, position});
          names_.push_back(fmt::format("{}[{}].{}", elements[entry].type, entry, key));
        }
      }
    }
  }
}

ComponentDescription OwnParameters::apply(const Eigen::VectorXd& logarithms) const {
  ComponentDescription result = description_;
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Slot& slot = slots_[static_cast<std::size_t>(i)];
    const double factor = std::exp(logarithms[i]);
    if (slot.where == Slot::specification) {
      result.specification.set(slot.key, result.specification.at(slot.key) * factor);
    } else {
      auto& entries = slot.where == Slot::element ? result.elements : result.add;
      entries[slot.entry].values[slot.key][slot.position] *= factor;
    }
  }
  return result;
}

std::optional<std::vector<ElementDescription>> OwnParameters::elements(const Eigen::VectorXd& logarithms) const {
  try {
    std::vector<ElementDescription> result = apply(logarithms).allElements();
    for (const ElementDescription& element : result) {
      complete(element);
    }
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

}  // namespace rubber_suspension
