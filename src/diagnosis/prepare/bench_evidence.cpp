// Collects logs with a wrong sign, unit, column or component, as recorded and corrected.
#include "diagnosis/prepare/bench_evidence.h"

#include <algorithm>

#include "gap/simulate.h"
#include "rubber_suspension/measurement/bench_check.h"

namespace rubber_suspension::diagnosis::prepare {
namespace {

constexpr std::size_t kMostLogsOfFigure = 3;

std::optional<ComparedLog> compare(const std::vector<element::ElementDescription>& elements,
                                   const log::Record& record) {
  ComparedLog result{record, gap::simulateEach(elements, {record}).front()};
  return result.simulated.allFinite() ? std::optional<ComparedLog>(std::move(result)) : std::nullopt;
}

}  // namespace

BenchEvidence benchEvidence(const std::vector<element::ElementDescription>& elements,
                            const std::vector<log::Record>& records,
                            const std::vector<measurement::RigFinding>& findings) {
  BenchEvidence evidence;
  for (const measurement::RigFinding& finding : findings) {
    const auto record = std::find_if(records.begin(), records.end(),
                                     [&](const log::Record& candidate) { return candidate.name == finding.log; });
    if (!finding.fatal || finding.finding == measurement::finding::kTooShort || record == records.end() ||
        evidence.logs.size() == kMostLogsOfFigure) {
      continue;
    }
    auto as_recorded = compare(elements, *record);
    if (!as_recorded) {
      continue;
    }
    evidence.logs.push_back({std::move(*as_recorded), "", std::nullopt});
    if (const auto correction = measurement::correctionOf(finding, elements, *record)) {
      evidence.logs.back().correction = correction->text;
      evidence.logs.back().corrected = compare(elements, correction->record);
    }
  }
  return evidence;
}

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
  result.next.text = "Correct the logs or record them again, and repeat the diagnosis.";
  result.rig_findings = std::move(findings);
  return result;
}

}  // namespace rubber_suspension::diagnosis::prepare
