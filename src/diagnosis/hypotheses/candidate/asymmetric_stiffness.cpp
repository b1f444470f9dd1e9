// Candidate effect: different stiffness in tension and compression.
#include <cmath>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addAsymmetricStiffness(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double typical = 0.1 * excitation.stiffness;
  candidate.terms = {fit::additiveTerm("asymmetric_stiffness", "quadratic", typical / excitation.largest_displacement),
                     fit::additiveTerm("asymmetric_stiffness", "tension_stiffness", typical)};
  for (fit::BasisTerm& term : candidate.terms) {
    term.lower = -term.upper;
  }
  // Laws that stiffen steeply on one side, but without a kink.
  for (const double share : {0.3, -0.3, 0.15, -0.15}) {
    const double scale = share * excitation.largest_displacement;
    candidate.terms.push_back(fit::additiveTerm("asymmetric_stiffness", "exponential",
                                                typical * std::exp(-1.0 / std::abs(share)),
                                                {{"exponential_scale", {scale}}}));
  }
}

const EffectEntry kAsymmetricStiffness({60, "asymmetric_stiffness",
                                        "different stiffness in the two directions: the force has a second harmonic, "
                                        "and its mean grows with the square of the amplitude",
                                        false, addAsymmetricStiffness});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
