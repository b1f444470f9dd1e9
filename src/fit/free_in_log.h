// Unknowns of each log alone, which no model run reproduces.
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
  bool trend = false;   ///< a slow trend
  bool offset = false;  ///< a zero of the force, over its standard deviation
  bool gain = false;    ///< a gain of the force's channel
  /// A zero of the displacement, by what it does to the force of each log [N], as byZero() gives it; null: it is none.
  ForceColumn by_zero = nullptr;
  /// A factor on friction, by the friction of each log [N], as frictionOf() gives it; null: it is none.
  ForceColumn by_factor = nullptr;

  bool any() const { return trend || offset || gain || by_zero || by_factor; }
  /// Common parts of the terms for all logs, too.
  bool ofTerms() const { return offset || gain; }
  Eigen::Index count() const {
    return (trend ? kTrendsPerLog : 0) + (by_zero ? 1 : 0) + (by_factor ? 1 : 0) + (offset ? 1 : 0) + (gain ? 1 : 0);
  }

  friend PerLogNuisances operator|(const PerLogNuisances& one, const PerLogNuisances& other) {
    return {one.trend || other.trend, one.offset || other.offset, one.gain || other.gain,
            one.by_zero ? one.by_zero : other.by_zero, one.by_factor ? one.by_factor : other.by_factor};
  }
  /// Both have it; the zero of the displacement and the factor are those of the other.
  friend PerLogNuisances operator&(const PerLogNuisances& one, const PerLogNuisances& other) {
    return {one.trend && other.trend, one.offset && other.offset, one.gain && other.gain,
            one.by_zero ? other.by_zero : nullptr, one.by_factor ? other.by_factor : nullptr};
  }

  /// Places of its unknowns among those of one that has them all, and maybe more.
  std::vector<Eigen::Index> placesIn(const PerLogNuisances& all) const;
  /// Index of the factor among its unknowns, if it is one of them.
  Eigen::Index placeOfFactor() const { return count() - (gain ? 1 : 0) - (offset ? 1 : 0) - 1; }
  Eigen::Index placeOfOffset() const { return count() - (gain ? 2 : 1); }
  Eigen::Index placeOfGain() const { return count() - 1; }

  /// Their columns over the samples of a log, by its place among all [N]. `simulated`: the model's force on it, which a
  /// gain changes.
  Eigen::MatrixXd columns(const log::Record& record, std::size_t place, const Eigen::VectorXd& simulated) const;

  /// Prior cost of each column as an error, at the size of the force; 0 without a prior. Half cosines have the prior of
  /// a random walk with the default tolerance of offsets, because free ones would predict nothing between the samples
  /// of the fit; those within an octave of the motion, or faster, are left out.
  Eigen::VectorXd costs(const gap::PreparedRecord& record) const;

  /// Both, the error as a penalty [N^2].
  gap::OwnUnknowns unknowns(const gap::PreparedRecord& record, std::size_t place,
                            const Eigen::VectorXd& simulated) const;

  /// The record with these among the nuisances: what the rig may have added to it (gap::PreparedRecord::withoutRig).
  gap::PreparedRecord addedTo(const gap::PreparedRecord& record, std::size_t place,
                              const Eigen::VectorXd& simulated) const;
};

/// The effect of one standard deviation of the displacement's zero (gap::RigPrior) on the force of elements on each
/// record [N], its mean taken out, which is a zero of the force; over what it counts as.
gap::Forces byZero(const std::vector<element::ElementDescription>& elements,
                   const std::vector<gap::PreparedRecord>& records);

/// The force of all friction of a component on each record [N]: what it has more than without these elements.
gap::Forces frictionOf(const std::vector<element::ElementDescription>& elements,
                       const std::vector<gap::PreparedRecord>& records);

}  // namespace rubber_suspension::fit
