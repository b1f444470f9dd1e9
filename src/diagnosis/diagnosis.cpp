// Diagnoses logs: checks the bench, searches the hypotheses, judges them and describes the result.
#include "rubber_suspension/diagnosis/diagnosis.h"

#include <fmt/format.h>

#include <Eigen/Core>
#include <algorithm>
#include <iterator>
#include <memory>
#include <string>
#include <utility>

#include "diagnosis/experiment/confusion.h"
#include "diagnosis/experiment/next_experiment.h"
#include "diagnosis/hypotheses/log_table.h"
#include "diagnosis/hypotheses/measured_logs.h"
#include "diagnosis/hypotheses/odds.h"
#include "diagnosis/hypotheses/search.h"
#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/invariants.h"
#include "diagnosis/judge/answer.h"
#include "diagnosis/prepare/bench_evidence.h"
#include "diagnosis/prepare/excerpts.h"
#include "diagnosis/prepare/lines.h"
#include "diagnosis/prepare/log_survey.h"
#include "diagnosis/prepare/memory.h"
#include "diagnosis/prepare/rig.h"
#include "diagnosis/results/describe.h"
#include "diagnosis/results/own_errors.h"
#include "diagnosis/surveyed_logs.h"
#include "diagnosis/words/sentence.h"
#include "diagnosis/words/text.h"
#include "element/each.h"
#include "element/largest_number.h"
#include "estimation/models.h"
#include "fit/parallel.h"
#include "gap/simulate.h"
#include "io/available_memory.h"
#include "io/rotational_unit.h"
#include "rubber_suspension/measurement/bench_check.h"
#include "rubber_suspension/measurement/prepared_log.h"

namespace rubber_suspension::diagnosis {
namespace {

using measurement::PreparedLog;
using measurement::RigFinding;

// Prepares the logs of the fit, each with its lead-in, and then the held-out logs.
std::vector<PreparedLog> preparedLogs(const prepare::Excerpts& excerpts, int threads) {
  const std::size_t of_the_fit = excerpts.logs.size();
  std::vector<PreparedLog> prepared(of_the_fit + excerpts.hold_out.size());
  fit::parallelFor(prepared.size(), threads, [&](std::size_t i) {
    prepared[i] = i < of_the_fit ? measurement::prepareLog(excerpts.logs[i], excerpts.lead_in[i])
                                 : measurement::prepareLog(excerpts.hold_out[i - of_the_fit]);
  });
  return prepared;
}

std::vector<log::Record> takeRecords(std::vector<PreparedLog> prepared) {
  std::vector<log::Record> records;
  for (PreparedLog& log : prepared) {
    records.push_back(std::move(log.record));
  }
  return records;
}

// Removes all records but the first `count`, and returns the removed ones.
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

Workings judged(const hypotheses::PreparedCase& prepared, hypotheses::Search search, const DiagnosisOptions& options) {
  search.noise.unseen = hypotheses::floorsOfUnseen(prepared, search);
  judge::Evidence evidence = hypotheses::evidenceOfLogs(prepared, search, options.threads);
  return {std::move(search), std::move(evidence), options.evidence};
}

using Records = std::vector<gap::PreparedRecord>;

// Prepares the models to be fitted and the logs of the fit, to which the priors of the rig's errors are added.
std::unique_ptr<hypotheses::PreparedCase> withRigPriors(const io::ComponentDescription& component, Records training,
                                                        Records held_out) {
  const fit::ModelParameters model(component, fit::Level::specification);
  prepare::LogsOfRig logs = prepare::withRigPriors(model, component.rig.value_or(io::RigTolerances{}),
                                                   hypotheses::errorScale(), std::move(training), std::move(held_out));
  return std::make_unique<hypotheses::PreparedCase>(component, std::move(logs.training), std::move(logs.held_out));
}

struct JudgedCase {
  std::unique_ptr<hypotheses::PreparedCase> prepared;
  Workings workings;
};

// Searches and judges the hypotheses. Gains or offsets that differ between logs without a cause in the motion are
// errors of these logs. They become free parameters, and the search is repeated until it finds no further ones.
JudgedCase searchedAndJudged(const io::ComponentDescription& component, Records training, Records held_out,
                             const DiagnosisOptions& options) {
  const std::vector<std::string> excluded = hypotheses::excludedEffects(component, options);
  for (;;) {
    auto prepared = withRigPriors(component, training, held_out);
    hypotheses::Search search =
        hypotheses::search(hypotheses::MeasuredLogs(prepared->fitter), excluded, options.threads, options.progress);
    Workings workings = judged(*prepared, std::move(search), options);
    const auto own = results::ownErrors(*prepared, workings.search.at(workings.answer.model));
    if (own.empty()) {
      return {std::move(prepared), std::move(workings)};
    }
    for (std::size_t r = 0; r < own.size(); ++r) {
      (r < training.size() ? training[r] : held_out[r - training.size()]).own = own[r];
    }
  }
}

// Converts rig findings to the units of a rotation. The sources in measurement/ treat every motion as a displacement.
std::vector<RigFinding> ofRotation(std::vector<RigFinding> findings) {
  for (RigFinding& finding : findings) {
    finding.unit = io::rotationalUnit(finding.unit);
    finding.text = words::inRotationUnits(finding.text);
  }
  return findings;
}

Diagnosis ofRotation(Diagnosis result) {
  result.turns = true;
  for (auto* sizes : {&result.law.model_sizes, &result.law.effect_sizes, &result.law.numbers}) {
    for (SizedValue& size : *sizes) {
      size.unit = io::rotationalUnit(size.unit);
    }
  }
  for (Admission& log : result.logs.admission) {
    log.notes = element::each(log.notes, words::inRotationUnits);
  }
  result.rig_findings = ofRotation(std::move(result.rig_findings));
  std::string& motion = result.next.proposed.description;
  motion = words::inRotationUnits(motion);
  return result;
}

Diagnosis inWords(const fit::Fitter& fitter, const experiment::NextExperiment& next, Diagnosis result) {
  const hypotheses::Search& search = result.workings->search;
  const hypotheses::FittedHypothesis& judged = search.at(result.workings->answer.model);
  const std::string temperature = words::temperatureNote(result.answer.effects, search.excitation);
  result.sentence = words::sentence(result) + words::excludedNote(result) +
                    words::factorNote(fitter.factors(judged.hypothesis, judged.fit.parameters)) + temperature +
                    (result.surrogate ? words::restNote(*result.surrogate) : "");
  result.next.text =
      words::experimentText(result, next) + (temperature.empty() ? "" : " Record temperature_degC at the same time.");
  return result;
}

// Removes hum of the mains or of a pump, which consists of lines in the spectrum, from the force of each log.
std::vector<RigFinding> removeLines(const io::ComponentDescription& component, std::vector<log::Record>& records,
                                    std::vector<prepare::RawChannels>& raw) {
  prepare::RigLines lines =
      prepare::linesOfRig(records, gap::simulateEach(component.allElements(), Records(records.begin(), records.end())));
  for (std::size_t r = 0; r < records.size(); ++r) {
    if (lines.forces[r].size() > 0) {
      records[r].force -= lines.forces[r];
      raw[r].line = std::move(lines.forces[r]);
    }
  }
  return std::move(lines.findings);
}

// `recorded` are the whole logs, from which the gap as recorded is computed.
Diagnosis diagnoseExcerpts(const io::ComponentDescription& component, const prepare::Excerpts& excerpts,
                           const std::vector<prepare::LogSurvey>& recorded, const DiagnosisOptions& options) {
  std::vector<PreparedLog> prepared = preparedLogs(excerpts, options.threads);
  std::vector<RigFinding> findings = findingsOf(prepared);
  std::vector<log::Record> training = takeRecords(std::move(prepared));
  const auto bench = measurement::checkBench(component.allElements(), training,
                                             estimation::largestTolerance(component.specification()));
  findings.insert(findings.end(), bench.begin(), bench.end());
  if (measurement::anyFatal(findings)) {
    auto evidence =
        std::make_shared<BenchEvidence>(prepare::benchEvidence(component.allElements(), training, findings));
    Diagnosis result =
        prepare::refused(component, options.turns ? ofRotation(std::move(findings)) : std::move(findings));
    result.turns = options.turns;
    result.bench_evidence = std::move(evidence);
    result.samples = {excerpts.samples, excerpts.of};
    return result;
  }
  std::vector<prepare::RawChannels> raw = prepare::rawChannels(excerpts.logs, excerpts.hold_out);
  const std::vector<RigFinding> lines = removeLines(component, training, raw);
  findings.insert(findings.end(), lines.begin(), lines.end());
  const std::vector<log::Record> held_out = splitOff(training, excerpts.logs.size());
  JudgedCase judged =
      searchedAndJudged(component, {training.begin(), training.end()}, {held_out.begin(), held_out.end()}, options);
  const fit::Fitter& fitter = judged.prepared->fitter;
  Diagnosis result =
      results::describe(*judged.prepared, std::move(judged.workings), recorded, raw, std::move(findings), options);
  result.samples = {excerpts.samples, excerpts.of};
  const experiment::NextExperiment next =
      experiment::nextExperiment(fitter, *result.workings, options.limits, options.threads);
  result.next.proposed = next.proposed;
  result.could_show = experiment::couldShow(result.workings->search);
  return inWords(fitter, next, options.turns ? ofRotation(std::move(result)) : std::move(result));
}

double largestOf(const std::vector<double>& signal) {
  return Eigen::Map<const Eigen::VectorXd>(signal.data(), static_cast<Eigen::Index>(signal.size()))
      .lpNorm<Eigen::Infinity>();
}

// Returns an error that names the stiffest log, for a fit that needs a parameter outside the range of every law.
log::LogError beyondAllLaws(const std::vector<log::Log>& logs, const char* number) {
  const auto stiffness = [](const log::Log& log) { return largestOf(log.force) / largestOf(log.displacement); };
  const auto log = std::max_element(logs.begin(), logs.end(),
                                    [&](const auto& a, const auto& b) { return stiffness(a) < stiffness(b); });
  return log::LogError(fmt::format(
      "{}: forces up to {:.3g} at displacements up to {:.3g} (SI units) need a parameter outside the range of "
      "every law ({}): check the units of the columns",
      log->name, largestOf(log->force), largestOf(log->displacement), number));
}

}  // namespace

SurveyedLogs surveyed(const io::ComponentDescription& component, const log::LogSources& logs,
                      const log::LogSources& hold_out, int threads) {
  if (logs.empty()) {
    throw log::LogError("no log is given; accepted: at least one log");
  }
  const component::Component built = component.makeComponent();
  return {prepare::surveyLogs(logs, built, threads), prepare::surveyLogs(hold_out, built, threads)};
}

Diagnosis diagnose(const io::ComponentDescription& component, const SurveyedLogs& logs,
                   const DiagnosisOptions& options) {
  const prepare::Excerpts excerpts = prepare::makeExcerpts(logs.logs, logs.hold_out, options.most_samples);
  prepare::requireMemory({excerpts.samples, excerpts.logs.size()}, excerpts.of, options.threads,
                         options.available_memory > 0 ? options.available_memory : io::availableMemory());
  try {
    return heldToInvariants(
        diagnoseExcerpts(component, excerpts, logs.hold_out.empty() ? logs.logs : logs.hold_out, options));
  } catch (const element::ValueOutOfRange& error) {
    throw beyondAllLaws(excerpts.logs, error.what());
  }
}

Diagnosis diagnose(const io::ComponentDescription& component, const log::LogSources& logs,
                   const log::LogSources& hold_out, const DiagnosisOptions& options) {
  return diagnose(component, surveyed(component, logs, hold_out, options.threads), options);
}

Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options) {
  const auto sources = [](const std::vector<log::Log>& list) -> log::LogSources {
    return element::each(list, [](const log::Log& log) { return log::sourceOf(log); });
  };
  return diagnose(component, sources(logs), sources(hold_out), options);
}

}  // namespace rubber_suspension::diagnosis
