// Candidate effect: a constant force, which may differ between logs.
#include "diagnosis/effect.h"

namespace rubber_suspension::diagnosis::hypotheses::candidate {
namespace {

// Each log may have its own offset, because amplifiers are zeroed between logs and pressures change.
void addForceOffset(const fit::Excitation& excitation, fit::Candidate& candidate) {
  fit::BasisTerm term = fit::additiveTerm("force_offset", "offset", 0.02 * excitation.force);
  term.lower = -term.upper;
  term.on_rig = true;
  term.is_offset = true;
  candidate.terms = {term};
  candidate.free_in_log.offset = excitation.whole_logs > 1 && !excitation.own.zero;
  candidate.one_form = true;
  candidate.constant = true;
}

const EffectEntry kForceOffset({140, "force_offset",
                                "zero error of the load cell: only the mean force is wrong, by the same amount in all "
                                "logs or by a different amount in each log",
                                true, addForceOffset, InSettledLoops::no_part_of_loop});

}  // namespace
}  // namespace rubber_suspension::diagnosis::hypotheses::candidate
