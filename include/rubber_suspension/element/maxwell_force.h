// The step of a Maxwell element, for one number or for several side by side in a vector of the processor, with the same
// bits. No include guard: kernels include it once for each kind of processor, into namespaces of their own.

/// F+ = e F + g dz: force at the end of a step from that at its begin; coefficients as in MaxwellStep. Throws nothing.
template <class Number, class Increment>
inline Number maxwellForce(const Number& decay, const Number& gain, const Number& force, const Increment& increment) {
  return decay * force + gain * increment;
}
