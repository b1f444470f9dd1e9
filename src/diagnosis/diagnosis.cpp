// The diagnosis from logs to a result: search, judgement, description.
#include "rubber_suspension/diagnosis/diagnosis.h"

#include <memory>
#include <utility>

#include "diagnosis/judge/judge.h"
#include "diagnosis/report/describe.h"
#include "diagnosis/search.h"
#include "diagnosis/unseen_logs.h"
#include "diagnosis/workings.h"
#include "fit/parallel.h"

namespace rubber_suspension::diagnosis {
namespace {

std::vector<log::Record> makeRecords(const std::vector<log::Log>& logs, int threads) {
  std::vector<log::Record> records(logs.size());
  fit::parallelFor(logs.size(), threads, [&](std::size_t i) { records[i] = log::makeRecord(logs[i]); });
  return records;
}

// Errors on unseen logs are found when the judgement turns on them, which is for few hypotheses.
Judgement judgeSearch(const PreparedCase& prepared, const Search& search, const Criteria& criteria) {
  Evidence evidence = evidenceOf(search);
  evidence.has_unseen_logs = !prepared.held_out.empty();
  Judgement judgement = judge(evidence, criteria);
  while (judgement.missing) {
    const int hypothesis = *judgement.missing;
    evidence.hypotheses[static_cast<std::size_t>(hypothesis)].unseen =
        unseenErrors(prepared.model, search.at(hypothesis), prepared.held_out);
    judgement = judge(evidence, criteria);
  }
  return judgement;
}

}  // namespace

Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options) {
  if (logs.empty()) {
    throw log::LogError("no log: a diagnosis needs at least one");
  }
  const PreparedCase prepared(component, makeRecords(logs, options.threads), makeRecords(hold_out, options.threads));
  const Criteria criteria;
  auto workings = std::make_shared<Workings>();
  workings->search = search(prepared.fitter, prepared.element_fitter, criteria, options.threads, options.progress);
  workings->judgement = judgeSearch(prepared, workings->search, criteria);
  return describe(prepared, std::move(workings), options);
}

}  // namespace rubber_suspension::diagnosis
