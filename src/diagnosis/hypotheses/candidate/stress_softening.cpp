// Candidate effect: softening by past displacements.
#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

fit::BasisTerm factorTerm(const element::ParameterValues& shape) {
  fit::BasisTerm term = fit::additiveTerm("stress_softening", "reduction", 0.1, shape);
  term.upper = 0.8;
  term.additive = false;
  term.softening = true;
  return term;
}

// Adds softening that begins anywhere below the largest past displacement, at once or within several cycles.
void addAtAnyReach(double largest, std::vector<fit::BasisTerm>& terms) {
  for (const double path : {0.0, 8.0}) {
    for (const double width : {0.05, 0.15, 0.5, 1.5}) {
      terms.push_back(factorTerm({{"width", {width}}, {"path", {path * largest}}}));
    }
  }
  for (const double path : {2.0, 32.0}) {
    for (const double width : {0.15, 1.5}) {
      terms.push_back(factorTerm({{"width", {width}}, {"path", {path * largest}}}));
    }
  }
}

// Adds softening that increases with the largest past displacement.
void addByReach(double largest, std::vector<fit::BasisTerm>& terms) {
  const auto add = [&](double exponent, double width, double path) {
    terms.push_back(factorTerm(
        {{"width", {width}}, {"path", {path * largest}}, {"reach_exponent", {exponent}}, {"full_reach", {largest}}}));
  };
  add(1.0, 1.5, 0.0);
  add(1.0, 1.5, 8.0);
  add(1.0, 0.15, 8.0);
  add(2.0, 1.5, 0.0);
  add(2.0, 1.5, 8.0);
}

// Adds softening that depends on the ratio of displacements instead of the ratio of energies.
void addByDisplacement(double largest, std::vector<fit::BasisTerm>& terms) {
  for (const double path : {0.0, 8.0}) {
    for (const double exponent : {0.0, 1.0}) {
      terms.push_back(factorTerm({{"width", {1.5}},
                                  {"ratio_power", {1.0}},
                                  {"path", {path * largest}},
                                  {"reach_exponent", {exponent}},
                                  {"full_reach", {largest}}}));
    }
  }
}

// Adds softening on one side only, and softening that recovers at rest.
void addOneSidedAndRecovering(const fit::Excitation& excitation, std::vector<fit::BasisTerm>& terms) {
  for (const double side : {1.0, -1.0}) {
    terms.push_back(
        factorTerm({{"width", {0.5}}, {"path", {8.0 * excitation.largest_displacement}}, {"side", {side}}}));
  }
  for (const double share : {0.03, 0.2, 1.0}) {
    const double time = share * excitation.longest_duration;
    terms.push_back(factorTerm({{"width", {0.5}}, {"recovery_time", {time}}}));
    terms.push_back(factorTerm({{"width", {1.5}}, {"ratio_power", {1.0}}, {"recovery_time", {time}}}));
  }
}

// Adds the additional force of a first loading. A factor on the settled force cannot represent it.
void addFirstLoading(const fit::Excitation& excitation, std::vector<fit::BasisTerm>& terms) {
  for (const double share : {0.02, 0.1, 0.5}) {
    terms.push_back(fit::additiveTerm("first_loading", "stiffness", 0.1 * excitation.stiffness / share,
                                      {{"yield_share", {share}}, {"dead_band", {excitation.dead_band}}}));
  }
}

void addStressSoftening(const fit::Excitation& excitation, fit::Candidate& candidate) {
  addAtAnyReach(excitation.largest_displacement, candidate.terms);
  addByReach(excitation.largest_displacement, candidate.terms);
  addByDisplacement(excitation.largest_displacement, candidate.terms);
  addOneSidedAndRecovering(excitation, candidate.terms);
  addFirstLoading(excitation, candidate.terms);
}

Effect stressSoftening() {
  Effect effect{90,    "stress_softening", "softening below the largest past displacement, within 3 to 5 cycles",
                false, addStressSoftening, InSettledLoops::over_before};
  effect.falls_like_warming = true;
  return effect;
}

const EffectEntry kStressSoftening(stressSoftening());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
