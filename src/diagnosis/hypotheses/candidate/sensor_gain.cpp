// Candidate effect: a force channel with a wrong gain.
#include <fmt/format.h>

#include <cmath>

#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

void addSensorGain(const fit::Excitation& excitation, fit::Candidate& candidate) {
  fit::BasisTerm term = fit::additiveTerm("sensor_gain", "gain", 0.05);
  term.lower = -0.5;
  term.upper = 1.0;
  term.additive = false;
  term.softening = true;
  term.is_gain = true;
  candidate.terms = {term};
  candidate.free_in_log.gain = excitation.whole_logs > 1 && !excitation.own.gain;
  candidate.one_form = true;
  candidate.like_parameters = true;
}

std::string gainOrValues(const std::map<std::string, double>& numbers) {
  const auto gain = numbers.find("gain");
  return gain == numbers.end()
             ? ""
             : fmt::format(
                   " The force channel reads {:.1f} % too {}, or all stiffness and damping values of the model are "
                   "wrong by this share: measure a known weight on the load cell to decide.",
                   100.0 * std::abs(gain->second), gain->second > 0.0 ? "much" : "little");
}

// A gain of all logs is equivalent to wrong values of the model. If the range of an amplifier is changed between logs,
// the gains differ, which no values of the model explain.
Effect sensorGain() {
  Effect effect{145, "sensor_gain",
                "wrong gain of the force channel, beyond the rig's tolerance: a factor on all forces, which looks like "
                "wrong stiffness and damping, or a different factor in each log",
                true, addSensorGain};
  effect.remark = gainOrValues;
  effect.beside_values = " Measure a known weight on the load cell to decide.";
  return effect;
}

const EffectEntry kSensorGain(sensorGain());

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
