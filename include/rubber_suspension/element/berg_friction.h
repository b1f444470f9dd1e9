// Berg's friction element, with a dead band against reversals that are noise. Throws nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rubber_suspension/element/element.h"

namespace rubber_suspension::element {

/// Contains the constants of a branch to one side of the reference point, which are computed once for many samples.
struct BergSide {
  double direction = 0.0;  ///< sign of the motion; 0 without a branch, so that keepsDirection() returns false
  double left = 0.0;       ///< limit F_max or -F_max, minus the reference force [N]
  double reach = 1.0;      ///< z2 (1 - mu) or z2 (1 + mu), greater than 0 [m]

  /// Returns the change of the force [N] after an absolute travel [m] from the reference point.
  double rise(double travel) const { return travel * left / (reach + travel); }
};

/// Simulates rate-independent friction that rises smoothly from each reversal towards its maximum.
///
/// From the reference point (z_s, F_s), with mu = F_s/F_max:
///   z > z_s: F = F_s + (z - z_s)(F_max - F_s)/(z2 (1 - mu) + z - z_s)
///   z < z_s: F = F_s + (z - z_s)(F_max + F_s)/(z2 (1 + mu) - (z - z_s))
/// Once the motion has backed off from a reversal point by more than the dead band, the reversal point becomes the
/// reference point. Until then the force returns along the present branch. A dead band of 6 standard deviations of the
/// sensor noise changes peak force and loss by at most 3 %. Simulated displacements need no dead band.
/// Minor loops do not close (the element has no memory of earlier reversals); `iwan` closes them.
/// Source: M. Berg, Proc. IMechE F 211 (1997) 95-108; Vehicle System Dynamics 30 (1998) 197-212.
class BergFriction final : public ParallelElement {
 public:
  BergFriction(double maximum_force /* F_max [N] */, double displacement /* z2, half of F_max from rest [m] */,
               double dead_band /* [m] */)
      : maximum_force_(maximum_force),
        displacement_(displacement),
        dead_band_(dead_band),
        compliance_(displacement / maximum_force) {}

  double maximumForce() const { return maximum_force_; }
  double displacement() const { return displacement_; }
  double deadBand() const { return dead_band_; }
  double compliance() const { return compliance_; }  ///< z2/F_max [m/N]

  /// Layout of the memory: reference point, extremum of the displacement since that point, direction of the branch (+1,
  /// -1, or 0 at rest).
  enum Slot : std::size_t { kReferenceDisplacement, kReferenceForce, kExtremum, kDirection, kMemorySize };
  std::size_t memorySize() const override { return kMemorySize; }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override { return advance(motion.displacement, memory); }
  Part part() const override { return Part::friction; }
  bool addTo(BasicLaws& sum) const override {
    sum.frictions.push_back({maximum_force_, displacement_, dead_band_});
    return true;
  }

  /// Initialises the memory to the lower reversal point of the settled loop of an amplitude [m] about a centre [m];
  /// returns the force at that point [N], which is -settledForce(amplitude).
  double startSettled(double amplitude, double centre, double* memory) const;

  /// Advances to a displacement [m]; returns the force [N].
  double advance(double displacement, double* memory) const {
    move(displacement, memory);
    return branch(displacement, memory[kReferenceDisplacement], memory[kReferenceForce]);
  }

  /// Returns true if the motion to a displacement [m] continues in the direction of the present branch.
  bool keepsDirection(double displacement, const double* memory) const {
    return (displacement - memory[kExtremum]) * memory[kDirection] > 0.0;
  }

  /// Returns the present branch, which is empty at rest. While keepsDirection() is true, continueTo() equals advance().
  BergSide currentBranch(const double* memory) const {
    const double direction = memory[kDirection];
    // In a restored memory of unknown origin, the reference point may lie beyond the extremum.
    const bool behind = (memory[kExtremum] - memory[kReferenceDisplacement]) * direction >= 0.0;
    return behind ? side(direction, memory[kReferenceForce]) : BergSide{};
  }

  /// Returns true if the motion to a displacement [m] continues in the direction of a branch.
  static bool keepsDirection(const BergSide& branch, double displacement, const double* memory) {
    return (displacement - memory[kExtremum]) * branch.direction > 0.0;
  }

  /// Continues a branch in its direction to a displacement [m]; returns the force [N].
  static double continueTo(const BergSide& branch, double displacement, double* memory) {
    memory[kExtremum] = displacement;
    return memory[kReferenceForce] + branch.rise(std::abs(displacement - memory[kReferenceDisplacement]));
  }

  /// Advances the memory through the displacements [m] that precede the first reversal of the motion and returns the
  /// number of these displacements. branch() returns the force at each of them.
  std::size_t followUntilReversal(const double* displacement, std::size_t count, double* memory) const;

  /// Reverses the motion at a displacement [m] on the present branch, which becomes the new reference point. The caller
  /// has to set the extremum.
  void reverseAt(double reversal_point, double* memory) const {
    const double force = branch(reversal_point, memory[kReferenceDisplacement], memory[kReferenceForce]);
    memory[kReferenceForce] = std::clamp(force, -maximum_force_, maximum_force_);  // against rounding
    memory[kReferenceDisplacement] = reversal_point;
    memory[kDirection] = -memory[kDirection];
  }

  /// Returns the force [N] at a displacement [m] on the branch from a reference point.
  double branch(double displacement, double reference_displacement, double reference_force) const {
    const double travel = displacement - reference_displacement;
    return reference_force + side(travel, reference_force).rise(std::abs(travel));
  }

  /// Returns the displacement z [m] where slope z + offset + compliance F(z) = 0 on either branch from the reference
  /// point, for a slope > 0 [-], an offset [m] and a compliance [m/N]. The equation is quadratic in the travel from the
  /// reference point.
  double solveSeriesBalance(double slope, double offset, double compliance, const double* memory) const;

  /// Returns the peak force F_f0 [N] of the settled loop at an amplitude [m].
  double settledForce(double amplitude) const;

  /// Returns the energy lost per cycle [J] of the settled loop at an amplitude [m].
  double settledLoss(double amplitude) const;

 private:
  /// Returns the branch on the side of the reference point to which a travel [m] leads. Its length z2 (1 -+ mu) equals
  /// z2/F_max times the distance of the reference force from the limit.
  BergSide side(double travel, double reference_force) const {
    // Avoids 0/0 at the reference point if friction is at its maximum there.
    constexpr double kTiny = std::numeric_limits<double>::min();
    const double left = std::copysign(maximum_force_, travel) - reference_force;
    return {travel, left, compliance_ * std::abs(left) + kTiny};
  }

  /// Advances the memory to a displacement [m].
  void move(double displacement, double* memory) const {
    const double beyond = (displacement - memory[kExtremum]) * memory[kDirection];
    if (beyond > 0.0) {
      memory[kExtremum] = displacement;
    } else if (beyond < 0.0 || memory[kDirection] == 0.0) {
      reverse(displacement, -beyond, memory);
    }
  }

  /// Starts a branch at the rest position, or at the extremum once the motion has backed off from it by more than the
  /// dead band.
  void reverse(double displacement, double travel_back, double* memory) const {
    if (memory[kDirection] == 0.0) {
      if (displacement != memory[kReferenceDisplacement]) {
        memory[kDirection] = displacement > memory[kReferenceDisplacement] ? 1.0 : -1.0;
        memory[kExtremum] = displacement;
      }
    } else if (travel_back > dead_band_) {
      reverseAt(memory[kExtremum], memory);
      memory[kExtremum] = displacement;
    }
  }

  double maximum_force_;
  double displacement_;
  double dead_band_;
  double compliance_;  // z2/F_max [m/N]
};

}  // namespace rubber_suspension::element
