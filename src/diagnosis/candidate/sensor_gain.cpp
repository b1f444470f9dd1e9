// Candidate effect: a force channel of wrong gain.
#include "diagnosis/candidate/registry.h"

namespace rubber_suspension::diagnosis {
namespace {

fit::Candidate sensorGain(const fit::Excitation& /*excitation*/) {
  fit::BasisTerm term = fit::additiveTerm("sensor_gain", "gain", 0.05);
  term.lower = -0.5;
  term.upper = 1.0;
  term.additive = false;
  term.softening = true;
  fit::Candidate candidate{"sensor_gain",
                           "force channel of wrong gain, beyond the rig's tolerance: one factor on all forces, as "
                           "stiffnesses and damping that are all off by it",
                           true,
                           {term},
                           false};
  candidate.like_parameters = true;
  return candidate;
}

const CandidateEntry kEntry(145, sensorGain);

}  // namespace
}  // namespace rubber_suspension::diagnosis
