// Candidate effect: rate-independent friction of any smoothness.
#include "diagnosis/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

fit::Candidate friction(const fit::Excitation& excitation) {
  fit::Candidate candidate{
      "friction", "rate-independent friction: stiffness falls with amplitude at any frequency", false, {}, false};
  // Stop operators over the range of amplitudes: with stiffnesses of 0 or more they compose any friction that obeys
  // Masing's rule (Coulomb, Dahl, Iwan) and come close to those that nearly do (Berg, Bouc-Wen).
  for (const double share : {0.006, 0.015, 0.035, 0.075, 0.15, 0.27, 0.45, 0.7}) {
    const double yield = share * excitation.largest_displacement;
    fit::BasisTerm term;
    term.typical = 0.1 * excitation.stiffness;
    term.at = [yield](double stiffness) {
      return element::ElementDescription{"iwan_table", {{"yield_displacement", {yield}}, {"stiffness", {stiffness}}}};
    };
    candidate.terms.push_back(term);
  }
  return candidate;
}

const CandidateEntry kEntry(10, friction);

}  // namespace
}  // namespace rubber_suspension::diagnosis
