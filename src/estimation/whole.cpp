// Finds the base of a component by root search on settled loops.
#include "rubber_suspension/estimation/whole.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

#include "element/refuse.h"
#include "estimation/models.h"
#include "estimation/point_fit.h"
#include "estimation/root.h"
#include "estimation/solvability.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::estimation {
namespace {

constexpr double kFromEnd = 1e-9;     // share of an interval of K_n, whose limits have no solution
constexpr double kAgreement = 1e-10;  // relative error of the loss or of the high-frequency stiffness
constexpr int kMostSteps = 40;
constexpr double kAnyAmplitude = 1e-3;  // [m]; for linear components, which do not depend on the amplitude

// Thrown if there is no solution.
struct Unsolvable {
  Obstacle obstacle;
  std::string accepted;  // accepted values, if known without a search
};

using Entries = std::vector<element::ElementDescription>;

// Returns the parallel law of an element; nullptr for other elements and for elements on the rig.
const element::ParallelElement* lawOfComponent(const element::ElementPointer& element) {
  const element::ParallelElement* law = element::parallelLaw(element);
  return law == nullptr || law->onRig() ? nullptr : law;
}

// Returns false for laws that never settle under a sine: drift of the rig, and factors that depend on history.
bool settles(const element::ElementDescription& entry) {
  const element::ElementPointer element = element::makeElement(entry);
  const element::Element& law = element::lawOf(element);
  return entry.type != "force_drift" && (law.action() != element::Action::scales_force || law.linear());
}

// Stiffness [N/m] of added springs and Maxwell elements at rest and at very high frequency.
struct AddedStiffness {
  double at_rest = 0.0;
  double limit = 0.0;

  AddedStiffness(const Entries& add, double displacement) {
    constexpr double kNever = 1e-12;  // [rad/s]
    constexpr double kAlways = 1e12;  // [rad/s]
    for (const element::ElementDescription& entry : add) {
      const element::ElementPointer element = element::makeElement(entry);
      const element::ParallelElement* law = lawOfComponent(element);
      if (law != nullptr && law->linear()) {
        at_rest += law->complexStiffness(kNever)->real();
        limit += law->complexStiffness(kAlways)->real();
      } else if (law != nullptr && law->part() == element::Part::elastic) {
        at_rest += slopeAbout(*law, displacement);
        limit += slopeAbout(*law, displacement);
      }
    }
  }
};

class Whole {
 public:
  Whole(Model model, const Specification& given, const Entries& add) : model_(model), given_(given), base_(given) {
    base_.describe(Describes::base);
    element::refuseIf(model == Model::kelvin_voigt && given.curve() != nullptr,
                      "describes: component: model kelvin_voigt has static_curve as its spring, and thus no parameter "
                      "that could be adapted to a stiffness; accepted: base, or another model");
    mean_ = nominalDisplacement(given);
    std::copy_if(add.begin(), add.end(), std::back_inserter(add_), settles);
    element::refuseIf(!given.has("nominal_amplitude") && !isLinear(),
                      "nominal_amplitude is missing, but the static curve or an element under add: is nonlinear; "
                      "accepted: the amplitude at which the whole component has K_n");
    subtract();
  }

  // Returns true if loops are fast to compute: all added elements are parallel, and there is no static curve.
  bool isQuick() const {
    return given_.curve() == nullptr && std::all_of(add_.begin(), add_.end(), [](const auto& entry) {
             return lawOfComponent(element::makeElement(entry)) != nullptr;
           });
  }

  // Returns the base; throws Unsolvable if there is none. `thorough`: scans the range if secants fail.
  Specification solve(bool thorough) const {
    if (const std::optional<Obstacle> obstacle = ratioObstacle(given_)) {
      throw Unsolvable{*obstacle, {}};
    }
    if (loss()) {
      return solveBoth(
          thorough, [&](Specification& base, double loss) { return solveLoss(base, loss); }, *loss() - lossOfAdded());
    }
    if (given_.has("high_frequency_stiffness")) {
      return solveBoth(
          thorough, [&](Specification& base, double stiffness) { return solveHigh(base, stiffness); },
          given_.at("high_frequency_stiffness") - stiffnessOfAdded(given_.at("high_frequency")));
    }
    Specification base = base_;
    solveStiffness(base, [](Specification&, double) { return true; });
    return base;
  }

 private:
  // Sets the remaining numbers of a base with the given K_n. Returns false if there is no solution.
  using Complete = std::function<bool(Specification& base, double stiffness)>;

  double frequency() const { return given_.at("nominal_frequency"); }
  double amplitude() const { return given_.valueOr("nominal_amplitude", kAnyAmplitude); }

  // Returns the loss stiffness K_n sin(delta) [N/m].
  std::optional<double> loss() const {
    const auto angle = specifiedLossAngle(given_);
    return angle ? std::make_optional(given_.at("dynamic_stiffness") * std::sin(*angle)) : std::nullopt;
  }

  bool isLinear() const {
    return given_.curve() == nullptr && std::all_of(add_.begin(), add_.end(), [](const auto& entry) {
             return element::lawOf(element::makeElement(entry)).linear();
           });
  }

  void subtract() {
    const AddedStiffness added(add_, mean_);
    for (const auto& [key, stiffness] :
         {std::pair("static_stiffness", added.at_rest), std::pair("maximum_stiffness", added.limit)}) {
      if (!given_.has(key) || stiffness == 0.0 || model_ == Model::kelvin_voigt) {
        continue;
      }
      if (!(given_.at(key) > stiffness)) {
        const WrittenUnit unit = given_.writtenUnit(key);
        obstacle_ = Obstacle{key, fmt::format("is not above {:.6g} {}, the stiffness of the elements under add:",
                                              stiffness / unit.size, unit.name)};
        return;
      }
      base_.set(key, given_.at(key) - stiffness);
    }
  }

  response::Characteristics characteristics(const Entries& base, double at_frequency) const {
    Entries all = base;
    all.insert(all.end(), add_.begin(), add_.end());
    response::LoopOptions options;
    options.mean = mean_;
    return response::characteristicsAt(component::Component(all), at_frequency, amplitude(), options).characteristics;
  }

  double lossStiffness(const response::Characteristics& whole) const {
    return whole.loss / (element::kPi * amplitude() * amplitude());
  }

  // Returns the characteristics of the added elements in parallel with a spring of stiffness K_n.
  response::Characteristics ofAdded(double at_frequency) const {
    return characteristics({{"spring", {{"stiffness", {given_.at("dynamic_stiffness")}}}}}, at_frequency);
  }
  double lossOfAdded() const { return lossStiffness(ofAdded(frequency())); }
  double stiffnessOfAdded(double at_frequency) const {
    return ofAdded(at_frequency).stiffness - given_.at("dynamic_stiffness");
  }

  // Finds K_n of the base with which the component has the given K_n. `complete` sets the base's other numbers.
  void solveStiffness(Specification& base, const Complete& complete) const {
    if (obstacle_) {
      throw Unsolvable{*obstacle_, {}};
    }
    const double target = given_.at("dynamic_stiffness");
    const auto withStiffness = [&](double stiffness) {
      Specification trial = base;
      trial.set("dynamic_stiffness", stiffness);
      return complete(trial, stiffness) ? std::optional<Specification>(std::move(trial)) : std::nullopt;
    };
    const auto mismatch = [&](double stiffness) {
      return characteristics(estimate(model_, withStiffness(stiffness).value()), frequency()).stiffness - target;
    };
    double lowest = std::numeric_limits<double>::infinity();
    double highest = 0.0;
    for (const auto& [from, to] : intervals(base, withStiffness)) {
      const double at_from = mismatch(from);
      const double at_to = mismatch(to);
      lowest = std::min({lowest, target + at_from, target + at_to});
      highest = std::max({highest, target + at_from, target + at_to});
      if (at_from * at_to <= 0.0) {
        base = withStiffness(rootBetween(mismatch, from, to, at_from, at_to, 48)).value();
        return;
      }
    }
    throw Unsolvable{outOfReach(lowest, highest), accepted(lowest, highest)};
  }

  Obstacle outOfReach(double lowest, double highest) const {
    const WrittenUnit unit = given_.writtenUnit("dynamic_stiffness");
    return {
        "dynamic_stiffness",
        highest > 0.0
            ? fmt::format("cannot be reached by the whole component with the other inputs (range {:.6g} to {:.6g} {})",
                          lowest / unit.size, highest / unit.size, unit.name)
            : "cannot be reached by the whole component: with the elements under add:, no base has a solution"};
  }

  std::string accepted(double lowest, double highest) const {
    const WrittenUnit unit = given_.writtenUnit("dynamic_stiffness");
    return highest > 0.0 ? fmt::format("dynamic_stiffness in ({:.6g}, {:.6g}) {}", lowest / unit.size,
                                       highest / unit.size, unit.name)
                         : "smaller values under add:";
  }

  // Returns the intervals of K_n in which a base has a solution.
  template <class WithStiffness>
  std::vector<std::pair<double, double>> intervals(const Specification& base, const WithStiffness& with) const {
    constexpr double kFar = 100.0;  // multiple of K_n, if there is no upper limit
    Specification start = base;
    start.set("dynamic_stiffness", given_.at("dynamic_stiffness"));
    const element::ParameterInfo& input = *element::findParameter(specificationParameters(), "dynamic_stiffness");
    const Solvable solvable = [&](const Specification& trial) {
      const auto complete = with(trial.at("dynamic_stiffness"));
      return complete && isSolvable(model_, *complete);
    };
    std::vector<std::pair<double, double>> found;
    for (const element::Range& range : solvableIntervals(start, input, solvable, Scan::coarse)) {
      const double upper = std::min(range.upper, kFar * given_.at("dynamic_stiffness"));
      const double margin = kFromEnd * (upper - range.lower);
      found.emplace_back(range.lower + margin, upper - margin);
    }
    return found;
  }

  // Finds K_n for a loss stiffness [N/m] of the base. Returns the relative error of the component's loss stiffness.
  double solveLoss(Specification& base, double loss) const {
    solveStiffness(base, [&](Specification& trial, double stiffness) {
      const double sine = loss / stiffness;  // sin(delta); for M1, whose K_n is the storage stiffness, tan(delta)
      const double angle = model_ == Model::kelvin_voigt ? std::atan(sine) : std::asin(sine);
      const bool angular = given_.has("loss_angle");
      const double damping = 0.5 * std::tan(angle);
      trial.set(angular ? "loss_angle" : "relative_damping", angular ? angle : damping);
      return angle > 0.0 && (angular ? angle < 0.5 * element::kPi : damping <= 1.0);  // false for NaN
    });
    return lossStiffness(characteristics(estimate(model_, base), frequency())) / *this->loss() - 1.0;
  }

  double solveHigh(Specification& base, double stiffness) const {
    base.set("high_frequency_stiffness", stiffness);
    solveStiffness(base, [](Specification&, double) { return true; });
    return characteristics(estimate(model_, base), given_.at("high_frequency")).stiffness /
               given_.at("high_frequency_stiffness") -
           1.0;
  }

  // Finds a second number besides K_n by secants from `start`, which is already the root if forces are additive.
  template <class Solve>
  Specification solveBoth(bool thorough, Solve solve, double start) const {
    const double wanted = loss() ? *loss() : given_.at("high_frequency_stiffness");
    if (!(start > 0.0)) {
      throw Unsolvable{tooMuch(), {}};
    }
    try {
      return secants(solve, start, wanted);
    } catch (const Unsolvable&) {
      if (!thorough) {
        throw;
      }
      if (auto found = scan(solve, start)) {
        return *found;
      }
      throw;
    }
  }

  template <class Solve>
  Specification secants(Solve solve, double start, double wanted) const {
    double value = start;
    double slope = 1.0 / wanted;
    Specification base = base_;
    double mismatch = solve(base, value);
    for (int i = 0; i < kMostSteps && std::abs(mismatch) > kAgreement; ++i) {
      const double next = std::max(value - mismatch / slope, 0.5 * value);
      base = base_;
      const double mismatch_next = solve(base, next);
      slope = next != value && mismatch_next != mismatch ? (mismatch_next - mismatch) / (next - value) : slope;
      value = next;
      mismatch = mismatch_next;
    }
    if (!(std::abs(mismatch) <= 1e3 * kAgreement)) {
      throw Unsolvable{tooMuch(), {}};
    }
    return base;
  }

  template <class Solve>
  std::optional<Specification> scan(Solve solve, double start) const {
    const auto mismatch = [&](double logarithm) {
      Specification base = base_;
      try {
        return solve(base, start * std::exp(logarithm));
      } catch (const Unsolvable&) {
        return std::numeric_limits<double>::quiet_NaN();
      }
    };
    constexpr int kPoints = 60;
    const double reach = std::log(50.0);
    const auto root = lowestRoot(mismatch, -reach, reach, kPoints, 44);
    Specification base = base_;
    if (root) {
      solve(base, start * std::exp(*root));
    }
    return root ? std::make_optional(base) : std::nullopt;
  }

  Obstacle tooMuch() const {
    if (!loss()) {
      return {"high_frequency_stiffness", "cannot be reached by the whole component with the other inputs"};
    }
    const double least = std::asin(std::clamp(lossOfAdded() / given_.at("dynamic_stiffness"), 0.0, 1.0));
    return {given_.has("loss_angle") ? "loss_angle" : "relative_damping",
            fmt::format("cannot be reached by the whole component: the elements under add: alone have {:.4g} deg",
                        least * 180.0 / element::kPi)};
  }

  Model model_;
  const Specification& given_;
  Specification base_;  // K_n and the second number still have the values of the component
  Entries add_;
  double mean_ = 0.0;
  std::optional<Obstacle> obstacle_;
};

std::vector<std::string> notesOf(const Entries& add) {
  std::vector<std::string> names;
  for (const element::ElementDescription& entry : add) {
    if (!settles(entry)) {
      names.push_back(entry.type);
    }
  }
  return names.empty()
             ? std::vector<std::string>{}
             : std::vector<std::string>{fmt::format(
                   "the specified stiffness and loss do not include elements that never settle under a sine: {}",
                   fmt::join(names, ", "))};
}

bool hasSolution(Model model, const Specification& specification, const Entries& add) {
  try {
    Whole(model, specification, add).solve(false);
    return true;
  } catch (const Unsolvable&) {
    return false;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

}  // namespace

Resolved resolve(Model model, const Specification& specification, const Entries& add) {
  if (!specification.preloads().empty()) {
    return {specification, {}, {}};  // describes a base; estimate() rejects any other
  }
  if (!specification.points().empty()) {
    return fitPoints(model, specification, add);
  }
  if (specification.describes() != Describes::component || model == Model::elements) {
    return {specification, {}, {}};
  }
  checkSpecification(model, specification);
  const Whole whole(model, specification, add);
  try {
    return {whole.solve(true), notesOf(add), {}};
  } catch (const Unsolvable& unsolvable) {
    const bool search = whole.isQuick() || unsolvable.accepted.empty();
    const std::string remedy =
        search ? describeSolvableInputs(
                     specification, [&](const Specification& changed) { return hasSolution(model, changed, add); },
                     Scan::coarse)
               : unsolvable.accepted;
    throw std::invalid_argument(fmt::format("{} {}; accepted: {}", inputText(specification, unsolvable.obstacle.key),
                                            unsolvable.obstacle.reason, remedy));
  }
}

}  // namespace rubber_suspension::estimation
