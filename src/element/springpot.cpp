// Springpot: the fractional element, between spring and dashpot, realised by Maxwell elements.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "element/maxwell_bank.h"
#include "element/registry.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::element {
namespace {

constexpr double kTwoPi = 2.0 * kPi;
constexpr double kMaximumDecadesOfFrequency = 20.0;  // limit of the range, which bounds the memory
const double kSpacing = std::log(10.0) / 2.0;
constexpr double kMargin = 10.0;  // factor by which the grid of break frequencies exceeds the range at either end

// Returns one element for all grid points x below `first`. The weights x^alpha of these points are a geometric series
// with the sum W and the centre of gravity x_t. Well above x_t, the sum of all x^alpha s/(s + x) is W s/(s + x_t) up to
// the second moment.
Maxwell lowTail(double scale, double first, double order) {
  const double weight = std::pow(first, order) / std::expm1(order * kSpacing);
  const double moment = std::pow(first, order + 1.0) / std::expm1((order + 1.0) * kSpacing);
  return {scale * weight, moment / weight / kTwoPi};
}

// Returns one element for all grid points x above `last`. For frequencies well below these points, the element has
// their total damping, the sum of x^(alpha-1), and their second moment, the sum of x^(alpha-2).
Maxwell highTail(double scale, double last, double order) {
  const double damping = std::pow(last, order - 1.0) / std::expm1((1.0 - order) * kSpacing);
  const double square = std::pow(last, order - 2.0) / std::expm1((2.0 - order) * kSpacing);
  const double break_omega = damping / square;
  return {scale * damping * break_omega, break_omega / kTwoPi};
}

struct SpringpotLaw {
  double stiffness;            // K_r = |K*| at the reference frequency [N/m]
  double reference_frequency;  // f_r [Hz]
  double order;                // alpha in (0, 1), a spring near 0 and a dashpot near 1 [-]
  double low_frequency;        // lower end of the range in which the bank follows the law [Hz]
  double high_frequency;       // upper end of this range [Hz]
};

/// Returns Maxwell elements of positive stiffness that realise F = K_r (d/dt / (2 pi f_r))^alpha z.
///
/// With w_r = 2 pi f_r, (s/w_r)^alpha is sin(pi alpha)/pi times the integral of (x/w_r)^alpha s/(s + x) dx/x over all
/// break frequencies x. The integral is approximated by a sum over a geometric grid, two elements per decade, from a
/// decade below the range to a decade above it. One Maxwell element at either end matches the first two moments of the
/// rest. Within the range the error |K*/K*_law - 1| is below 1e-3 for every order; most of it is the error of the grid,
/// exp(-pi^2/ln sqrt(10)) = 2e-4. Unlike the law, the bank relaxes to zero force below the range and has a finite
/// stiffness above. Source: M. Sjöberg and L. Kari, Vehicle System Dynamics 37 (2002) 217-236; K. Sedlaczek, S. Dronka
/// and J. Rauh, Vehicle System Dynamics 49 (2011) 741-759.
std::vector<Maxwell> springpotBank(const SpringpotLaw& law) {
  // Frequencies are in units of the reference frequency. The sine of the smaller of pi alpha and pi (1 - alpha) is
  // accurate near both limits of alpha.
  const double sine = std::sin(kPi * std::min(law.order, 1.0 - law.order));
  const double scale = law.stiffness * sine / kPi * kSpacing;
  const double first = law.low_frequency / kMargin / law.reference_frequency;
  const double reach = law.high_frequency / law.low_frequency * kMargin * kMargin;
  const int intervals = static_cast<int>(std::ceil(std::log(reach) / kSpacing));

  std::vector<Maxwell> elements;
  const auto addElement = [&](const Maxwell& unit) {
    elements.emplace_back(unit.stiffness(), law.reference_frequency / unit.relaxationTime());
  };
  addElement(lowTail(scale, first, law.order));
  double last = first;
  for (int i = 0; i <= intervals; ++i) {
    last = first * std::exp(i * kSpacing);
    addElement(Maxwell(scale * std::pow(last, law.order), last / kTwoPi));
  }
  addElement(highTail(scale, last, law.order));
  return elements;
}

void checkRange(const ElementDescription& description) {
  const double low = description.value("low_frequency");
  const double high = description.value("high_frequency");
  const double most = low * std::pow(10.0, kMaximumDecadesOfFrequency);
  if (!(high > low && high <= most)) {
    refuseValue(description.type, "high_frequency", high, "Hz",
                fmt::format("in ({:g}, {:g}], which is at most {:g} decades above low_frequency", low, most,
                            kMaximumDecadesOfFrequency));
  }
}

const ElementEntry kSpringpotEntry(
    200, {"springpot",
          "Fractional element, K* = K_r (i f/f_r)^alpha: constant loss angle of 90 degrees times alpha.",
          {{"stiffness", "N/m", Role::scale, Range::positive(), "magnitude K_r of K* at the reference frequency"},
           {"order", "1", Role::shape, Range::open(0.0, 1.0), "order alpha; 0 would be a spring, 1 a dashpot"},
           {"reference_frequency", "Hz", Role::reference, Range::positive(), "reference frequency f_r", 1.0},
           {"low_frequency", "Hz", Role::choice, Range::positive(),
            "lower end of the range in which K* is exact to 0.1 %; far below it K* tends to 0", 0.001},
           {"high_frequency", "Hz", Role::choice, Range::positive(),
            "upper end of the range in which K* is exact to 0.1 %", 1000.0}},
          [](const ElementDescription& description) -> ElementPointer {
            checkRange(description);
            return std::make_shared<const MaxwellBank>(springpotBank(
                {description.value("stiffness"), description.value("reference_frequency"), description.value("order"),
                 description.value("low_frequency"), description.value("high_frequency")}));
          }});

}  // namespace
}  // namespace rubber_suspension::element
