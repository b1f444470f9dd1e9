// When Berg friction reverses along a log: that depends on the displacement alone, so one look serves all parameters.
#pragma once

#include <cstddef>
#include <vector>

namespace rubber_suspension::fit {

/// Samples during which friction stays on one branch, and on one side of its reference point.
struct FrictionStretch {
  std::size_t end;         ///< sample after the last one
  double side;             ///< sign of the travel from the reference point: 1 or -1
  bool reverses;           ///< whether a branch begins; then its reference point is the reversal
  double reversal_travel;  ///< of the reversal, from the reference point of the branch before it [m], without sign
  double reversal_side;    ///< and its sign
};

/// The travel of a displacement through the branches of a BergFriction of this dead band [m], at rest at the first
/// sample.
class FrictionPath {
 public:
  FrictionPath(const std::vector<double>& displacement, double dead_band);

  /// Of each sample from its reference point [m], without sign; some zeros follow for code that takes several at once.
  const std::vector<double>& travel() const { return travel_; }
  const std::vector<FrictionStretch>& stretches() const { return stretches_; }

 private:
  std::vector<double> travel_;
  std::vector<FrictionStretch> stretches_;
};

}  // namespace rubber_suspension::fit
