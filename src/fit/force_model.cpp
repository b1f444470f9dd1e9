// Simulated force over unknown parameters.
#include "fit/force_model.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>

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

// The parameters of an element that are sought.
std::vector<element::ParameterInfo> ForceModel::freeOf(const element::ElementDescription& element) const {
  std::vector<element::ParameterInfo> free;
  for (const element::ParameterInfo& parameter : element::findElementType(element.type)->parameters) {
    const bool held = std::find(held_.begin(), held_.end(), element.type + "." + parameter.name) != held_.end();
    if (!held && element::isFree(parameter, element.list(parameter.name))) {
      free.push_back(parameter);
    }
  }
  return free;
}

void ForceModel::addNonlinear(Part& part, std::size_t position, const element::ParameterInfo& parameter) {
  part.unknowns.push_back(static_cast<Eigen::Index>(nonlinear_.size()));
  nonlinear_.push_back(makeUnknown(position, parameter, elements_[position].value(parameter.name), scales_));
}

void ForceModel::addWhole() {
  Part part;
  part.elements = elements_;
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    for (const element::ParameterInfo& parameter : freeOf(elements_[i])) {
      addNonlinear(part, i, parameter);
    }
  }
  parts_.push_back(std::move(part));
}

// A column for each parameter that scales a force of the element, where all of these are free.
void ForceModel::addElement(std::size_t position) {
  const element::ElementDescription& element = elements_[position];
  const auto scales = [&](const element::ParameterInfo& parameter) {
    return parameter.role == element::Role::scale && element.value(parameter.name) != 0.0;
  };
  const auto& table = element::findElementType(element.type)->parameters;
  const std::vector<element::ParameterInfo> free = freeOf(element);
  std::vector<element::ParameterInfo> scaling;
  std::copy_if(free.begin(), free.end(), std::back_inserter(scaling), scales);
  if (static_cast<std::ptrdiff_t>(scaling.size()) < std::count_if(table.begin(), table.end(), scales)) {
    scaling.clear();
  }
  Part part;
  part.elements = {element};
  for (const element::ParameterInfo& parameter : free) {
    if (scaling.empty() || !scales(parameter)) {
      addNonlinear(part, position, parameter);
    }
  }
  if (scaling.empty()) {
    parts_.push_back(part);
  }
  for (const element::ParameterInfo& parameter : scaling) {
    Part alone = part;
    for (const element::ParameterInfo& other : scaling) {
      if (other.name != parameter.name) {
        alone.elements[0].values[other.name] = {0.0};
      }
    }
    alone.column = static_cast<Eigen::Index>(linear_.size());
    parts_.push_back(std::move(alone));
    linear_.push_back(makeUnknown(position, parameter, element.value(parameter.name), scales_));
    signed_columns_.push_back(parameter.range.lower < 0.0);
  }
}

// The columns after those of the elements.
void ForceModel::addRig(const std::vector<Eigen::MatrixXd>& rig) {
  Eigen::Index column = static_cast<Eigen::Index>(linear_.size());
  const Eigen::Index columns =
      std::accumulate(rig.begin(), rig.end(), column + 1,
                      [](Eigen::Index sum, const Eigen::MatrixXd& of_log) { return sum + of_log.cols(); });
  signed_columns_.resize(static_cast<std::size_t>(columns), true);
  basis_ = Eigen::MatrixXd::Zero(size_, columns);
  basis_.col(column++).setOnes();
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    basis_.block(row, column, rig[i].rows(), rig[i].cols()) = rig[i];
    row += static_cast<Eigen::Index>(logs_[i].stamp.size());
    column += rig[i].cols();
  }
}

Eigen::VectorXd ForceModel::simulate(const Part& part, const Eigen::VectorXd& values) const {
  std::vector<element::ElementDescription> elements = part.elements;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Unknown& unknown = nonlinear_[static_cast<std::size_t>(part.unknowns[static_cast<std::size_t>(i)])];
    elements[elements.size() == 1 ? 0 : unknown.element].values[unknown.name] = {unknown.toValue(values[i])};
  }
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

void ForceModel::evaluate(const Eigen::VectorXd& search) {
  rest_ = Eigen::VectorXd::Zero(size_);
  for (Part& part : parts_) {
    const Eigen::VectorXd values = search(part.unknowns);
    if (part.force.size() != size_ || values != part.values) {
      part.force = simulate(part, values);
      part.values = values;
    }
    if (part.column < 0) {
      rest_ += part.force;
    } else {
      basis_.col(part.column) = part.force;
    }
  }
}

Eigen::VectorXd ForceModel::derivative(const Eigen::VectorXd& search, Eigen::Index unknown,
                                       const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(size_);
  for (const Part& part : parts_) {
    if (std::find(part.unknowns.begin(), part.unknowns.end(), unknown) == part.unknowns.end()) {
      continue;
    }
    double step = 1e-6;  // of ln(value): truncation 1e-6 and rounding 1e-10, both relative
    const auto moved = [&] {
      const Eigen::VectorXd place = search + step * Eigen::VectorXd::Unit(search.size(), unknown);
      return simulate(part, place(part.unknowns));
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
  return sum;
}

}  // namespace rubber_suspension::fit
