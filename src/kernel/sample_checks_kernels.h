// Checks of many samples, for one kind of processor (see instruction_sets.h). They have no branch per sample, so that
// the compiler can use vector instructions.

// Adds a number that causes a carry into the sign bit for biased exponents of at least `from`. Infinity and NaN have
// the biased exponent 2047.
inline bool exponentsBelow(const double* value, std::size_t count, std::uint64_t from) {
  constexpr std::uint64_t kSign = std::uint64_t{1} << 63U;
  const std::uint64_t added = (2048U - from) << 52U;
  std::uint64_t seen = 0;
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, value + i, sizeof bits);
    seen |= (bits & ~kSign) + added;
  }
  return (seen & kSign) == 0;
}

inline bool increasing(const std::int64_t* stamp, std::size_t count) {
  std::int64_t against = 0;
  for (std::size_t i = 1; i < count; ++i) {
    against |= stamp[i] > stamp[i - 1] ? 0 : 1;
  }
  return against == 0;
}

// The upper limit of `step` excludes stamps that overflow between the first and the last one.
inline bool even(const std::int64_t* stamp, std::size_t count, std::uint64_t step) {
  const std::uint64_t largest = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()) / count;
  std::uint64_t differences = 0;
  for (std::size_t i = 1; i <= count; ++i) {
    differences |= (static_cast<std::uint64_t>(stamp[i]) - static_cast<std::uint64_t>(stamp[i - 1])) ^ step;
  }
  return differences == 0 && step <= largest && stamp[count] > stamp[0];
}
