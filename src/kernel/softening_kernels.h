// Factors of stress softening, for one kind of processor. See instruction_sets.h.
#include "processor/lanes.h"
#include "rubber_suspension/element/relaxation_mean.h"

inline Lanes larger(const Lanes& one, const Lanes& other) { return select(one > other, one, other); }
inline Lanes smaller(const Lanes& one, const Lanes& other) { return select(one < other, one, other); }

/// Returns exp(-x) for x >= 0 with a relative error of 1e-15. A multiple of ln 2 is subtracted from x; the exponential
/// of half the remainder is computed and squared.
inline Lanes fallen(const Lanes& x) {
  constexpr double kMost = 700.0;          // for larger x the result is negligible
  constexpr double kToInteger = 0x1.8p52;  // the last bits of a sum with this number are an integer
  constexpr double kHighLn2 = 6.93147180369123816490e-01;
  constexpr double kLowLn2 = 1.90821492927058770002e-10;
  const Lanes at = smaller(x, spread(kMost));
  const Lanes counter = (at * 0x1.71547652b82fep+0 - 0.5) + kToInteger;
  const Lanes halvings = counter - kToInteger;
  const Lanes half = 0.5 * ((at - halvings * kHighLn2) - halvings * kLowLn2);
  const Lanes root = 1.0 - half * meanOverSmallStep(half);
  const LaneMask power = (1023 - reinterpret_cast<LaneMask>(counter)) << 52;
  return root * root * reinterpret_cast<Lanes>(power);
}

/// Moves the memory towards the reach of the present displacement.
inline Lanes recovered(const Lanes& reach, const Lanes& reached, const Lanes& rate, const Lanes& kept) {
  const Lanes left = smaller(reach, reached + larger(reach - reached, Lanes{}) * kept);
  return select(rate > 0.0, left, reach);
}

/// Returns the factors after a step of the laws in the lanes from `lane` on. `largest` and `reach` are their memories.
inline Lanes softened(const SofteningBlock& laws, std::size_t lane, double dt, double displacement, double increment,
                      double* largest, double* reach) {
  const Lanes side = load(laws.side.data() + lane);
  const Lanes aside = magnitude(spread(displacement));
  const Lanes reached = select(side == 0.0, aside, larger(side * displacement, Lanes{}));
  Lanes most = load(largest + lane);
  Lanes soft = load(reach + lane);
  if (laws.recovers) {
    const Lanes rate = load(laws.recovery_rate.data() + lane);
    const Lanes kept = 1.0 - (1.0 - fallen(dt * rate));  // exactly 0 where it is 0 in the single laws
    most = recovered(most, reached, rate, kept);
    soft = recovered(soft, reached, rate, kept);
  }
  most = larger(most, reached);
  const Lanes per_way = load(laws.inverse_path.data() + lane);
  const Lanes set_in = 1.0 - fallen(magnitude(spread(increment)) * per_way);
  soft = select(per_way > 0.0, soft + (most - soft) * set_in, most);
  store(most, largest + lane);
  store(soft, reach + lane);

  const Lanes inverse = 1.0 / soft;
  const Lanes ratio = aside * inverse;
  const Lanes power = ratio * (load(laws.by_ratio.data() + lane) + ratio * load(laws.by_square.data() + lane));
  const Lanes rest = fallen(load(laws.steepness.data() + lane) * (1.0 - power));  // tanh u = (1 - rest)/(1 + rest)
  const Lanes share = smaller(soft * load(laws.inverse_full_reach.data() + lane), spread(1.0));
  const Lanes grown = load(laws.evenly.data() + lane) +
                      share * (load(laws.by_reach.data() + lane) + share * load(laws.by_reach_squared.data() + lane));
  const Lanes blended = smaller(larger(0.5 + 2.0 * side * displacement * inverse, Lanes{}), spread(1.0));
  const Lanes reduction = load(laws.reduction.data() + lane) * grown * select(side == 0.0, spread(1.0), blended);
  return select(aside < soft, 1.0 - reduction * (1.0 - rest) / (1.0 + rest), spread(1.0));
}

/// Returns the product of the factors, multiplied in the same order on each processor. `memory`: M and S of each law.
inline double softenedProduct(const SofteningBlock* blocks, std::size_t laws, double dt, double displacement,
                              double increment, double* memory) {
  constexpr std::size_t kSize = SofteningBlock::kSize;
  double product = 1.0;
  for (std::size_t first = 0; first < laws; first += kSize, ++blocks) {
    const std::size_t count = laws - first < kSize ? laws - first : kSize;
    double largest[kSize] = {};
    double reach[kSize] = {};
    double factor[kSize];
    for (std::size_t i = 0; i < count; ++i) {
      largest[i] = memory[2 * (first + i)];
      reach[i] = memory[2 * (first + i) + 1];
    }
    for (std::size_t lane = 0; lane < kSize; lane += kWidth) {
      store(softened(*blocks, lane, dt, displacement, increment, largest, reach), factor + lane);
    }
    for (std::size_t i = 0; i < count; ++i) {
      memory[2 * (first + i)] = largest[i];
      memory[2 * (first + i) + 1] = reach[i];
      product *= factor[i];
    }
  }
  return product;
}
