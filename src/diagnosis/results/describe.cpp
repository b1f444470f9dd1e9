// Computes the numbers of a report from a judged search.
#include "diagnosis/results/describe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "diagnosis/hypotheses/fitted_component.h"
#include "diagnosis/hypotheses/unseen_logs.h"
#include "diagnosis/results/answered.h"
#include "diagnosis/results/characteristics.h"
#include "diagnosis/results/further_log.h"
#include "diagnosis/results/replayed.h"
#include "diagnosis/results/rig_findings.h"
#include "diagnosis/results/simplest_law.h"
#include "diagnosis/results/surrogate.h"
#include "diagnosis/results/taken_out.h"
#include "diagnosis/results/withholding.h"
#include "diagnosis/results/written_law.h"
#include "fit/parallel.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

// A residual above this share of the force conceals errors of the rig.
constexpr double kHidesTheRig = 0.1;

// Returns the share of the samples at which the displacement has the same value as one period before, for the period
// with the most repeats. The repeats distinguish noise from model error without a model.
double repeatsOf(const log::Record& record) {
  constexpr double kSame = 0.05;  // displacements that differ by fewer standard deviations are repeats
  constexpr Eigen::Index kCoarse = 1024;
  const Eigen::Index stride = std::max<Eigen::Index>(1, record.size() / kCoarse);
  const Eigen::Index count = record.size() / stride;
  Eigen::VectorXd z(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    z[i] = record.displacement[i * stride];
  }
  z.array() -= z.mean();
  const double standard_deviation = std::sqrt(z.squaredNorm() / static_cast<double>(count));
  double best = 0.0;
  for (Eigen::Index lag = 4; lag < count / 2; ++lag) {
    const Eigen::Index rest = count - lag;
    const Eigen::ArrayXd difference = (z.tail(rest) - z.head(rest)).array().abs();
    const auto same = (difference < kSame * standard_deviation).count();
    best = std::max(best, static_cast<double>(same) / static_cast<double>(count));
  }
  return best;
}

// `noise` is the noise floor in the unit of a gap. `account` states what was removed from the log.
Admission admit(const log::Record& record, bool hold_out, double noise, const LogAccount& account) {
  Admission admission;
  admission.log = record.name;
  admission.hold_out = hold_out;
  admission.duration = record.duration();
  admission.dt = record.dt;
  admission.largest_displacement = record.displacement.cwiseAbs().maxCoeff();
  admission.highest_frequency = record.highest_frequency;
  admission.noise = noise;
  admission.repeats = repeatsOf(record);
  admission.recorded = std::sqrt(account.recorded());
  admission.left = std::sqrt(account.left());
  admission.notes = record.notes;
  return admission;
}

// Returns the forces of a component on the logs of the fit, followed by those on the held-out logs.
gap::Forces simulate(const hypotheses::PreparedCase& prepared, const io::ComponentDescription& description) {
  const auto elements = description.allElements();
  gap::Forces forces = gap::simulate(elements, prepared.training, gap::asRecorded);
  const gap::Forces unseen = gap::simulateEach(elements, prepared.held_out);
  forces.insert(forces.end(), unseen.begin(), unseen.end());
  return forces;
}

Simulated simulateAll(const hypotheses::PreparedCase& prepared, const io::ComponentDescription& re_estimated,
                      const io::ComponentDescription& augmented, int threads) {
  Simulated simulated;
  simulated.records = prepared.training;
  simulated.records.insert(simulated.records.end(), prepared.held_out.begin(), prepared.held_out.end());
  simulated.training = prepared.training.size();
  const std::array<std::pair<const io::ComponentDescription*, gap::Forces*>, 3> models = {
      {{&prepared.component, &simulated.configured},
       {&re_estimated, &simulated.re_estimated},
       {&augmented, &simulated.augmented}}};
  fit::parallelFor(models.size(), threads,
                   [&](std::size_t i) { *models[i].second = simulate(prepared, *models[i].first); });
  return simulated;
}

// Returns a 95 % lower bound of the mean reduction of the squared error that an effect causes in the parts of the logs.
// The standard error is estimated only from parts in which the error increases. An effect may act in few parts of the
// logs, and a large reduction there does not make the mean uncertain.
double removedAtLeast(const std::vector<gap::PartError>& without, const std::vector<gap::PartError>& with) {
  constexpr double kNormal95 = 1.645;  // one-sided
  double sum = 0.0;
  double weights = 0.0;
  double squares = 0.0;
  for (std::size_t p = 0; p < with.size(); ++p) {
    const double more = with[p].weight * (without[p].error - with[p].error);
    sum += more;
    weights += with[p].weight;
    squares += more < 0.0 ? 2.0 * more * more : 0.0;
  }
  return (sum - kNormal95 * std::sqrt(squares)) / weights;
}

// Raises the noise floors to the given floors of the logs of the fit and of the held-out logs, and judges again.
void raiseFloors(const std::vector<double>& floors, const hypotheses::PreparedCase& prepared, Workings& workings) {
  hypotheses::Noise& noise = workings.search.noise;
  for (std::size_t r = 0; r < floors.size(); ++r) {
    const std::size_t training = prepared.training.size();
    double& floor = r < training ? noise.of_logs[r] : noise.unseen[r - training];
    const double raised = std::max(floor, floors[r]);
    judge::LogEvidence& log = workings.evidence.logs[r];
    log.floor = std::sqrt(log.floor * log.floor + raised * raised - floor * floor);
    floor = raised;
  }
  noise.floor = hypotheses::commonFloor(noise.of_logs, prepared.training);
  workings.judgeAgain();
}

class Describer {
 public:
  Describer(const hypotheses::PreparedCase& prepared, const Workings& workings,
            const io::ComponentDescription& re_estimated, const Replayed& before, const MeasuredLaw& written,
            const DiagnosisOptions& options)
      : prepared_(prepared),
        workings_(workings),
        search_(workings.search),
        answer_(workings.answer),
        judged_(workings.search.at(workings.answer.model)),
        re_estimated_(re_estimated),
        before_(before),
        written_(written),
        law_(written.law),
        free_(written.fitted.law.about.free_in_log),
        options_(options) {}

  Diagnosis run(const std::vector<prepare::LogSurvey>& recorded, const std::vector<prepare::RawChannels>& raw,
                std::vector<measurement::RigFinding> findings) const {
    const Left left = leftByModels();
    Diagnosis result;
    result.component = prepared_.component.name;
    result.configured = prepared_.component;
    result.re_estimated = re_estimated_;
    result.answer = answered(answer_, workings_.evidence);
    result.gaps = gapsOf(left, workings_, options_);
    const Gap& gap = result.gaps.unseen;
    result.gaps.further_log =
        gapOfFurtherLog(prepared_, written_.as_configured ? nullptr : &written_.fitted, options_.threads);
    result.candidates = candidateResults(left, result.gaps, workings_, options_);
    tellAsWritten(law_, result.answer.effects, result.gaps, result.candidates);
    result.shares = sharesOf(
        result.answer.effects, gap,
        [&](const auto& in) { return gap::gapOfParts(errorsWith(result.answer.effects, in)); }, options_.threads);
    result.where = where(gap);
    result.rig_findings = std::move(findings);
    result.logs = admittedLogs(raw);
    result.parameters =
        ownParameters(prepared_.model, search_.re_estimated.fit.parameters.model, judged_.fit.parameters.model);
    result.whole = wholeStiffness(prepared_.component, law_.augmented, prepared_.training);
    result.surrogate = leavesRest(answer_.verdict) ? std::optional(surrogateOf(gap.noise_floor)) : std::nullopt;
    const std::vector<double> gaps = gapsAsRecorded(recorded, result.surrogate);
    result.gap_as_recorded = {gaps[0], gaps[1], gaps[2]};
    if (result.surrogate) {
      result.surrogate->gap = gaps[3];
    }
    result.law = law_;
    return result;
  }

  // Returns the errors of the rig in each log, from the residuals of the judged model and of the next likely model.
  // Returns none if the residual is a fault of the model (leavesMoreThanItExplains()).
  std::vector<measurement::RigFinding> findingsOfRig() const {
    std::vector<measurement::RigFinding> findings;
    if (leavesMoreThanItExplains(gapOfModels())) {
      return findings;
    }
    const io::RigTolerances tolerances = prepared_.component.rig.value_or(io::RigTolerances{});
    const auto elements = law_.full.allElements();
    const auto rival =
        hypotheses::augmentedDescription(prepared_.model, search_.likeliestBeside(judged_)).allElements();
    for (const bool held_out : {false, true}) {
      const auto found = rigFindings(elements, rival, tolerances, held_out ? prepared_.held_out : prepared_.training,
                                     options_.threads);
      findings.insert(findings.end(), found.begin(), found.end());
    }
    return findings;
  }

  // Returns true if the named law has a smaller gap than the re-estimated component. If its values are nearer to the
  // data sheet, a smaller gap than that of the configured component is enough.
  bool closes() const {
    const double left = gap::gapOfParts(written_.errors.unseen());
    const auto configured = [&] {
      return gap::gapOfParts(gap::partErrors(recordsOfGap(), simulated(prepared_.component.allElements())));
    };
    return left < gap::gapOfParts(before_.unseen()) ||
           (workings_.isNearerToTheSheet(answer_.model) && left < configured());
  }

  // Returns a lower bound of the squared error that each named effect removes while all other changes stay in place.
  std::vector<double> squaresRemoved() const {
    const std::vector<std::string> effects = answered(answer_, workings_.evidence).effects;
    const std::vector<bool> all(1 + effects.size(), true);
    const std::vector<gap::PartError> with = errorsWith(effects, all);
    std::vector<double> removed(effects.size());
    fit::parallelFor(effects.size(), options_.threads, [&](std::size_t e) {
      std::vector<bool> others = all;
      others[1 + e] = false;
      removed[e] = removedAtLeast(errorsWith(effects, others), with);
    });
    return removed;
  }

 private:
  bool hasUnseenLogs() const { return !prepared_.held_out.empty(); }

  gap::Forces ofTraining(const gap::Forces& forces) const {
    return {forces.begin(), forces.begin() + static_cast<std::ptrdiff_t>(prepared_.training.size())};
  }

  // recordsOfGap() returns the logs on which the gap is computed. ofGap() selects the forces on these logs.
  const std::vector<gap::PreparedRecord>& recordsOfGap() const {
    return hasUnseenLogs() ? prepared_.held_out : prepared_.training;
  }
  gap::Forces ofGap(const gap::Forces& forces) const {
    return hasUnseenLogs()
               ? gap::Forces(forces.begin() + static_cast<std::ptrdiff_t>(prepared_.training.size()), forces.end())
               : forces;
  }

  gap::Forces simulated(const std::vector<element::ElementDescription>& elements) const {
    return hasUnseenLogs() ? gap::simulateEach(elements, recordsOfGap())
                           : gap::simulate(elements, recordsOfGap(), gap::asRecorded);
  }

  std::vector<double> gapsAlone() const {
    std::vector<double> gaps(search_.singles.size());
    fit::parallelFor(gaps.size(), options_.threads, [&](std::size_t c) {
      FittedLaw alone = fullLaw(search_.singles[c]);
      if (hasUnseenLogs() && &search_.singles[c] != &judged_) {
        // An effect that is not named explains drifts and gains only as far as a simulation predicts them. Fitted to
        // each log, drifts and gains would absorb slow noise or an error of the law.
        alone.law.about.free_in_log = {};
      }
      gaps[c] = gap::gapOfParts(
          unseenErrors(prepared_.fitter, alone, elementsOf(prepared_.model, alone), prepared_.held_out));
    });
    return gaps;
  }

  // Returns scores computed with the errors that `replay` finds for the written and for the re-estimated component.
  judge::ScoreTable scoresOfTheFile() const {
    judge::Evidence evidence = workings_.evidence;
    const auto set = [&](int hypothesis, const Replayed& errors) {
      const auto byLog = [](const std::vector<gap::PartError>& parts, const std::vector<gap::PreparedRecord>& logs) {
        return hypotheses::errorsByLog(parts, std::vector<double>(logs.size(), 0.0));
      };
      std::vector<double>& by_log = evidence.hypotheses[static_cast<std::size_t>(hypothesis)].log_errors;
      by_log = byLog(errors.of_the_fit, prepared_.training);
      const std::vector<double> of_held_out = byLog(errors.held_out, prepared_.held_out);
      by_log.insert(by_log.end(), of_held_out.begin(), of_held_out.end());
    };
    set(judge::Evidence::kReEstimated, before_);
    set(answer_.model, written_.errors);
    return judge::scoreTable(evidence);
  }

  Gap gapOfModels() const {
    const double configured = gap::gapOfParts(gap::partErrors(recordsOfGap(), ofGap(workings_.simulated.configured)));
    const double floor =
        hasUnseenLogs() ? hypotheses::commonFloor(search_.noise.unseen, prepared_.held_out) : search_.noise.floor;
    return {configured, gap::gapOfParts(before_.unseen()), gap::gapOfParts(written_.errors.unseen()), floor};
  }

  Left leftByModels() const { return {gapOfModels(), law_.gap_of_full, gapsAlone(), scoresOfTheFile()}; }

  // Returns the errors of the model with some values and effects, in-sample if there are no unseen logs.
  std::vector<gap::PartError> errorsWith(const std::vector<std::string>& effects, const std::vector<bool>& in) const {
    const auto elements = withSome(prepared_.component, law_, effects, in).allElements();
    const std::vector<gap::PreparedRecord>& records = recordsOfGap();
    fit::Hypothesis freed;  // with the per-log parameters of the selected effects
    bool has_friction = false;
    for (std::size_t e = 0; e < answer_.effects.size(); ++e) {
      const fit::Candidate& candidate = search_.candidates[static_cast<std::size_t>(answer_.effects[e])];
      const fit::PerLogNuisances free = candidate.free_in_log & free_;
      has_friction = has_friction || (in[1 + e] && candidate.is_friction);
      freed.free_in_log = in[1 + e] ? freed.free_in_log | free : freed.free_in_log;
    }
    if (free_.by_factor && has_friction) {
      freed.free_in_log.by_factor = fit::columnOf(hasUnseenLogs() ? hypotheses::frictionOfEach(elements, records)
                                                                  : fit::frictionOf(elements, records));
    }
    return hypotheses::partErrorsOf(freed, records, simulated(elements));
  }

  // Returns gaps on the logs as recorded, with all errors of the rig: of the configured, the re-estimated and the
  // augmented component, and of the surrogate if there is one.
  std::vector<double> gapsAsRecorded(const std::vector<prepare::LogSurvey>& logs,
                                     const std::optional<Surrogate>& surrogate) const {
    std::vector<std::vector<element::ElementDescription>> models = {
        prepared_.component.allElements(), re_estimated_.allElements(), law_.augmented.allElements()};
    if (surrogate) {
      models.push_back(surrogate->component.allElements());
    }
    const Recorded recorded = hasUnseenLogs() ? Recorded::each_on_a_new_one : Recorded::on_one_component;
    return recordedGaps(models, logs, recorded, options_.threads);
  }

  // Returns the map of a gap. The squares of its cells add up to the squared gap.
  std::vector<gap::GapCell> mapOf(const gap::Forces& forces, double gap) const {
    const std::vector<gap::PreparedRecord>& records = recordsOfGap();
    gap::Forces residual;
    for (std::size_t r = 0; r < records.size(); ++r) {
      residual.push_back(records[r].withoutRig(records[r].force - forces[r]));
    }
    std::vector<gap::GapCell> cells =
        gap::gapMap(records, residual, hasUnseenLogs() ? search_.noise.unseen : search_.noise.of_logs);
    for (gap::GapCell& cell : cells) {
      cell.squared = cell.share * gap * gap;
    }
    return cells;
  }

  Where where(const Gap& gap) const {
    const Simulated& s = workings_.simulated;
    Where where;
    const std::array<std::function<void()>, 4> tasks = {
        [&] { where.re_estimated = characteristicErrors(recordsOfGap(), ofGap(s.re_estimated)); },
        [&] { where.augmented = characteristicErrors(recordsOfGap(), ofGap(s.augmented)); },
        [&] { where.before = mapOf(ofGap(s.configured), gap.as_configured); },
        [&] { where.after = mapOf(ofGap(s.augmented), gap.augmented); }};
    fit::parallelFor(tasks.size(), options_.threads, [&](std::size_t i) { tasks[i](); });
    return where;
  }

  // Returns true if the residual above the noise is larger than what the augmented component removes, and is no small
  // share
  // of the force. Such a residual is a fault of the model rather than of the rig.
  static bool leavesMoreThanItExplains(const Gap& gap) {
    const auto squared = [](double value) { return value * value; };
    const double left = squared(gap.augmented) - squared(gap.noise_floor);
    const double noise = std::max(kHidesTheRig, gap.noise_floor);
    return left > squared(gap.as_configured) - squared(gap.augmented) && left > squared(noise);
  }

  AdmittedLogs admittedLogs(const std::vector<prepare::RawChannels>& raw) const {
    const std::vector<LogAccount> accounts =
        accountsOf(law_.augmented.allElements(), prepared_.training, prepared_.held_out, raw, free_);
    const std::size_t training = prepared_.training.size();
    AdmittedLogs logs;
    logs.admission.resize(accounts.size());
    fit::parallelFor(accounts.size(), options_.threads, [&](std::size_t r) {
      const double noise = r < training ? search_.noise.of_logs[r] : search_.noise.unseen[r - training];
      const Simulated& s = workings_.simulated;
      logs.admission[r] = admit(s.records[r], r >= training, noise, accounts[r]);
      logs.admission[r].rating = {gap::rateIso18571(s.records[r].force, s.configured[r]),
                                  gap::rateIso18571(s.records[r].force, s.augmented[r])};
    });
    for (const LogAccount& account : accounts) {
      const std::vector<TakenOut> entries = account.entries();
      logs.taken_out.insert(logs.taken_out.end(), entries.begin(), entries.end());
    }
    return logs;
  }

  Surrogate surrogateOf(double noise_floor) const {
    const Simulated& s = workings_.simulated;
    Surrogate surrogate =
        fitSurrogate(law_.augmented, {prepared_.training, ofTraining(s.augmented), prepared_.held_out}, noise_floor,
                     options_.threads);
    surrogate.missing = missingForce(s.records, s.augmented, simulate(prepared_, surrogate.component));
    return surrogate;
  }

  const hypotheses::PreparedCase& prepared_;
  const Workings& workings_;
  const hypotheses::Search& search_;
  const judge::Answer& answer_;
  const hypotheses::FittedHypothesis& judged_;
  const io::ComponentDescription& re_estimated_;
  const Replayed& before_;
  const MeasuredLaw& written_;
  const WrittenLaw& law_;
  const fit::PerLogNuisances& free_;  // per-log parameters that are fitted together with the written law
  const DiagnosisOptions& options_;
};

}  // namespace

Diagnosis describe(const hypotheses::PreparedCase& prepared, Workings judged,
                   const std::vector<prepare::LogSurvey>& recorded, const std::vector<prepare::RawChannels>& raw,
                   std::vector<measurement::RigFinding> findings, const DiagnosisOptions& options) {
  const auto workings = std::make_shared<Workings>(std::move(judged));
  const hypotheses::Search& search = workings->search;
  const io::ComponentDescription re_estimated = prepared.model.apply(search.re_estimated.fit.parameters.model);
  const Replayed before =
      replayed(prepared.fitter, fullLaw(search.re_estimated), re_estimated.allElements(), prepared.held_out);
  const double gap_before = gap::gapOfParts(before.unseen());
  const auto describer = [&](const MeasuredLaw& law) {
    return Describer(prepared, *workings, re_estimated, before, law, options);
  };
  MeasuredLaw named;
  std::vector<double> removed;
  const auto settle = [&] {  // a set of effects is no answer if it, or one of its effects, closes nothing
    for (bool settled = false; !settled;) {
      named = writtenLaw(prepared, search, search.at(workings->answer.model), gap_before, options);
      const Describer of_named = describer(named);
      removed = of_named.squaresRemoved();
      settled = (removed.empty() || of_named.closes()) &&
                std::all_of(removed.begin(), removed.end(), [](double squares) { return squares > 0.0; });
      if (!settled) {
        workings->evidence.hypotheses[static_cast<std::size_t>(workings->answer.model)].idle = true;
        workings->judgeAgain();
      }
    }
    workings->simulated = simulateAll(prepared, re_estimated, named.law.augmented, options.threads);
  };
  settle();
  const ColouredNoise noise = colouredNoise(workings->simulated.records, workings->simulated.augmented);
  if (!noise.findings.empty()) {  // the residual is noise, which no law has to follow
    raiseFloors(noise.floors, prepared, *workings);
    settle();
  }
  findings.insert(findings.end(), noise.findings.begin(), noise.findings.end());
  const std::vector<measurement::RigFinding> of_rig = describer(named).findingsOfRig();
  findings.insert(findings.end(), of_rig.begin(), of_rig.end());
  const MeasuredLaw written = withoutDamage(prepared, *workings, std::move(named), gap_before, findings, options);
  if (!written.law.withheld.empty()) {
    workings->simulated.augmented = simulate(prepared, written.law.augmented);
  }
  Diagnosis result = describer(written).run(recorded, raw, std::move(findings));
  for (std::size_t e = 0; e < removed.size(); ++e) {
    result.shares[1 + e].squares_at_least = removed[e];
  }
  result.workings = workings;
  return result;
}

}  // namespace rubber_suspension::diagnosis::results
