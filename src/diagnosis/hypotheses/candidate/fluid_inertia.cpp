// Candidate effect: a column of fluid that resonates, as in a hydraulic mount.
#include "diagnosis/hypotheses/candidate/registry.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// A track with a resonance [rad/s], damping as a share of the critical one, and free travel of a decoupler [m]; the
// scale is the stiffness of its chamber.
fit::BasisTerm trackTerm(double typical, double resonance, double damping, double free_travel) {
  fit::BasisTerm term;
  term.typical = typical;
  term.at = [=](double stiffness) {
    element::ElementDescription entry{"inertia_track",
                                      {{"mass", {stiffness / (resonance * resonance)}},
                                       {"damping", {2.0 * damping * stiffness / resonance}},
                                       {"stiffness", {stiffness}}}};
    if (free_travel > 0.0) {
      entry.values["free_travel"] = {free_travel};
    }
    return entry;
  };
  return term;
}

// Tracks about one frequency [Hz]: together any damping and a resonance between them, or one that the amplitude moves.
std::vector<fit::BasisTerm> termsAt(const fit::Excitation& excitation, double frequency) {
  constexpr double kBeside = 1.18;  // a resonance over the next
  constexpr double kDecoupled = 0.25;
  const double typical = 0.2 * excitation.stiffness;
  const double resonance = 2.0 * element::kPi * frequency;
  std::vector<fit::BasisTerm> terms;
  for (const double ratio : {1.0 / kBeside, 1.0, kBeside}) {
    for (const double damping : {0.08, 0.25, 0.6}) {
      terms.push_back(trackTerm(typical, ratio * resonance, damping, 0.0));
    }
  }
  for (const double share : {0.05, 0.2}) {
    terms.push_back(trackTerm(typical, resonance, kDecoupled, share * excitation.largest_displacement));
  }
  return terms;
}

// Far below its resonance a column is a mass and a damper, far above it a spring: these are effects of their own.
fit::Candidate fluidInertia(const fit::Excitation& excitation) {
  constexpr double kLeast = 0.15;  // of the highest frequency of the motion
  constexpr double kLargest = 1.5;
  fit::Candidate candidate{"fluid_inertia",
                           "column of fluid that resonates, as in a hydraulic mount: the loss has a peak at one "
                           "frequency, below which stiffness falls and above which it is higher",
                           false,
                           {}};
  candidate.contains = {"inertia"};
  candidate.least_shape = kLeast * excitation.highest_frequency;
  candidate.largest_shape = kLargest * excitation.highest_frequency;
  candidate.terms_at = [excitation](double frequency) { return termsAt(excitation, frequency); };
  candidate.terms = candidate.terms_at(0.5 * excitation.highest_frequency);
  return candidate;
}

const CandidateEntry kFluidInertiaEntry(45, fluidInertia);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
