// Simulated force as a function of unknown parameters.
#include "fit/force_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>

#include "element/each.h"
#include "kernel/maxwell_forces.h"
#include "kernel/sample_checks.h"
#include "log/even_blocks.h"
#include "numerics/bounded_least_squares.h"
#include "numerics/difference_quotient.h"
#include "numerics/gram.h"
#include "numerics/least_squares.h"
#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/element/catalogue.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kSearchReach = 1e3;  // factor above and below the given value where the log implies no scale
constexpr double kStartReach = 10.0;
constexpr double kNanoseconds = 1e9;

// Scales that follow from rate, length and amplitude of the logs.
struct LogScales {
  double sampling_rate = 0.0;  // [Hz]
  double duration = 0.0;       // duration of the longest log [s]
  double amplitude = 0.0;      // amplitudeOf() [m]
};

bool allParallel(const std::vector<element::ElementDescription>& elements) {
  return std::all_of(elements.begin(), elements.end(), [](const element::ElementDescription& element) {
    return element::lawOf(element::makeElement(element)).action() == element::Action::adds_force;
  });
}

bool canBeMade(const std::vector<element::ElementDescription>& elements) {
  try {
    static_cast<void>(component::Component(elements));
    return true;
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// Returns the parameters of a single Maxwell element; nullopt for other elements.
std::optional<element::BasicLaws::MaxwellNumbers> maxwellOf(const std::vector<element::ElementDescription>& elements) {
  element::BasicLaws laws;
  if (elements.size() == 1) {
    const element::ElementPointer element = element::makeElement(elements.front());
    const element::ParallelElement* const law = element::parallelLaw(element);
    if (law != nullptr && !law->onRig()) {
      law->addTo(laws);
    }
  }
  const bool alone =
      laws.maxwells.size() == 1 && laws.stiffness == 0.0 && laws.damping == 0.0 && laws.frictions.empty();
  return alone ? std::optional(laws.maxwells.front()) : std::nullopt;
}

LogScales scalesOf(const std::vector<log::Log>& logs) {
  LogScales scales{0.0, 0.0, amplitudeOf(logs)};
  for (const log::Log& log : logs) {
    log::TimeSteps steps;
    steps.add(log);
    const log::EvenSteps even = steps.evenSteps();
    const double rate = static_cast<double>(log.size() - 1 - even.gaps) / even.duration;
    scales.sampling_rate = std::max(scales.sampling_rate, rate);
    scales.duration = std::max(scales.duration, even.duration);
  }
  return scales;
}

// Returns the range of a value with this unit that the logs can show.
Reach reachOf(const std::string& unit, double given, const LogScales& scales) {
  const auto& [rate, duration, amplitude] = scales;
  if (unit == "Hz") {
    return {0.05 / duration, 0.5 * rate, 1.0 / duration, 0.2 * rate};
  }
  if (unit == "m") {
    return {1e-3 * amplitude, 100.0 * amplitude, amplitude / 30.0, 10.0 * amplitude};
  }
  if (unit == "s") {
    return {0.2 / rate, 20.0 * duration, given / kStartReach, given * kStartReach};
  }
  return {given / kSearchReach, given * kSearchReach, given / kStartReach, given * kStartReach};
}

Unknown unknownOf(std::size_t position, const element::ParameterInfo& parameter, double given,
                  const LogScales& scales) {
  const element::Range& range = parameter.range;
  const bool logarithmic = range.lower >= 0.0;
  const double scale = logarithmic ? 1.0 : std::max(std::abs(given), 1e-3);
  Reach reach{-kSearchReach * scale, kSearchReach * scale, -2.0 * scale, 2.0 * scale};
  if (logarithmic) {
    reach = reachOf(parameter.unit, given, scales);
  }
  reach.lower = std::max(std::min(reach.lower, given), range.lower);
  reach.upper = std::min(std::max(reach.upper, given), range.upper * (range.open_upper ? 1.0 - 1e-9 : 1.0));
  Unknown unknown{reach, position, parameter.name, parameter.unit, given, logarithmic, scale, false};
  for (double* const limit : {&unknown.lower, &unknown.upper, &unknown.start_lower, &unknown.start_upper}) {
    *limit = unknown.toSearch(std::clamp(*limit, reach.lower, reach.upper));
  }
  return unknown;
}

// Returns the unknown parameters of an element. Parameters that scale its force are linear unless one of them is fixed.
std::vector<Unknown> unknownsOf(std::size_t position, const element::ElementDescription& element,
                                const std::vector<std::string>& held, const LogScales& scales) {
  std::vector<Unknown> unknowns;
  bool all_scales = true;
  for (const element::ParameterInfo& parameter : element::findElementType(element.type)->parameters) {
    const bool is_scale = parameter.role == element::Role::scale && element.value(parameter.name) != 0.0;
    const bool is_held = std::find(held.begin(), held.end(), element.type + "." + parameter.name) != held.end();
    if (!is_held && element::isFree(parameter, element.list(parameter.name))) {
      unknowns.push_back(unknownOf(position, parameter, element.value(parameter.name), scales));
      unknowns.back().linear = is_scale;
    } else {
      all_scales = all_scales && !is_scale;
    }
  }
  for (Unknown& unknown : unknowns) {
    unknown.linear = unknown.linear && all_scales;
  }
  return unknowns;
}

}  // namespace

double amplitudeOf(const std::vector<log::Log>& logs) {
  double amplitude = 0.0;
  for (const log::Log& log : logs) {
    const auto [low, high] = std::minmax_element(log.displacement.begin(), log.displacement.end());
    amplitude = std::max(amplitude, 0.5 * (*high - *low));
  }
  return amplitude;
}

ForceModel::ForceModel(std::vector<element::ElementDescription> elements, const std::vector<log::Log>& logs,
                       const Compared& compared, const std::vector<std::string>& held,
                       const std::vector<Eigen::MatrixXd>& rig)
    : elements_(std::move(elements)), logs_(logs), compared_(compared), unit_(compared.force.squaredNorm()) {
  const LogScales scales = scalesOf(logs);
  const bool apart = allParallel(elements_);
  Part whole{elements_, {}};
  for (std::size_t i = 0; i < elements_.size(); ++i) {
    const std::vector<Unknown> unknowns = unknownsOf(i, elements_[i], held, scales);
    if (apart) {
      addElement(i, unknowns);
    } else {
      std::for_each(unknowns.begin(), unknowns.end(), [&](const Unknown& unknown) { addNonlinear(unknown, whole); });
    }
  }
  if (!apart) {
    parts_.push_back(std::move(whole));
  }
  makeColumns(rig);
}

void ForceModel::addNonlinear(const Unknown& unknown, Part& part) {
  part.unknowns.push_back(static_cast<Eigen::Index>(nonlinear_.size()));
  nonlinear_.push_back(unknown);
  nonlinear_.back().linear = false;
}

// Adds a column to the basis for each parameter that scales a force of the element.
void ForceModel::addElement(std::size_t position, const std::vector<Unknown>& unknowns) {
  Part part{{elements_[position]}, {}};
  for (const Unknown& unknown : unknowns) {
    if (!unknown.linear) {
      addNonlinear(unknown, part);
    }
  }
  const std::vector<Unknown> scaling = element::those(unknowns, &Unknown::linear);
  if (scaling.empty()) {
    parts_.push_back(part);
  }
  for (const Unknown& unknown : scaling) {
    Part alone = part;
    for (const Unknown& other : scaling) {
      if (other.name != unknown.name) {
        alone.elements[0].values[other.name] = {0.0};
      }
    }
    alone.column = static_cast<Eigen::Index>(linear_.size());
    parts_.push_back(std::move(alone));
    linear_.push_back(unknown);
    signed_columns_.push_back(!unknown.logarithmic);
  }
}

// The columns of the rig's errors are set only once, because they do not depend on the parameters.
void ForceModel::makeColumns(const std::vector<Eigen::MatrixXd>& rig) {
  Eigen::Index column = static_cast<Eigen::Index>(linear_.size()) + 1;
  const Eigen::Index end =
      std::accumulate(rig.begin(), rig.end(), column + 1,
                      [](Eigen::Index sum, const Eigen::MatrixXd& of_log) { return sum + of_log.cols(); });
  signed_columns_.resize(static_cast<std::size_t>(end - 1), true);
  const Eigen::Index size = std::accumulate(
      logs_.begin(), logs_.end(), Eigen::Index{0},
      [](Eigen::Index sum, const log::Log& log) { return sum + static_cast<Eigen::Index>(log.stamp.size()); });
  columns_.resize(measured().size(), end + 1 + static_cast<Eigen::Index>(nonlinear_.size()));
  columns_.col(column++).setOnes();
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < rig.size(); ++i) {
    for (const auto& of_log : rig[i].colwise()) {
      Eigen::VectorXd over_all = Eigen::VectorXd::Zero(size);
      over_all.segment(row, of_log.size()) = of_log;
      columns_.col(column++) = over_all(compared_.rows);
    }
    row += static_cast<Eigen::Index>(logs_[i].stamp.size());
  }
  all_.resize(size == measured().size() ? 0 : size);
  const std::size_t shared =
      std::accumulate(parts_.begin(), parts_.end(), std::size_t{0},
                      [](std::size_t sum, const Part& part) { return sum + part.unknowns.size(); }) -
      nonlinear_.size();
  moved_.resize(measured().size(), static_cast<Eigen::Index>(shared));
  for (const log::Log& log : logs_) {
    const std::int64_t step = log.stamp[1] - log.stamp[0];
    if (all_.size() > 0 || !kernel::allEven(log.stamp.data(), log.size() - 1, static_cast<std::uint64_t>(step))) {
      dt_.clear();
      break;
    }
    dt_.push_back(static_cast<double>(step) / kNanoseconds);
  }
}

ForceModel::Elements ForceModel::elementsAt(const Part& part, const Eigen::VectorXd& values) const {
  Elements elements = part.elements;
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const Unknown& unknown = nonlinear_[static_cast<std::size_t>(part.unknowns[static_cast<std::size_t>(i)])];
    elements[elements.size() == 1 ? 0 : unknown.element].values[unknown.name] = {unknown.toValue(values[i])};
  }
  return elements;
}

void ForceModel::simulate(const Simulation& simulation) {
  const component::Component component(simulation.elements);
  double* const begin = all_.size() > 0 ? all_.data() : simulation.force;
  double* first = begin;
  for (const log::Log& log : logs_) {
    const std::size_t size = log.stamp.size();
    component::SampleStream stream(component);
    const double* const temperature = log.temperature.empty() ? nullptr : log.temperature.data();
    const std::size_t accepted = stream.pushAll(log.stamp.data(), log.displacement.data(), temperature, size, first);
    // The force is set to 0 from the first sample without a finite force.
    std::fill(first + accepted, first + size, 0.0);
    first += size;
  }
  if (all_.size() > 0) {
    Eigen::Map<Eigen::VectorXd>(simulation.force, measured().size()) = all_(compared_.rows);
  }
}

// Simulates parts. Single Maxwell elements are simulated together, with vector instructions.
void ForceModel::simulate(const std::vector<Simulation>& simulations) {
  std::vector<element::BasicLaws::MaxwellNumbers> maxwells;
  std::vector<double*> forces;
  for (const Simulation& simulation : simulations) {
    const auto maxwell = dt_.empty() ? std::nullopt : maxwellOf(simulation.elements);
    if (maxwell) {
      maxwells.push_back(*maxwell);
      forces.push_back(simulation.force);
    } else {
      simulate(simulation);
    }
  }
  for (std::size_t i = 0; i < dt_.size(); ++i) {
    const std::vector<double>& displacement = logs_[i].displacement;
    kernel::maxwellForces(maxwells, dt_[i], displacement[0], displacement.data(), displacement.size(), forces);
    for (double*& force : forces) {
      force += displacement.size();
    }
  }
}

void ForceModel::evaluate(const Eigen::VectorXd& search) {
  std::vector<Simulation> simulations;
  for (Part& part : parts_) {
    const Eigen::VectorXd values = search(part.unknowns);
    if (!part.simulated || values != part.values) {
      part.simulated = false;
      part.force.resize(part.column < 0 ? measured().size() : 0);
      simulations.push_back({elementsAt(part, values), forceOf(part).data()});
      part.values = values;
    }
  }
  simulate(simulations);
  columns_.col(0) = measured();
  for (Part& part : parts_) {
    part.simulated = true;
    if (part.column < 0) {
      columns_.col(0) -= part.force;
    }
  }
}

void ForceModel::differentiate(const ModelFit& fit) {
  const Eigen::VectorXd& search = fit.search;
  struct Quotient {
    Part& part;
    Eigen::Index unknown;
    double step;
    Eigen::Map<Eigen::VectorXd> moved;
  };
  auto derivatives = columns_.rightCols(search.size());
  std::vector<Quotient> quotients;
  std::vector<Simulation> simulations;
  std::vector<bool> begun(nonlinear_.size());
  Eigen::Index others = 0;
  for (Part& part : parts_) {
    for (const Eigen::Index unknown : part.unknowns) {
      double* const moved =
          begun[static_cast<std::size_t>(unknown)] ? moved_.col(others++).data() : derivatives.col(unknown).data();
      begun[static_cast<std::size_t>(unknown)] = true;
      Simulation simulation{{}, moved};
      const double step = numerics::takenStep(numerics::kSearchStep, [&](double by) {
        const Eigen::VectorXd place = search + by * Eigen::VectorXd::Unit(search.size(), unknown);
        simulation.elements = elementsAt(part, place(part.unknowns));
        return canBeMade(simulation.elements);
      });
      quotients.push_back({part, unknown, step, {moved, measured().size()}});
      if (step != 0.0) {
        simulations.push_back(std::move(simulation));
      }
    }
  }
  simulate(simulations);
  for (const auto& [part, unknown, step, moved] : quotients) {
    const double factor = step == 0.0 ? 0.0 : (part.column < 0 ? 1.0 : fit.coefficients[part.column]) / step;
    if (moved.data() != derivatives.col(unknown).data()) {
      derivatives.col(unknown) += factor * (moved - forceOf(part));
    } else if (factor != 0.0) {
      derivatives.col(unknown) = factor * (moved - forceOf(part));
    } else {
      derivatives.col(unknown).setZero();
    }
  }
}

ModelFit ForceModel::fitAt(const Eigen::VectorXd& search) {
  evaluate(search);
  const Eigen::MatrixXd products = numerics::gramOf(columns_.leftCols(1 + bases()));
  products_ = products.bottomRightCorner(bases(), bases());
  ModelFit fit;
  fit.search = search;
  fit.coefficients = numerics::nonNegativeLeastSquares(products_, products.col(0).tail(bases()), signed_columns_);
  columns_.col(1 + bases()) = columns_.col(0);
  columns_.col(1 + bases()).noalias() -= columns_.middleCols(1, bases()) * fit.coefficients;
  return fit;
}

double ForceModel::at(const Eigen::VectorXd& search) {
  try {
    last_ = fitAt(search);
    return residual().squaredNorm();
  } catch (const std::invalid_argument&) {  // a combination of values that a law rejects
    return std::numeric_limits<double>::infinity();
  }
}

numerics::SumOfSquares::Slope ForceModel::slope() {
  std::vector<Eigen::Index> taken;  // columns of the basis whose coefficient is not fixed at zero
  for (Eigen::Index i = 0; i < last_.coefficients.size(); ++i) {
    if (last_.coefficients[i] != 0.0 || signed_columns_[static_cast<std::size_t>(i)]) {
      taken.push_back(i);
    }
  }
  differentiate(last_);
  const Eigen::Index unknowns = last_.search.size();
  const Eigen::MatrixXd products =
      numerics::productOf(columns_.rightCols(bases() + 1 + unknowns), columns_.rightCols(1 + unknowns));
  const Eigen::VectorXd scale = products_.diagonal()(taken).array().max(1e-300).rsqrt();
  const Eigen::MatrixXd of_basis = scale.asDiagonal() * products_(taken, taken) * scale.asDiagonal();
  const Eigen::MatrixXd shared = products(taken, Eigen::all).rightCols(unknowns);
  // Coefficients of the projection of the derivatives onto the basis.
  const Eigen::MatrixXd shares =
      scale.asDiagonal() * numerics::solveLeastNorm(of_basis, Eigen::MatrixXd(scale.asDiagonal() * shared));
  return {shares.transpose() * products.col(0)(taken) - products.col(0).tail(unknowns),
          products.bottomRightCorner(unknowns, unknowns) - shared.transpose() * shares};
}

Eigen::MatrixXd ForceModel::ofParameters(const ModelFit& fit, const Eigen::MatrixXd& products) {
  const Eigen::Index unknowns = fit.search.size();
  const Eigen::Index bases = fit.coefficients.size();
  Eigen::VectorXd unit = Eigen::VectorXd::Ones(unknowns + bases);
  std::vector<Eigen::Index> places;
  for (Eigen::Index i = 0; i < unknowns + bases; ++i) {
    places.push_back(i < unknowns ? products.cols() - unknowns + i : 1 + i - unknowns);
    if (i >= unknowns && fit.coefficients[i - unknowns] != 0.0) {
      unit[i] = std::abs(fit.coefficients[i - unknowns]);
    }
  }
  return unit.asDiagonal() * products(places, places) * unit.asDiagonal();
}

}  // namespace rubber_suspension::fit
