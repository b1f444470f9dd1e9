// Columns in the least-squares system, and priors, of the nuisance parameters of a log.
#include "fit/free_in_log.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "numerics/least_squares.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::fit {

StoredForces::StoredForces(const gap::Forces& forces) {
  double largest = 0.0;
  for (const Eigen::VectorXd& force : forces) {
    largest = std::max(largest, force.size() > 0 ? force.cwiseAbs().maxCoeff() : 0.0);
  }
  largest_ = largest > 0.0 && std::isfinite(largest) ? largest : 1.0;
  for (const Eigen::VectorXd& force : forces) {
    shapes_.push_back((force / largest_).cast<float>());
  }
}

StoredForces StoredForces::without(std::size_t log) const {
  StoredForces others = *this;
  others.shapes_.erase(others.shapes_.begin() + static_cast<std::ptrdiff_t>(log));
  return others;
}

std::vector<Eigen::Index> PerLogNuisances::placesIn(const PerLogNuisances& all) const {
  std::vector<Eigen::Index> places;
  Eigen::Index next = 0;
  const auto take = [&](bool has, bool of_all, Eigen::Index count) {
    for (Eigen::Index i = 0; i < (of_all ? count : 0); ++i, ++next) {
      if (has) {
        places.push_back(next);
      }
    }
  };
  take(trend, all.trend, kTrendsPerLog);
  take(by_zero != nullptr, all.by_zero != nullptr, 1);
  take(by_factor != nullptr, all.by_factor != nullptr, 1);
  take(offset, all.offset, 1);
  take(gain, all.gain, 1);
  return places;
}

Eigen::MatrixXd PerLogNuisances::columns(const log::Record& record, std::size_t place,
                                         const Eigen::VectorXd& simulated) const {
  Eigen::MatrixXd columns(record.size(), count());
  if (trend) {
    const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(record.size(), 0.0, 1.0);
    columns.col(0) = time - 0.5;
    const Eigen::ArrayXd once = (element::kPi * time).cos();
    columns.col(1) = once;
    columns.col(2) = 2.0 * once.square() - 1.0;
    for (Eigen::Index k = 3; k < kTrendsPerLog; ++k) {  // Chebyshev's recursion: cos(k a) from the two preceding ones
      columns.col(k) = 2.0 * once * columns.col(k - 1).array() - columns.col(k - 2).array();
    }
    columns.leftCols(kTrendsPerLog) *= record.force_deviation;
  }
  if (by_zero) {
    columns.col(trend ? kTrendsPerLog : 0) = (*by_zero)[place];
  }
  if (by_factor) {
    columns.col(placeOfFactor()) = (*by_factor)[place];
  }
  if (offset) {
    columns.col(placeOfOffset()).setConstant(record.force_deviation);
  }
  if (gain) {
    columns.col(placeOfGain()) = simulated;
  }
  return columns;
}

Eigen::VectorXd PerLogNuisances::costs(const gap::PreparedRecord& record) const {
  constexpr double kWalk = 0.1;  // standard deviation of the trend, relative to the force
  constexpr double kGain = 0.5;  // standard deviation of gains and friction's factor; prefers a law of the same effect
  constexpr double kBelowMotion = 0.5;  // share of the motion's lowest frequency; faster forces are the component's
  constexpr double kNone = 1e6;         // cost that excludes a half cosine
  Eigen::VectorXd costs = Eigen::VectorXd::Zero(count());
  if (trend) {
    costs[0] = record.rig.one_deviation / kWalk;
    costs.segment(1, kTrendsPerLog - 1) =
        costs[0] * Eigen::VectorXd::LinSpaced(kTrendsPerLog - 1, 1.0, static_cast<double>(kTrendsPerLog - 1));
    const double half_cosines = 2.0 * record.duration() * kBelowMotion * record.lowest_frequency;
    for (Eigen::Index k = 1; k < kTrendsPerLog; ++k) {
      costs[k] = static_cast<double>(k) > half_cosines ? kNone : costs[k];
    }
  }
  if (by_zero) {
    costs[trend ? kTrendsPerLog : 0] = 1.0;
  }
  if (by_factor) {
    costs[placeOfFactor()] = record.rig.one_deviation / kGain;
  }
  if (gain) {
    costs[placeOfGain()] = record.rig.one_deviation / kGain;
  }
  return costs;
}

gap::OwnUnknowns PerLogNuisances::unknowns(const gap::PreparedRecord& record, std::size_t place,
                                           const Eigen::VectorXd& simulated) const {
  const double force = std::pow(record.force_deviation, 2) * record.counted();
  return {columns(record, place, simulated), force * costs(record).cwiseAbs2()};
}

gap::PreparedRecord PerLogNuisances::addedTo(const gap::PreparedRecord& record, std::size_t place,
                                             const Eigen::VectorXd& simulated) const {
  constexpr double kWide = 1e3;  // standard deviation of parameters without a prior, relative to the force
  gap::PreparedRecord result = record;
  if (!any()) {
    return result;
  }
  const Eigen::MatrixXd known = numerics::columnsOfWhitening(record.rig.columns);
  Eigen::MatrixXd all(record.size(), known.cols() + count());
  all.leftCols(known.cols()) = known;
  auto own = all.rightCols(count());
  own = columns(record, place, simulated) / (record.force_deviation * std::sqrt(record.counted())) *
        costs(record).cwiseMax(1.0 / kWide).cwiseInverse().asDiagonal();
  if (record.counts.size() > 0) {
    own.array().colwise() *= record.counts.array();
  }
  result.rig.columns = numerics::whiteningColumns(all);
  return result;
}

gap::Forces byZero(const std::vector<element::ElementDescription>& elements,
                   const std::vector<gap::PreparedRecord>& records) {
  constexpr double kStep = 0.1;  // in standard deviations
  gap::Forces columns = gap::simulate(elements, records);
  const auto moved = gap::simulate(elements, records, [&](const gap::PreparedRecord& record) -> Eigen::VectorXd {
    return record.displacement.array() - kStep * record.rig.displacement_zero;
  });
  for (std::size_t r = 0; r < records.size(); ++r) {
    columns[r] = (moved[r] - columns[r]) / (kStep * records[r].rig.one_deviation);
    columns[r].array() -= columns[r].mean();
  }
  return columns;
}

gap::Forces frictionOf(const std::vector<element::ElementDescription>& elements,
                       const std::vector<gap::PreparedRecord>& records) {
  std::vector<element::ElementDescription> others;
  std::copy_if(elements.begin(), elements.end(), std::back_inserter(others), [](const auto& description) {
    const element::ElementPointer element = element::makeElement(description);
    const element::ParallelElement* const parallel = element::parallelLaw(element);
    return parallel == nullptr || parallel->part() != element::Part::friction;
  });
  gap::Forces forces = gap::simulate(elements, records);
  const gap::Forces without = gap::simulate(others, records);
  for (std::size_t r = 0; r < forces.size(); ++r) {
    forces[r] -= without[r];
  }
  return forces;
}

}  // namespace rubber_suspension::fit
