// Candidate effect: unlike stiffness in tension and compression.
#include <cmath>

#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::Candidate asymmetricStiffness(const fit::Excitation& excitation) {
  const double typical = 0.1 * excitation.stiffness;
  fit::Candidate candidate{
      "asymmetric_stiffness",
      "even stiffness: second harmonic, mean force grows with amplitude squared",
      false,
      {fit::additiveTerm("asymmetric_stiffness", "quadratic", typical / excitation.largest_displacement),
       fit::additiveTerm("asymmetric_stiffness", "tension_stiffness", typical)}};
  for (fit::BasisTerm& term : candidate.terms) {
    term.lower = -term.upper;
  }
  // One side that stiffens steeply, without a knee.
  for (const double share : {0.3, -0.3, 0.15, -0.15}) {
    const double scale = share * excitation.largest_displacement;
    candidate.terms.push_back(fit::additiveTerm("asymmetric_stiffness", "exponential",
                                                typical * std::exp(-1.0 / std::abs(share)),
                                                {{"exponential_scale", {scale}}}));
  }
  return candidate;
}

const CandidateEntry kAsymmetricStiffnessEntry(60, asymmetricStiffness);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
