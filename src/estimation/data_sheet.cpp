// Conversion of data sheets: hardness and shape, stiffness ratio, second loss angle.
#include "rubber_suspension/estimation/data_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>

#include "element/refuse.h"
#include "estimation/models.h"
#include "estimation/root.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::estimation {
namespace {

using Values = std::map<std::string, double>;

constexpr double kLowestHardness = 20.0;
constexpr double kHighestHardness = 80.0;
constexpr double kHardnessTolerance = 5.0;
constexpr double kLowestShapeFactor = 0.2;
constexpr double kHighestShapeFactor = 3.0;
constexpr double kLowestShearShapeFactor = 1.0;  // bending adds (t/a)^2/3 to the shear of a square block, here 2 %

bool isDataSheetKey(const std::string& key) { return element::findParameter(dataSheetParameters(), key) != nullptr; }

void checkRanges(const Values& values) {
  for (const auto& [key, value] : values) {
    for (const auto* table : {&dataSheetParameters(), &specificationParameters()}) {
      if (const element::ParameterInfo* row = element::findParameter(*table, key)) {
        checkRange(*row, value);
      }
    }
  }
}

void requireAll(const Values& values, const std::vector<std::string>& keys, const std::string& purpose) {
  for (const std::string& key : keys) {
    element::refuseIf(values.count(key) == 0, "{}: is missing; it is needed for {}", key, purpose);
  }
}

void refuseBoth(const Values& values, const std::string& derived, const std::string& direct) {
  element::refuseIf(values.count(derived) != 0 && values.count(direct) != 0,
                    "{}: is given together with {}; accepted: only one of the two", derived, direct);
}

double blockStiffness(const Values& values, double hardness, LoadDirection direction) {
  const double layers = values.count("layers") != 0 ? values.at("layers") : 1.0;
  const double area_over_height = values.at("loaded_area") / (layers * values.at("layer_thickness"));
  const double modulus = modulusFromShoreA(hardness);
  return direction == LoadDirection::shear ? modulus / 3.0 * area_over_height
                                           : modulus * compressionFactor(values.at("shape_factor")) * area_over_height;
}

// Sets the static stiffness from hardness and shape.
void addStaticStiffness(const Values& values, LoadDirection direction, DataSheetResult& result) {
  static const std::vector<std::string> keys = {"shore_a", "loaded_area", "layer_thickness", "shape_factor"};
  if (values.count("shore_a") == 0) {
    for (const char* key : {"loaded_area", "layer_thickness", "shape_factor", "layers"}) {
      element::refuseIf(values.count(key) != 0,
                        "{}: is given without shore_a, but the shape alone does not determine a stiffness", key);
    }
    return;
  }
  refuseBoth(values, "shore_a", "static_stiffness");
  requireAll(values, keys, "a static stiffness from hardness");
  const double shape_factor = values.at("shape_factor");
  element::refuseIf(
      direction == LoadDirection::shear && shape_factor < kLowestShearShapeFactor,
      "shape_factor: {:g} is out of range in shear, because a slender block bends; accepted: at least {:g}",
      shape_factor, kLowestShearShapeFactor);
  const double hardness = values.at("shore_a");
  const double stiffness = blockStiffness(values, hardness, direction);
  const double softest = blockStiffness(values, std::max(kLowestHardness, hardness - kHardnessTolerance), direction);
  const double hardest = blockStiffness(values, std::min(kHighestHardness, hardness + kHardnessTolerance), direction);
  result.specification.set("static_stiffness", stiffness);
  result.notes.push_back(fmt::format(
      "static_stiffness {:.6g} N/m follows from Shore A {:g}: Young's modulus {:.4g} MPa (Gent 1958){}; a hardness "
      "tolerance of {:g} degrees means {:.4g} to {:.4g} N/m",
      stiffness, hardness, modulusFromShoreA(hardness) * 1e-6,
      direction == LoadDirection::shear
          ? ", shear modulus one third of it"
          : fmt::format(", times 1 + 2 S^2 = {:.4g} (Gent and Lindley 1959)", compressionFactor(shape_factor)),
      kHardnessTolerance, softest, hardest));
}

void addDynamicStiffness(const Values& values, DataSheetResult& result) {
  if (values.count("dynamic_to_static_ratio") != 0) {
    refuseBoth(values, "dynamic_to_static_ratio", "dynamic_stiffness");
    element::refuseIf(!result.specification.has("static_stiffness"),
                      "static_stiffness: is missing; it is needed for dynamic_to_static_ratio");
    const double stiffness = values.at("dynamic_to_static_ratio") * result.specification.at("static_stiffness");
    result.specification.set("dynamic_stiffness", stiffness);
    result.notes.push_back(fmt::format("dynamic_stiffness {:.6g} N/m from dynamic_to_static_ratio", stiffness));
  } else if (values.count("dynamic_stiffness") == 0) {
    throw std::invalid_argument(
        "dynamic_stiffness: is missing; it does not follow from hardness or static stiffness because it depends on the "
        "filler; accepted: dynamic_stiffness or dynamic_to_static_ratio from the data sheet or a test");
  }
}

// Returns the break frequency with which M3 has the second loss angle. Between the limits of a dashpot alone (f_b -> 0)
// and of a Maxwell element alone, the loss angle at another frequency depends monotonically on f_b.
double breakFrequencyForSecondAngle(const Specification& specification, double frequency, double angle) {
  Specification trial = specification;
  const double highest = std::log(breakFrequencyForLossAngle(specification));
  const auto mismatch = [&](double log_frequency) {
    trial.set("break_frequency", std::exp(log_frequency));
    return std::arg(stiffnessAt(estimateMaxwellDashpot(trial), frequency)) - angle;
  };
  const double lowest = highest - std::log(1e6);
  const double top = highest - 1e-9;
  const double at_lowest = mismatch(lowest);
  const double at_top = mismatch(top);
  if (at_lowest * at_top > 0.0) {
    const double a = at_lowest + angle;
    const double b = at_top + angle;
    throw std::invalid_argument(
        fmt::format("second_loss_angle: {:g} rad at {:g} Hz cannot be reached by one Maxwell element and a dashpot "
                    "with the other inputs; accepted: in ({:.6g}, {:.6g}) rad",
                    angle, frequency, std::min(a, b), std::max(a, b)));
  }
  return std::exp(rootBetween(mismatch, lowest, top, at_lowest, at_top, 48));
}

void addSecondAngle(const Values& values, DataSheetResult& result) {
  requireAll(values, {"second_frequency", "second_loss_angle"}, "a second loss angle");
  if (result.model != Model::maxwell_dashpot) {
    throw std::invalid_argument("second_loss_angle: model " + toString(result.model) +
                                " has no parameter for a second loss angle; accepted: model maxwell_dashpot");
  }
  refuseBoth(values, "second_loss_angle", "break_frequency");
  Specification& specification = result.specification;
  element::refuseIf(values.at("second_frequency") == specification.at("nominal_frequency"),
                    "second_frequency: is equal to the nominal frequency; accepted: a different frequency");
  specification.set("break_frequency", 1.0);  // any value, for the checks; determined below
  checkSpecification(Model::maxwell_dashpot, specification);
  for (const auto& obstacle : {stiffnessObstacle(specification), storageObstacle(specification)}) {
    if (obstacle) {
      throw std::invalid_argument(inputText(specification, obstacle->key) + " " + obstacle->reason);
    }
  }
  const double frequency =
      breakFrequencyForSecondAngle(specification, values.at("second_frequency"), values.at("second_loss_angle"));
  specification.set("break_frequency", frequency);
  result.notes.push_back(fmt::format("break_frequency {:.6g} Hz from the loss angle at {:g} Hz", frequency,
                                     values.at("second_frequency")));
}

Model simplestModel(const Values& values) {
  const auto has = [&](const char* key) { return values.count(key) != 0; };
  if (has("second_loss_angle")) {
    return Model::maxwell_dashpot;
  }
  if (has("high_frequency") || has("low_frequency") || has("maxwell_elements")) {
    return Model::multi_maxwell;
  }
  if (has("nominal_amplitude")) {
    return has("break_frequency") ? Model::berg : has("viscous_share") ? Model::friction_dashpot : Model::friction;
  }
  const bool damping = has("loss_angle") || has("relative_damping");
  return damping && has("break_frequency") ? Model::maxwell_dashpot : Model::maxwell;
}

}  // namespace

double modulusFromShoreA(double hardness) {
  element::refuseIf(!(hardness >= kLowestHardness && hardness <= kHighestHardness),
                    "shore_a: {:g} is outside the range of Gent's relation; accepted: in [{:g}, "
                    "{:g}]",
                    hardness, kLowestHardness, kHighestHardness);
  return 1e6 * 0.0981 * (56.0 + 7.62336 * hardness) / (0.137505 * (254.0 - 2.54 * hardness));
}

double compressionFactor(double shape_factor) {
  element::refuseIf(!(shape_factor >= kLowestShapeFactor && shape_factor <= kHighestShapeFactor),
                    "shape_factor: {:g} is outside the range of the formula 1 + 2 S^2 (below it a block bends, above "
                    "it the compressibility of rubber matters); accepted: in [{:g}, {:g}]",
                    shape_factor, kLowestShapeFactor, kHighestShapeFactor);
  return 1.0 + 2.0 * shape_factor * shape_factor;
}

const std::vector<element::ParameterInfo>& dataSheetParameters() {
  using element::Range;
  using element::Role;
  static const std::vector<element::ParameterInfo> table = {
      {"shore_a", "1", Role::shape, Range::closed(kLowestHardness, kHighestHardness), "Shore A hardness"},
      {"loaded_area", "m^2", Role::shape, Range::positive(), "loaded area of one layer"},
      {"layer_thickness", "m", Role::shape, Range::positive(), "thickness of one layer of rubber"},
      {"shape_factor", "1", Role::shape, Range::closed(kLowestShapeFactor, 50.0),
       "ratio of loaded area to force-free area of one layer"},
      {"layers", "1", Role::choice, Range::closed(1.0, 100.0), "number of layers in series", 1.0},
      {"dynamic_to_static_ratio", "1", Role::shape, Range::openBelow(1.0, 10.0), "K_n/K_st at the nominal frequency"},
      {"second_frequency", "Hz", Role::reference, Range::positive(), "frequency of the second loss angle"},
      {"second_loss_angle", "rad", Role::shape, Range::open(0.0, 0.5 * element::kPi), "loss angle at second_frequency"},
  };
  return table;
}

DataSheetResult specificationFromDataSheet(std::optional<Model> model, LoadDirection direction, const Values& values) {
  DataSheetResult result{model.value_or(simplestModel(values)), {}, {}};
  checkRanges(values);
  for (const auto& [key, value] : values) {
    if (!isDataSheetKey(key)) {
      result.specification.set(key, value);
    }
  }
  addStaticStiffness(values, direction, result);
  addDynamicStiffness(values, result);
  if (values.count("second_loss_angle") != 0 || values.count("second_frequency") != 0) {
    addSecondAngle(values, result);
  }
  estimate(result.model, result.specification);  // throws if the specification has no solution
  return result;
}

}  // namespace rubber_suspension::estimation
