// Many steps of basic laws, for one kind of processor. See instruction_sets.h.
#include "processor/lanes.h"
#include "rubber_suspension/element/maxwell_force.h"

/// Computes BergFriction::branch in each lane, with the same result bit by bit. `compliance` is z2/F_max.
inline Lanes frictionBranch(const Lanes& displacement, const Lanes& reference_displacement,
                            const Lanes& reference_force, const Lanes& maximum_force, const Lanes& compliance) {
  constexpr double kTiny = std::numeric_limits<double>::min();
  const Lanes travel = displacement - reference_displacement;
  const Lanes left = withSignOf(maximum_force, travel) - reference_force;
  const Lanes reach = compliance * magnitude(left) + kTiny;
  return reference_force + magnitude(travel) * left / (reach + magnitude(travel));
}

// Maxwell elements in the lanes of vectors. Each element is one sample behind the preceding element, so that the sum
// for a sample moves from lane to lane. The last element is in lane 0, where the sums are complete.
template <std::size_t elements>
class MaxwellPipeline {
  static constexpr std::size_t kVectors = (elements + kWidth - 1) / kWidth;

 public:
  // Number of steps from the input of a sample to its complete sum. Lanes without an element add 0.
  static constexpr std::size_t kLag = elements == 0 ? 0 : kVectors * kWidth - 1;

  MaxwellPipeline(const MaxwellBlock& block, const double* force) {
    for (std::size_t i = 0; i < elements; ++i) {
      lane(decay_, i) = block.decay[i / 2][i % 2];
      lane(gain_, i) = block.gain[i / 2][i % 2];
      lane(force_, i) = force[i];
    }
  }

  // Executes the steps [from, to) of the count + kLag steps for `count` samples. The sums are changed in place.
  // Increments and sums need space for kLag numbers before and after the samples.
  __attribute__((always_inline)) void run(std::size_t from, std::size_t to, std::size_t count, const double* increment,
                                          double* sum) {
    std::size_t sample = from;
    for (; sample < to && sample < kLag; ++sample) {
      step<false>(sample, count, increment, sum);
    }
    for (; sample < to && sample < count; ++sample) {
      step<true>(sample, count, increment, sum);
    }
    for (; sample < to; ++sample) {
      step<false>(sample, count, increment, sum);
    }
  }

  void save(double* force) const {
    for (std::size_t i = 0; i < elements; ++i) {
      force[i] = force_[(kLag - i) / kWidth][(kLag - i) % kWidth];
    }
  }

 private:
  static double& lane(Lanes* vectors, std::size_t element) {
    return reinterpret_cast<double*>(vectors)[kLag - element];
  }

  // `inside`: all elements are at samples of the run.
  template <bool inside>
  __attribute__((always_inline)) void step(std::size_t sample, std::size_t count, const double* increment,
                                           double* sum) {
    const double* oldest = increment + sample - kLag;
    for (std::size_t k = 0; k < kVectors; ++k) {
      const Lanes force = maxwellForce(decay_[k], gain_[k], force_[k], load(oldest + k * kWidth));
      force_[k] = inside ? force : select(isInside(sample, count, k), force, force_[k]);
      sum_[k] = shifted(sum_[k], k + 1 < kVectors ? sum_[k + 1] : spread(sum[sample])) + force_[k];
    }
    *(sum + sample - kLag) = sum_[0][0];
  }

  // Returns a mask of the lanes that are at samples of the run.
  static LaneMask isInside(std::size_t sample, std::size_t count, std::size_t k) {
    Lanes lane;
    for (std::size_t i = 0; i < kWidth; ++i) {
      lane[i] = static_cast<double>(i);
    }
    const Lanes at = lane + (static_cast<double>(sample + k * kWidth) - static_cast<double>(kLag));
    return (at >= Lanes{}) & (at < spread(static_cast<double>(count)));
  }

  Lanes decay_[kVectors] = {};
  Lanes gain_[kVectors] = {};
  Lanes force_[kVectors] = {};
  Lanes sum_[kVectors] = {};
};

template <>
class MaxwellPipeline<0> {
 public:
  static constexpr std::size_t kLag = 0;
  MaxwellPipeline(const MaxwellBlock& /*block*/, const double* /*force*/) {}
  void run(std::size_t /*from*/, std::size_t /*to*/, std::size_t /*count*/, const double* /*increment*/,
           double* /*sum*/) {}
  void save(double* /*force*/) const {}
};

// Adds the force of friction on its present branch to a part of a block.
inline void addBranch(const element::BergFriction& berg, const double* memory, const double* displacement,
                      std::size_t count, double* force) {
  const double reference_displacement = memory[element::BergFriction::kReferenceDisplacement];
  const double reference_force = memory[element::BergFriction::kReferenceForce];
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

// Bit masks of the samples of a block at which the displacement rises, falls, or is NaN.
struct Directions {
  std::uint64_t rising;
  std::uint64_t falling;
  std::uint64_t unknown;
};

inline std::uint64_t joined(const LaneMask& bits) {
  std::uint64_t all = 0;
  for (std::size_t i = 0; i < kWidth; ++i) {
    all |= static_cast<std::uint64_t>(bits[i]);
  }
  return all;
}

inline Directions directionsOf(const double* increment) {
  LaneMask bit;
  for (std::size_t i = 0; i < kWidth; ++i) {
    bit[i] = std::int64_t{1} << i;
  }
  LaneMask rising = {};
  LaneMask falling = {};
  LaneMask unknown = {};
  for (std::size_t i = 0; i < kSimulationBlock; i += kWidth) {
    const Lanes travel = load(increment + i);
    rising |= (travel > Lanes{}) & bit;
    falling |= (travel < Lanes{}) & bit;
    unknown |= (travel != travel) & bit;
    bit <<= kWidth;
  }
  return {joined(rising), joined(falling), joined(unknown)};
}

// One number for each sample of a block.
struct BlockNumbers {
  Lanes lanes[kSimulationBlock / kWidth];

  // Sets the numbers of all samples from `sample` on.
  void set(double number, std::size_t sample) {
    Lanes position;
    for (std::size_t i = 0; i < kWidth; ++i) {
      position[i] = static_cast<double>(i);
    }
    position -= static_cast<double>(sample);
    for (Lanes& some : lanes) {
      some = select(position >= Lanes{}, spread(number), some);
      position += static_cast<double>(kWidth);
    }
  }
};

// Adds friction without dead band that has moved before. It reverses where the sign of the increments changes, so that
// the reversals of a whole block are known before its forces are computed.
inline void addFrictionOfBlock(const element::BergFriction& berg, const double* displacement,
                               const Directions& directions, double* memory, double* force) {
  BlockNumbers reference_displacement;
  BlockNumbers reference_force;
  for (std::size_t i = 0; i < kSimulationBlock / kWidth; ++i) {
    reference_displacement.lanes[i] = spread(memory[element::BergFriction::kReferenceDisplacement]);
    reference_force.lanes[i] = spread(memory[element::BergFriction::kReferenceForce]);
  }
  const std::uint64_t up =
      std::uint64_t{0} - static_cast<std::uint64_t>(memory[element::BergFriction::kDirection] > 0.0);
  std::uint64_t against = (directions.falling & up) | (directions.rising & ~up);
  std::uint64_t along = (directions.falling & ~up) | (directions.rising & up);
  while (against != 0) {
    const auto sample = static_cast<std::size_t>(__builtin_ctzll(against));
    berg.reverseAt(displacement[static_cast<std::ptrdiff_t>(sample) - 1], memory);
    reference_displacement.set(memory[element::BergFriction::kReferenceDisplacement], sample);
    reference_force.set(memory[element::BergFriction::kReferenceForce], sample);
    const std::uint64_t left = along & (~std::uint64_t{0} << sample);
    along = against;
    against = left;
  }
  memory[element::BergFriction::kExtremum] = displacement[kSimulationBlock - 1];
  for (std::size_t i = 0; i < kSimulationBlock; i += kWidth) {
    const Lanes branch =
        frictionBranch(load(displacement + i), reference_displacement.lanes[i / kWidth],
                       reference_force.lanes[i / kWidth], spread(berg.maximumForce()), spread(berg.compliance()));
    store(load(force + i) + branch, force + i);
  }
}

inline void addFrictionOneByOne(const element::BergFriction& berg, const double* displacement, std::size_t count,
                                double* memory, double* force) {
  for (std::size_t first = 0; first < count; ++first) {
    const std::size_t size = berg.followUntilReversal(displacement + first, count - first, memory);
    addBranch(berg, memory, displacement + first, size, force + first);
    first += size;
    if (first < count) {
      force[first] += berg.advance(displacement[first], memory);
    }
  }
}

inline void addFriction(const LogSteps& steps, std::size_t first, std::size_t count, const double* increment,
                        double* force) {
  const double* displacement = steps.displacement + first;
  const bool whole = count == kSimulationBlock && first > 0;
  const Directions directions = whole ? directionsOf(increment) : Directions{0, 0, ~std::uint64_t{0}};
  for (std::size_t k = 0; k < steps.frictions; ++k) {
    const element::BergFriction& berg = steps.friction[k];
    double* memory = steps.friction_memory + k * element::BergFriction::kMemorySize;
    if (directions.unknown == 0 && berg.deadBand() == 0.0 && memory[element::BergFriction::kDirection] != 0.0 &&
        memory[element::BergFriction::kExtremum] == displacement[-1]) {
      addFrictionOfBlock(berg, displacement, directions, memory, force);
    } else {
      addFrictionOneByOne(berg, displacement, count, memory, force);
    }
  }
}

// Several samples in the pipeline: their increments, and the summed forces of dashpots and Maxwell elements.
class Portion {
 public:
  static constexpr std::size_t kSize = 16 * kSimulationBlock;

  // Continues with the samples from `first` on. After the end there are none.
  void start(const LogSteps& steps, std::size_t first) {
    first_ = first;
    count_ = first >= steps.count ? 0 : steps.count - first < kSize ? steps.count - first : kSize;
    std::memset(increment_ + kRoom + count_, 0, kRoom * sizeof(double));
    std::memset(sum_ + kRoom + count_, 0, kRoom * sizeof(double));
  }

  // Computes the increments and the dashpot forces of a block.
  void prepare(const LogSteps& steps, std::size_t from) {
    if (from + kSimulationBlock <= count_) {
      prepare(steps, from, kSimulationBlock);
    } else if (from < count_) {
      prepare(steps, from, count_ - from);
    }
  }

  // Advances Maxwell elements over a block, over all samples, or at the end over all samples and their lag.
  template <std::size_t elements>
  __attribute__((always_inline)) void advance(std::size_t from, std::size_t count,
                                              MaxwellPipeline<elements>& maxwells) {
    const std::size_t end = count_ == 0 ? 0 : count_ + MaxwellPipeline<elements>::kLag;
    if (from < end) {
      maxwells.run(from, end - from < count ? end : from + count, count_, increment_ + kRoom, sum_ + kRoom);
    }
  }

  // Adds the forces of friction and springs of a block.
  void finish(const LogSteps& steps, std::size_t from) const {
    if (from + kSimulationBlock <= count_) {
      finish(steps, from, kSimulationBlock);
    } else if (from < count_) {
      finish(steps, from, count_ - from);
    }
  }

 private:
  static constexpr std::size_t kRoom = kMostMaxwells;  // space for kLag numbers

  __attribute__((always_inline)) void prepare(const LogSteps& steps, std::size_t from, std::size_t count) {
    const double* displacement = steps.displacement + first_ + from;
    double* increment = increment_ + kRoom + from;
    double* sum = sum_ + kRoom + from;
    const std::size_t known = first_ + from == 0 ? 1 : 0;
    if (known > 0) {
      increment[0] = displacement[0] - steps.start;
      sum[0] = steps.dashpot_gain * increment[0];
    }
    for (std::size_t i = known; i < count; ++i) {
      const double travel = displacement[i] - *(displacement + i - 1);
      increment[i] = travel;
      sum[i] = steps.dashpot_gain * travel;
    }
  }

  __attribute__((always_inline)) void finish(const LogSteps& steps, std::size_t from, std::size_t count) const {
    double friction[kSimulationBlock] = {};
    if (steps.frictions > 0) {
      addFriction(steps, first_ + from, count, increment_ + kRoom + from, friction);
    }
    const double* displacement = steps.displacement + first_ + from;
    const double* sum = sum_ + kRoom + from;
    double* force = steps.force + first_ + from;
    for (std::size_t i = 0; i < count; ++i) {
      force[i] = steps.spring_stiffness * displacement[i] + sum[i] + friction[i];
    }
  }

  std::size_t first_ = 0;
  std::size_t count_ = 0;
  double increment_[kRoom + kSize + kRoom];
  double sum_[kRoom + kSize + kRoom];
};

// The `last` Maxwell elements, at most eight, keep their forces in registers; those before them load and save theirs
// with each portion. Each step of an element waits eight cycles for its preceding step. Meanwhile the processor
// prepares a block of the next portion and finishes a block of the preceding one; it looks no further ahead.
template <std::size_t last>
inline void simulateWith(const LogSteps& steps) {
  const std::size_t before = steps.maxwells - last;
  MaxwellPipeline<last> maxwells(steps.maxwell[before / kMostMaxwells], steps.maxwell_force + before);
  Portion portions[3];
  for (std::size_t number = 0; number * Portion::kSize < steps.count + 2 * Portion::kSize; ++number) {
    Portion& prepared = portions[number % 3];
    Portion& advanced = portions[(number + 2) % 3];
    const Portion& finished = portions[(number + 1) % 3];
    prepared.start(steps, number * Portion::kSize);
    for (std::size_t k = 0; k < before; k += kMostMaxwells) {
      MaxwellPipeline<kMostMaxwells> others(steps.maxwell[k / kMostMaxwells], steps.maxwell_force + k);
      advanced.advance(0, 2 * Portion::kSize, others);
      others.save(steps.maxwell_force + k);
    }
    const std::size_t end = steps.count < Portion::kSize ? steps.count : Portion::kSize;
    for (std::size_t from = 0; from < end + maxwells.kLag; from += kSimulationBlock) {
      prepared.prepare(steps, from);
      advanced.advance(from, kSimulationBlock, maxwells);
      finished.finish(steps, from);
    }
  }
  maxwells.save(steps.maxwell_force + before);
}

inline void simulateLogSteps(const LogSteps& steps) {
  switch (steps.maxwells == 0 ? 0 : (steps.maxwells - 1) % kMostMaxwells + 1) {
    case 0:
      return simulateWith<0>(steps);
    case 1:
      return simulateWith<1>(steps);
    case 2:
      return simulateWith<2>(steps);
    case 3:
      return simulateWith<3>(steps);
    case 4:
      return simulateWith<4>(steps);
    case 5:
      return simulateWith<5>(steps);
    case 6:
      return simulateWith<6>(steps);
    case 7:
      return simulateWith<7>(steps);
    default:
      return simulateWith<kMostMaxwells>(steps);
  }
}
