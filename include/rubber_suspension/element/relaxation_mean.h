// The mean of a relaxing force over a small step for one number or for a vector of the processor, with bitwise equal
// results. There is no include guard, because kernels include this file once for each kind of processor, into separate
// namespaces.

/// Returns (1 - exp(-x))/x for 0 <= x <= 0.35, as 1 + x P(x). P is the polynomial that agrees with ((1 - exp(-x))/x -
/// 1)/x at nine Chebyshev points of [0, 0.35]; its error is below 1e-17 of the mean. Throws nothing.
template <class Number>
inline Number meanOverSmallStep(const Number& x) {
  const Number x2 = x * x;
  const Number x4 = x2 * x2;
  const Number low = (-0.5 + x * 0x1.5555555555479p-3) + x2 * (-0x1.5555555544e97p-5 + x * 0x1.1111110986e3cp-7);
  const Number high =
      (-0x1.6c16bdf33ee18p-10 + x * 0x1.a0191b55231b5p-13) + x2 * (-0x1.9ff6dcbf864aep-16 + x * 0x1.6eb9cfe67b12bp-19);
  return 1.0 + x * (low + x4 * (high + x4 * -0x1.009a72f2b430cp-22));
}
