// Description of a judged search.
#include "diagnosis/results/describe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/hypotheses/unseen_logs.h"
#include "diagnosis/results/admission.h"
#include "diagnosis/results/answered.h"
#include "diagnosis/results/characteristics.h"
#include "diagnosis/results/missing_force.h"
#include "diagnosis/results/recorded_gap.h"
#include "diagnosis/results/replayed.h"
#include "diagnosis/results/rig_findings.h"
#include "diagnosis/results/simplest_law.h"
#include "diagnosis/results/surrogate.h"
#include "diagnosis/results/taken_out.h"
#include "diagnosis/results/whole_stiffness.h"
#include "diagnosis/results/written_law.h"
#include "fit/parallel.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr double kHidesTheRig = 0.1;  // of the force: a rest in which what rigs do gets lost

class Describer {
 public:
  Describer(const hypotheses::PreparedCase& prepared, std::shared_ptr<Workings> workings,
            const std::vector<prepare::LogSurvey>& recorded, const std::vector<prepare::RawChannels>& raw,
            std::vector<measurement::RigFinding> findings, const DiagnosisOptions& options)
      : prepared_(prepared),
        recorded_(recorded),
        raw_(raw),
        options_(options),
        workings_(std::move(workings)),
        search_(workings_->search),
        answer_(workings_->answer),
        judged_(search_.at(answer_.model)) {
    result_.rig_findings = std::move(findings);
  }

  Diagnosis run() {
    result_.component = prepared_.component.name;
    result_.configured = prepared_.component;
    result_.re_estimated = prepared_.model.apply(search_.re_estimated.fit.parameters.model);
    before_ = replayed(prepared_.fitter, fullLaw(search_.re_estimated), result_.re_estimated.allElements(), held_out_);
    written_ =
        addWrittenLaw(prepared_, search_.candidates, judged_, gap::gapOfParts(before_.unseen()), options_, result_);
    simulateAll();
    measureGap();
    mapGap();
    describeRig();
    describeLogs();
    accountForTheRig();
    describeParameters();
    describeAnswer();
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

  // Errors with each effect alone, on the data that the gap is of.
  std::vector<std::vector<gap::PartError>> errorsAlone() const {
    std::vector<std::vector<gap::PartError>> errors(search_.singles.size());
    fit::parallelFor(errors.size(), options_.threads, [&](std::size_t c) {
      FittedLaw alone = fullLaw(search_.singles[c]);
      if (hasUnseenLogs() && &search_.singles[c] != &judged_) {
        // Where it is not named, a drift or a gain is what a simulation predicts of it: what is free in a log would
        // take slow noise, or a law's error, with it.
        alone.law.about.free_in_log = {};
      }
      errors[c] = unseenErrors(prepared_.fitter, alone, elementsOf(prepared_.model, alone), held_out_);
    });
    return errors;
  }

  double gapAsConfigured() const {
    const gap::Forces& forces = workings_->force_configured;
    return gap::gapOfParts(hasUnseenLogs() ? gap::partErrors(prepared_.held_out, unseen(forces))
                                           : gap::partErrors(prepared_.training, forces));
  }

  // The errors of the component that is written, and of the re-estimated one, as `replay` has them.
  judge::Evidence evidenceOfTheFile() const {
    judge::Evidence evidence = workings_->evidence;
    const auto set = [&](int hypothesis, const Replayed& errors) {
      std::vector<double>& by_log = evidence.hypotheses[static_cast<std::size_t>(hypothesis)].log_errors;
      by_log = errorsByLog(errors.of_the_fit, prepared_.training.size());
      const std::vector<double> of_held_out = errorsByLog(errors.held_out, prepared_.held_out.size());
      by_log.insert(by_log.end(), of_held_out.begin(), of_held_out.end());
    };
    set(judge::Evidence::kReEstimated, before_);
    set(answer_.model, written_);
    return evidence;
  }

  void measureGap() {
    noise_ = search_.record_noise;
    result_.noise_source = search_.noise_source;
    Gap gap = {gapAsConfigured(), gap::gapOfParts(before_.unseen()), gap::gapOfParts(written_.unseen()), search_.noise};
    if (hasUnseenLogs()) {
      const std::vector<double> floors =
          hypotheses::noiseFloors(result_.augmented_full.allElements(), hypotheses::freeOfNoise(judged_.hypothesis),
                                  hypotheses::predict(prepared_.model, judged_, prepared_.held_out), prepared_.held_out,
                                  measurement::noiseLimit(search_.record_noise, prepared_.training));
      noise_.insert(noise_.end(), floors.begin(), floors.end());
      gap.noise_floor = hypotheses::commonFloor(floors, prepared_.held_out);
    }
    addGap(gap, errorsAlone(), evidenceOfTheFile(), *workings_, options_, result_);
  }

  // With some of the values and effects. In sample where there are no unseen logs.
  double gapWith(const std::vector<bool>& in) const {
    const auto elements = withSome(result_, in).allElements();
    const std::vector<log::Record>& records = hasUnseenLogs() ? prepared_.held_out : prepared_.training;
    fit::Hypothesis freed;  // what the effects that are in have free in each log
    bool has_friction = false;
    for (std::size_t e = 0; e < answer_.effects.size(); ++e) {
      const fit::Candidate& candidate = search_.candidates[static_cast<std::size_t>(answer_.effects[e])];
      const fit::FreeInLog free = candidate.free_in_log & judged_.hypothesis.free_in_log;
      has_friction = has_friction || (in[1 + e] && candidate.is_friction);
      freed.free_in_log = in[1 + e] ? freed.free_in_log | free : freed.free_in_log;
    }
    if (judged_.hypothesis.free_in_log.by_factor && has_friction) {
      freed.free_in_log.by_factor = hasUnseenLogs() ? hypotheses::frictionOfEach(elements, records)
                                                    : fit::columnOf(fit::frictionOf(elements, records));
    }
    return gap::gapOfParts(hypotheses::partErrorsOf(
        freed, records,
        hasUnseenLogs() ? gap::simulateEach(elements, records) : gap::simulate(elements, records, gap::asRecorded)));
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

  // Errors over frequency, amplitude and time, on the logs that the gap is of; where the configured model is wrong.
  void mapGap() {
    const Workings& w = *workings_;
    const std::vector<log::Record>& records = hasUnseenLogs() ? prepared_.held_out : prepared_.training;
    const auto of = [&](const gap::Forces& forces) { return hasUnseenLogs() ? unseen(forces) : forces; };
    const auto mapOf = [&](const gap::Forces& forces) {
      gap::Forces residual;
      for (std::size_t r = 0; r < prepared_.training.size(); ++r) {
        const log::Record& record = prepared_.training[r];
        residual.push_back(record.withoutRig(record.force - forces[r]));
      }
      return gap::gapMap(prepared_.training, residual, search_.record_noise);
    };
    const std::array<std::function<void()>, 4> tasks = {
        [&] { result_.errors_re_estimated = characteristicErrors(records, of(w.force_re_estimated)); },
        [&] { result_.errors_augmented = characteristicErrors(records, of(w.force_augmented)); },
        [&] { result_.where = mapOf(w.force_configured); }, [&] { result_.where_after = mapOf(w.force_augmented); }};
    fit::parallelFor(tasks.size(), options_.threads, [&](std::size_t i) { tasks[i](); });
  }

  // Faults of the rig in each log, by what the judged model and the next likely one leave of it; of a model that leaves
  // more than it explains it is the model's.
  void describeRig() {
    if (leavesMoreThanItExplains()) {
      return;
    }
    const io::RigTolerances tolerances = prepared_.component.rig.value_or(io::RigTolerances{});
    const auto elements = result_.augmented_full.allElements();
    const auto rival =
        hypotheses::augmentedDescription(prepared_.model, search_.likeliestBeside(judged_)).allElements();
    for (const bool held_out : {false, true}) {
      const auto found = rigFindings(elements, rival, tolerances, held_out ? prepared_.held_out : prepared_.training,
                                     held_out ? prepared_.zeros.held_out : prepared_.zeros.training,
                                     judged_.hypothesis.free_in_log, options_.threads);
      result_.rig_findings.insert(result_.rig_findings.end(), found.begin(), found.end());
    }
  }

  bool leavesMoreThanItExplains() const {
    const auto squared = [](double gap) { return gap * gap; };
    const double left = squared(result_.gap.augmented) - squared(result_.gap.noise_floor);
    const double noise = std::max(kHidesTheRig, result_.gap.noise_floor);
    return left > squared(result_.gap.as_configured) - squared(result_.gap.augmented) && left > squared(noise);
  }

  void describeLogs() {
    result_.admission.resize(noise_.size());
    fit::parallelFor(noise_.size(), options_.threads, [&](std::size_t r) {
      const Workings& w = *workings_;
      result_.admission[r] = admit(w.records[r], r >= prepared_.training.size(), noise_[r]);
      result_.admission[r].rating = {gap::rateIso18571(w.records[r].force, w.force_configured[r]),
                                     gap::rateIso18571(w.records[r].force, w.force_augmented[r])};
    });
  }

  void accountForTheRig() {
    const std::vector<LogAccount> accounts =
        accountsOf(result_.augmented.allElements(), prepared_.training, prepared_.held_out, raw_,
                   judged_.hypothesis.free_in_log, prepared_.zeros);
    for (std::size_t r = 0; r < accounts.size(); ++r) {
      result_.admission[r].recorded = std::sqrt(accounts[r].recorded());
      result_.admission[r].left = std::sqrt(accounts[r].left());
      const std::vector<TakenOut> entries = accounts[r].entries();
      result_.taken_out.insert(result_.taken_out.end(), entries.begin(), entries.end());
    }
  }

  void describeParameters() {
    result_.parameter_ratios = prepared_.model.ratios(search_.re_estimated.fit.parameters.model);
    result_.guess = search_.guess;
    addDepartures(prepared_.model, judged_.fit.parameters.model, result_);
    result_.whole = wholeStiffness(prepared_.component, result_.augmented, prepared_.training);
  }

  void describeAnswer() {
    addAnswer(answer_, workings_->evidence, result_);
    addShares([&](const std::vector<bool>& in) { return gapWith(in); }, options_.threads, result_);
  }

  // A gap that no effect explains is closed all the same.
  void describeSurrogate() {
    if (!leavesRest(answer_.verdict)) {
      return;
    }
    Workings& w = *workings_;
    const gap::Forces of_training(w.force_augmented.begin(),
                                  w.force_augmented.begin() + static_cast<std::ptrdiff_t>(w.training));
    Surrogate surrogate = fitSurrogate(result_.augmented, {prepared_.training, of_training, prepared_.held_out},
                                       result_.gap.noise_floor, options_.threads);
    surrogate.missing = missingForce(w.records, w.force_augmented, simulate(surrogate.component));
    result_.surrogate = std::move(surrogate);
  }

  const hypotheses::PreparedCase& prepared_;
  const std::vector<prepare::LogSurvey>& recorded_;
  const std::vector<prepare::RawChannels>& raw_;
  const DiagnosisOptions& options_;
  std::shared_ptr<Workings> workings_;
  const hypotheses::Search& search_;
  const judge::Answer& answer_;
  const hypotheses::FittedHypothesis& judged_;
  std::vector<double> noise_;  // floor of each record
  const HeldOut held_out_{prepared_.held_out, prepared_.zeros.held_out};
  Replayed before_;
  Replayed written_;
  Diagnosis result_;
};

}  // namespace

Diagnosis describe(const hypotheses::PreparedCase& prepared, std::shared_ptr<Workings> workings,
                   const std::vector<prepare::LogSurvey>& recorded, const std::vector<prepare::RawChannels>& raw,
                   std::vector<measurement::RigFinding> findings, const DiagnosisOptions& options) {
  return Describer(prepared, std::move(workings), recorded, raw, std::move(findings), options).run();
}

}  // namespace rubber_suspension::diagnosis::results
