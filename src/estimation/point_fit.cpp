// Fit of a model to points by a Levenberg-Marquardt search over the logarithms of its elements' parameters.
#include "estimation/point_fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "element/refuse.h"
#include "element/suggestion.h"
#include "estimation/models.h"
#include "numerics/trust_region.h"
#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::estimation {
namespace {

using FitEntries = std::vector<element::ElementDescription>;

constexpr double kAnyPointAmplitude = 1e-3;  // [m]; for linear components, which do not depend on the amplitude
const double kWidestFit = std::log(1e4);     // limit of a logarithm on either side of its start

// A parameter of the model's elements, which is fitted or fixed.
struct FitNumber {
  const char* name;
  std::vector<double> starts;  // starts of the search; one if the parameter is fixed
  bool kept = false;
};

class PointFit {
 public:
  PointFit(Model model, const Specification& given, const FitEntries& add) : model_(model), given_(given), add_(add) {
    checkKeys();
    checkPoints();
    addNumbers();
  }

  Resolved fit() const {
    std::size_t combinations = 1;
    for (const FitNumber& number : numbers_) {
      combinations *= number.starts.size();
    }
    constexpr double kStep = 1e-6;  // step of the logarithms; loops are settled to 1e-9
    numerics::DifferencedSquares misfit([this](const Eigen::VectorXd& x) { return residuals(x); }, kStep);
    residuals(start(0));  // throws if the component itself is rejected
    numerics::Optimum best{{}, std::numeric_limits<double>::infinity()};
    for (std::size_t i = 0; i < combinations; ++i) {
      const numerics::Optimum found = numerics::searchLeast(misfit, start(i), limits());
      best = found.cost < best.cost ? found : best;
    }
    element::refuseIf(!std::isfinite(best.cost),
                      "points: the model cannot be fitted to these points; accepted: points of one component");
    return result(best.search);
  }

 private:
  bool is(std::initializer_list<Model> models) const {
    return std::find(models.begin(), models.end(), model_) != models.end();
  }
  bool hasFriction() const { return is({Model::friction, Model::friction_dashpot, Model::berg}); }
  bool hasMaxwell() const { return is({Model::maxwell, Model::maxwell_dashpot, Model::berg}); }
  bool hasDashpot() const { return is({Model::kelvin_voigt, Model::maxwell_dashpot, Model::friction_dashpot}); }

  void checkKeys() const {
    std::vector<std::string> accepted = {"nominal_frequency", "nominal_amplitude", "nominal_displacement",
                                         "nominal_force"};
    if (model_ != Model::kelvin_voigt) {
      accepted.emplace_back("static_stiffness");
    }
    if (hasMaxwell()) {
      accepted.emplace_back("break_frequency");
    }
    if (model_ == Model::multi_maxwell) {
      accepted.insert(accepted.end(), {"maxwell_elements", "low_frequency", "high_frequency"});
    }
    for (const auto& [key, value] : given_.values()) {
      if (std::find(accepted.begin(), accepted.end(), key) == accepted.end()) {
        throw std::invalid_argument(fmt::format("{}: is given, but follows from points{}; accepted: {}", key,
                                                element::didYouMean(key, accepted), fmt::join(accepted, ", ")));
      }
    }
  }

  void checkPoints() const {
    if (given_.curve() != nullptr) {
      given_.curve()->check();
    }
    for (std::size_t i = 0; i < given_.points().size(); ++i) {
      const SpecifiedPoint& point = given_.points()[i];
      element::refuseIf(!point.stiffness && !point.loss_angle,
                        "points[{}] has neither stiffness nor loss_angle; accepted: stiffness, loss_angle or both", i);
      element::refuseIf(
          point.amplitude == 0.0 && !isLinear() && !given_.has("nominal_amplitude"),
          "points[{}].amplitude is missing, but the component is nonlinear; accepted: the amplitude of the point", i);
    }
  }

  bool describesWhole() const { return given_.describes() == Describes::component; }

  bool isLinear() const {
    const auto linear = [](const auto& entry) { return element::lawOf(element::makeElement(entry)).linear(); };
    return !hasFriction() && given_.curve() == nullptr &&
           (!describesWhole() || std::all_of(add_.begin(), add_.end(), linear));
  }

  double amplitudeOf(const SpecifiedPoint& point) const {
    return point.amplitude > 0.0 ? point.amplitude : given_.valueOr("nominal_amplitude", kAnyPointAmplitude);
  }

  template <class Value>
  double geometricMean(Value value) const {
    double sum = 0.0;
    for (const SpecifiedPoint& point : given_.points()) {
      sum += std::log(value(point));
    }
    return std::exp(sum / static_cast<double>(given_.points().size()));
  }
  double nominalFrequency() const {
    return given_.valueOr("nominal_frequency", geometricMean([](const auto& point) { return point.frequency; }));
  }
  double nominalAmplitude() const {
    return given_.valueOr("nominal_amplitude", geometricMean([&](const auto& point) { return amplitudeOf(point); }));
  }

  template <class Value>
  std::pair<double, double> range(Value value) const {
    std::pair<double, double> ends(std::numeric_limits<double>::infinity(), 0.0);
    for (const SpecifiedPoint& point : given_.points()) {
      ends = {std::min(ends.first, value(point)), std::max(ends.second, value(point))};
    }
    return ends;
  }

  void addNumbers() {
    const auto [f_low, f_high] = range([](const auto& point) { return point.frequency; });
    const auto [a_low, a_high] = range([&](const auto& point) { return amplitudeOf(point); });
    const auto [k_low, k_high] = range([&](const auto& point) { return point.stiffness.value_or(levelOfStiffness()); });
    const double f_mean = std::sqrt(f_low * f_high);
    if (given_.curve() != nullptr) {
      const double tangent = given_.curve()->tangentAt(nominalDisplacement(given_));
      numbers_.push_back({"spring", {tangent}, true});
    } else if (const auto static_stiffness = given_.find("static_stiffness")) {
      numbers_.push_back({"spring", {*static_stiffness}, true});
    } else {
      numbers_.push_back({"spring", {0.8 * k_low}});
    }
    const double rise = std::max(0.1 * k_high, k_high - numbers_[0].starts[0]);
    if (hasFriction()) {
      numbers_.push_back({"friction_stiffness", {2.0 * rise}});  // F_max/z2 of the friction
      numbers_.push_back({"friction_displacement", {0.3 * a_low, std::sqrt(a_low * a_high), 3.0 * a_high}});
    }
    if (hasMaxwell() || model_ == Model::multi_maxwell) {
      numbers_.push_back({"relaxing", {rise}});
    }
    if (hasMaxwell() && given_.has("break_frequency")) {
      numbers_.push_back({"break_frequency", {given_.at("break_frequency")}, true});
    } else if (hasMaxwell()) {
      numbers_.push_back({"break_frequency", {0.5 * f_low, f_mean, 2.0 * f_high}});
    }
    if (model_ == Model::multi_maxwell) {
      numbers_.push_back({"alpha", {0.5, 1.0, 2.0}});
    }
    if (hasDashpot()) {
      numbers_.push_back({"damping", {0.1 * k_low / (2.0 * element::kPi * f_mean)}});
    }
    checkCount();
  }

  double levelOfStiffness() const {
    for (const SpecifiedPoint& point : given_.points()) {
      if (point.stiffness) {
        return *point.stiffness;
      }
    }
    if (const auto level = given_.find("static_stiffness")) {
      return *level;
    }
    element::refuseIf(
        given_.curve() == nullptr,
        "points: no point has a stiffness; accepted: a stiffness in at least one point, or static_stiffness");
    return given_.curve()->tangentAt(nominalDisplacement(given_));
  }

  void checkCount() const {
    const auto moved = std::count_if(numbers_.begin(), numbers_.end(), [](const auto& number) { return !number.kept; });
    if (moved > residualCount()) {
      throw std::invalid_argument(
          fmt::format("points: {0} values do not determine {1} free parameters of model {2}; accepted: at least {1} "
                      "values, or static_stiffness{3}",
                      residualCount(), moved, toString(model_), hasMaxwell() ? " and break_frequency" : ""));
    }
  }

  std::ptrdiff_t residualCount() const {
    std::ptrdiff_t count = 0;
    for (const SpecifiedPoint& point : given_.points()) {
      count += (point.stiffness ? 1 : 0) + (point.loss_angle ? 1 : 0);
    }
    return count;
  }

  // Returns the logarithms of the fitted parameters at one combination of their starts.
  Eigen::VectorXd start(std::size_t combination) const {
    std::vector<double> logarithms;
    for (const FitNumber& number : numbers_) {
      const double value = number.starts[combination % number.starts.size()];
      combination /= number.starts.size();
      if (!number.kept) {
        logarithms.push_back(std::log(value));
      }
    }
    return Eigen::Map<Eigen::VectorXd>(logarithms.data(), static_cast<Eigen::Index>(logarithms.size()));
  }

  double valueOf(const Eigen::VectorXd& logarithms, const std::string& name) const {
    Eigen::Index moved = 0;
    for (const FitNumber& number : numbers_) {
      if (number.name == name) {
        return number.kept ? number.starts.front() : std::exp(logarithms[moved]);
      }
      moved += number.kept ? 0 : 1;
    }
    throw std::out_of_range(name);
  }

  Specification bandSpecification() const {
    const auto [low, high] = range([](const auto& point) { return point.frequency; });
    Specification band;
    band.set("high_frequency", given_.valueOr("high_frequency", high));
    band.set("low_frequency", given_.valueOr("low_frequency", std::min(low, 0.1 * band.at("high_frequency"))));
    band.set("maxwell_elements", valueOrDefault(given_, "maxwell_elements"));
    return band;
  }

  // Returns the elements with a linear spring in place of the static curve.
  FitEntries tangentElements(const Eigen::VectorXd& logarithms) const {
    const auto value = [&](const char* name) { return valueOf(logarithms, name); };
    FitEntries elements = {{"spring", {{"stiffness", {value("spring")}}}}};
    if (hasFriction()) {
      const double z2 = value("friction_displacement");
      elements.push_back({"friction", {{"maximum_force", {value("friction_stiffness") * z2}}, {"displacement", {z2}}}});
    }
    if (hasMaxwell()) {
      elements.push_back(
          {"maxwell", {{"stiffness", {value("relaxing")}}, {"break_frequency", {value("break_frequency")}}}});
    }
    if (model_ == Model::multi_maxwell) {
      const FitEntries maxwells = multiMaxwellElements(bandSpecification(), value("relaxing"), value("alpha"));
      elements.insert(elements.end(), maxwells.begin(), maxwells.end());
    }
    if (hasDashpot()) {
      elements.push_back({"dashpot", {{"damping", {value("damping")}}}});
    }
    return elements;
  }

  component::Component componentOf(const Eigen::VectorXd& logarithms) const {
    FitEntries elements = tangentElements(logarithms);
    if (given_.curve() != nullptr) {
      elements = alongCurve(*given_.curve(), nominalDisplacement(given_), std::move(elements));
    }
    if (describesWhole()) {
      elements.insert(elements.end(), add_.begin(), add_.end());
    }
    return component::Component(elements);
  }

  response::Characteristics at(const component::Component& component, const SpecifiedPoint& point) const {
    response::LoopOptions options;
    options.mean = nominalDisplacement(given_);
    return response::characteristicsAt(component, point.frequency, amplitudeOf(point), options).characteristics;
  }

  Eigen::VectorXd residuals(const Eigen::VectorXd& logarithms) const {
    const component::Component component = componentOf(logarithms);
    Eigen::VectorXd result(residualCount());
    Eigen::Index next = 0;
    for (const SpecifiedPoint& point : given_.points()) {
      const response::Characteristics found = at(component, point);
      const double weight = std::sqrt(point.weight);
      if (point.stiffness) {
        result[next++] = weight * std::log(found.stiffness / *point.stiffness);
      }
      if (point.loss_angle) {
        result[next++] = weight * (found.loss_angle - *point.loss_angle);
      }
    }
    return result;
  }

  // Returns the limits of the logarithms, on either side of the first starts.
  numerics::Limits limits() const {
    const Eigen::VectorXd first = start(0);
    return {first.array() - kWidestFit, first.array() + kWidestFit};
  }

  Resolved result(const Eigen::VectorXd& logarithms) const {
    const component::Component component = componentOf(logarithms);
    Resolved resolved{baseOf(logarithms), {}, {}};
    for (const SpecifiedPoint& point : given_.points()) {
      const response::Characteristics found = at(component, point);
      resolved.points.push_back({point, found.stiffness, found.loss_angle});
      resolved.notes.push_back(noteOn(resolved.points.back(), resolved.points.size()));
    }
    return resolved;
  }

  std::string noteOn(const PointMisfit& misfit, std::size_t number) const {
    constexpr double kDegrees = 180.0 / element::kPi;
    std::string text =
        fmt::format("point {}, {:g} Hz and {:g} mm:", number, misfit.point.frequency, 1e3 * amplitudeOf(misfit.point));
    if (const auto stiffness = misfit.point.stiffness) {
      text += fmt::format(" K {:.6g} N/m, {:+.2g} % from {:.6g}", misfit.stiffness,
                          100.0 * (misfit.stiffness / *stiffness - 1.0), *stiffness);
    }
    if (const auto angle = misfit.point.loss_angle) {
      text += fmt::format("{} loss angle {:.4g} deg, {:+.2g} deg from {:.4g}", misfit.point.stiffness ? "," : "",
                          misfit.loss_angle * kDegrees, (misfit.loss_angle - *angle) * kDegrees, *angle * kDegrees);
    }
    return text;
  }

  // Returns the specification of the fitted base, by the inverse of Eqs. 10 to 21 of Polach (IAVSD 2015).
  Specification baseOf(const Eigen::VectorXd& logarithms) const {
    Specification base = given_;
    base.describe(Describes::base);
    base.setPoints({});
    const double f_n = nominalFrequency();
    const double amplitude = nominalAmplitude();
    const FitEntries elements = tangentElements(logarithms);
    const component::Component component(elements);
    base.set("nominal_frequency", f_n);
    if (hasFriction()) {
      base.set("nominal_amplitude", amplitude);
    }
    const response::Characteristics found = response::characteristicsAt(component, f_n, amplitude).characteristics;
    if (given_.curve() == nullptr && model_ != Model::kelvin_voigt) {
      base.set("static_stiffness", valueOf(logarithms, "spring"));
    }
    if (model_ == Model::kelvin_voigt) {
      if (given_.curve() == nullptr) {
        base.set("dynamic_stiffness", valueOf(logarithms, "spring"));
      }
      base.set("loss_angle", found.loss_angle);
      return base;
    }
    base.set("dynamic_stiffness", found.stiffness);
    if (hasMaxwell()) {
      base.set("break_frequency", valueOf(logarithms, "break_frequency"));
    }
    if (model_ == Model::maxwell_dashpot) {
      base.set("loss_angle", found.loss_angle);
    }
    if (model_ == Model::multi_maxwell) {
      const Specification band = bandSpecification();
      for (const auto& [key, value] : band.values()) {
        base.set(key, value);
      }
      base.set("maximum_stiffness", valueOf(logarithms, "spring") + valueOf(logarithms, "relaxing"));
    }
    if (hasFriction()) {
      setFriction(base, logarithms, found.stiffness);
    }
    return base;
  }

  // M4 and M5 have K_n at the turning point, where a dashpot has no force. Losses are computed in closed form.
  void setFriction(Specification& base, const Eigen::VectorXd& logarithms, double peak_stiffness) const {
    const double z2 = valueOf(logarithms, "friction_displacement");
    const element::BergFriction friction(valueOf(logarithms, "friction_stiffness") * z2, z2, 0.0);
    const double amplitude = base.at("nominal_amplitude");
    const double omega = 2.0 * element::kPi * base.at("nominal_frequency");
    double viscous = 0.0;  // viscous loss stiffness [N/m]
    if (model_ == Model::friction_dashpot) {
      viscous = omega * valueOf(logarithms, "damping");
    } else if (model_ == Model::berg) {
      const double ratio = base.at("nominal_frequency") / base.at("break_frequency");
      viscous = valueOf(logarithms, "relaxing") / (ratio + 1.0 / ratio);
    }
    const double loss = viscous + friction.settledLoss(amplitude) / (element::kPi * amplitude * amplitude);
    const double stiffness = model_ == Model::berg
                                 ? peak_stiffness
                                 : valueOf(logarithms, "spring") + friction.settledForce(amplitude) / amplitude;
    base.set("dynamic_stiffness", stiffness);
    base.set("loss_angle", std::asin(loss / stiffness));
    if (model_ != Model::friction) {
      base.set("viscous_share", viscous / loss);
    }
  }

  Model model_;
  const Specification& given_;
  const FitEntries& add_;
  std::vector<FitNumber> numbers_;
};

}  // namespace

Resolved fitPoints(Model model, const Specification& specification, const FitEntries& add) {
  element::refuseIf(model == Model::elements,
                    "points: the model elements has no parameters to estimate; accepted: any other model");
  return PointFit(model, specification, add).fit();
}

}  // namespace rubber_suspension::estimation
