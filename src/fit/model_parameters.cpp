// A model's model parameters as unknowns.
#include "fit/model_parameters.h"

#include <fmt/format.h>

#include <cmath>
#include <complex>
#include <map>

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {
namespace {

// The shift with temperature is no element of these: no fit moves it.
io::ComponentDescription asElements(const io::ComponentDescription& description) {
  io::ComponentDescription unshifted = description;
  unshifted.temperature.reset();
  io::ComponentDescription result(description.name, unshifted.allElements());
  result.temperature = description.temperature;
  return result;
}

}  // namespace

double ModelParameters::bound(Eigen::Index i) const {
  const Slot::Where where = slots_[static_cast<std::size_t>(i)].where;
  return where == Slot::element || where == Slot::added ? std::log(10.0) : std::log(3.0);
}

double ModelParameters::firmness(Eigen::Index i) const {
  constexpr double kOfBand = 2.0;
  const Slot& slot = slots_[static_cast<std::size_t>(i)];
  const bool band = slot.where == Slot::relaxation &&
                    (slot.key == "break_frequency" || slot.key == "alpha" || slot.key == "band_ratio");
  return band && relaxation_.elements > 1 ? kOfBand : 1.0;
}

ModelParameters::ModelParameters(const io::ComponentDescription& description, Level level)
    : description_(level == Level::elements || !description.specification().preloads().empty() ? asElements(description)
                                                                                               : description) {
  const estimation::Model model = description_.model();
  if (model == estimation::Model::maxwell || model == estimation::Model::maxwell_dashpot ||
      model == estimation::Model::multi_maxwell) {
    addRelaxation();
  } else if (model != estimation::Model::elements) {
    addSpecification();
  }
  if (model == estimation::Model::elements) {
    addElements(description_.elements(), Slot::element);
  }
  addElements(description_.add, Slot::added);
}

void ModelParameters::add(Slot slot, const std::string& name) {
  slots_.push_back(std::move(slot));
  names_.push_back(name);
}

void ModelParameters::addRelaxation() {
  std::vector<double> break_frequencies;
  std::vector<double> stiffnesses;
  // The static curve, where there is one, is measured: it stays.
  const bool curve = description_.specification().curve() != nullptr;
  for (const element::ElementDescription& element :
       estimation::estimateTangent(description_.model(), description_.specification())) {
    if (element.type == "spring") {
      relaxation_.static_stiffness = element.value("stiffness");
    } else if (element.type == "dashpot") {
      relaxation_.damping = element.value("damping");
    } else if (element.type == "maxwell") {
      stiffnesses.push_back(element.value("stiffness"));
      break_frequencies.push_back(element.value("break_frequency"));
      relaxation_.relaxing_stiffness += stiffnesses.back();
    }
  }
  relaxation_.elements = stiffnesses.size();
  relaxation_.break_frequency = break_frequencies.back();
  if (relaxation_.elements > 1) {
    relaxation_.alpha = stiffnesses[0] / stiffnesses[1];
    relaxation_.band_ratio = break_frequencies[1] / break_frequencies[0];
  }
  const auto addFree = [&](const char* key, bool free) {
    if (free) {
      add({Slot::relaxation, 0, key, 0}, key);
    }
  };
  addFree("static_stiffness", !curve);
  addFree("relaxing_stiffness", true);
  addFree("break_frequency", true);
  addFree("alpha", relaxation_.elements > 1);
  addFree("band_ratio", description_.specification().has("low_frequency"));
  addFree("damping", relaxation_.damping > 0.0);
}

void ModelParameters::addSpecification() {
  for (const auto& [key, value] : description_.specification().values()) {
    const bool unused = description_.model() == estimation::Model::kelvin_voigt && key == "static_stiffness";
    if (!unused && element::isFree(*element::findParameter(estimation::specificationParameters(), key), {value})) {
      add({Slot::specification, 0, key, 0}, key);
    }
  }
}

void ModelParameters::addElements(const std::vector<element::ElementDescription>& elements, Slot::Where where) {
  for (std::size_t entry = 0; entry < elements.size(); ++entry) {
    const element::ElementDescription completed = element::complete(elements[entry]);
    const auto& table = element::findElementType(completed.type)->parameters;
    for (const auto& [key, values] : completed.values) {
      if (element::isFree(*element::findParameter(table, key), values)) {
        add({where, entry, key, values.front()}, fmt::format("{}[{}].{}", completed.type, entry, key));
      }
    }
  }
}

double& ModelParameters::coordinate(Relaxation& relaxation, const std::string& key) {
  static const std::map<std::string, double Relaxation::*> numbers = {
      {"static_stiffness", &Relaxation::static_stiffness},
      {"relaxing_stiffness", &Relaxation::relaxing_stiffness},
      {"alpha", &Relaxation::alpha},
      {"break_frequency", &Relaxation::break_frequency},
      {"band_ratio", &Relaxation::band_ratio},
      {"damping", &Relaxation::damping}};
  return relaxation.*numbers.at(key);
}

// The specification of a point: Eqs. 17 to 21 of Polach (IAVSD 2015) read backwards.
estimation::Specification ModelParameters::specificationOf(const Relaxation& relaxation) const {
  estimation::Specification specification = description_.specification();
  const double omega = 2.0 * element::kPi * specification.at("nominal_frequency");
  double weights = 0.0;
  double weight = 1.0;
  for (std::size_t i = 0; i < relaxation.elements; ++i, weight *= relaxation.alpha) {
    weights += weight;
  }
  std::complex<double> dynamic(relaxation.static_stiffness, omega * relaxation.damping);
  double frequency = relaxation.break_frequency;
  weight = 1.0;  // of the fastest element, i = n_M
  for (std::size_t i = 0; i < relaxation.elements; ++i) {
    const std::complex<double> iwt(0.0, omega / (2.0 * element::kPi * frequency));
    dynamic += relaxation.relaxing_stiffness * weight / weights * iwt / (1.0 + iwt);
    weight *= relaxation.alpha;
    frequency /= relaxation.band_ratio;
  }
  if (specification.curve() == nullptr) {
    specification.set("static_stiffness", relaxation.static_stiffness);
  }
  specification.erase("high_frequency_stiffness");
  specification.set("dynamic_stiffness", std::abs(dynamic));
  specification.erase("relative_damping");
  specification.erase("loss_angle");
  if (description_.model() == estimation::Model::multi_maxwell) {
    const double high = 2.0 * relaxation.break_frequency / (1.0 + 1.0 / relaxation.band_ratio);
    specification.set("maximum_stiffness", relaxation.static_stiffness + relaxation.relaxing_stiffness);
    specification.set("high_frequency", high);
    if (specification.has("low_frequency")) {
      specification.set("low_frequency",
                        high / std::pow(relaxation.band_ratio, static_cast<double>(relaxation.elements)));
    }
    return specification;
  }
  specification.erase("maximum_stiffness");
  specification.erase("high_frequency");
  specification.set("break_frequency", relaxation.break_frequency);
  if (description_.model() == estimation::Model::maxwell_dashpot) {
    specification.set("loss_angle", std::arg(dynamic));
  }
  return specification;
}

estimation::Specification ModelParameters::specification(const Eigen::VectorXd& logarithms) const {
  if (logarithms.isZero(0.0)) {
    return description_.specification();  // as configured, to the last bit
  }
  Relaxation relaxation = relaxation_;
  estimation::Specification result = description_.specification();
  bool relaxes = false;
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Slot& slot = slots_[static_cast<std::size_t>(i)];
    if (slot.where == Slot::relaxation) {
      coordinate(relaxation, slot.key) *= std::exp(logarithms[i]);
      relaxes = true;
    } else if (slot.where == Slot::specification) {
      result.set(slot.key, result.at(slot.key) * std::exp(logarithms[i]));
    }
  }
  return relaxes ? specificationOf(relaxation) : result;
}

io::ComponentDescription ModelParameters::apply(const Eigen::VectorXd& logarithms) const {
  if (logarithms.isZero(0.0)) {
    return description_;  // as configured, to the last bit
  }
  std::vector<element::ElementDescription> elements = description_.elements();
  std::vector<element::ElementDescription> added = description_.add;
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Slot& slot = slots_[static_cast<std::size_t>(i)];
    if (slot.where == Slot::element || slot.where == Slot::added) {
      auto& entries = slot.where == Slot::element ? elements : added;
      entries[slot.entry].values[slot.key] = {slot.configured * std::exp(logarithms[i])};
    }
  }
  io::ComponentDescription result =
      description_.model() == estimation::Model::elements
          ? io::ComponentDescription(description_.name, std::move(elements))
          : io::ComponentDescription(description_.name, description_.model(), specification(logarithms));
  result.add = std::move(added);
  result.temperature = description_.temperature;
  return result;
}

std::optional<std::vector<element::ElementDescription>> ModelParameters::elements(
    const Eigen::VectorXd& logarithms) const {
  try {
    std::vector<element::ElementDescription> result = apply(logarithms).allElements();
    for (const element::ElementDescription& element : result) {
      element::complete(element);
    }
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::vector<std::pair<std::string, double>> ModelParameters::ratios(const Eigen::VectorXd& logarithms) const {
  std::vector<std::pair<std::string, double>> result;
  const estimation::Specification moved = specification(logarithms);
  for (const auto& [key, value] : moved.values()) {
    if (description_.specification().has(key) && description_.specification().at(key) != value) {
      result.emplace_back(key, value / description_.specification().at(key));
    }
  }
  for (Eigen::Index i = 0; i < size(); ++i) {
    const Slot& slot = slots_[static_cast<std::size_t>(i)];
    if (slot.where == Slot::element || slot.where == Slot::added) {
      result.emplace_back(names_[static_cast<std::size_t>(i)], std::exp(logarithms[i]));
    }
  }
  return result;
}

}  // namespace rubber_suspension::fit
