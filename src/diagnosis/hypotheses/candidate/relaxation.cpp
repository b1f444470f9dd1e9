// Candidate effect: further relaxation times within the band of the excitation.
#include "diagnosis/effect.h"
#include "diagnosis/hypotheses/candidate/branches.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Adds relaxation that is faster than creep. A single element represents all relaxation that is faster than the motion,
// because such relaxation acts as damping.
void addRelaxation(const fit::Excitation& excitation, fit::Candidate& candidate) {
  const double slowest = 1.0 / (2.0 * element::kPi * longestRelaxationTime(excitation));
  constexpr double kRatio = 2.2;
  constexpr double kBeyondMotion = 8.0;
  std::vector<double> frequencies;
  for (double frequency = slowest; frequency < 2.0 * excitation.highest_frequency; frequency *= kRatio) {
    frequencies.push_back(frequency);
  }
  frequencies.push_back(kBeyondMotion * excitation.highest_frequency);
  addBranches(frequencies, 0.1 * excitation.stiffness, excitation, candidate);
}

const EffectEntry kRelaxation({20, "relaxation",
                               "further relaxation: the error of stiffness and loss depends only on frequency, or "
                               "grows with strain like the slope of a nonlinear spring",
                               false, addRelaxation});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
