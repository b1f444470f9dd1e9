// Candidate effect: a force channel of wrong gain.
#include "diagnosis/hypotheses/candidate/registry.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// One factor on all logs is what wrong values are. Where an amplifier's range was changed between logs, their gains
// differ, which no values do.
fit::Candidate sensorGain(const fit::Excitation& excitation) {
  fit::BasisTerm term = fit::additiveTerm("sensor_gain", "gain", 0.05);
  term.lower = -0.5;
  term.upper = 1.0;
  term.additive = false;
  term.softening = true;
  term.is_gain = true;
  fit::Candidate candidate{"sensor_gain",
                           "force channel of wrong gain, beyond the rig's tolerance: one factor on all forces, as "
                           "stiffnesses and damping that are all off by it, or another one in each log",
                           true,
                           {term}};
  candidate.free_in_log.gain = excitation.whole_logs > 1;
  candidate.one_form = true;
  candidate.like_parameters = true;
  return candidate;
}

const CandidateEntry kSensorGainEntry(145, sensorGain);

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
