// Parameters of a model as parameters of a fit.
#include "fit/model_parameters.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "estimation/models.h"
#include "numerics/difference_quotient.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {
namespace {

// Largest ratios of fitted to configured values.
constexpr double kLargestRatio = 3.0;
constexpr double kLargestOfElement = 10.0;
constexpr double kLargestOfLadder = 100.0;
constexpr double kOwnDeviation = 0.3;  // standard deviation of ln(element's value), which no data sheet states

// Returns the component as a list of elements. The shift with temperature is kept, because no fit changes it.
io::ComponentDescription asElements(const io::ComponentDescription& description) {
  io::ComponentDescription unshifted = description;
  unshifted.temperature.reset();
  io::ComponentDescription result(description.name, unshifted.allElements());
  result.temperature = description.temperature;
  result.tolerance = description.tolerance;
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
  const std::size_t of_base = slots_.size();
  addElements(&Point::added);
  addKnown(of_base);
}

void ModelParameters::add(const std::string& name, Slot slot, double largest_ratio) {
  names_.push_back(name);
  bounds_.conservativeResize(size());
  bounds_[size() - 1] = std::log(largest_ratio);
  slots_.push_back(std::move(slot));
}

void ModelParameters::addRelaxation() {
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
  const auto addFree = [&](bool free, const char* name, double Relaxation::* number, double largest) {
    if (free) {
      add(name, {[=](Point& point, double ratio) { point.relaxation.*number *= ratio; }, false, 0.0, 0.0}, largest);
    }
  };
  const double usual = largestRatio();
  // A static curve was measured, so that the fit does not change it.
  addFree(description_.specification().curve() == nullptr, "static_stiffness", &Relaxation::static_stiffness, usual);
  // The data sheet may state a relaxing stiffness of nearly 0.
  addFree(true, "relaxing_stiffness", &Relaxation::relaxing_stiffness,
          std::max(kLargestOfLadder, kLargestRatio * relaxation.static_stiffness / relaxation.relaxing_stiffness));
  addFree(true, "break_frequency", &Relaxation::break_frequency, kLargestOfLadder);
  addFree(band, "alpha", &Relaxation::alpha, kLargestOfLadder);
  addFree(description_.specification().has("low_frequency"), "band_ratio", &Relaxation::band_ratio, usual);
  addFree(relaxation.damping > 0.0, "damping", &Relaxation::damping, kLargestOfLadder);
}

void ModelParameters::addSpecification() {
  for (const auto& [key, value] : description_.specification().values()) {
    const bool unused = description_.model() == estimation::Model::kelvin_voigt && key == "static_stiffness";
    if (!unused && element::isFree(*element::findParameter(estimation::specificationParameters(), key), {value})) {
      const auto move = [key = key](Point& point, double ratio) {
        point.specification.set(key, point.specification.at(key) * ratio);
      };
      add(key, {move, false, 0.0, 0.0}, largestRatio());
    }
  }
}

void ModelParameters::addElements(std::vector<element::ElementDescription> Point::* list) {
  for (std::size_t entry = 0; entry < (configured_.*list).size(); ++entry) {
    const element::ElementDescription completed = element::complete((configured_.*list)[entry]);
    const auto& table = element::findElementType(completed.type)->parameters;
    const std::string name = fmt::format("{}[{}]", completed.type, entry);
    const auto& [of_all, by_entry] = description_.tolerance;
    const auto own = by_entry.find(name);
    const double deviation = list == &Point::added   ? kOwnDeviation
                             : own != by_entry.end() ? own->second
                                                     : of_all.value_or(kOwnDeviation);
    for (const auto& [key, values] : completed.values) {
      if (element::isFree(*element::findParameter(table, key), values)) {
        const auto move = [=, key = key, value = values.front()](Point& point, double ratio) {
          (point.*list)[entry].values[key] = {value * ratio};
        };
        add(name + "." + key, {move, true, values.front(), deviation},
            std::max(kLargestOfElement, std::exp(2.0 * deviation)));
      }
    }
  }
}

// Adds all numbers that the data sheet states, except inputs that the model does not use.
void ModelParameters::addKnown(std::size_t of_base) {
  using estimation::Model;
  const Point point = configured_;
  for (const auto& [key, value] : configured_.specification.values()) {
    const bool unused = (description_.model() == Model::kelvin_voigt && key == "static_stiffness") ||
                        (description_.model() == Model::maxwell && key == "high_frequency");
    if (!unused && description_.model() != Model::elements && estimation::isOfSheet(key)) {
      known_.push_back({key, std::log(sheetNumber(point, key)), sheetDeviation(key), true, true});
    }
  }
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].of_element) {
      known_.push_back({names_[i], 0.0, slots_[i].deviation, false, i < of_base});
    }
  }
}

double ModelParameters::largestRatio() const {
  return std::max(kLargestRatio, std::exp(2.0 * estimation::largestTolerance(configured_.specification)));
}

bool ModelParameters::isGuess() const {
  return !known_.empty() && known_.front().of_base &&
         std::all_of(known_.begin(), known_.end(), [](const KnownNumber& number) {
           return !number.of_base || number.deviation >= estimation::SheetTolerance::kGuess;
         });
}

Eigen::VectorXd ModelParameters::departures(const Eigen::VectorXd& logarithms) const {
  const Point point = movedBy(logarithms);
  Eigen::VectorXd departures(static_cast<Eigen::Index>(known_.size()));
  Eigen::Index place = 0;
  for (const KnownNumber& number : known_) {
    if (number.of_sheet) {
      departures[place++] = (std::log(sheetNumber(point, number.name)) - number.logarithm) / number.deviation;
    }
  }
  for (std::size_t i = 0; i < slots_.size(); ++i) {
    if (slots_[i].of_element) {
      departures[place] = logarithms[static_cast<Eigen::Index>(i)] / known_[static_cast<std::size_t>(place)].deviation;
      ++place;
    }
  }
  return departures;
}

Eigen::MatrixXd ModelParameters::departureSlopes(const Eigen::VectorXd& logarithms) const {
  constexpr double kDifference = 1e-5;
  return numerics::centralDifferences([this](const Eigen::VectorXd& x) { return departures(x); }, logarithms,
                                      kDifference);
}

std::vector<Eigen::VectorXd> ModelParameters::starts() const {
  constexpr double kLeaning = 5.0;  // ratio alpha of neighbouring stiffnesses
  constexpr double kUsual = 0.3;    // ratio of relaxing to static stiffness
  std::vector<Eigen::VectorXd> starts = {Eigen::VectorXd::Zero(size())};
  const auto start = [&](const char* name, double ratio) {
    const auto place = std::find(names_.begin(), names_.end(), name);
    if (place != names_.end()) {
      starts.push_back(starts.front());
      starts.back()[place - names_.begin()] = std::log(ratio);
    }
  };
  start("alpha", 1.0 / kLeaning);
  start("alpha", kLeaning);
  const Relaxation& relaxation = configured_.relaxation;
  const double usual = kUsual * relaxation.static_stiffness / relaxation.relaxing_stiffness;
  if (usual > kLargestRatio) {
    start("relaxing_stiffness", usual);
  }
  return starts;
}

ModelParameters::Point ModelParameters::movedBy(const Eigen::VectorXd& logarithms) const {
  Point point = configured_;
  for (Eigen::Index i = 0; i < size(); ++i) {
    slots_[static_cast<std::size_t>(i)].move(point, std::exp(logarithms[i]));
  }
  return point;
}

ModelParameters::Point ModelParameters::pointAt(const Eigen::VectorXd& logarithms) const {
  if (logarithms.isZero(0.0)) {
    return configured_;  // unchanged bit by bit
  }
  Point point = movedBy(logarithms);
  if (point.relaxation.elements > 0) {
    specify(point);
  }
  return point;
}

// Returns the complex stiffness of the elements by the inverse of Eqs. 18 to 21 of Polach (IAVSD 2015).
std::complex<double> ModelParameters::Relaxation::stiffnessAt(double frequency) const {
  double weights = 0.0;
  double weight = 1.0;
  for (std::size_t i = 0; i < elements; ++i, weight *= alpha) {
    weights += weight;
  }
  std::complex<double> stiffness(static_stiffness, 2.0 * element::kPi * frequency * damping);
  double corner = break_frequency;
  weight = 1.0;  // weight of the fastest element
  for (std::size_t i = 0; i < elements; ++i) {
    const std::complex<double> ratio(0.0, frequency / corner);
    stiffness += relaxing_stiffness * weight / weights * ratio / (1.0 + ratio);
    weight *= alpha;
    corner /= band_ratio;
  }
  return stiffness;
}

double ModelParameters::sheetNumber(const Point& point, const std::string& key) const {
  const Relaxation& relaxation = point.relaxation;
  if (relaxation.elements == 0) {
    return point.specification.at(key);
  }
  const estimation::Specification& sheet = configured_.specification;
  const std::complex<double> nominal = relaxation.stiffnessAt(sheet.at("nominal_frequency"));
  return key == "static_stiffness"           ? relaxation.static_stiffness
         : key == "dynamic_stiffness"        ? std::abs(nominal)
         : key == "maximum_stiffness"        ? relaxation.static_stiffness + relaxation.relaxing_stiffness
         : key == "high_frequency_stiffness" ? std::abs(relaxation.stiffnessAt(sheet.at("high_frequency")))
         : key == "high_frequency"           ? relaxation.highFrequency()
         : key == "low_frequency"            ? relaxation.lowFrequency()
         : key == "break_frequency"          ? relaxation.break_frequency
         : key == "loss_angle"               ? std::arg(nominal)
                                             : 0.5 * nominal.imag() / nominal.real();
}

// Sets the specification of a relaxation by the inverse of Eq. 17 of Polach.
void ModelParameters::specify(Point& point) const {
  const Relaxation& relaxation = point.relaxation;
  estimation::Specification& specification = point.specification;
  const std::complex<double> dynamic = relaxation.stiffnessAt(specification.at("nominal_frequency"));
  if (specification.curve() == nullptr) {
    specification.set("static_stiffness", relaxation.static_stiffness);
  }
  for (const char* const other : {"high_frequency_stiffness", "relative_damping", "loss_angle"}) {
    specification.erase(other);
  }
  specification.set("dynamic_stiffness", std::abs(dynamic));
  if (description_.model() == estimation::Model::multi_maxwell) {
    specification.set("maximum_stiffness", relaxation.static_stiffness + relaxation.relaxing_stiffness);
    specification.set("high_frequency", relaxation.highFrequency());
    if (specification.has("low_frequency")) {
      specification.set("low_frequency", relaxation.lowFrequency());
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
    return description_;  // unchanged bit by bit
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
  for (const auto& [key, before] : configured.values()) {
    const double value = point.specification.has(key) ? point.specification.at(key) : sheetNumber(point, key);
    if (value != before) {
      result.emplace_back(key, value / before);
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
