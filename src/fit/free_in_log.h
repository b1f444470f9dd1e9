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

/// Derivative of the force by an unknown, per log; null: zero everywhere.
using ForceColumn = std::shared_ptr<const gap::Forces>;

inline ForceColumn columnOf(gap::Forces forces) { return std::make_shared<const gap::Forces>(std::move(forces)); }

/// Number of unknowns of the slow trend of a log: a ramp and eight half cosines, all with a mean of 0.
constexpr Eigen::Index kTrendsPerLog = 9;

/// Per-log nuisance parameters of a hypothesis, in this order: trend, offset of the displacement, factor on friction,
/// offset of the force, gain.
struct PerLogNuisances {
  bool trend = false;   ///< ramp and half cosines
  bool offset = false;  ///< an offset of the force, over its standard deviation
  bool gain = false;    ///< a gain of the force's channel
  /// Effect of an offset of the displacement on the force of each log [N], from byZero(); null: it is not free.
  ForceColumn by_zero = nullptr;
  /// Effect of a factor on friction: the friction of each log [N], from frictionOf(); null: it is not free.
  ForceColumn by_factor = nullptr;

  bool any() const { return trend || offset || gain || by_zero || by_factor; }
  /// Returns true if a term for all logs may represent the mean of some of them over the logs.
  bool ofTerms() const { return offset || gain; }
  Eigen::Index count() const {
    return (trend ? kTrendsPerLog : 0) + (by_zero ? 1 : 0) + (by_factor ? 1 : 0) + (offset ? 1 : 0) + (gain ? 1 : 0);
  }

  friend PerLogNuisances operator|(const PerLogNuisances& one, const PerLogNuisances& other) {
    return {one.trend || other.trend, one.offset || other.offset, one.gain || other.gain,
            one.by_zero ? one.by_zero : other.by_zero, one.by_factor ? one.by_factor : other.by_factor};
  }
  /// Keeps what both have; effects of the displacement's offset and of the factor are those of the other.
  friend PerLogNuisances operator&(const PerLogNuisances& one, const PerLogNuisances& other) {
    return {one.trend && other.trend, one.offset && other.offset, one.gain && other.gain,
            one.by_zero ? other.by_zero : nullptr, one.by_factor ? other.by_factor : nullptr};
  }

  /// Returns the indices of these unknowns among those of `all`, which has at least these.
  std::vector<Eigen::Index> placesIn(const PerLogNuisances& all) const;
  /// Returns the index of the factor among these unknowns, if it is one of them.
  Eigen::Index placeOfFactor() const { return count() - (gain ? 1 : 0) - (offset ? 1 : 0) - 1; }
  Eigen::Index placeOfOffset() const { return count() - (gain ? 2 : 1); }
  Eigen::Index placeOfGain() const { return count() - 1; }

  /// Returns their columns over the samples of a log, which has the index `place` [N]. `simulated`: force of the model
  /// on the log, which is the column of a gain.
  Eigen::MatrixXd columns(const log::Record& record, std::size_t place, const Eigen::VectorXd& simulated) const;

  /// Returns the error, relative to the force, that counts as much as one unit of each unknown; 0 without a prior. Half
  /// cosines have the prior of a random walk with the default tolerance of offsets, because free ones would predict
  /// nothing between the samples of the fit; those within an octave of the motion, or faster, are excluded.
  Eigen::VectorXd costs(const gap::PreparedRecord& record) const;

  /// Returns columns() and the squared costs as a penalty [N^2].
  gap::OwnUnknowns unknowns(const gap::PreparedRecord& record, std::size_t place,
                            const Eigen::VectorXd& simulated) const;

  /// Returns the record with these unknowns added to the errors of its rig (gap::PreparedRecord::withoutRig).
  gap::PreparedRecord addedTo(const gap::PreparedRecord& record, std::size_t place,
                              const Eigen::VectorXd& simulated) const;
};

/// Returns the effect of a displacement offset of one standard deviation (gap::RigPrior) on the force of each record
/// [N], per gap that it counts as. The mean is removed, because an offset of the force would absorb it.
gap::Forces byZero(const std::vector<element::ElementDescription>& elements,
                   const std::vector<gap::PreparedRecord>& records);

/// Returns the force of all friction on each record [N]: the simulated force minus that without friction elements.
gap::Forces frictionOf(const std::vector<element::ElementDescription>& elements,
                       const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::fit
