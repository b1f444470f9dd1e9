// Arithmetic on several numbers in one vector register. There is no include guard: instruction_sets.h includes this
// file for each kind of processor, in a namespace that defines kWidth, the number of lanes.

/// A vector type of GCC that Clang also supports.
using Lanes = double __attribute__((vector_size(kWidth * sizeof(double))));
/// The result of a comparison: in each lane either all bits are set or none.
using LaneMask = decltype(Lanes{} < Lanes{});

inline Lanes load(const double* numbers) {
  Lanes lanes;
  std::memcpy(&lanes, numbers, sizeof lanes);
  return lanes;
}

inline void store(const Lanes& lanes, double* numbers) { std::memcpy(numbers, &lanes, sizeof lanes); }

/// Returns a vector with the number in each lane.
inline Lanes spread(double number) { return number - Lanes{}; }

/// Returns the lanes moved by one towards lane 0; the last lane is the first number of `following`.
inline Lanes shifted(const Lanes& lanes, const Lanes& following) {
#ifdef __clang__
  Lanes result;
  for (std::size_t i = 0; i < kWidth; ++i) {
    result[i] = i + 1 < kWidth ? lanes[i + 1] : following[0];
  }
  return result;
#else
  LaneMask from;
  for (std::size_t i = 0; i < kWidth; ++i) {
    from[i] = static_cast<std::int64_t>(i) + 1;
  }
  return __builtin_shuffle(lanes, following, from);
#endif
}

inline Lanes select(const LaneMask& mask, const Lanes& yes, const Lanes& no) {
  return reinterpret_cast<Lanes>((mask & reinterpret_cast<LaneMask>(yes)) | (~mask & reinterpret_cast<LaneMask>(no)));
}

inline Lanes magnitude(const Lanes& lanes) {
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneMask>(lanes) & INT64_MAX);
}

/// Returns std::copysign for positive numbers.
inline Lanes withSignOf(const Lanes& positive, const Lanes& sign) {
  return reinterpret_cast<Lanes>(reinterpret_cast<LaneMask>(positive) | (reinterpret_cast<LaneMask>(sign) & INT64_MIN));
}
