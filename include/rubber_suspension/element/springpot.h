// Springpot: the fractional element, between spring and dashpot, realised by Maxwell elements.
#pragma once

#include "rubber_suspension/element/maxwell_bank.h"

namespace rubber_suspension::element {

/// The law that a springpot is meant to be.
struct SpringpotLaw {
  double stiffness;            ///< K_r = |K*| at the reference frequency [N/m]
  double reference_frequency;  ///< f_r [Hz]
  double order;                ///< alpha in (0, 1): towards 0 a spring, towards 1 a dashpot [-]
  double low_frequency;        ///< ends of the range in which the bank holds to the law [Hz]
  double high_frequency;

  /// K* = K_r (i f/f_r)^alpha [N/m]: the loss angle is 90 degrees times alpha at every frequency.
  std::complex<double> complexStiffness(double omega) const;
};

/// F = K_r (d/dt / (2 pi f_r))^alpha z by a bank of Maxwell elements with weights greater than 0.
///
/// Realisation: (s/w_r)^alpha = sin(pi alpha)/pi  int (x/w_r)^alpha s/(s + x) dx/x  over all break frequencies x. The
/// integral is a sum over a geometric grid, two elements per decade, from a decade below the range to a decade above
/// it; the sums beyond both ends are one Maxwell element each that matches their first two moments. Error |K*/K*_law -
/// 1| within the range: below 1e-3 for every order (mostly the grid's exp(-pi^2/ln sqrt(10)) = 2e-4). Below the range
/// the element relaxes to zero force, above it it stiffens to a finite value; both differ from the law. Source: M.
/// Sjöberg and L. Kari, Vehicle System Dynamics 37 (2002) 217-236; K. Sedlaczek, S. Dronka and J. Rauh, Vehicle System
/// Dynamics 49 (2011) 741-759. The type's make() throws std::invalid_argument for a range of frequencies out of sense.
class Springpot final : public MaxwellBank {
 public:
  explicit Springpot(const SpringpotLaw& law);

  const SpringpotLaw& law() const { return law_; }

 private:
  SpringpotLaw law_;
};

ElementType springpotType();

}  // namespace rubber_suspension::element
