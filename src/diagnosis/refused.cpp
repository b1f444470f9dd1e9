// The verdict check_bench.
#include "diagnosis/refused.h"

namespace rubber_suspension::diagnosis {

Diagnosis refused(const io::ComponentDescription& component, std::vector<measurement::RigFinding> findings) {
  Diagnosis result;
  result.component = component.name;
  result.answer.verdict = Verdict::check_bench;
  for (const measurement::RigFinding& finding : findings) {
    if (finding.fatal) {
      result.sentence = "Check the bench: " + finding.log + ": " + finding.text + ".";
      break;
    }
  }
  result.next.text = "Correct what was measured, or measure it again, and diagnose again.";
  result.rig_findings = std::move(findings);
  return result;
}

}  // namespace rubber_suspension::diagnosis
