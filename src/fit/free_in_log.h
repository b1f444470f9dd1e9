// Nuisance parameters of single logs, which no simulation of the model reproduces.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "gap/simulate.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/gap/prepared_record.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Forces in single precision, which halves the memory of a search. It rounds each by 6e-8 of its value, while the
/// noise of logs is near 1e-3.
class StoredForces {
 public:
  explicit StoredForces(const gap::Forces& forces);

  std::size_t size() const { return shapes_.size(); }
  /// Returns an expression for the force on a log [N].
  auto operator[](std::size_t log) const { return largest_ * shapes_[log].cast<double>(); }
  /// Returns the forces without those on one log.
  StoredForces without(std::size_t log) const;

 private:
  double largest_ = 1.0;  // a displacement of 1 nm to the fifth power would be too small a number
  std::vector<Eigen::VectorXf> shapes_;
};

/// Derivative of the force with respect to a parameter; null if it is zero everywhere.
using ForceColumn = std::shared_ptr<const StoredForces>;

inline ForceColumn columnOf(const gap::Forces& forces) { return std::make_shared<const StoredForces>(forces); }

/// Number of parameters of the slow trend of a log: a ramp and eight half cosines, all with a mean of 0.
constexpr Eigen::Index kTrendsPerLog = 9;

/// Nuisance parameters of each log that a hypothesis fits, in this order: trend, displacement offset, factor on
/// friction, force offset, gain.
struct PerLogNuisances {
  bool trend = false;   ///< ramp and half cosines
  bool offset = false;  ///< force offset, in units of the offset's standard deviation
  bool gain = false;    ///< gain of the force channel
  /// Force of each log [N] due to a displacement offset, from byZero(); null if this offset is not fitted.
  ForceColumn by_zero = nullptr;
  /// Friction of each log [N], from frictionOf(), on which a factor acts; null if this factor is not fitted.
  ForceColumn by_factor = nullptr;

  bool any() const { return trend || offset || gain || by_zero || by_factor; }
  /// Returns true if a term that all logs share may represent the mean of some nuisance parameters over the logs.
  bool ofTerms() const { return offset || gain; }
  Eigen::Index count() const {
    return (trend ? kTrendsPerLog : 0) + (by_zero ? 1 : 0) + (by_factor ? 1 : 0) + (offset ? 1 : 0) + (gain ? 1 : 0);
  }

  friend PerLogNuisances operator|(const PerLogNuisances& one, const PerLogNuisances& other) {
    return {one.trend || other.trend, one.offset || other.offset, one.gain || other.gain,
            one.by_zero ? one.by_zero : other.by_zero, one.by_factor ? one.by_factor : other.by_factor};
  }
  /// Returns the nuisance parameters that `one` and `other` have in common, with the pointers of `other`.
  friend PerLogNuisances operator&(const PerLogNuisances& one, const PerLogNuisances& other) {
    return {one.trend && other.trend, one.offset && other.offset, one.gain && other.gain,
            one.by_zero ? other.by_zero : nullptr, one.by_factor ? other.by_factor : nullptr};
  }

  /// Returns the indices of this object's parameters among the parameters of `all`, which has to contain them.
  std::vector<Eigen::Index> placesIn(const PerLogNuisances& all) const;
  /// Returns the index of the factor on friction among the parameters, provided that the factor is fitted.
  Eigen::Index placeOfFactor() const { return count() - (gain ? 1 : 0) - (offset ? 1 : 0) - 1; }
  Eigen::Index placeOfOffset() const { return count() - (gain ? 2 : 1); }
  Eigen::Index placeOfGain() const { return count() - 1; }

  /// Returns the columns [N] of the least-squares system for the nuisance parameters over the samples of a log with
  /// index `place`. `simulated`: force of the model on this log, which is the column of a gain.
  Eigen::MatrixXd columns(const log::Record& record, std::size_t place, const Eigen::VectorXd& simulated) const;

  /// Returns the error, relative to the force, that counts as much as one unit of each parameter; 0 without a prior.
  /// Half cosines have the prior of a random walk with the default tolerance of offsets, because otherwise they predict
  /// nothing between the samples of the fit. Those above half of the motion's lowest frequency are excluded.
  Eigen::VectorXd costs(const gap::PreparedRecord& record) const;

  /// Returns columns() and the squared costs as a penalty [N^2].
  gap::OwnUnknowns unknowns(const gap::PreparedRecord& record, std::size_t place,
                            const Eigen::VectorXd& simulated) const;

  /// Returns the record with the nuisance parameters added to the errors of its rig (gap::PreparedRecord::withoutRig).
  gap::PreparedRecord addedTo(const gap::PreparedRecord& record, std::size_t place,
                              const Eigen::VectorXd& simulated) const;
};

/// Returns the force of each record [N] due to a displacement offset of one standard deviation (gap::RigPrior), divided
/// by the gap that this deviation counts as. The mean is removed, because a force offset would absorb it.
gap::Forces byZero(const std::vector<element::ElementDescription>& elements,
                   const std::vector<gap::PreparedRecord>& records);

/// Returns the force of all friction on each record [N]: the simulated force minus the force without friction elements.
gap::Forces frictionOf(const std::vector<element::ElementDescription>& elements,
                       const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::fit
