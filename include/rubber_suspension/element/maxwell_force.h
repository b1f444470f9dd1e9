// The step of a Maxwell element for one number or for a vector of the processor, with bitwise equal results. There is
// no include guard, because kernels include this file once for each kind of processor, into separate namespaces.

/// Returns the force F+ = e F + g dz at the end of a step, with e and g as in MaxwellStep. Throws nothing.
template <class Number, class Increment>
inline Number maxwellForce(const Number& decay, const Number& gain, const Number& force, const Increment& increment) {
  return decay * force + gain * increment;
}
