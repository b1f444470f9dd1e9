// A model's model parameters as unknowns.
#include "fit/model_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>

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

ModelParameters::ModelParameters(const io::ComponentDescription& description, Level level)
    : description_(level == Level::elements || !description.specification().preloads().empty() ? asElements(description)
                                                                                               : description),
      configured_{description_.specification(), {}, description_.elements(), description_.add} {
  const estimation::Model model = description_.model();
  if (model == estimation::Model::maxwell || model == estimation::Model::maxwell_dashpot ||
      model == estimation::Model::multi_maxwell) {
    addRelaxation();
  } else if (model != estimation::Model::elements) {
    addSpecification();
  } else {
    addElements(&Point::elements);
  }
  addElements(&Point::added);
}

void ModelParameters::add(const std::string& name, Slot slot, double firmness) {
  names_.push_back(name);
  bounds_.conservativeResize(size());
  firmness_.conservativeResize(size());
  bounds_[size() - 1] = std::log(slot.of_element ? 10.0 : 3.0);
  firmness_[size() - 1] = firmness;
  slots_.push_back(std::move(slot));
}

void ModelParameters::addRelaxation() {
  constexpr double kOfBand = 2.0;
  Relaxation& relaxation = configured_.relaxation;
  std::vector<double> break_frequencies;
  std::vector<double> stiffnesses;
  for (const element::ElementDescription& element :
       estimation::estimateTangent(description_.model(), description_.specification())) {
    if (element.type == "spring") {
      relaxation.static_stiffness = element.value("stiffness");
    } else if (element.type == "dashpot") {
      relaxation.damping = element.value("damping");
    } else if (element.type == "maxwell") {
      stiffnesses.push_back(element.value("stiffness"));
      break_frequencies.push_back(element.value("break_frequency"));
      relaxation.relaxing_stiffness += stiffnesses.back();
    }
  }
  relaxation.elements = stiffnesses.size();
  relaxation.break_frequency = break_frequencies.back();
  const bool band = relaxation.elements > 1;
  if (band) {
    relaxation.alpha = stiffnesses[0] / stiffnesses[1];
    relaxation.band_ratio = break_frequencies[1] / break_frequencies[0];
  }
  const auto addFree = [&](bool free, const char* name, double Relaxation::*number, double firmness = 1.0) {
    if (free) {
      add(name, {[=](Point& point, double ratio) { point.relaxation.*number *= ratio; }, false, 0.0}, firmness);
    }
  };
  // The static curve, where there is one, is measured: it stays.
  addFree(description_.specification().curve() == nullptr, "static_stiffness", &Relaxation::static_stiffness);
  addFree(true, "relaxing_stiffness", &Relaxation::relaxing_stiffness);
  addFree(true, "break_frequency", &Relaxation::break_frequency, band ? kOfBand : 1.0);
  addFree(band, "alpha", &Relaxation::alpha, kOfBand);
  addFree(description_.specification().has("low_frequency"), "band_ratio", &Relaxation::band_ratio,
          band ? kOfBand : 1.0);
  addFree(relaxation.damping > 0.0, "damping", &Relaxation::damping);
}

void ModelParameters::addSpecification() {
  for (const auto& [key, value] : description_.specification().values()) {
    const bool unused = description_.model() == estimation::Model::kelvin_voigt && key == "static_stiffness";
    if (!unused && element::isFree(*element::findParameter(estimation::specificationParameters(), key), {value})) {
      const auto move = [key = key](Point& point, double ratio) {
        point.specification.set(key, point.specification.at(key) * ratio);
      };
      add(key, {move, false, 0.0});
    }
  }
}

void ModelParameters::addElements(std::vector<element::ElementDescription> Point::*list) {
  for (std::size_t entry = 0; entry < (configured_.*list).size(); ++entry) {
    const element::ElementDescription completed = element::complete((configured_.*list)[entry]);
    const auto& table = element::findElementType(completed.type)->parameters;
    for (const auto& [key, values] : completed.values) {
      if (element::isFree(*element::findParameter(table, key), values)) {
        const auto move = [=, key = key, value = values.front()](Point& point, double ratio) {
          (point.*list)[entry].values[key] = {value * ratio};
        };
        add(fmt::format("{}[{}].{}", completed.type, entry, key), {move, true, values.front()});
      }
    }
  }
}

ModelParameters::Point ModelParameters::pointAt(const Eigen::VectorXd& logarithms) const {
  Point point = configured_;
  if (logarithms.isZero(0.0)) {
    return point;  // as configured, to the last bit
  }
  for (Eigen::Index i = 0; i < size(); ++i) {
    slots_[static_cast<std::size_t>(i)].move(point, std::exp(logarithms[i]));
  }
  if (point.relaxation.elements > 0) {
    specify(point);
  }
  return point;
}

// The specification of a relaxation: Eqs. 17 to 21 of Polach (IAVSD 2015) read backwards.
void ModelParameters::specify(Point& point) const {
  const Relaxation& relaxation = point.relaxation;
  estimation::Specification& specification = point.specification;
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
  for (const char* const other : {"high_frequency_stiffness", "relative_damping", "loss_angle"}) {
    specification.erase(other);
  }
  specification.set("dynamic_stiffness", std::abs(dynamic));
  if (description_.model() == estimation::Model::multi_maxwell) {
    const double high = 2.0 * relaxation.break_frequency / (1.0 + 1.0 / relaxation.band_ratio);
    specification.set("maximum_stiffness", relaxation.static_stiffness + relaxation.relaxing_stiffness);
    specification.set("high_frequency", high);
    if (specification.has("low_frequency")) {
      specification.set("low_frequency",
                        high / std::pow(relaxation.band_ratio, static_cast<double>(relaxation.elements)));
    }
    return;
  }
  specification.erase("maximum_stiffness");
  specification.erase("high_frequency");
  specification.set("break_frequency", relaxation.break_frequency);
  if (description_.model() == estimation::Model::maxwell_dashpot) {
    specification.set("loss_angle", std::arg(dynamic));
  }
}

io::ComponentDescription ModelParameters::apply(const Eigen::VectorXd& logarithms) const {
  if (logarithms.isZero(0.0)) {
    return description_;  // as configured, to the last bit
  }
  Point point = pointAt(logarithms);
  io::ComponentDescription result =
      description_.model() == estimation::Model::elements
          ? io::ComponentDescription(description_.name, std::move(point.elements))
          : io::ComponentDescription(description_.name, description_.model(), std::move(point.specification));
  result.add = std::move(point.added);
  result.temperature = description_.temperature;
  return result;
}

std::optional<std::vector<element::ElementDescription>> ModelParameters::elements(
    const Eigen::VectorXd& logarithms) const {
  try {
    std::vector<element::ElementDescription> result = apply(logarithms).allElements();
    std::for_each(result.begin(), result.end(), element::complete);
    return result;
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
}

std::vector<std::pair<std::string, double>> ModelParameters::ratios(const Eigen::VectorXd& logarithms) const {
  std::vector<std::pair<std::string, double>> result;
  const estimation::Specification& configured = configured_.specification;
  const Point point = pointAt(logarithms);
  for (const auto& [key, value] : point.specification.values()) {
    if (configured.has(key) && configured.at(key) != value) {
      result.emplace_back(key, value / configured.at(key));
    }
  }
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].of_element) {
      result.emplace_back(names_[i], std::exp(logarithms[static_cast<Eigen::Index>(i)]));
    }
  }
  return result;
}

}  // namespace rubber_suspension::fit
