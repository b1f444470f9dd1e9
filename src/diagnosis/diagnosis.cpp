// The diagnosis from logs to a result: the bench, search, judgement, description.
#include "rubber_suspension/diagnosis/diagnosis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

#include "diagnosis/hypotheses/log_table.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/hypotheses/search_evidence.h"
#include "diagnosis/hypotheses/unseen_logs.h"
#include "diagnosis/judge/judge.h"
#include "diagnosis/prepare/bench_evidence.h"
#include "diagnosis/prepare/excerpts.h"
#include "diagnosis/prepare/friction_noise.h"
#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/prepare/measured_logs.h"
#include "diagnosis/prepare/memory.h"
#include "diagnosis/prepare/rig.h"
#include "diagnosis/refused.h"
#include "diagnosis/results/augmented.h"
#include "diagnosis/results/describe.h"
#include "diagnosis/results/workings.h"
#include "fit/parallel.h"
#include "io/available_memory.h"
#include "rubber_suspension/measurement/bench_check.h"
#include "rubber_suspension/measurement/prepared_log.h"

namespace rubber_suspension::diagnosis {
namespace {

using measurement::PreparedLog;
using measurement::RigFinding;

// The logs, then those held out.
std::vector<PreparedLog> prepare(const Excerpts& excerpts, int threads) {
  std::vector<const log::Log*> logs;
  for (const auto* list : {&excerpts.logs, &excerpts.hold_out}) {
    for (const log::Log& log : *list) {
      logs.push_back(&log);
    }
  }
  std::vector<PreparedLog> prepared(logs.size());
  fit::parallelFor(logs.size(), threads, [&](std::size_t i) { prepared[i] = measurement::prepareLog(*logs[i]); });
  return prepared;
}

std::vector<log::Record> takeRecords(std::vector<PreparedLog> prepared) {
  std::vector<log::Record> records;
  for (PreparedLog& log : prepared) {
    records.push_back(std::move(log.record));
  }
  return records;
}

// All but the first `count`, which stay.
std::vector<log::Record> splitOff(std::vector<log::Record>& records, std::size_t count) {
  const auto first = std::make_move_iterator(records.begin() + static_cast<std::ptrdiff_t>(count));
  std::vector<log::Record> others(first, std::make_move_iterator(records.end()));
  records.resize(count);
  return others;
}

std::vector<RigFinding> findingsOf(const std::vector<PreparedLog>& prepared) {
  std::vector<RigFinding> findings;
  for (const PreparedLog& log : prepared) {
    findings.insert(findings.end(), log.findings.begin(), log.findings.end());
  }
  return findings;
}

// What a log may have that is slow and no drift, as a gap over all logs: slow noise of the rig, and what small
// reversals make of Berg's friction.
double slowNoiseOf(const io::ComponentDescription& component, const std::vector<log::Record>& records) {
  std::vector<double> shares = frictionNoise(component.allElements(), records);
  for (std::size_t r = 0; r < records.size(); ++r) {
    shares[r] = std::hypot(records[r].slow_noise / records[r].force_deviation, shares[r]);
  }
  return commonFloor(shares, records);
}

std::pair<Judgement, Evidence> judgeSearch(const PreparedCase& prepared, const Search& search, const Criteria& criteria,
                                           const DiagnosisOptions& options) {
  Evidence evidence = evidenceOf(search);
  evidence.resamplings = options.resamplings;
  evidence.seed = options.seed;
  evidence.has_unseen_logs = !prepared.held_out.empty();
  evidence.slow_noise = slowNoiseOf(prepared.component, prepared.training);
  markGainsWithinTolerance(prepared.component.rig.value_or(io::RigTolerances{}).gain, search, criteria, evidence);
  const NoiseLimit limit = noiseLimit(search.record_noise, prepared.training);
  if (evidence.has_unseen_logs) {
    fit::parallelFor(evidence.hypotheses.size(), options.threads, [&](std::size_t hypothesis) {
      evidence.hypotheses[hypothesis].unseen =
          unseenErrors(prepared.model, search.at(static_cast<int>(hypothesis)), prepared.held_out, limit);
    });
  }
  Judgement judgement = judge(evidence, criteria);
  return {std::move(judgement), std::move(evidence)};
}

// A search and what it comes to.
struct Judged {
  std::unique_ptr<PreparedCase> prepared;
  std::shared_ptr<Workings> workings;
};

Judged searchAndJudge(const io::ComponentDescription& component, std::vector<log::Record> training,
                      std::vector<log::Record> held_out, const DiagnosisOptions& options) {
  const Criteria criteria;
  Judged judged{std::make_unique<PreparedCase>(component, std::move(training), std::move(held_out)),
                std::make_shared<Workings>()};
  judged.workings->search = search(MeasuredLogs(judged.prepared->fitter, judged.prepared->element_fitter), criteria,
                                   options.threads, options.progress);
  auto [judgement, evidence] = judgeSearch(*judged.prepared, judged.workings->search, criteria, options);
  judged.workings->judgement = std::move(judgement);
  for (const HypothesisEvidence& hypothesis : evidence.hypotheses) {
    if (hypothesis.unseen) {
      judged.workings->unseen.push_back(*hypothesis.unseen);
    }
  }
  judged.workings->evidence = std::move(evidence);
  return judged;
}

// The hypothesis that leaves least, of those that say nothing of zeros and trends.
const FittedHypothesis& bestButZeros(const Search& search) {
  const auto tells = [&](const FittedHypothesis& fitted) {
    return fitted.hypothesis.free_in_log.trend ||
           std::any_of(fitted.hypothesis.members.begin(), fitted.hypothesis.members.end(), [&](int member) {
             return search.candidates[static_cast<std::size_t>(member)].effect == "force_offset";
           });
  };
  const FittedHypothesis* best = &search.re_estimated;
  for (const FittedHypothesis* fitted : search.withEffects()) {
    const bool counts = fitted->hypothesis.competes() && !tells(*fitted);
    best = counts && fitted->fit.score() < best->fit.score() ? fitted : best;
  }
  return *best;
}

// Zeros are free in the first search, so that no effect is weighed by them and what they are is told by the best law.
// If they have a cause, they count in a second search.
void considerZeros(const io::ComponentDescription& component, const io::RigTolerances& tolerances,
                   const DiagnosisOptions& options, Judged& judged) {
  const Search& search = judged.workings->search;
  const Criteria criteria;
  const double least = std::max(criteria.insignificant_gap, criteria.within_noise * search.noise);
  const auto elements = augmentedDescription(judged.prepared->model, bestButZeros(search)).allElements();
  const std::optional<double> zero =
      zeroWithCause(elements, least, tolerances, judged.prepared->training, judged.prepared->held_out);
  if (!zero) {
    return;
  }
  std::vector<log::Record> training = judged.prepared->training;
  std::vector<log::Record> held_out = judged.prepared->held_out;
  countZeros(elements, *zero, tolerances, training, held_out);
  judged = {};  // two searches are not in memory at once
  judged = searchAndJudge(component, std::move(training), std::move(held_out), options);
}

// The model that is judged, the one without an effect, and the best with effects: zeros of the displacement keep a law
// that is not linear from its best fit, so that the right one need not be the best yet.
std::vector<const FittedHypothesis*> likeliest(const Judged& judged) {
  constexpr std::size_t kSingles = 4;
  constexpr std::size_t kPairs = 2;
  const Search& search = judged.workings->search;
  std::vector<const FittedHypothesis*> singles;
  for (const FittedHypothesis& single : search.singles) {
    if (single.hypothesis.competes()) {
      singles.push_back(&single);
    }
  }
  std::stable_sort(singles.begin(), singles.end(), [](const FittedHypothesis* x, const FittedHypothesis* y) {
    return x->fit.score() < y->fit.score();
  });
  std::vector<const FittedHypothesis*> chosen = {&search.at(judged.workings->judgement.model), &search.re_estimated};
  singles.resize(std::min(kSingles, singles.size()));
  chosen.insert(chosen.end(), singles.begin(), singles.end());
  for (std::size_t i = 0; i < std::min(kPairs, search.pairs.size()); ++i) {
    chosen.push_back(&search.pairs[i]);
  }
  return chosen;
}

// Elements of the model that leaves least once both zeros of each log are free; of those that leave about as little,
// the one with the fewest numbers, since a law with many follows zeros as well.
std::vector<element::ElementDescription> bestWithoutZeros(const Judged& judged, const io::RigTolerances& tolerances,
                                                          int threads) {
  constexpr double kAbout = 1.05;
  const std::vector<const FittedHypothesis*> models = likeliest(judged);
  std::vector<std::vector<element::ElementDescription>> elements(models.size());
  std::vector<double> left(models.size());
  fit::parallelFor(models.size(), threads, [&](std::size_t i) {
    elements[i] = augmentedDescription(judged.prepared->model, *models[i]).allElements();
    left[i] = leftWithoutZeros(elements[i], tolerances, judged.prepared->training);
  });
  const double least = *std::min_element(left.begin(), left.end());
  std::size_t best = 0;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < models.size(); ++i) {
    const std::size_t terms = models[i]->hypothesis.terms.size();
    if (left[i] <= kAbout * least && terms < fewest) {
      best = i;
      fewest = terms;
    }
  }
  return elements[best];
}

// What the best of all hypotheses leaves of the logs of the fit, and of unseen ones: 0 where there are none.
struct Least {
  double score = 0.0;
  double unseen = 0.0;
};

Least leastOf(const Judged& judged) {
  const Search& search = judged.workings->search;
  const std::vector<UnseenErrors>& unseen = judged.workings->unseen;
  Least least{search.re_estimated.fit.score(), unseen.empty() ? 0.0 : unseen[Evidence::kReEstimated].gap};
  const std::vector<const FittedHypothesis*> fitted = search.withEffects();
  for (std::size_t i = 0; i < fitted.size(); ++i) {
    if (fitted[i]->hypothesis.competes()) {
      least.score = std::min(least.score, fitted[i]->fit.score());
      least.unseen = unseen.empty() ? 0.0 : std::min(least.unseen, unseen[Evidence::kFirstSingle + i].gap);
    }
  }
  return least;
}

// Zeros of the displacement show through laws that are not linear, and delays through all: they are known once these
// are, and taken out. Under a law that is not the right one they would be wrong: they stay where nothing explains the
// logs better without them, or unseen logs as well.
void takeOutRig(const io::ComponentDescription& component, const io::RigTolerances& tolerances,
                const DiagnosisOptions& options, Judged& judged, std::vector<RigFinding>& findings) {
  auto elements = bestWithoutZeros(judged, tolerances, options.threads);
  const auto is_delay = [](const element::ElementDescription& element) { return element.type == "time_delay"; };
  elements.erase(std::remove_if(elements.begin(), elements.end(), is_delay), elements.end());  // told log by log
  std::vector<log::Record> training = judged.prepared->training;
  std::vector<log::Record> held_out = judged.prepared->held_out;
  const std::vector<RigPart> parts = rigParts(elements, tolerances, training);
  const double delay = commonDelay(parts);
  if (!takeOut(parts, delay, training)) {
    return;
  }
  const std::vector<RigPart> of_held_out = rigParts(elements, tolerances, held_out);
  takeOut(of_held_out, delay, held_out);
  forgetUnitEffects(judged.workings->search);  // two searches are not in memory at once
  Judged without = searchAndJudge(component, std::move(training), std::move(held_out), options);
  const Least as_it_was = leastOf(judged);
  const Least is = leastOf(without);
  if (is.score >= as_it_was.score || is.unseen > Criteria().floor_margin * as_it_was.unseen) {
    without = {};
    findUnitEffects(judged.workings->search, judged.prepared->training, options.threads);
    return;
  }
  judged = std::move(without);
  for (const auto* list : {&parts, &of_held_out}) {
    for (const RigPart& part : *list) {
      findings.insert(findings.end(), part.findings.begin(), part.findings.end());
    }
  }
}

// Where nothing is named, what part of the gap the motion causes at all counts: no effect has to explain more.
void considerMotion(const DiagnosisOptions& options, Judged& judged) {
  Workings& workings = *judged.workings;
  if (workings.judgement.verdict != Verdict::unknown) {
    return;
  }
  const PreparedCase& prepared = *judged.prepared;
  const auto component = augmentedDescription(prepared.model, workings.search.at(workings.judgement.model));
  const gap::Forces force = gap::simulate(component.allElements(), prepared.training, gap::asRecorded);
  workings.surrogate = fitSurrogate(component, {prepared.training, force, prepared.held_out}, options.threads);
  workings.evidence->caused_by_motion = shareOfMotion(*workings.surrogate, workings.evidence->noise_floor);
  workings.judgement = judge(*workings.evidence);
  if (!workings.judgement.effects.empty()) {
    workings.surrogate.reset();  // the rest is another one
  }
}

// `recorded`: the whole logs that the gap as recorded is of.
Diagnosis diagnoseExcerpts(const io::ComponentDescription& component, const Excerpts& excerpts,
                           const std::vector<LogSurvey>& recorded, const DiagnosisOptions& options) {
  std::vector<PreparedLog> prepared = prepare(excerpts, options.threads);
  std::vector<RigFinding> findings = findingsOf(prepared);
  std::vector<log::Record> training = takeRecords(std::move(prepared));
  addLeadIns(excerpts.lead_in, training);
  const auto bench = measurement::checkBench(component.allElements(), training);
  findings.insert(findings.end(), bench.begin(), bench.end());
  if (measurement::anyFatal(findings)) {
    auto evidence = std::make_shared<BenchEvidence>(benchEvidence(component.allElements(), training, findings));
    Diagnosis result = refused(component, std::move(findings));
    result.bench_evidence = std::move(evidence);
    return result;
  }
  std::vector<log::Record> held_out = splitOff(training, excerpts.logs.size());
  const io::RigTolerances tolerances = component.rig.value_or(io::RigTolerances{});
  freeNuisances(fit::ModelParameters(component, fit::Level::specification), tolerances, training, held_out);
  Judged judged = searchAndJudge(component, std::move(training), std::move(held_out), options);
  considerZeros(component, tolerances, options, judged);
  takeOutRig(component, tolerances, options, judged, findings);
  considerMotion(options, judged);
  if (options.evidence) {
    addLogTable(*judged.prepared, judged.workings->search, options.threads, *judged.workings->evidence);
  } else {
    judged.workings->evidence.reset();
  }
  return describe(*judged.prepared, std::move(judged.workings), recorded, std::move(findings), options);
}

}  // namespace

Diagnosis diagnose(const io::ComponentDescription& component, const log::LogSources& logs,
                   const log::LogSources& hold_out, const DiagnosisOptions& options) {
  if (logs.empty()) {
    throw log::LogError("no log: a diagnosis needs at least one");
  }
  const component::Component built = component.makeComponent();
  const std::vector<LogSurvey> surveys = surveyLogs(logs, built, options.threads);
  const std::vector<LogSurvey> unseen = surveyLogs(hold_out, built, options.threads);
  const Excerpts excerpts = makeExcerpts(surveys, unseen, options.most_samples);
  requireMemory(excerpts.samples, excerpts.of, options.threads,
                options.available_memory > 0 ? options.available_memory : io::availableMemory());
  Diagnosis result = diagnoseExcerpts(component, excerpts, unseen.empty() ? surveys : unseen, options);
  result.samples = excerpts.samples;
  result.recorded_samples = excerpts.of;
  return result;
}

Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options) {
  const auto sources = [](const std::vector<log::Log>& list) {
    log::LogSources result;
    std::transform(list.begin(), list.end(), std::back_inserter(result),
                   [](const log::Log& log) { return log::sourceOf(log); });
    return result;
  };
  return diagnose(component, sources(logs), sources(hold_out), options);
}

}  // namespace rubber_suspension::diagnosis
