// Many steps of one component, for one kind of processor. See instruction_sets.h.
#include "lanes.h"

// Maxwell elements whose numbers stay in registers.
template <std::size_t elements>
class MaxwellVectors {
 public:
  MaxwellVectors(const MaxwellBlock& block, const double* force) {
    fill(block.decay, decay_);
    fill(block.gain, gain_);
    fill(force, force_);
  }

  // Adds the forces over a block to the sums, in the order of the elements. Of a single vector they are read from
  // memory some time after it was stored whole; of several, taking them out of the registers is faster.
  void addForces(std::size_t count, const double* increment, double* sum) {
    if constexpr (kVectors == 1) {
      double stored[kSimulationBlock][kPadded];
      for (std::size_t sample = 0; sample < count; ++sample) {
        advance(increment[sample]);
        store(force_[0], stored[sample]);
      }
      for (std::size_t sample = 0; sample < count; ++sample) {
        for (std::size_t i = 0; i < elements; ++i) {
          sum[sample] += stored[sample][i];
        }
      }
    } else {
      for (std::size_t sample = 0; sample < count; ++sample) {
        advance(increment[sample]);
        for (std::size_t i = 0; i < elements; ++i) {
          sum[sample] += force_[i / kWidth][i % kWidth];
        }
      }
    }
  }

  void save(double* force) const {
    double numbers[kPadded];
    std::memcpy(numbers, force_, sizeof numbers);
    std::memcpy(force, numbers, elements * sizeof(double));
  }

 private:
  static constexpr std::size_t kVectors = (elements + kWidth - 1) / kWidth;
  static constexpr std::size_t kPadded = kVectors * kWidth;

  void advance(double increment) {
    for (std::size_t k = 0; k < kVectors; ++k) {
      force_[k] = decay_[k] * force_[k] + gain_[k] * increment;
    }
  }

  static void fill(const void* numbers, Lanes* vectors) {
    double padded[kPadded] = {};
    std::memcpy(padded, numbers, elements * sizeof(double));
    std::memcpy(vectors, padded, sizeof padded);
  }

  Lanes decay_[kVectors];
  Lanes gain_[kVectors];
  Lanes force_[kVectors];
};

template <>
class MaxwellVectors<0> {
 public:
  MaxwellVectors(const MaxwellBlock& /*block*/, const double* /*force*/) {}
  void addForces(std::size_t /*count*/, const double* /*increment*/, double* /*sum*/) {}
  void save(double* /*force*/) const {}
};

// Forces on the branch that friction is on, added to a part of a block.
inline void addBranch(const BergFriction& berg, const double* memory, const double* displacement, std::size_t count,
                      double* force) {
  const double reference_displacement = memory[BergFriction::kReferenceDisplacement];
  const double reference_force = memory[BergFriction::kReferenceForce];
  std::size_t i = 0;
  for (; i + kWidth <= count; i += kWidth) {
    const Lanes branch = frictionBranch(load(displacement + i), spread(reference_displacement), spread(reference_force),
                                        spread(berg.maximumForce()), spread(berg.compliance()));
    store(load(force + i) + branch, force + i);
  }
  for (; i < count; ++i) {
    force[i] += berg.branch(displacement[i], reference_displacement, reference_force);
  }
}

inline void addFriction(const BergFriction& berg, const double* displacement, std::size_t count, double* memory,
                        double* force) {
  for (std::size_t first = 0; first < count; ++first) {
    const std::size_t size = berg.followUntilTurn(displacement + first, count - first, memory);
    addBranch(berg, memory, displacement + first, size, force + first);
    first += size;
    if (first < count) {
      force[first] += berg.advance(displacement[first], memory);
    }
  }
}

// `last` of the Maxwell elements, eight at most, keep their forces in registers throughout; those before them come and
// go with each block.
template <std::size_t last>
inline void simulatePlain(const PlainSteps& steps) {
  const std::size_t before = steps.maxwells - last;
  MaxwellVectors<last> maxwells(steps.maxwell[before / kMostMaxwells], steps.maxwell_force + before);
  for (std::size_t first = 0; first < steps.count; first += kSimulationBlock) {
    const double* displacement = steps.displacement + first;
    const std::size_t count = steps.count - first < kSimulationBlock ? steps.count - first : kSimulationBlock;
    double increment[kSimulationBlock];
    double viscous[kSimulationBlock];
    double friction[kSimulationBlock] = {};
    increment[0] = displacement[0] - (first == 0 ? steps.start : displacement[-1]);
    for (std::size_t i = 1; i < count; ++i) {
      increment[i] = displacement[i] - displacement[i - 1];
    }
    for (std::size_t i = 0; i < count; ++i) {
      viscous[i] = steps.dashpot_gain * increment[i];
    }
    for (std::size_t k = 0; k < before; k += kMostMaxwells) {
      MaxwellVectors<kMostMaxwells> others(steps.maxwell[k / kMostMaxwells], steps.maxwell_force + k);
      others.addForces(count, increment, viscous);
      others.save(steps.maxwell_force + k);
    }
    maxwells.addForces(count, increment, viscous);
    for (std::size_t k = 0; k < steps.bergs; ++k) {
      addFriction(steps.berg[k], displacement, count, steps.berg_memory + k * BergFriction::kMemorySize, friction);
    }
    for (std::size_t i = 0; i < count; ++i) {
      steps.force[first + i] = steps.spring_stiffness * displacement[i] + viscous[i] + friction[i];
    }
  }
  maxwells.save(steps.maxwell_force + before);
}

inline void simulatePlainSteps(const PlainSteps& steps) {
  switch (steps.maxwells == 0 ? 0 : (steps.maxwells - 1) % kMostMaxwells + 1) {
    case 0:
      return simulatePlain<0>(steps);
    case 1:
      return simulatePlain<1>(steps);
    case 2:
      return simulatePlain<2>(steps);
    case 3:
      return simulatePlain<3>(steps);
    case 4:
      return simulatePlain<4>(steps);
    case 5:
      return simulatePlain<5>(steps);
    case 6:
      return simulatePlain<6>(steps);
    case 7:
      return simulatePlain<7>(steps);
    default:
      return simulatePlain<kMostMaxwells>(steps);
  }
}
