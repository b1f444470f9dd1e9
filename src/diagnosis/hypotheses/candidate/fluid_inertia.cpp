// Candidate effect: a resonating column of fluid, as in a hydraulic mount.
#include <cmath>

#include "diagnosis/effect.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// An inertia track with its resonance [rad/s].
struct Track {
  double resonance;
  double damping;            // divided by the critical damping
  double free_travel = 0.0;  // free travel of a decoupler [m]
  double turbulence = 0.0;   // coefficient of the quadratic damping divided by the mass [1/m]
};

// Returns the term of a track. Its scale is the stiffness of the fluid chamber.
fit::BasisTerm trackTerm(double typical, const Track& track) {
  fit::BasisTerm term;
  term.typical = typical;
  term.at = [track](double stiffness) {
    const double mass = stiffness / (track.resonance * track.resonance);
    element::ElementDescription entry{"inertia_track",
                                      {{"mass", {mass}},
                                       {"damping", {2.0 * track.damping * stiffness / track.resonance}},
                                       {"stiffness", {stiffness}}}};
    if (track.free_travel > 0.0) {
      entry.values["free_travel"] = {track.free_travel};
    }
    if (track.turbulence > 0.0) {
      entry.values["quadratic_damping"] = {track.turbulence * mass};
    }
    return entry;
  };
  return term;
}

double typicalStiffness(const fit::Excitation& excitation) { return 0.2 * excitation.stiffness; }

// Returns a track whose quadratic loss is `share` of the critical damping if the fluid moves as far as the rubber.
fit::BasisTerm turbulentTerm(const fit::Excitation& excitation, double resonance, double share) {
  constexpr double kLaminar = 0.05;
  return trackTerm(typicalStiffness(excitation),
                   {resonance, kLaminar, 0.0, 2.0 * share / excitation.largest_displacement});
}

// Returns tracks with resonances about one frequency [Hz]. Together they represent any damping, and resonances that lie
// between the listed ones or depend on the amplitude.
std::vector<fit::BasisTerm> tracksAt(const fit::Excitation& excitation, double frequency) {
  constexpr double kBeside = 1.18;  // ratio of adjacent resonance frequencies
  constexpr double kDecoupled = 0.25;
  constexpr double kTurbulent = 0.2;
  const double typical = typicalStiffness(excitation);
  const double resonance = 2.0 * element::kPi * frequency;
  std::vector<fit::BasisTerm> terms;
  for (const double ratio : {1.0 / kBeside, 1.0, kBeside}) {
    for (const double damping : {0.08, 0.25, 0.6}) {
      terms.push_back(trackTerm(typical, {ratio * resonance, damping}));
    }
  }
  for (const double share : {0.05, 0.2}) {
    terms.push_back(trackTerm(typical, {resonance, kDecoupled, share * excitation.largest_displacement}));
  }
  terms.push_back(turbulentTerm(excitation, resonance, kTurbulent));
  return terms;
}

// Returns tracks with a mostly quadratic loss, from which a fit of the parameters of one track may start.
std::vector<fit::BasisTerm> turbulentLaws(const fit::Excitation& excitation, double least, double largest) {
  constexpr int kFrequencies = 7;  // adjacent frequencies differ by a factor of 1.4, less than a resonance is wide
  std::vector<fit::BasisTerm> laws;
  for (int i = 0; i < kFrequencies; ++i) {
    const double frequency = least * std::pow(largest / least, (i + 0.5) / kFrequencies);
    for (const double share : {0.1, 0.4}) {
      laws.push_back(turbulentTerm(excitation, 2.0 * element::kPi * frequency, share));
    }
  }
  return laws;
}

// The resonance is near the frequencies of the motion. Far below it, the fluid acts as a mass and a damper, and far
// above it, as a spring. These are effects of their own.
void addFluidInertia(const fit::Excitation& excitation, fit::Candidate& candidate) {
  constexpr double kLeast = 0.15;  // divided by the highest frequency of the motion
  constexpr double kLargest = 1.5;
  candidate.least_shape = kLeast * excitation.highest_frequency;
  candidate.largest_shape = kLargest * excitation.highest_frequency;
  candidate.terms_at = [excitation](double frequency) { return tracksAt(excitation, frequency); };
  candidate.terms = candidate.terms_at(0.5 * excitation.highest_frequency);
  candidate.laws = turbulentLaws(excitation, candidate.least_shape, candidate.largest_shape);
}

// Returns the other cause that a report has to mention. A resonance of the fixture has the same transfer function as a
// column of fluid, so that only the component file can exclude it.
std::string fluidOrFixture(const io::ComponentDescription& configured) {
  return configured.holds_fluid ? "" : "a fluid track, or a mass on a spring such as the fixture";
}

Effect fluidInertia() {
  Effect effect{45, "fluid_inertia",
                "column of fluid that resonates, as in a hydraulic mount: the loss has a peak at one frequency; below "
                "this frequency the stiffness is lower, above it higher",
                false, addFluidInertia};
  effect.contains = {"inertia"};
  effect.readings = fluidOrFixture;
  return effect;
}

const EffectEntry kFluidInertia(fluidInertia());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
