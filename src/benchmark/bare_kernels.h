// The bare loop over blocks for one kind of processor; included once for each by processor/instruction_sets.h. The laws
// are repeated on purpose.
#include "processor/lanes.h"

inline bool any(const LaneMask& mask) {
  auto seen = mask[0];
  for (std::size_t i = 1; i < kWidth; ++i) {
    seen |= mask[i];
  }
  return seen != 0;
}

// The state-space form of the Maxwell elements over as many samples as a vector has numbers.
class StateSpace {
 public:
  explicit StateSpace(const BareBlock& work) {
    double power[kBareElements][kWidth + 1];
    for (std::size_t k = 0; k < kBareElements; ++k) {
      power[k][0] = 1.0;
      for (std::size_t i = 0; i < kWidth; ++i) {
        power[k][i + 1] = power[k][i] * work.decay[k];
        from_state_[k][i] = power[k][i + 1];
      }
      kept_[k / kWidth][k % kWidth] = power[k][kWidth];
      for (std::size_t j = 0; j < kWidth; ++j) {
        to_state_[j][k / kWidth][k % kWidth] = work.gain[k] * power[k][kWidth - 1 - j];
        for (std::size_t i = j; i < kWidth; ++i) {
          response_[j][i] += work.gain[k] * power[k][i - j];
        }
      }
    }
  }

  Lanes advance(const double* increment) {
    double state[kVectors * kWidth];
    std::memcpy(state, state_, sizeof state);
    Lanes force = response_[0] * increment[0];
    for (std::size_t j = 1; j < kWidth; ++j) {
      force += response_[j] * increment[j];
    }
    for (std::size_t k = 0; k < kBareElements; ++k) {
      force += from_state_[k] * state[k];
    }
    for (std::size_t v = 0; v < kVectors; ++v) {
      Lanes added = to_state_[0][v] * increment[0];
      for (std::size_t j = 1; j < kWidth; ++j) {
        added += to_state_[j][v] * increment[j];
      }
      state_[v] = kept_[v] * state_[v] + added;
    }
    return force;
  }

 private:
  static constexpr std::size_t kVectors = (kBareElements + kWidth - 1) / kWidth;

  Lanes response_[kWidth] = {};            // of the sum of forces to the increment of each sample
  Lanes from_state_[kBareElements] = {};   // of the sum of forces to the force of an element before the block
  Lanes to_state_[kWidth][kVectors] = {};  // of the elements at the end to the increment of each sample
  Lanes kept_[kVectors] = {};
  Lanes state_[kVectors] = {};
};

// Friction of a block from `first` on: by vectors where the motion keeps its direction, else one by one.
inline Lanes blockFriction(const BareBlock& work, BareFriction& friction, std::size_t first, const Lanes& z,
                           const Lanes& increment) {
  if (friction.direction == 0.0 || any(increment * friction.direction <= 0.0)) {
    double force[kWidth];
    for (std::size_t i = 0; i < kWidth; ++i) {
      force[i] = friction.advance(work.displacement[first + i], work.maximum_force, work.friction_displacement);
    }
    return load(force);
  }
  const double left = friction.direction * work.maximum_force - friction.reference_force;
  const double reach = work.friction_displacement / work.maximum_force * (left < 0.0 ? -left : left);
  const Lanes way = magnitude(z - friction.reference_displacement);
  const Lanes force = friction.reference_force + way * left / (reach + way);
  friction.last_displacement = work.displacement[first + kWidth - 1];
  friction.last_force = force[kWidth - 1];
  return force;
}

// Whole blocks only; returns the first sample that is left over.
inline std::size_t runBlocks(const BareBlock& work) {
  StateSpace maxwells(work);
  BareFriction friction;
  friction.last_displacement = friction.reference_displacement = work.displacement[0];
  work.force[0] = work.spring * work.displacement[0];
  std::size_t first = 1;
  for (; first + kWidth <= work.count; first += kWidth) {
    const Lanes z = load(work.displacement + first);
    const Lanes increment = z - load(work.displacement + first - 1);
    double increments[kWidth];
    store(increment, increments);
    const Lanes force = maxwells.advance(increments) + blockFriction(work, friction, first, z, increment);
    store(work.spring * z + force, work.force + first);
  }
  return first;
}
