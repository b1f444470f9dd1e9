// Berg's friction element, with a dead band against reversals that are noise. Throws nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "rubber_suspension/element/element.h"

namespace rubber_suspension::element {

/// The side of a branch's reference point that the motion is on, made ready for many samples.
struct BergSide {
  double direction = 0.0;  ///< of the motion; 0: there is no branch, and no motion keeps it
  double left = 0.0;       ///< difference of the reference force to F_max or -F_max [N]
  double reach = 1.0;      ///< z2 (1 -+ mu), kept above 0 [m]

  /// Change of the force [N] over an absolute travel [m] from the reference point.
  double rise(double travel) const { return travel * left / (reach + travel); }
};

/// Rate-independent friction that rises smoothly from each reversal towards its maximum.
///
/// From the reference point (z_s, F_s), with mu = F_s/F_max:
///   z > z_s: F = F_s + (z - z_s)(F_max - F_s)/(z2 (1 - mu) + z - z_s)
///   z < z_s: F = F_s + (z - z_s)(F_max + F_s)/(z2 (1 + mu) - (z - z_s))
/// The reference point moves to the reversal point once the motion has backed off from it by more than the dead band;
/// until then the force goes back along the branch that it came from. With sensor noise of standard deviation sigma a
/// dead band of 6 sigma keeps peak force and loss within 3 % (0 for simulated displacements).
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

  /// Layout of the memory: reference point, running extremum since it, direction of the branch (+1, -1, 0 at rest).
  enum Slot : std::size_t { kReferenceDisplacement, kReferenceForce, kExtremum, kDirection, kMemorySize };
  std::size_t memorySize() const override { return kMemorySize; }
  double initialise(double displacement, double* memory) const override;
  double step(const Motion& motion, double* memory) const override { return advance(motion.displacement, memory); }
  Part part() const override { return Part::friction; }
  bool addTo(BasicLaws& sum) const override {
    sum.frictions.push_back({maximum_force_, displacement_, dead_band_});
    return true;
  }

  /// Starts on the settled loop of this amplitude at its lower reversal point: z = centre - amplitude, F = -F_f0.
  double startSettled(double amplitude, double centre, double* memory) const;

  /// Advances to a displacement [m]; returns the force [N]. Rate does not matter.
  double advance(double displacement, double* memory) const {
    move(displacement, memory);
    return branch(displacement, memory[kReferenceDisplacement], memory[kReferenceForce]);
  }

  /// True where the motion to a displacement [m] keeps the direction of the branch.
  bool keepsDirection(double displacement, const double* memory) const {
    return (displacement - memory[kExtremum]) * memory[kDirection] > 0.0;
  }

  /// The branch that the element is on; none at rest. Where a motion keeps its direction, continueTo() is advance().
  BergSide currentBranch(const double* memory) const {
    const double direction = memory[kDirection];
    // The reference point lies behind the extremum, unless the memory was made up.
    const bool behind = (memory[kExtremum] - memory[kReferenceDisplacement]) * direction >= 0.0;
    return behind ? side(direction, memory[kReferenceForce]) : BergSide{};
  }

  /// True where the motion to a displacement [m] keeps the direction of a branch.
  static bool keepsDirection(const BergSide& branch, double displacement, const double* memory) {
    return (displacement - memory[kExtremum]) * branch.direction > 0.0;
  }

  /// Continues a branch in its direction to a displacement [m]; returns the force [N].
  static double continueTo(const BergSide& branch, double displacement, double* memory) {
    memory[kExtremum] = displacement;
    return memory[kReferenceForce] + branch.rise(std::abs(displacement - memory[kReferenceDisplacement]));
  }

  /// Moves along displacements [m] up to, and without, the first that reverses the motion; returns how many these
  /// are. The force at each is branch().
  std::size_t followUntilReversal(const double* displacement, std::size_t count, double* memory) const;

  /// Reverses at a displacement [m] that the branch has led to: it becomes the reference point. The extremum is then
  /// the caller's to set.
  void reverseAt(double reversal_point, double* memory) const {
    const double force = branch(reversal_point, memory[kReferenceDisplacement], memory[kReferenceForce]);
    memory[kReferenceForce] = std::clamp(force, -maximum_force_, maximum_force_);  // against rounding
    memory[kReferenceDisplacement] = reversal_point;
    memory[kDirection] = -memory[kDirection];
  }

  /// Force [N] at a displacement [m] on the branch that starts at a reference point.
  double branch(double displacement, double reference_displacement, double reference_force) const {
    const double travel = displacement - reference_displacement;
    return reference_force + side(travel, reference_force).rise(std::abs(travel));
  }

  /// Displacement z [m] on the branch that the element is on, where slope z + offset + compliance F(z) = 0 for a
  /// slope > 0 [-], an offset [m] and a compliance [m/N]: with the travel w from the reference point, a quadratic
  /// equation.
  double solveSeriesBalance(double slope, double offset, double compliance, const double* memory) const;

  /// Peak force F_f0 of the settled loop at this amplitude [m], [N].
  double settledForce(double amplitude) const;

  /// Energy lost per cycle of the settled loop at this amplitude [m], [J].
  double settledLoss(double amplitude) const;

 private:
  /// The side of the reference point that a travel [m] leads to: both branches in one. z2 (1 -+ mu) is z2/F_max times
  /// the force that is left.
  BergSide side(double travel, double reference_force) const {
    // Keeps 0/0 away at the reference point itself once friction is at its maximum.
    constexpr double kTiny = std::numeric_limits<double>::min();
    const double left = std::copysign(maximum_force_, travel) - reference_force;
    return {travel, left, compliance_ * std::abs(left) + kTiny};
  }

  /// Brings the memory to a displacement [m].
  void move(double displacement, double* memory) const {
    const double beyond = (displacement - memory[kExtremum]) * memory[kDirection];
    if (beyond > 0.0) {
      memory[kExtremum] = displacement;
    } else if (beyond < 0.0 || memory[kDirection] == 0.0) {
      reverse(displacement, -beyond, memory);
    }
  }

  /// Starts from rest, or from a reversal point once the motion has backed off far enough.
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
