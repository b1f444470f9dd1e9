// Simulated force over unknown parameters.
#include "fit/force_model.h"

#include <algorithm>
#include <cmath>

#include "log/even_blocks.h"
#include "rubber_suspension/component/sample_stream.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kSearchReach = 1e3;  // factor to either side of the given value where the log sets no scale
constexpr double kStartReach = 10.0;

bool allParallel(const std::vector<element::ElementDescription>& elements) {
  return std::all_of(elements.begin(), elements.end(), [](const element::ElementDescription& element) {
    return element::lawOf(element::makeElement(element)).action() == element::Action::adds_force;
  });
}

LogScales scalesOf(const std::vector<log::Log>& logs) {
  LogScales scales{0.0, 0.0, amplitudeOf(logs)};
  for (const log::Log& log : logs) {
    log::TimeSteps steps;
    steps.add(log);
    const log::EvenSteps even = steps.evenSteps();
    const double duration = even.duration;
    const double rate = static_cast<double>(log.size() - 1 - even.gaps) / duration;
    scales.sampling_rate = std::max(scales.sampling_rate, rate);
    scales.duration = std::max(scales.duration, duration);
  }
  return scales;
}

// Limits that the log sets for a unit; nothing for units that it sets none for.
std::optional<std::pair<double, double>> searchLimits(const std::string& unit, const LogScales& scales) {
  if (unit == "Hz") {
    return std::make_pair(0.05 / scales.duration, 0.5 * scales.sampling_rate);
  }
  if (unit == "m") {
    return std::make_pair(1e-3 * scales.amplitude, 100.0 * scales.amplitude);
  }
  if (unit == "s") {
    return std::make_pair(0.2 / scales.sampling_rate, 20.0 * scales.duration);
  }
  return std::nullopt;
}

std::pair<double, double> startLimits(const Unknown& unknown, const LogScales& scales) {
  if (unknown.unit == "Hz") {
    return {1.0 / scales.duration, 0.2 * scales.sampling_rate};
  }
  if (unknown.unit == "m") {
    return {scales.amplitude / 30.0, 10.0 * scales.amplitude};
  }
  return {unknown.given / kStartReach, unknown.given * kStartReach};
}

Unknown makeUnknown(std::size_t position, const element::ParameterInfo& parameter, double given,
                    const LogScales& scales) {
  Unknown unknown{position, parameter.name, parameter.unit, given, parameter.range.lower >= 0.0, 1.0, 0, 0, 0, 0};
  const auto limits = searchLimits(parameter.unit, scales);
  if (unknown.logarithmic) {
    const auto [low, high] = limits.value_or(std::make_pair(given / kSearchReach, given * kSearchReach));
    const double inside = parameter.range.upper * (parameter.range.open_upper ? 1.0 - 1e-9 : 1.0);
    unknown.lower = std::max(std::min(low, given), parameter.range.lower);
    unknown.upper = std::min(std::max(high, given), inside);
    const auto [start_low, start_high] = startLimits(unknown, scales);
    unknown.start_lower = std::clamp(start_low, unknown.lower, unknown.upper);
    unknown.start_upper = std::clamp(start_high, unknown.lower, unknown.upper);
  } else {
    unknown.scale = std::max(std::abs(given), 1e-3);
    unknown.lower = std::max(parameter.range.lower, -kSearchReach * unknown.scale);
    unknown.upper = std::min(parameter.range.upper, kSearchReach * unknown.scale);
    unknown.start_lower = std::max(unknown.lower, -2.0 * unknown.scale);
    unknown.start_upper = std::min(unknown.upper, 2.0 * unknown.scale);
  }
  for (double* const limit : {&unknown.lower, &unknown.upper, &unknown.start_lower, &unknown.start_upper}) {
    *limit = unknown.toSearch(*limit);
  }
  return unknown;
}

}  // namespace

double Unknown::toSearch(double value) const { return logarithmic ? std::log(value) : value / scale; }
double Unknown::toValue(double search) const { return logarithmic ? std::exp(search) : search * scale; }

double amplitudeOf(const std::vector<log::Log>& logs) {
  double amplitude = 0.0;
  for (const log::Log& log : logs) {
    const auto [low, high] = std::minmax_element(log.displacement.begin(), log.displacement.end());
    amplitude = std::max(amplitude, 0.5 * (*high - *low));
  }
  return amplitude;
}

ForceModel::ForceModel(std::vector<element::ElementDescription> elements, const std::vector<log::Log>& logs,
                       const std::vector<std::string>& held, const std::vector<Eigen::MatrixXd>& rig)
    : elements_(std::move(elements)), logs_(logs), held_(held), scales_(scalesOf(logs)) {
  for (const log::Log& log : logs_) {
    size_ += static_cast<Eigen::Index>(log.stamp.size());
  }
  if (allParallel(elements_)) {
    for (std::size_t i = 0; i < elements_.size(); ++i) {
      addElement(i);
    }
  } else {
    addWhole();
  }
  addRig(rig);
}

void ForceModel::addRig(const std::vector<Eigen::MatrixXd>& rig) {
  Eigen::Index columns = 1;
  for (const Eigen::MatrixXd& of_log : rig) {
    columns += of_log.cols();
  }
  rig_ = Eigen::MatrixXd::Zero(size_, columns);
  rig_.col(0).setOnes();
  Eigen::Index row = 0;
  Eigen::Index column = 1;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    rig_.block(row, column, rig[i].rows(), rig[i].cols()) = rig[i];
    row += static_cast<Eigen::Index>(logs_[i].stamp.size());
    column += rig[i].cols();
  }
  signed_columns_.insert(signed_columns_.end(), static_cast<std::size_t>(columns), true);
}

bool ForceModel::isHeld(const element::ElementDescription& element, const element::ParameterInfo& parameter) const {
  return !element::isFree(parameter, element.list(parameter.name)) ||
         std::find(held_.begin(), held_.end(), element.type + "." + parameter.name) != held_.end();
}

void ForceModel::addNonlinear(Part& part, std::size_t position, const element::ParameterInfo& parameter) {
  part.unknowns.push_back(nonlinear_.size());
  nonlinear_.push_back(makeUnknown(position, parameter, elements_[position].value(parameter.name), scales_));
}

void ForceModel::addColumn(Part part, std::size_t position, const element::ParameterInfo& parameter) {
  part.column = static_cast<Eigen::Index>(signed_columns_.size());
  signed_columns_.push_back(parameter.range.lower < 0.0);
  linear_.push_back(makeUnknown(position, parameter, elements_[position].value(parameter.name), scales_));
  parts_.push_back(std::move(part));
}

void ForceModel::addWhole() {
  Part part;
  part.elements = elements_;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    part.positions.push_back(i);
    for (const element::ParameterInfo& parameter : element::findElementType(elements_[i].type)->parameters) {
      if (!isHeld(elements_[i], parameter)) {
        addNonlinear(part, i, parameter);
      }
    }
  }
  parts_.push_back(std::move(part));
}

void ForceModel::addElement(std::size_t position) {
  const element::ElementDescription& element = elements_[position];
  Part part;
  part.elements = {element};
  part.positions = {position};
  std::vector<element::ParameterInfo> scaling;
  bool scaling_held = false;
  for (const element::ParameterInfo& parameter : element::findElementType(element.type)->parameters) {
    const bool linear = parameter.role == element::Role::scale;
    if (linear && element.value(parameter.name) != 0.0) {
      scaling.push_back(parameter);
      scaling_held = scaling_held || isHeld(element, parameter);
    } else if (!linear && !isHeld(element, parameter)) {
      addNonlinear(part, position, parameter);
    }
  }
  if (scaling.empty() || scaling_held) {
    for (const element::ParameterInfo& parameter : scaling) {
      if (!isHeld(element, parameter)) {
        addNonlinear(part, position, parameter);
      }
    }
    parts_.push_back(std::move(part));
    return;
  }
  for (const element::ParameterInfo& parameter : scaling) {
    Part alone = part;
    for (const element::ParameterInfo& other : scaling) {
      if (other.name != parameter.name) {
        alone.elements[0].values[other.name] = {0.0};
      }
    }
    addColumn(std::move(alone), position, parameter);
  }
}

Eigen::VectorXd ForceModel::simulate(const std::vector<element::ElementDescription>& elements) const {
  const component::Component component(elements);
  Eigen::VectorXd force = Eigen::VectorXd::Zero(size_);
  double* first = force.data();
  for (const log::Log& log : logs_) {
    const std::size_t size = log.stamp.size();
    component::SampleStream stream(component);
    // A sample without a finite force, and all after it, counts as none at all.
    if (component.shiftsWithTemperature() && !log.temperature.empty()) {
      stream.pushAll(log.stamp.data(), log.displacement.data(), log.temperature.data(), size, first);
    } else {
      stream.pushAll(log.stamp.data(), log.displacement.data(), size, first);
    }
    first += size;
  }
  return force;
}

std::vector<double> ForceModel::valuesOf(const Part& part, const Eigen::VectorXd& search) const {
  std::vector<double> values;
  for (const std::size_t unknown : part.unknowns) {
    values.push_back(search[static_cast<Eigen::Index>(unknown)]);
  }
  return values;
}

Eigen::VectorXd ForceModel::simulate(const Part& part, const std::vector<double>& values) const {
  std::vector<element::ElementDescription> elements = part.elements;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const Unknown& unknown = nonlinear_[part.unknowns[i]];
    const auto at = std::find(part.positions.begin(), part.positions.end(), unknown.element) - part.positions.begin();
    elements[static_cast<std::size_t>(at)].values[unknown.name] = {unknown.toValue(values[i])};
  }
  return simulate(elements);
}

bool ForceModel::simulateIfChanged(Part& part, const Eigen::VectorXd& search) const {
  std::vector<double> values = valuesOf(part, search);
  if (part.force.size() == size_ && values == part.values) {
    return false;
  }
  part.force = simulate(part, values);
  part.values = std::move(values);
  return true;
}

Eigen::VectorXd ForceModel::derivative(const Eigen::VectorXd& search, Eigen::Index unknown,
                                       const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(size_);
  for (const Part& part : parts_) {
    if (std::find(part.unknowns.begin(), part.unknowns.end(), static_cast<std::size_t>(unknown)) !=
        part.unknowns.end()) {
      double step = 1e-6;  // of ln(value): truncation 1e-6 and rounding 1e-10, both relative
      const auto moved = [&] {
        return simulate(part, valuesOf(part, search + step * Eigen::VectorXd::Unit(search.size(), unknown)));
      };
      Eigen::VectorXd force;
      try {
        force = moved();
      } catch (const std::invalid_argument&) {  // beyond the border of what the law accepts
        step = -step;
        force = moved();
      }
      const double coefficient = part.column < 0 ? 1.0 : coefficients[part.column];
      sum += coefficient / step * (force - part.force);
    }
  }
  return sum;
}

void ForceModel::evaluate(const Eigen::VectorXd& search) {
  if (basis_.rows() != size_) {
    basis_.resize(size_, static_cast<Eigen::Index>(signed_columns_.size()));
    basis_.rightCols(rig_.cols()) = rig_;
  }
  rest_ = Eigen::VectorXd::Zero(size_);
  for (Part& part : parts_) {
    const bool changed = simulateIfChanged(part, search);
    if (part.column < 0) {
      rest_ += part.force;
    } else if (changed) {
      basis_.col(part.column) = part.force;
    }
  }
}

}  // namespace rubber_suspension::fit
