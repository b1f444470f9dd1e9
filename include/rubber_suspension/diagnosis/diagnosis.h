// The diagnosis as one call: where the model fails, which effect is missing, and how much of the gap it closes.
#pragma once

#include <array>
#include <complex>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/diagnosis/could_show.h"
#include "rubber_suspension/diagnosis/experiment_limits.h"
#include "rubber_suspension/diagnosis/posterior.h"
#include "rubber_suspension/diagnosis/verdict.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/fit/measured_table.h"
#include "rubber_suspension/gap/iso18571.h"
#include "rubber_suspension/gap/where.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/log/log_source.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis {

/// Default for the most samples of a search; memory and time grow with them.
constexpr std::size_t kMostSamples = 300000;

/// Value of a number that was not computed, as for the verdict check_bench; null in report.json.
constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

/// The options of a diagnosis besides the component and the logs.
struct DiagnosisOptions {
  int threads = 2;
  /// Called with the stage's name and the fraction done.
  std::function<void(const std::string& stage, double fraction)> progress;
  unsigned seed = 1;                       ///< of the draws for intervals
  int resamplings = 400;                   ///< draws
  ExperimentLimits limits;                 ///< of the experiment that is proposed
  std::vector<std::string> excluded = {};  ///< effects that are ruled out besides those of the component
  bool evidence = false;  ///< the report includes the evidence: errors of every hypothesis on held-out data
  std::uint64_t available_memory = 0;  ///< limit [bytes]; 0: what is available to this process
  /// Most samples of all logs and hold-outs that the search uses; longer logs are searched in excerpts.
  std::size_t most_samples = kMostSamples;
  bool turns = false;  ///< of a rotation: in its logs and its component m stands for rad, and N for N m
};

/// The result of the diagnosis on one candidate effect.
struct CandidateResult {
  std::string effect;
  std::string documentation;
  bool on_rig = false;
  double probability = 0.0;  ///< of all sets with this effect
  double gap = 0.0;          ///< held out, with this effect alone added
  double closed = 0.0;       ///< fraction of the closable gap
  /// 95 % interval of `closed` on further logs of the same rig.
  std::array<double, 2> interval{};
  bool testable = false;       ///< a typical size of it would be visible in these logs, or what was fitted is
  double visible_share = 0.0;  ///< of a typical effect's force, the part that re-estimation does not hide [-]
  std::map<std::string, double> parameters;
  std::vector<element::ElementDescription> add;  ///< its entries for a component file
  /// Its numbers are those of the component file, with all that is named; else they are those of its full law, alone.
  bool written = false;
};

/// Another explanation of the logs than the reported one.
struct Alternative {
  Verdict verdict = Verdict::none;   ///< `named` for a set of effects
  std::vector<std::string> effects;  ///< the set
  double probability = 0.0;
};

/// An excluded effect, with the probability that it would have otherwise.
struct ExcludedEffect {
  std::string effect;
  double probability_otherwise = 0.0;
};

/// RMS of measured minus simulated force over the standard deviation of the measured force, on data that took no part
/// in the fit.
struct Gap {
  double as_configured = kNotComputed;
  double re_estimated = kNotComputed;
  double augmented = kNotComputed;
  double noise_floor = kNotComputed;
};

/// The force that a model lacks: means over cells of displacement and velocity, all logs together.
struct MissingForce {
  std::vector<double> displacement;  ///< edges of the cells [m]
  std::vector<double> velocity;      ///< edges [m/s]
  /// Cells row by row along the velocity; where there are too few samples not a number.
  std::vector<double> measured;   ///< measured less augmented force [N]
  std::vector<double> surrogate;  ///< force of the surrogate [N]
  std::vector<int> samples;
};

/// A component that closes a gap that no effect explains, without stating a cause.
struct Surrogate {
  io::ComponentDescription component;  ///< the augmented one with a `residual` on top
  double gap = 0.0;                    ///< of the logs as they are, which `replay` of the component gives
  double unseen_before = 0.0;  ///< gap of the augmented component on logs or blocks that took no part in the fit
  double unseen_after = 0.0;   ///< the same with surrogates that were fitted without them
  double share = 0.0;          ///< of the squared residual beyond the noise that these predict
  double chance = 1.0;         ///< p-value of their prediction
  bool beyond_chance = false;  ///< the prediction is significant
  bool function_of_the_motion = false;  ///< the larger part of the residual is predicted, significantly
  MissingForce missing;                 ///< the force that it is fitted to
};

/// Errors of the characteristics on held-out data, relative RMS over windows.
struct CharacteristicErrors {
  double stiffness = kNotComputed;   ///< [-]
  double loss_angle = kNotComputed;  ///< [rad]
  double energy = kNotComputed;      ///< of the loss per cycle [-]
};

/// The rating of a log by ISO/TS 18571, as it was recorded.
struct LogRating {
  gap::Iso18571 as_configured;
  gap::Iso18571 augmented;
};

/// A log as it was admitted.
struct Admission {
  std::string log;
  bool hold_out = false;
  double duration = 0.0;              ///< [s]
  double dt = 0.0;                    ///< [s]
  double largest_displacement = 0.0;  ///< [m]
  double highest_frequency = 0.0;     ///< [Hz]
  double noise = kNotComputed;        ///< floor in units of the force's standard deviation
  double repeats = 0.0;               ///< share of the log that repeats an earlier motion
  double recorded = kNotComputed;     ///< gap of the augmented component to the log as recorded
  double left = kNotComputed;         ///< the same without the errors of the rig
  std::optional<LogRating> rating;    ///< of a log that was judged
  std::vector<std::string> notes;
};

/// Errors of one kind that were removed from a log before it was compared with a model.
struct TakenOut {
  std::string log;
  std::string kind;  ///< spikes, zero, drift, delay, gain, displacement_zero, initial_state
  /// Root of its part of the mean squared residual, over the force's standard deviation; negative if the residual grew.
  /// The squares of a log, each with its sign, add up to recorded^2 - left^2 of its Admission.
  double share = 0.0;
};

/// Re-estimated over configured value, by the parameter's name.
using ParameterRatios = std::vector<std::pair<std::string, double>>;

/// A file that a diagnosis read.
struct InputFile {
  std::string option;  ///< that named it
  std::string name;    ///< without its folder
  std::string sha256;  ///< of its bytes, 64 hexadecimal digits
};

/// The run that made a report, so that it can be filed and repeated; the program that diagnoses fills it in.
struct RunRecord {
  std::string version;
  std::string date;  ///< UTC, ISO 8601
  std::string command_line;
  std::vector<InputFile> files;
};

/// A number of the judged model with its uncertainty.
struct SizedValue {
  std::string owner;  ///< "specification", the type of an element, or the effect that it belongs to
  std::string name;
  std::string unit;                                              ///< SI; "1" for none
  double configured = std::numeric_limits<double>::quiet_NaN();  ///< not a number where the component file has none
  double value = 0.0;
  std::array<double, 2> interval_95{};  ///< posterior predictive: logs, form of the law and choice of the law
  std::array<bool, 2> at_bound{};       ///< whether an end of it is a bound of the fit
  std::string text = {};                ///< for a number of a file: its text there; empty: in full
};

/// The part of the gap as configured that values or one effect remove.
struct GapShare {
  std::string by;  ///< "values", or the effect
  double share = 0.0;
  /// For an effect: 95 % lower bound of the squares that its law removes from held-out data, over parts of the logs, in
  /// units of the force's variance.
  double squares_at_least = kNotComputed;
};

/// Deviation of a number of the data sheet in the logs.
struct SheetDeviation {
  std::string name;         ///< a key of the specification
  double tolerances = 0.0;  ///< by which the logs' value is above that of the sheet
};

/// The whole component at one point, as configured and as augmented.
struct WholeStiffness {
  double frequency = 0.0;              ///< [Hz]
  double amplitude = 0.0;              ///< [m]
  bool nominal_amplitude = false;      ///< it is that of the specification; else the logs' median
  std::array<double, 2> stiffness{};   ///< K before and after [N/m]
  std::array<double, 2> loss_angle{};  ///< likewise [rad]
};

/// An experiment to play on the bench.
struct ProposedExperiment {
  std::string description;
  double dt = 0.0;                   ///< [s]
  std::vector<double> displacement;  ///< [m], at even steps; empty: none is proposed
  std::string decides;               ///< the explanation judged, by its effects
  std::vector<std::string> against;  ///< its competitors
  double difference = 0.0;   ///< were it right: RMS force by which the nearest other, refitted, would be off there [N]
  double open_before = 0.0;  ///< entropy of the names: of each effect, whether it is at work [bit]
  double open_after = 0.0;   ///< the same, expected once the log is among those diagnosed [bit]
  double probability = 0.0;  ///< expected, of the right explanation once the log is among those diagnosed
};

/// One value of two reports.
struct ReportChange {
  std::string what;
  std::string before;  ///< with unit and interval
  std::string after;
  bool differs = false;  ///< beyond noise and intervals
};

/// Differences of a report from an earlier one.
struct Comparison {
  std::string with;  ///< the earlier report's path; empty: nothing was compared
  std::string date;  ///< of the earlier report, where it has one
  std::vector<ReportChange> changes;
};

/// A row of a table, measured and simulated.
struct DiagnosedRow {
  fit::TablePoint measured;
  std::complex<double> as_configured;  ///< K* [N/m]
  std::complex<double> re_estimated;
  std::complex<double> augmented;
};

/// The table that a diagnosis was made from in place of logs.
struct DiagnosedTable {
  std::string name;
  std::vector<DiagnosedRow> rows;
  std::vector<std::string> never_shown;  ///< effects that no table shows
  std::vector<std::string> notes;
};

struct BenchEvidence;  // figures of logs that fail the checks of the bench
struct Workings;       // what the report draws and lists besides: every hypothesis that was tried, the simulated forces

/// The answer of the judgement, with the names of effects.
struct Answered {
  Verdict verdict = Verdict::none;
  double probability = kNotComputed;  ///< of the verdict; where effects are named, of their set
  std::vector<std::string> effects;   ///< named, most important first
  /// Where effects are named: the sets of effects that make 90 % of all, the likeliest first.
  std::vector<std::vector<std::string>> confounded;
  std::vector<Alternative> alternatives;  ///< what else may be right, the likeliest first
  std::vector<ExcludedEffect> excluded;   ///< what the component file or the options rule out
  Posterior posterior;                    ///< of the answers; the verdict's is the largest
};

/// Reduction of the gap.
struct Gaps {
  Gap unseen;                    ///< without the errors of the rig
  double closed = kNotComputed;  ///< fraction of the closable gap
  /// 95 %, of further logs of the same rig where effects are named.
  std::array<double, 2> closed_interval = {kNotComputed, kNotComputed};
  /// Predicted gap of a further log, with only an offset removed: of each log by a fit of the written law to the
  /// others. Computed for three logs or more without hold-outs.
  double further_log = kNotComputed;
  std::string noise_source;
};

/// Gaps of the configured and of the written component on a log, with an offset and an initial state fitted to both,
/// and the reported errors of the rig removed.
struct LeftOfLog {
  std::string log;
  double configured = 0.0;
  double written = 0.0;
  double allowed = 0.0;  ///< allowed excess of the second squared gap over the first
};

/// An effect that is named but not written, because the file would have a larger gap on a log than the configured
/// component.
struct Withheld {
  std::string effect;   ///< "values" for the re-estimated ones
  std::string log;      ///< the one with the largest excess; "all logs" where it is the sum of all
  double before = 0.0;  ///< gap there as configured
  double after = 0.0;   ///< gap there with the effect
};

/// The component that a diagnosis writes, and the law that was judged.
struct WrittenLaw {
  /// Re-estimated, with the simplest law of each effect named, rounded: as augmented.yaml has it.
  io::ComponentDescription augmented;
  io::ComponentDescription full;      ///< the same with the laws that were judged, all their numbers in full
  double gap_of_full = kNotComputed;  ///< of that one, as Gaps::unseen.augmented is of the simplest law
  /// Effect of each entry that `augmented` adds to the configured ones.
  std::vector<std::string> added_for;
  std::vector<SizedValue> numbers;       ///< of `augmented` in full, by their places (io::numberPlace)
  std::vector<SizedValue> model_sizes;   ///< of the judged model's own parameters
  std::vector<SizedValue> effect_sizes;  ///< of the effects that are written
  std::vector<LeftOfLog> left_of_logs;   ///< of the logs of the fit, then of those held out
  std::vector<Withheld> withheld;        ///< in the order in which they were
};

/// Where a component is wrong.
struct Where {
  std::vector<gap::GapCell> before;  ///< as configured
  std::vector<gap::GapCell> after;   ///< as augmented
  CharacteristicErrors re_estimated;
  CharacteristicErrors augmented;
};

/// The model's own parameters.
struct OwnParameters {
  ParameterRatios ratios;
  std::vector<SheetDeviation> sheet_deviations;  ///< of the judged model, the farthest off first
  std::vector<std::string> at_bounds;            ///< those of the judged model at a bound of the fit
  bool guess = false;                            ///< the data sheet is a guess: its values are identified
};

/// The logs, and the errors removed from each.
struct AdmittedLogs {
  std::vector<Admission> admission;
  std::vector<TakenOut> taken_out;  ///< log by log
};

/// Recommended next step.
struct NextStep {
  std::string text;
  ProposedExperiment proposed;  ///< its displacement
};

/// Number of samples that a search used.
struct Samples {
  std::size_t searched = 0;
  std::size_t recorded = 0;  ///< that the logs have; more than `searched` where it took excerpts
};

/// The result of a diagnosis: what each of its steps found. For the verdicts check_bench and defect, numbers are
/// kNotComputed and lists are empty.
struct Diagnosis {
  std::string component;
  bool turns = false;    ///< of a rotation: what is stated in m is in rad, and N is N m; units of values say it
  std::string sentence;  ///< the verdict for an engineer
  std::string defect;    ///< invariants that are broken; empty but for Verdict::defect
  Answered answer;
  Gaps gaps;
  Gap gap_as_recorded;  ///< of the logs as they are, which `replay` gives; without a floor
  /// Shares that values and each effect of the judged model remove; they add up to the whole. Because the share of one
  /// depends on those already present, it is the mean over all orders (Shapley, 1953).
  std::vector<GapShare> shares;
  std::vector<CandidateResult> candidates;  ///< most probable first
  Where where;
  CouldShow could_show;  ///< effects that these logs could have shown
  NextStep next;
  io::ComponentDescription configured;
  io::ComponentDescription re_estimated;
  WrittenLaw law;
  bool write_full_law = false;                        ///< the report has augmented_full.yaml
  std::optional<Surrogate> surrogate;                 ///< for the verdicts unknown and partly
  std::optional<DiagnosedTable> table;                ///< empty where it was made from logs
  std::vector<measurement::RigFinding> rig_findings;  ///< errors of the rig
  Samples samples;
  AdmittedLogs logs;
  OwnParameters parameters;
  std::optional<WholeStiffness> whole;  ///< nothing where a component has no settled loop
  RunRecord run;
  Comparison comparison;
  std::shared_ptr<const Workings> workings;             ///< none for the verdict check_bench
  std::shared_ptr<const BenchEvidence> bench_evidence;  ///< for the verdict check_bench alone
};

/// True if the diagnosis has a component file, WrittenLaw::augmented: one was judged, and the report does not
/// contradict itself.
inline bool hasComponentFile(const Diagnosis& diagnosis) {
  return diagnosis.workings != nullptr && diagnosis.defect.empty();
}

/// Diagnoses one component. Logs in the order of recording, on one component; each hold-out starts with a new one.
/// Without hold-outs the gaps are those of blocks that took no part in the fit (cross validation). Logs with more
/// samples than the options allow are searched in excerpts, each of which is a log in the report; `gap_as_recorded` is
/// of the whole logs. Throws LogError for a log that cannot be used, or where all of them take more memory than there
/// is, std::invalid_argument for a component that cannot be built.
Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options = {});

/// Diagnoses logs of any length, which are read block by block, up to three times: memory depends on the samples that
/// the search uses, not on the length of the logs.
Diagnosis diagnose(const io::ComponentDescription& component, const log::LogSources& logs,
                   const log::LogSources& hold_out, const DiagnosisOptions& options = {});

/// The report as JSON text, schema rubber_suspension/gap_report/1.
std::string toJson(const Diagnosis& diagnosis);

/// The errors of every hypothesis, on which the judgement is based, as JSON text; empty unless requested.
std::string evidenceJson(const Diagnosis& diagnosis);

/// Names of the files that a report may consist of, the page last.
std::vector<std::string> reportFiles();

/// Writes the report into a folder, which is made: report.json, augmented.yaml, augmented_full.yaml where it was asked
/// for, next_experiment.csv, surrogate.yaml and missing_force.csv where there is a surrogate, evidence.json where it
/// was asked for, and the numbers of its figures. All are written before the first is renamed. Before that the page of
/// an earlier report is removed, with whatever else that report left there and this one lacks. Throws
/// std::runtime_error.
void writeReportData(const Diagnosis& diagnosis, const std::string& folder);

/// Writes the data, and then report.html, a page that needs no network, by scripts/render_report. Returns an empty
/// string, or one line with the reason if there is no page. Throws std::runtime_error.
std::string writeReport(const Diagnosis& diagnosis, const std::string& folder);

}  // namespace rubber_suspension::diagnosis
