// Tables of the specification and of the models, their checks, and the choice of the function that estimates.
#include "rubber_suspension/estimation/specification.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "element/largest_number.h"
#include "element/refuse.h"
#include "element/suggestion.h"
#include "estimation/models.h"
#include "estimation/solvability.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::estimation {
namespace {

// A larger ratio of dynamic to static stiffness is an error by a power of ten; rubber has 1.1 to about 4.
constexpr double kLargestStiffnessRatio = 10.0;

struct NamedModel {
  ModelInfo info;
  std::string name;
  std::optional<Obstacle> (*obstacle)(const Specification&);
  std::vector<element::ElementDescription> (*elements)(const Specification&);
};

std::optional<Obstacle> noObstacle(const Specification& /*specification*/) { return std::nullopt; }
std::vector<element::ElementDescription> noElements(const Specification& /*specification*/) { return {}; }

const std::vector<NamedModel>& models() {
  static const std::vector<NamedModel> table = {
      {{Model::kelvin_voigt,
        "M1: spring and dashpot; the spring has the stiffness K_n, and static_stiffness is not used",
        {"dynamic_stiffness", "nominal_frequency"},
        {{"relative_damping", "loss_angle"}},
        {"static_stiffness"},
        {}},
       "kelvin_voigt",
       noObstacle,
       estimateKelvinVoigt},
      {{Model::maxwell,
        "M2: spring and one Maxwell element",
        {"static_stiffness", "dynamic_stiffness", "nominal_frequency"},
        {{"break_frequency", "loss_angle", "relative_damping", "maximum_stiffness", "high_frequency_stiffness"}},
        {"high_frequency"},
        {}},
       "maxwell",
       maxwellObstacle,
       estimateMaxwell},
      {{Model::maxwell_dashpot,
        "M3: spring, one Maxwell element and dashpot",
        {"static_stiffness", "dynamic_stiffness", "nominal_frequency", "break_frequency"},
        {{"relative_damping", "loss_angle"}},
        {},
        {}},
       "maxwell_dashpot",
       maxwellDashpotObstacle,
       estimateMaxwellDashpot},
      {{Model::friction,
        "M4: spring and Berg friction",
        {"static_stiffness", "dynamic_stiffness", "nominal_frequency", "nominal_amplitude"},
        {{"relative_damping", "loss_angle"}},
        {},
        {}},
       "friction",
       frictionObstacle,
       estimateFriction},
      {{Model::friction_dashpot,
        "M5: spring, Berg friction and dashpot; K_n holds between the turning points, where the dashpot has no force",
        {"static_stiffness", "dynamic_stiffness", "nominal_frequency", "nominal_amplitude"},
        {{"relative_damping", "loss_angle"}},
        {"viscous_share"},
        {}},
       "friction_dashpot",
       frictionDashpotObstacle,
       estimateFrictionDashpot},
      {{Model::berg,
        "M6: spring, Berg friction and one Maxwell element",
        {"static_stiffness", "dynamic_stiffness", "nominal_frequency", "nominal_amplitude", "break_frequency"},
        {{"relative_damping", "loss_angle"}},
        {"viscous_share"},
        {}},
       "berg",
       bergObstacle,
       estimateBerg},
      {{Model::multi_maxwell,
        "M2 with n_M Maxwell elements from five inputs; if low_frequency is not given, its value is n_M "
        "f_h/10^(n_M-1), a reconstruction of the paper's illegible Eq. 22",
        {"static_stiffness", "dynamic_stiffness", "nominal_frequency"},
        {},
        {"maxwell_elements", "low_frequency", "high_frequency_stiffness"},
        {{"maximum_stiffness", "high_frequency", "loss_angle"}}},
       "multi_maxwell",
       multiMaxwellObstacle,
       estimateMultiMaxwell},
      {{Model::elements, "a list of elements; nothing is estimated", {}, {}, {}, {}},
       "elements",
       noObstacle,
       noElements},
  };
  return table;
}

// Keys that every model accepts: an amplitude, which does not affect linear models, and the rest of the working point,
// which `describes` and a static curve need.
const std::vector<std::string> kWorkingPoint = {"nominal_amplitude", "nominal_displacement", "nominal_force"};

const NamedModel& entry(Model model) { return models().at(static_cast<std::size_t>(model)); }

const element::ParameterInfo* findParameter(std::string_view name) {
  return element::findParameter(specificationParameters(), name);
}

std::string join(const std::vector<std::string>& names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::vector<std::string> acceptedKeys(const ModelInfo& info, bool whole) {
  std::vector<std::string> keys = info.required;
  for (const auto& groups : {info.one_of, info.two_of}) {
    for (const auto& group : groups) {
      keys.insert(keys.end(), group.begin(), group.end());
    }
  }
  keys.insert(keys.end(), info.optional.begin(), info.optional.end());
  for (const std::string& key : kWorkingPoint) {
    const bool taken = info.model != Model::elements && (whole || key == "nominal_amplitude");
    if (taken && std::find(keys.begin(), keys.end(), key) == keys.end()) {
      keys.push_back(key);
    }
  }
  return keys;
}

void checkKeys(const NamedModel& model, const Specification& specification, bool whole) {
  const std::vector<std::string> accepted = acceptedKeys(model.info, whole);
  for (const auto& [key, value] : specification.values()) {
    if (std::find(accepted.begin(), accepted.end(), key) == accepted.end()) {
      const std::string what = findParameter(key) == nullptr ? "unknown key" + element::didYouMean(key, accepted)
                                                             : "is not an input of model " + model.name;
      throw std::invalid_argument(
          fmt::format("{}: {}; accepted: {}", key, what, accepted.empty() ? "no specification" : join(accepted)));
    }
  }
}

void checkInput(const std::string& key, double value) {
  const element::ParameterInfo& parameter = *findParameter(key);
  checkRange(parameter, value);
  if (key == "maxwell_elements" && value != std::floor(value)) {
    throw std::invalid_argument(fmt::format("{}: {:g} is not a whole number; accepted: whole numbers {}", key, value,
                                            element::describe(parameter.range)));
  }
}

// The missing key comes first: "loss_angle is missing, or relative_damping instead of it".
std::string missingText(const std::vector<std::string>& missing, std::size_t needed) {
  const auto split = missing.begin() + static_cast<std::ptrdiff_t>(needed);
  const std::vector<std::string> first(missing.begin(), split);
  const std::vector<std::string> others(split, missing.end());
  return fmt::format("{} {} missing{}", fmt::join(first, " and "), needed == 1 ? "is" : "are",
                     others.empty() ? ""
                                    : fmt::format(", or {} instead of {}", fmt::join(others, " or "),
                                                  needed == 1 ? "it" : "one of them"));
}

std::string givenText(const std::vector<std::string>& given) {
  return given.empty() ? "" : fmt::format("; given: {}", fmt::join(given, ", "));
}

void checkGroup(const NamedModel& model, const Specification& specification, const std::vector<std::string>& group,
                std::size_t needed) {
  std::vector<std::string> given;
  std::vector<std::string> others;
  for (const std::string& key : group) {
    (specification.has(key) ? given : others).push_back(key);
  }
  if (given.size() != needed) {
    const std::string what = given.size() > needed ? join(given) + " are given"
                                                   : missingText(others, needed - given.size()) + givenText(given);
    throw std::invalid_argument(fmt::format("{}; accepted by model {}: exactly {} of {}", what, model.name,
                                            needed == 1 ? "one" : "two", join(group)));
  }
}

// Checks high_frequency_stiffness, which replaces maximum_stiffness and is valid at high_frequency.
void checkHighFrequency(const NamedModel& model, const Specification& specification) {
  const bool stiffness = specification.has("high_frequency_stiffness");
  element::refuseIf(stiffness && !specification.has("high_frequency"),
                    "high_frequency is missing; accepted: the frequency at which high_frequency_stiffness holds");
  element::refuseIf(
      !stiffness && model.info.model == Model::maxwell,
      "high_frequency: is given without high_frequency_stiffness; accepted by model maxwell: both or neither");
  for (const char* other : {"maximum_stiffness", "loss_angle"}) {
    element::refuseIf(
        stiffness && specification.has(other),
        "{0}: is given together with high_frequency_stiffness, which replaces it; accepted: only one of the two",
        other);
  }
}

void checkPresence(const NamedModel& model, const Specification& specification) {
  for (const std::string& key : model.info.required) {
    if (!specification.has(key)) {
      throw std::invalid_argument(
          fmt::format("{} is missing; model {} needs {}", key, model.name, join(model.info.required)));
    }
  }
  for (const auto& group : model.info.one_of) {
    checkGroup(model, specification, group, 1);
  }
  if (specification.has("high_frequency_stiffness") || specification.has("high_frequency")) {
    checkHighFrequency(model, specification);
  }
  for (const auto& group : model.info.two_of) {
    if (!specification.has("high_frequency_stiffness")) {
      checkGroup(model, specification, group, 2);
    }
  }
}

std::optional<Obstacle> findObstacle(const NamedModel& model, const Specification& specification) {
  if (auto obstacle = stiffnessObstacle(specification)) {
    return obstacle;
  }
  return model.obstacle(specification);
}

[[noreturn]] void refuse(const NamedModel& model, const Specification& specification, const Obstacle& obstacle) {
  const std::string remedy = describeSolvableInputs(
      specification, [&](const Specification& changed) { return !findObstacle(model, changed).has_value(); });
  throw std::invalid_argument(
      fmt::format("{} {}; accepted: {}", inputText(specification, obstacle.key), obstacle.reason, remedy));
}

}  // namespace

Specification tangentOf(Model model, const Specification& specification) {
  if (specification.curve() == nullptr) {
    return specification;
  }
  const char* key = model == Model::kelvin_voigt ? "dynamic_stiffness" : "static_stiffness";
  element::refuseIf(specification.has(key),
                    "{}: is given together with static_curve, which already determines it as a tangent; accepted: only "
                    "one of the two",
                    key);
  Specification tangent = specification;
  const double stiffness = specification.curve()->tangentAt(nominalDisplacement(specification));
  if (!(stiffness > 0.0)) {
    throw std::invalid_argument(
        fmt::format("static_curve: the tangent at the working point, {:g} m, is {:.6g} N/m; accepted: a "
                    "nominal_displacement or nominal_force at which the curve rises",
                    nominalDisplacement(specification), stiffness));
  }
  tangent.set(key, stiffness);
  tangent.eraseCurve();
  return tangent;
}

namespace {

void checkWorkingPoint(const Specification& specification) {
  if (specification.curve() != nullptr) {
    specification.curve()->check();
  } else if (specification.has("nominal_force")) {
    throw std::invalid_argument("nominal_force: is given without static_curve; accepted: nominal_displacement");
  }
  element::refuseIf(specification.has("nominal_force") && specification.has("nominal_displacement"),
                    "nominal_force: is given together with nominal_displacement; accepted: only one of the two");
}

}  // namespace

std::string toString(Model model) { return entry(model).name; }

std::optional<Model> modelFromString(const std::string& name) {
  for (const NamedModel& model : models()) {
    if (model.name == name) {
      return model.info.model;
    }
  }
  return std::nullopt;
}

const std::vector<element::ParameterInfo>& specificationParameters() {
  using element::Range;
  using element::Role;
  static const std::vector<element::ParameterInfo> table = {
      {"static_stiffness", "N/m", Role::shape, Range::positive(), "static stiffness K_st"},
      {"dynamic_stiffness", "N/m", Role::shape, Range::positive(), "dynamic stiffness K_n at the nominal frequency"},
      {"nominal_frequency", "Hz", Role::reference, Range::positive(), "frequency f_n at which K_n and loss angle hold"},
      {"maximum_stiffness", "N/m", Role::shape, Range::positive(), "stiffness K_max at very high frequency"},
      {"high_frequency", "Hz", Role::shape, Range::positive(), "upper end f_h of the frequencies of interest"},
      {"low_frequency", "Hz", Role::shape, Range::positive(),
       "lower end f_l of the frequencies of interest (default: n_M f_h/10^(n_M-1))"},
      {"maxwell_elements", "1", Role::choice, Range::closed(2, 20),
       "number n_M of Maxwell elements; one element is the model maxwell", 5.0},
      {"nominal_amplitude", "m", Role::reference, Range::openBelow(0.0, 1.0),
       "amplitude A_n at which K_n and loss angle hold, half of peak to peak, in metres"},
      {"loss_angle", "rad", Role::shape, Range::open(0.0, 0.5 * element::kPi), "loss angle at the nominal frequency"},
      {"relative_damping", "1", Role::shape, Range::openBelow(0.0, 1.0),
       "relative damping D_n = tan(loss angle)/2; 0.05 means 5 %"},
      {"break_frequency", "Hz", Role::shape, Range::positive(), "break frequency f_b of the Maxwell element"},
      {"viscous_share", "1", Role::choice, Range::openAbove(0.0, 1.0), "viscous share of the loss energy at (f_n, A_n)",
       0.2},
      {"high_frequency_stiffness", "N/m", Role::shape, Range::positive(),
       "stiffness K at f_h and A_n; give this stiffness instead of K_max"},
      {"nominal_displacement", "m", Role::reference, Range::any(),
       "displacement about which K_n and loss angle hold, and at which K_st is the tangent of static_curve", 0.0},
      {"nominal_force", "N", Role::reference, Range::any(),
       "force of static_curve at the nominal displacement; give this force instead of nominal_displacement"},
  };
  return table;
}

bool isOfSheet(std::string_view name) {
  const element::ParameterInfo* parameter = findParameter(name);
  return parameter != nullptr && parameter->role == element::Role::shape;
}

double largestTolerance(const Specification& specification) {
  double largest = 0.0;
  for (const auto& [key, value] : specification.values()) {
    largest = isOfSheet(key) ? std::max(largest, specification.tolerance().of(key)) : largest;
  }
  return largest > 0.0 ? largest : specification.tolerance().of("");
}

const ModelInfo& modelInfo(Model model) { return entry(model).info; }

double nominalDisplacement(const Specification& specification) {
  if (!specification.preloads().empty() && !specification.has("nominal_displacement") &&
      !specification.has("nominal_force")) {
    Specification first = specification;
    first.setPreloads({});
    for (const auto& [key, value] : specification.preloads().front()) {
      first.set(key, value);
    }
    return nominalDisplacement(first);
  }
  if (const auto force = specification.find("nominal_force"); force && specification.curve() != nullptr) {
    return specification.curve()->displacementAt(*force);
  }
  return specification.valueOr("nominal_displacement", 0.0);
}

std::string toString(Describes describes) {
  return describes == Describes::unsaid ? "" : describes == Describes::base ? "base" : "component";
}

void checkSpecification(Model model, const Specification& given) {
  checkWorkingPoint(given);
  const Specification specification = tangentOf(model, given);
  checkKeys(entry(model), specification, given.describes() != Describes::unsaid || given.curve() != nullptr);
  for (const auto& [key, value] : specification.values()) {
    checkInput(key, value);
  }
  checkPresence(entry(model), specification);
}

bool isSolvable(Model model, const Specification& specification) {
  return !findObstacle(entry(model), tangentOf(model, specification)).has_value();
}

std::vector<element::ElementDescription> estimateTangent(Model model, const Specification& given) {
  element::refuseIf(
      !given.points().empty() || given.describes() == Describes::component,
      "describes: the specification describes more than the model; accepted: the specification that resolve() returns");
  checkSpecification(model, given);
  const Specification specification = tangentOf(model, given);
  if (const auto obstacle = findObstacle(entry(model), specification)) {
    refuse(entry(model), specification, *obstacle);
  }
  return entry(model).elements(specification);
}

namespace {

// Returns the specification of one set of numbers, with the tangent of the curve at its displacement.
Specification blockOf(Model model, const Specification& given, const Specification::Values& block) {
  Specification specification = given;
  specification.setPreloads({});
  for (const char* place : {"nominal_displacement", "nominal_force"}) {
    specification.erase(place);
  }
  for (const auto& [key, value] : block) {
    specification.set(key, value);
  }
  checkSpecification(model, specification);
  return specification;
}

// Joins the Maxwell elements and dashpots of all sets of numbers, interpolated linearly over the displacement.
std::vector<element::ElementDescription> joined(const std::vector<double>& displacement,
                                                const std::vector<std::vector<element::ElementDescription>>& blocks) {
  std::vector<element::ElementDescription> result;
  for (std::size_t i = 1; i < blocks.front().size(); ++i) {
    const std::string scale = blocks.front()[i].type == "maxwell" ? "stiffness" : "damping";
    element::ElementDescription element{blocks.front()[i].type + "_along_curve", {{"displacement", displacement}}};
    for (const auto& block : blocks) {
      element::refuseIf(
          scale == "stiffness" &&
              std::abs(block[i].value("break_frequency") / blocks.front()[i].value("break_frequency") - 1.0) > 1e-9,
          "preloads: the break frequencies of the blocks differ; accepted: break_frequency, or high_frequency of the "
          "model multi_maxwell, outside of the blocks");
      element.values[scale].push_back(block[i].value(scale));
    }
    if (scale == "stiffness") {
      element.values["break_frequency"] = {blocks.front()[i].value("break_frequency")};
    }
    result.push_back(element);
  }
  return result;
}

void checkPreloads(Model model, const Specification& given) {
  element::refuseIf(given.curve() == nullptr, "preloads: are given without static_curve; accepted: both or neither");
  element::refuseIf(given.describes() == Describes::component || !given.points().empty(),
                    "preloads: the blocks describe the base; accepted: describes: base, without points");
  element::refuseIf(model == Model::friction || model == Model::friction_dashpot || model == Model::berg,
                    "preloads: the friction of model {} cannot vary with the preload; accepted: kelvin_voigt, maxwell, "
                    "maxwell_dashpot, multi_maxwell",
                    toString(model));
}

std::vector<element::ElementDescription> estimatePreloads(Model model, const Specification& given) {
  checkPreloads(model, given);
  std::map<double, std::vector<element::ElementDescription>> by_displacement;
  for (const Specification::Values& block : given.preloads()) {
    const Specification specification = blockOf(model, given, block);
    by_displacement[nominalDisplacement(specification)] = estimateTangent(model, specification);
  }
  element::refuseIf(by_displacement.size() != given.preloads().size(),
                    "preloads: two blocks have the same displacement; accepted: one block for each displacement");
  std::vector<double> displacement;
  std::vector<std::vector<element::ElementDescription>> blocks;
  for (auto& [place, elements] : by_displacement) {
    displacement.push_back(place);
    blocks.push_back(std::move(elements));
  }
  std::vector<element::ElementDescription> elements = joined(displacement, blocks);
  elements.insert(elements.begin(), springOf(*given.curve()));
  return elements;
}

}  // namespace

std::vector<element::ElementDescription> estimate(Model model, const Specification& specification) {
  if (!specification.preloads().empty()) {
    return estimatePreloads(model, specification);
  }
  std::vector<element::ElementDescription> elements = estimateTangent(model, specification);
  return specification.curve() == nullptr
             ? elements
             : alongCurve(*specification.curve(), nominalDisplacement(specification), std::move(elements));
}

std::optional<double> specifiedLossAngle(const Specification& specification) {
  const std::optional<double> damping = specification.find("relative_damping");
  return specification.has("loss_angle") ? specification.find("loss_angle")
         : damping                       ? std::make_optional(std::atan(2.0 * *damping))
                                         : std::nullopt;
}

std::complex<double> stiffnessAt(const std::vector<element::ElementDescription>& elements, double frequency) {
  std::complex<double> sum = 0.0;
  for (const element::ElementDescription& element : elements) {
    sum += *element::parallelLaw(element::makeElement(element))->complexStiffness(2.0 * element::kPi * frequency);
  }
  return sum;
}

double slopeAbout(const element::ParallelElement& law, double displacement) {
  constexpr double kStep = 1e-7;  // [m]
  std::vector<double> memory(law.memorySize());
  const double above = law.initialise(displacement + kStep, memory.data());
  return (above - law.initialise(displacement - kStep, memory.data())) / (2.0 * kStep);
}

void checkRange(const element::ParameterInfo& input, double value) {
  if (!input.range.contains(value)) {
    throw std::invalid_argument(fmt::format("{}: {:g}{} is out of range; accepted: {} ({})", input.name, value,
                                            input.unit == "1" ? "" : " " + input.unit,
                                            element::acceptedFor(value, input.range), input.documentation));
  }
}

double valueOrDefault(const Specification& specification, std::string_view key) {
  const std::optional<double> value = specification.find(key);
  return value ? *value : findParameter(key)->default_value.value();
}

std::string inputText(const Specification& specification, const std::string& key) {
  const WrittenUnit unit = specification.writtenUnit(key);
  return fmt::format("{}: {:.6g}{}", key, specification.at(key) / unit.size, unit.name == "1" ? "" : " " + unit.name);
}

WrittenUnit Specification::writtenUnit(std::string_view name) const {
  if (units_ != nullptr && units_->find(name) != units_->end()) {
    return units_->find(name)->second;
  }
  const element::ParameterInfo* parameter = findParameter(name);
  return {parameter == nullptr ? "1" : parameter->unit, 1.0};
}

std::optional<Obstacle> ratioObstacle(const Specification& specification) {
  const double k_st = specification.valueOr("static_stiffness", HUGE_VAL);
  // The numbers of a base may be an arbitrarily small part of the numbers of the component.
  if (specification.describes() == Describes::base) {
    return std::nullopt;
  }
  for (const char* key : {"dynamic_stiffness", "maximum_stiffness", "high_frequency_stiffness"}) {
    if (specification.valueOr(key, 0.0) > kLargestStiffnessRatio * k_st) {
      return Obstacle{key, fmt::format("is more than {:g} times {}, which is impossible for a rubber component",
                                       kLargestStiffnessRatio, inputText(specification, "static_stiffness"))};
    }
  }
  return std::nullopt;
}

std::optional<Obstacle> stiffnessObstacle(const Specification& specification) {
  const std::optional<double> k_st = specification.find("static_stiffness");
  const std::optional<double> k_n = specification.find("dynamic_stiffness");
  const std::optional<double> k_max = specification.find("maximum_stiffness");
  // A missing number becomes NaN, with which every comparison is false.
  const auto orNone = [](const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
  };
  if (orNone(k_n) <= orNone(k_st)) {
    return Obstacle{"dynamic_stiffness", "is not above " + inputText(specification, "static_stiffness")};
  }
  if (orNone(k_max) <= orNone(k_n)) {
    return Obstacle{"maximum_stiffness", "is not above " + inputText(specification, "dynamic_stiffness")};
  }
  return ratioObstacle(specification);
}

}  // namespace rubber_suspension::estimation
