// Fast springs, dashpots, Maxwell elements and Berg friction in parallel; bit by bit equal to the single laws.
#pragma once

#include <algorithm>
#include <array>
#include <boost/align/aligned_allocator.hpp>
#include <boost/container/small_vector.hpp>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <vector>

#include "rubber_suspension/element/basic_laws.h"
#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/element.h"
#include "rubber_suspension/kernel/maxwell_block.h"

namespace rubber_suspension::kernel {

/// Coefficients that make the next step fast. A kernel derives them from its laws, the step length and the memory, so
/// that they need not be saved. Besides the memory they are all that such a step reads, so that little is fetched per
/// component. No member function throws.
struct PreparedStep {
  double dt = -1.0;               ///< step length for which the coefficients are valid [s]
  double dashpot_gain = 0.0;      ///< c/dt [N/m]
  double spring_stiffness = 0.0;  ///< [N/m]
  element::BergSide branch;       ///< branch of a single friction for the present memory, or no branch
  std::uint32_t friction_count = 0;
  std::uint32_t maxwell_count = 0;
  /// Coefficients of the Maxwell elements.
  boost::container::small_vector<MaxwellBlock, 1, boost::alignment::aligned_allocator<MaxwellBlock, kCacheLine>>
      maxwells;

  /// Returns true if continueTo() may replace the step: its length is unchanged, and no friction reverses.
  __attribute__((always_inline)) bool continues(double length, double displacement, const double* memory) const {
    return sameBits(length, dt) &&
           (friction_count == 1 ? element::BergFriction::keepsDirection(branch, displacement, memory + maxwell_count)
                                : friction_count == 0);
  }

  /// Returns the force [N] after a step for which continues() is true, without calling a function.
  __attribute__((always_inline)) element::ComponentForce continueTo(double displacement, double increment,
                                                                    double* memory) const {
    const double friction =
        friction_count == 1 ? element::BergFriction::continueTo(branch, displacement, memory + maxwell_count) : 0.0;
    return advance(displacement, increment, friction, memory);
  }

  /// Advances the Maxwell elements and returns the force [N] of all laws. `friction`: force of friction [N].
  __attribute__((always_inline)) element::ComponentForce advance(double displacement, double increment, double friction,
                                                                 double* memory) const {
    const double elastic = spring_stiffness * displacement;
    const double viscous = stepMaxwells(maxwells.data(), maxwell_count, increment, dashpot_gain * increment, memory);
    return {elastic + viscous + friction, elastic, viscous, friction};
  }

 private:
  /// Returns true if two step lengths, neither 0 nor NaN, are equal. Comparing them as integers saves two instructions.
  static bool sameBits(double one, double other) {
    std::uint64_t bits = 0;
    std::uint64_t other_bits = 0;
    std::memcpy(&bits, &one, sizeof bits);
    std::memcpy(&other_bits, &other, sizeof other_bits);
    return bits == other_bits;
  }
};

/// A force that depends linearly on a displacement.
struct LinearForce {
  double held;   ///< force at zero displacement [N]
  double slope;  ///< [N/m]

  double at(double displacement) const { return held + slope * displacement; }
};

/// Computes F = k z + c dz/dt + sum of Maxwell forces + sum of Berg friction, added in this order.
///
/// The caller owns the memory, which contains the Maxwell forces and then the memory of each friction.
class BasicLawsKernel {
 public:
  explicit BasicLawsKernel(const element::BasicLaws& laws = {});

  std::size_t memorySize() const { return maxwell_count_ + frictions_.size() * element::BergFriction::kMemorySize; }

  /// Returns a PreparedStep of the right size, which still needs a step length.
  PreparedStep makePreparedStep() const;

  /// Initialises the memory for a fully relaxed state at rest at this displacement [m].
  element::ComponentForce initialise(double displacement, double* memory) const;

  /// Computes the coefficients for a step length > 0 [s].
  void prepare(double dt, PreparedStep& prepared) const;

  /// Advances by one step. `prepared` has to belong to this kernel and, if it has a branch, to `memory`. The arguments
  /// are passed in registers.
  element::ComponentForce step(double dt, double displacement, double increment, double* memory,
                               PreparedStep& prepared) const;

  /// Advances by one step of the prepared length. It does not use the branch, so other code may also change the memory.
  element::ComponentForce stepWithoutBranch(const element::Motion& motion, double* memory,
                                            const PreparedStep& prepared) const {
    return prepared.advance(motion.displacement, motion.increment, advanceFrictions(motion.displacement, memory),
                            memory);
  }

  /// Simulates steps of dt [s] from the displacement `start` [m] to `count` further displacements and writes the total
  /// forces [N] to `force`. This is several times as fast as single steps.
  void simulate(double dt, double start, const double* displacement, std::size_t count, double* force, double* memory,
                PreparedStep& prepared) const;

  /// Returns the force without friction after a step from `start` [m], as a function of the new displacement.
  LinearForce withoutFriction(double start, const double* memory, const PreparedStep& prepared) const;

  /// Returns the force of friction [N] after a step to this displacement [m], without changing the memory.
  double frictionAt(double displacement, const double* memory) const;

  /// Returns in closed form the displacement z [m] after a step for which slope z + offset + compliance friction(z) =
  /// 0. Returns nullopt for several frictions, or if friction reverses.
  std::optional<double> balance(double slope, double offset, double compliance, const double* memory) const;

  /// Returns K* [N/m] at the angular frequency omega [rad/s]; nullopt if there is friction.
  std::optional<std::complex<double>> complexStiffness(double omega) const;

 private:
  double advanceFrictions(double displacement, double* memory) const {
    memory = frictionMemory(memory);
    double force = 0.0;
    for (const element::BergFriction& friction : frictions_) {
      force += friction.advance(displacement, memory);
      memory += element::BergFriction::kMemorySize;
    }
    return force;
  }

  double* frictionMemory(double* memory) const { return memory + maxwell_count_; }
  const double* frictionMemory(const double* memory) const { return memory + maxwell_count_; }

  double spring_stiffness_;
  double damping_;
  std::size_t maxwell_count_;
  std::vector<double> maxwell_stiffness_;  // [N/m], padded with zeros to a whole number of blocks
  std::vector<double> maxwell_rate_;       // 1/tau [1/s], padded with zeros to a whole number of blocks
  double fastest_rate_ = 0.0;
  std::vector<element::BergFriction> frictions_;
};

// These functions are inline, because a series balance calls them in each trial.

inline LinearForce BasicLawsKernel::withoutFriction(double start, const double* memory,
                                                    const PreparedStep& prepared) const {
  double slope = prepared.dashpot_gain;
  double held = 0.0;
  for (std::size_t i = 0; i < maxwell_count_; ++i) {
    const MaxwellBlock& block = prepared.maxwells[i / MaxwellBlock::kSize];
    const std::size_t pair = i % MaxwellBlock::kSize / 2;
    slope += block.gain[pair][i % 2];
    held += block.decay[pair][i % 2] * memory[i];
  }
  return {held - slope * start, slope + spring_stiffness_};
}

inline double BasicLawsKernel::frictionAt(double displacement, const double* memory) const {
  memory = frictionMemory(memory);
  double force = 0.0;
  for (const element::BergFriction& friction : frictions_) {
    std::array<double, element::BergFriction::kMemorySize> trial;
    std::copy_n(memory, trial.size(), trial.begin());
    force += friction.advance(displacement, trial.data());
    memory += trial.size();
  }
  return force;
}

inline std::optional<double> BasicLawsKernel::balance(double slope, double offset, double compliance,
                                                      const double* memory) const {
  if (frictions_.empty()) {
    return -offset / slope;
  }
  if (frictions_.size() == 1) {
    const double displacement =
        frictions_.front().solveSeriesBalance(slope, offset, compliance, frictionMemory(memory));
    if (frictions_.front().keepsDirection(displacement, frictionMemory(memory))) {
      return displacement;
    }
  }
  return std::nullopt;
}

}  // namespace rubber_suspension::kernel
