// Description of a judged search.
#include "diagnosis/results/describe.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <utility>

#include "diagnosis/experiment/confusion.h"
#include "diagnosis/experiment/next_experiment.h"
#include "diagnosis/hypotheses/unseen_logs.h"
#include "diagnosis/judge/closed_interval.h"
#include "diagnosis/prepare/rig.h"
#include "diagnosis/report/admission.h"
#include "diagnosis/report/sentence.h"
#include "diagnosis/report/temperature_note.h"
#include "diagnosis/results/augmented.h"
#include "diagnosis/results/characteristics.h"
#include "diagnosis/results/model_parameters_by_log.h"
#include "diagnosis/results/recorded_gap.h"
#include "diagnosis/results/sizes.h"
#include "diagnosis/results/surrogate.h"
#include "fit/parallel.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis {
namespace {

class Describer {
 public:
  Describer(const PreparedCase& prepared, std::shared_ptr<Workings> workings, const std::vector<LogSurvey>& recorded,
            std::vector<measurement::RigFinding> findings, const DiagnosisOptions& options)
      : prepared_(prepared),
        recorded_(recorded),
        options_(options),
        workings_(std::move(workings)),
        search_(workings_->search),
        judgement_(workings_->judgement),
        judged_(search_.at(judgement_.model)) {
    result_.rig_findings = std::move(findings);
  }

  Diagnosis run() {
    result_.component = prepared_.component.name;
    result_.verdict = toString(judgement_.verdict);
    result_.configured = prepared_.component;
    result_.re_estimated = prepared_.model.apply(search_.re_estimated.fit.parameters.model);
    result_.augmented = augmentedDescription(prepared_.model, judged_);
    simulateAll();
    measureCandidates();
    measureGap();
    measureParts();
    mapGap();
    describeRig();
    describeLogs();
    describeCandidates();
    describeParameters();
    describeJudgement();
    describeSurrogate();
    measureRecorded();
    result_.workings = std::move(workings_);
    return std::move(result_);
  }

 private:
  bool hasUnseenLogs() const { return !prepared_.held_out.empty(); }

  // The logs of the fit, then those held out.
  gap::Forces simulate(const io::ComponentDescription& description) const {
    const auto elements = description.allElements();
    gap::Forces forces = gap::simulate(elements, prepared_.training, gap::asRecorded);
    const gap::Forces unseen = gap::simulateEach(elements, prepared_.held_out);
    forces.insert(forces.end(), unseen.begin(), unseen.end());
    return forces;
  }

  void simulateAll() {
    Workings& w = *workings_;
    w.records = prepared_.training;
    w.records.insert(w.records.end(), prepared_.held_out.begin(), prepared_.held_out.end());
    w.training = prepared_.training.size();
    const std::array<std::pair<const io::ComponentDescription*, gap::Forces*>, 3> models = {
        {{&prepared_.component, &w.force_configured},
         {&result_.re_estimated, &w.force_re_estimated},
         {&result_.augmented, &w.force_augmented}}};
    fit::parallelFor(models.size(), options_.threads,
                     [&](std::size_t i) { *models[i].second = simulate(*models[i].first); });
  }

  // The forces of the logs that took no part in the fit.
  gap::Forces unseen(const gap::Forces& forces) const {
    return {forces.begin() + static_cast<std::ptrdiff_t>(prepared_.training.size()), forces.end()};
  }

  // Errors of a hypothesis of the evidence on the logs that took no part in the fit.
  const std::vector<gap::PartError>& unseenParts(int hypothesis) const {
    return workings_->unseen[static_cast<std::size_t>(hypothesis)].parts;
  }

  // Errors with each effect alone, on the data that the gap is of.
  void measureCandidates() {
    of_candidates_.resize(search_.singles.size());
    fit::parallelFor(of_candidates_.size(), options_.threads, [&](std::size_t c) {
      const FittedHypothesis& single = search_.singles[c];
      of_candidates_[c] = single.fit.blocks;
      if (hasUnseenLogs()) {
        // Where it is not named, a drift or a gain is what a simulation predicts of it: what is free in a log would
        // take slow noise, or a law's error, with it.
        const bool as_predicted = single.hypothesis.free_in_log.any() && &single != &judged_;
        of_candidates_[c] =
            as_predicted ? gap::partErrors(prepared_.held_out, predict(prepared_.model, single, prepared_.held_out))
                         : unseenParts(Evidence::kFirstSingle + static_cast<int>(c));
      }
    });
  }

  // Noise is no more than what any of the models leaves.
  void boundFloor() {
    Gap& gap = result_.gap;
    gap.noise_floor = std::min({gap.noise_floor, gap.as_configured, gap.re_estimated, gap.augmented});
    for (const auto& errors : of_candidates_) {
      gap.noise_floor = std::min(gap.noise_floor, gap::gapOfParts(errors));
    }
  }

  void measureGap() {
    noise_ = search_.record_noise;
    result_.noise_source = search_.noise_source;
    if (hasUnseenLogs()) {
      before_ = unseenParts(Evidence::kReEstimated);
      after_ = unseenParts(judgement_.model);
      const std::vector<double> floors =
          noiseFloors(result_.augmented.allElements(), freeOfNoise(judged_.hypothesis),
                      predict(prepared_.model, judged_, prepared_.held_out), prepared_.held_out,
                      noiseLimit(search_.record_noise, prepared_.training));
      noise_.insert(noise_.end(), floors.begin(), floors.end());
      result_.gap = {gap::gapOfParts(unseenParts(Evidence::kAsConfigured)), gap::gapOfParts(before_),
                     gap::gapOfParts(after_), commonFloor(floors, prepared_.held_out)};
    } else {
      before_ = search_.re_estimated.fit.blocks;
      after_ = judged_.fit.blocks;
      result_.gap = {search_.configured_gap, gap::gapOfParts(before_), gap::gapOfParts(after_), search_.noise};
    }
    boundFloor();
    result_.closed = closed(result_.gap.augmented);
    result_.closed_interval = judgement_.effects.empty() ? interval(after_) : intervalOnFurtherLogs();
  }

  // Of what is named; the logs that the gap is of are further logs, too.
  std::array<double, 2> intervalOnFurtherLogs() const {
    std::vector<LogErrors> logs;
    addLogs(search_.re_estimated.fit.blocks, judged_.fit.blocks, 0, logs);
    if (hasUnseenLogs()) {
      addLogs(before_, after_, workings_->training, logs);
    }
    const std::array<double, 2> interval = closedOnFurtherLogs(logs, options_.resamplings, options_.seed);
    return {std::min(interval[0], result_.closed), std::max(interval[1], result_.closed)};
  }

  // Errors of parts gathered log by log, the first of which is the record at that place.
  void addLogs(const std::vector<gap::PartError>& before, const std::vector<gap::PartError>& after, std::size_t first,
               std::vector<LogErrors>& logs) const {
    for (std::size_t i = 0; i < before.size(); ++i) {
      const std::size_t place = first + static_cast<std::size_t>(before[i].log);
      if (place >= logs.size()) {
        logs.resize(place + 1, {0.0, 0.0, 0.0, 0.0});
      }
      logs[place].before += before[i].weight * before[i].error;
      logs[place].after += after[i].weight * after[i].error;
      logs[place].weight += before[i].weight;
    }
    for (std::size_t r = first; r < logs.size(); ++r) {
      if (logs[r].weight == 0.0) {
        continue;  // no sample of it counts
      }
      logs[r].before /= logs[r].weight;
      logs[r].after /= logs[r].weight;
      logs[r].floor = noise_[r];
      logs[r].weight = workings_->records[r].weight;
    }
  }

  // What of the gap is due to the model's own values, and what to the effects: each alone. In sample where there are no
  // unseen logs, as both are.
  void measureParts() {
    io::ComponentDescription values = result_.augmented;
    values.add = prepared_.component.add;
    io::ComponentDescription effects = prepared_.component;
    effects.add = result_.augmented.add;
    const std::array<std::pair<const io::ComponentDescription*, double*>, 2> parts = {
        {{&values, &result_.gap_of_values}, {&effects, &result_.gap_of_effects}}};
    fit::parallelFor(parts.size(), options_.threads, [&](std::size_t i) {
      const auto elements = parts[i].first->allElements();
      const std::vector<log::Record>& records = hasUnseenLogs() ? prepared_.held_out : prepared_.training;
      const auto smoothed = [](const log::Record& record) { return record.displacement; };
      *parts[i].second =
          gap::gapOfParts(gap::partErrors(records, hasUnseenLogs() ? gap::simulateEach(elements, records, smoothed)
                                                                   : gap::simulate(elements, records)));
    });
  }

  // Gaps of the whole logs with all that the rig did to them.
  void measureRecorded() {
    std::vector<std::vector<element::ElementDescription>> models;
    for (const auto& description : {prepared_.component, result_.re_estimated, result_.augmented}) {
      models.push_back(description.allElements());
    }
    if (result_.surrogate) {
      models.push_back(result_.surrogate->component.allElements());
    }
    const Recorded recorded = hasUnseenLogs() ? Recorded::each_on_a_new_one : Recorded::on_one_component;
    const std::vector<double> gaps = recordedGaps(models, recorded_, recorded, options_.threads);
    result_.gap_as_recorded = {gaps[0], gaps[1], gaps[2]};
    if (result_.surrogate) {
      result_.surrogate->gap = gaps[3];
    }
  }

  double closed(double gap) const {
    return std::min(1.0, gap::closedFraction(result_.gap.re_estimated, gap, result_.gap.noise_floor));
  }

  std::array<double, 2> interval(const std::vector<gap::PartError>& after) const {
    return closedInterval(before_, after, result_.gap.noise_floor, options_.resamplings, options_.seed);
  }

  // Errors over frequency, amplitude and time, on the logs that the gap is of; where the configured model is wrong.
  void mapGap() {
    const Workings& w = *workings_;
    const std::vector<log::Record>& records = hasUnseenLogs() ? prepared_.held_out : prepared_.training;
    const auto of = [&](const gap::Forces& forces) { return hasUnseenLogs() ? unseen(forces) : forces; };
    const std::array<std::function<void()>, 3> tasks = {
        [&] { result_.errors_re_estimated = characteristicErrors(records, of(w.force_re_estimated)); },
        [&] { result_.errors_augmented = characteristicErrors(records, of(w.force_augmented)); },
        [&] {
          gap::Forces residual;
          for (std::size_t r = 0; r < prepared_.training.size(); ++r) {
            const log::Record& record = prepared_.training[r];
            residual.push_back(record.withoutRig(record.force - w.force_configured[r]));
          }
          result_.where = gap::gapMap(prepared_.training, residual, search_.record_noise);
        }};
    fit::parallelFor(tasks.size(), options_.threads, [&](std::size_t i) { tasks[i](); });
  }

  // What the rig did to each log, by what the best model leaves of it.
  void describeRig() {
    const io::RigTolerances tolerances = prepared_.component.rig.value_or(io::RigTolerances{});
    const auto elements = result_.augmented.allElements();
    for (const auto* records : {&prepared_.training, &prepared_.held_out}) {
      const auto found = rigFindings(elements, tolerances, *records);
      result_.rig_findings.insert(result_.rig_findings.end(), found.begin(), found.end());
    }
  }

  void describeLogs() {
    result_.admission.resize(noise_.size());
    fit::parallelFor(noise_.size(), options_.threads, [&](std::size_t r) {
      result_.admission[r] = admit(workings_->records[r], r >= prepared_.training.size(), noise_[r]);
    });
  }

  void describeCandidates() {
    result_.candidates.resize(search_.candidates.size());
    fit::parallelFor(result_.candidates.size(), options_.threads,
                     [&](std::size_t c) { result_.candidates[c] = describeCandidate(c); });
    std::stable_sort(result_.candidates.begin(), result_.candidates.end(),
                     [](const CandidateResult& a, const CandidateResult& b) {
                       return a.probability != b.probability ? a.probability > b.probability : a.closed > b.closed;
                     });
  }

  CandidateResult describeCandidate(std::size_t c) const {
    const FittedHypothesis& single = search_.singles[c];
    const std::vector<gap::PartError>& errors = of_candidates_[c];
    CandidateResult candidate;
    candidate.effect = search_.candidates[c].effect;
    candidate.documentation = search_.candidates[c].documentation;
    candidate.on_rig = search_.candidates[c].on_rig;
    candidate.probability = judgement_.probabilities[c];
    candidate.gap = gap::gapOfParts(errors);
    candidate.closed = closed(candidate.gap);
    candidate.interval = &single == &judged_ ? result_.closed_interval : interval(errors);
    candidate.visible_share = search_.visible_share[c];
    candidate.testable = judgement_.testable[c];
    candidate.add = entriesOf(single);
    candidate.parameters = headlineOf(candidate.add);
    return candidate;
  }

  void describeParameters() {
    const fit::Fit& joint = search_.re_estimated.fit;
    result_.parameter_ratios = prepared_.model.ratios(joint.parameters.model);
    result_.by_log = parametersByLog(prepared_.fitter, joint);
    Sizes sizes = sizesOf(prepared_.fitter, search_.candidates, judged_, options_);
    result_.model_sizes = std::move(sizes.model);
    result_.effect_sizes = std::move(sizes.effects);
  }

  void describeJudgement() {
    result_.posterior = judgement_.posterior;
    result_.effects = names(judgement_.effects);
    for (const auto& set : judgement_.confounded) {
      result_.confounded.push_back(names(set));
    }
    if (judgement_.values_would_do) {
      result_.confounded.front().push_back(toString(Verdict::parameter_error));
    }
    NextExperiment next = nextExperiment(prepared_.fitter, search_, judgement_, options_.limits, options_.threads);
    result_.next_experiment = std::move(next.text);
    result_.proposed = std::move(next.proposed);
    result_.sentence = sentence(judgement_, result_);
    result_.could_show = couldShow(search_, Criteria{});
    if (const std::string note = temperatureNote(result_.effects, search_.excitation); !note.empty()) {
      result_.sentence += " " + note;
      result_.next_experiment += " Record temperature_degC with it.";
    }
  }

  // What no effect explains is closed all the same.
  void describeSurrogate() {
    if (!needsSurrogate(judgement_.verdict)) {
      return;
    }
    Workings& w = *workings_;
    if (!w.surrogate) {
      const gap::Forces of_training(w.force_augmented.begin(),
                                    w.force_augmented.begin() + static_cast<std::ptrdiff_t>(w.training));
      w.surrogate =
          fitSurrogate(result_.augmented, {prepared_.training, of_training, prepared_.held_out}, options_.threads);
    }
    Surrogate surrogate = judgeSurrogate(std::move(*w.surrogate), result_.gap.noise_floor);
    w.surrogate.reset();
    w.force_surrogate = simulate(surrogate.component);
    result_.sentence += " " + describeRest(surrogate);
    result_.surrogate = std::move(surrogate);
  }

  std::vector<std::string> names(const std::vector<int>& effects) const {
    std::vector<std::string> result;
    for (const int effect : effects) {
      result.push_back(search_.candidates[static_cast<std::size_t>(effect)].effect);
    }
    return result;
  }

  const PreparedCase& prepared_;
  const std::vector<LogSurvey>& recorded_;
  const DiagnosisOptions& options_;
  std::shared_ptr<Workings> workings_;
  const Search& search_;
  const Judgement& judgement_;
  const FittedHypothesis& judged_;
  std::vector<double> noise_;  // floor of each record
  std::vector<gap::PartError> before_;
  std::vector<gap::PartError> after_;
  std::vector<std::vector<gap::PartError>> of_candidates_;
  Diagnosis result_;
};

}  // namespace

Diagnosis describe(const PreparedCase& prepared, std::shared_ptr<Workings> workings,
                   const std::vector<LogSurvey>& recorded, std::vector<measurement::RigFinding> findings,
                   const DiagnosisOptions& options) {
  return Describer(prepared, std::move(workings), recorded, std::move(findings), options).run();
}

}  // namespace rubber_suspension::diagnosis
