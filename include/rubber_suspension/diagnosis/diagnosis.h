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

/// Default for the largest number of samples of a search; memory and time grow with it.
constexpr std::size_t kMostSamples = 300000;

/// Value of a number that was not computed, as for the verdict check_bench; null in report.json.
constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

/// The options of a diagnosis besides the component and the logs.
struct DiagnosisOptions {
  int threads = 2;
  /// Called with the stage's name and the fraction done.
  std::function<void(const std::string& stage, double fraction)> progress;
  unsigned seed = 1;                       ///< of the random draws for intervals
  int resamplings = 400;                   ///< number of random draws for intervals
  ExperimentLimits limits;                 ///< of the proposed experiment
  std::vector<std::string> excluded = {};  ///< effects that are ruled out in addition to those of the component
  bool evidence = false;  ///< the report includes the evidence: errors of every hypothesis on held-out data
  std::uint64_t available_memory = 0;  ///< limit [bytes]; 0: all that is available to this process
  /// Largest number of samples, over all logs and hold-outs, that the search uses; longer logs are searched in
  /// excerpts.
  std::size_t most_samples = kMostSamples;
  bool turns = false;  ///< the component is a rotation: m stands for rad and N for N m in it and its logs
};

/// The result of the diagnosis on one candidate effect.
struct CandidateResult {
  std::string effect;
  std::string documentation;
  bool on_rig = false;
  double probability = 0.0;  ///< sum over all sets that contain this effect
  double gap = 0.0;          ///< held-out gap with this effect alone added
  double closed = 0.0;       ///< fraction of the closable gap
  /// 95 % interval of `closed` on further logs of the same rig.
  std::array<double, 2> interval{};
  bool testable = false;       ///< it is named, or a typical size of it would be visible in these logs
  double visible_share = 0.0;  ///< part of its typical force that re-estimation does not hide [-]
  std::map<std::string, double> parameters;
  std::vector<element::ElementDescription> add;  ///< its entries for `add` of a component file
  /// The numbers above are those of the written component with all named effects; else of this effect's full law alone.
  bool written = false;
};

/// An explanation of the logs other than the reported one.
struct Alternative {
  Verdict verdict = Verdict::none;   ///< `named` for a set of effects
  std::vector<std::string> effects;  ///< the set
  double probability = 0.0;
};

/// An excluded effect, with the probability that it would have if nothing were excluded.
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

/// The force that a model lacks, as means over cells of displacement and velocity over all logs.
struct MissingForce {
  std::vector<double> displacement;  ///< edges of the cells [m]
  std::vector<double> velocity;      ///< edges [m/s]
  /// Cells in rows of constant velocity, like `surrogate` and `samples`; NaN where there are too few samples.
  std::vector<double> measured;   ///< measured minus augmented force [N]
  std::vector<double> surrogate;  ///< force of the surrogate [N]
  std::vector<int> samples;
};

/// A component that closes a gap that no effect explains, without stating a cause.
struct Surrogate {
  io::ComponentDescription component;  ///< the augmented component with an element `residual` added
  double gap = 0.0;                    ///< on the logs as recorded, as `replay` of the component reports it
  double unseen_before = 0.0;  ///< gap of the augmented component on logs or blocks that took no part in the fit
  double unseen_after = 0.0;   ///< the same gap with surrogates that were fitted without these
  double share = 0.0;          ///< of the squared residual beyond the noise that these surrogates predict
  double chance = 1.0;         ///< p-value of their prediction
  bool beyond_chance = false;  ///< the prediction is significant
  bool function_of_the_motion = false;  ///< the larger part of the residual is predicted, significantly
  MissingForce missing;                 ///< the force that the surrogate is fitted to
};

/// Errors of the characteristics on held-out data, relative RMS over windows.
struct CharacteristicErrors {
  double stiffness = kNotComputed;   ///< [-]
  double loss_angle = kNotComputed;  ///< [rad]
  double energy = kNotComputed;      ///< of the loss per cycle [-]
};

/// Ratings of a recorded log by ISO/TS 18571.
struct LogRating {
  gap::Iso18571 as_configured;
  gap::Iso18571 augmented;
};

/// An admitted log.
struct Admission {
  std::string log;
  bool hold_out = false;
  double duration = 0.0;              ///< [s]
  double dt = 0.0;                    ///< [s]
  double largest_displacement = 0.0;  ///< [m]
  double highest_frequency = 0.0;     ///< [Hz]
  double noise = kNotComputed;        ///< noise floor in units of the force's standard deviation
  double repeats = 0.0;               ///< share of the log that repeats an earlier motion
  double recorded = kNotComputed;     ///< gap of the augmented component on the log as recorded
  double left = kNotComputed;         ///< the same gap after removal of the errors of the rig
  std::optional<LogRating> rating;    ///< present for logs that were judged
  std::vector<std::string> notes;
};

/// Errors of one kind that were removed from a log before it was compared with a model.
struct TakenOut {
  std::string log;
  std::string kind;  ///< spikes, line, zero, displacement_zero, initial_state, drift, gain, friction_factor, delay
  /// Root of the mean squared residual removed, over the force's standard deviation; negative if the residual grew.
  /// The squares of a log, each with its sign, add up to recorded^2 - left^2 of its Admission.
  double share = 0.0;
};

/// Ratio of the re-estimated to the configured value of each parameter, by name.
using ParameterRatios = std::vector<std::pair<std::string, double>>;

/// A file that a diagnosis read.
struct InputFile {
  std::string option;  ///< command-line option that named the file
  std::string name;    ///< file name without its folder
  std::string sha256;  ///< 64 hexadecimal digits
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
  double configured = std::numeric_limits<double>::quiet_NaN();  ///< NaN if the component file has none
  double value = 0.0;
  std::array<double, 2> interval_95{};  ///< posterior predictive: logs, form of the law and choice of the law
  std::array<bool, 2> at_bound{};       ///< for each end of the interval: it is a bound of the fit
  std::string text = {};                ///< rounded text of a number in a component file; empty: in full
};

/// The part of the gap as configured that values or one effect remove.
struct GapShare {
  std::string by;  ///< "values", or the effect
  double share = 0.0;
  /// For an effect: 95 % lower bound of the squared residual that its law removes from held-out parts of the logs, in
  /// units of the force's variance.
  double squares_at_least = kNotComputed;
};

/// Deviation of a number of the data sheet in the logs.
struct SheetDeviation {
  std::string name;         ///< a key of the specification
  double tolerances = 0.0;  ///< by which the value in the logs exceeds that of the data sheet
};

/// The whole component at one point, as configured and as augmented.
struct WholeStiffness {
  double frequency = 0.0;              ///< [Hz]
  double amplitude = 0.0;              ///< [m]
  bool nominal_amplitude = false;      ///< the amplitude is that of the specification; else the median of the logs
  std::array<double, 2> stiffness{};   ///< dynamic stiffness as configured and as augmented [N/m]
  std::array<double, 2> loss_angle{};  ///< likewise [rad]
};

/// An experiment to run on the bench.
struct ProposedExperiment {
  std::string description;
  double dt = 0.0;                   ///< [s]
  std::vector<double> displacement;  ///< [m], at constant time steps; empty if none is proposed
  std::string decides;               ///< effects of the judged explanation
  std::vector<std::string> against;  ///< effects of each competing explanation
  double difference = 0.0;   ///< if `decides` is right: RMS force error of the nearest competitor after a refit [N]
  double open_before = 0.0;  ///< entropy of which effects are at work, summed over the effects [bit]
  double open_after = 0.0;   ///< its expectation once this log is diagnosed with the others [bit]
  double probability = 0.0;  ///< expected, that the right explanation then stands alone
};

/// One value that two reports state.
struct ReportChange {
  std::string what;
  std::string before;  ///< value with unit and interval
  std::string after;
  bool differs = false;  ///< beyond noise and intervals
};

/// Differences of a report from an earlier one.
struct Comparison {
  std::string with;  ///< path of the earlier report; empty if nothing was compared
  std::string date;  ///< of the earlier report; empty if unknown
  std::vector<ReportChange> changes;
};

/// A row of a table, measured and simulated.
struct DiagnosedRow {
  fit::TablePoint measured;
  std::complex<double> as_configured;  ///< K* [N/m]
  std::complex<double> re_estimated;
  std::complex<double> augmented;
};

/// The table that was diagnosed in place of logs.
struct DiagnosedTable {
  std::string name;
  std::vector<DiagnosedRow> rows;
  std::vector<std::string> never_shown;  ///< effects that no table can show
  std::vector<std::string> notes;
};

struct BenchEvidence;  // data for figures of logs that fail the checks of the bench
struct Workings;       // further data of the report: all hypotheses that were tried, simulated forces

/// The answer of the judgement, with the names of effects.
struct Answered {
  Verdict verdict = Verdict::none;
  double probability = kNotComputed;  ///< of the verdict; if effects are named, of their set
  std::vector<std::string> effects;   ///< named, most important first
  /// If effects are named: the likeliest sets, which together have 90 % of the probability of all sets.
  std::vector<std::vector<std::string>> confounded;
  std::vector<Alternative> alternatives;  ///< the likeliest first
  std::vector<ExcludedEffect> excluded;   ///< by the component file or the options
  Posterior posterior;                    ///< of the four answers; the verdict has the largest
};

/// Reduction of the gap.
struct Gaps {
  Gap unseen;                    ///< on held-out data, without the errors of the rig
  double closed = kNotComputed;  ///< (re_estimated - augmented) / (re_estimated - noise_floor), at most 1
  /// 95 % interval of `closed` on further logs of the same rig; [closed, closed] if no effect is named.
  std::array<double, 2> closed_interval = {kNotComputed, kNotComputed};
  /// Predicted gap on a further log of which only an offset is removed, from fits of the written law to all logs but
  /// one. Computed for three or more logs without hold-outs.
  double further_log = kNotComputed;
  std::string noise_source;
};

/// Gaps of the configured and of the written component on a log, after removal of the reported errors of the rig and
/// with an offset and an initial state fitted for each component.
struct LeftOfLog {
  std::string log;
  double configured = 0.0;
  double written = 0.0;
  double allowed = 0.0;  ///< allowed excess of written^2 over configured^2
};

/// An effect that is named but not written, because the file would have a larger gap on a log than the configured
/// component.
struct Withheld {
  std::string effect;   ///< "values" for the re-estimated values
  std::string log;      ///< log with the largest excess; "all logs" if only their sum has one
  double before = 0.0;  ///< gap there as configured
  double after = 0.0;   ///< gap there with the effect
};

/// The component that a diagnosis writes, and the law that was judged.
struct WrittenLaw {
  /// The re-estimated component with the simplest law of each named effect, rounded: augmented.yaml.
  io::ComponentDescription augmented;
  io::ComponentDescription full;      ///< the same with the judged laws, not rounded
  double gap_of_full = kNotComputed;  ///< of `full`, like Gaps::unseen.augmented of `augmented`
  /// Effect of each entry that `augmented` adds to the configured ones.
  std::vector<std::string> added_for;
  std::vector<SizedValue> numbers;       ///< of `augmented`, not rounded, by io::numberPlace
  std::vector<SizedValue> model_sizes;   ///< of the judged model's own parameters
  std::vector<SizedValue> effect_sizes;  ///< of the effects that are written
  std::vector<LeftOfLog> left_of_logs;   ///< of the logs of the fit, then of those held out
  std::vector<Withheld> withheld;        ///< in the order of withholding
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
  std::vector<SheetDeviation> sheet_deviations;  ///< of the judged model, the largest first
  std::vector<std::string> at_bounds;            ///< parameters of the judged model at a bound of the fit
  bool guess = false;                            ///< the data sheet is a guess: its values are identified from the logs
};

/// The logs, and the errors removed from each.
struct AdmittedLogs {
  std::vector<Admission> admission;
  std::vector<TakenOut> taken_out;  ///< log by log
};

/// Recommended next step.
struct NextStep {
  std::string text;
  ProposedExperiment proposed;
};

/// Number of samples that a search used.
struct Samples {
  std::size_t searched = 0;
  std::size_t recorded = 0;  ///< in the logs; more than `searched` if the search used excerpts
};

/// The result of a diagnosis. For the verdicts check_bench and defect, numbers are kNotComputed and lists are empty.
struct Diagnosis {
  std::string component;
  bool turns = false;    ///< rotation: [m] stands for [rad] and [N] for [N m]; the units of values are converted
  std::string sentence;  ///< the verdict for an engineer
  std::string defect;    ///< broken invariants; empty except for Verdict::defect
  Answered answer;
  Gaps gaps;
  Gap gap_as_recorded;  ///< of the logs as recorded, as `replay` reports them; without a noise floor
  /// Shares that values and each effect of the judged model remove; they add up to the removed part of the gap. Because
  /// the share of one depends on those already present, it is the mean over all orders (Shapley, 1953).
  std::vector<GapShare> shares;
  std::vector<CandidateResult> candidates;  ///< most probable first
  Where where;
  CouldShow could_show;  ///< effects that these logs could have shown
  NextStep next;
  io::ComponentDescription configured;
  io::ComponentDescription re_estimated;
  WrittenLaw law;
  bool write_full_law = false;                        ///< the report includes augmented_full.yaml
  std::optional<Surrogate> surrogate;                 ///< for the verdicts unknown and partly
  std::optional<DiagnosedTable> table;                ///< empty if logs were diagnosed
  std::vector<measurement::RigFinding> rig_findings;  ///< errors of the rig
  Samples samples;
  AdmittedLogs logs;
  OwnParameters parameters;
  std::optional<WholeStiffness> whole;  ///< empty for a component without a settled loop
  RunRecord run;
  Comparison comparison;
  std::shared_ptr<const Workings> workings;             ///< none for the verdict check_bench
  std::shared_ptr<const BenchEvidence> bench_evidence;  ///< for the verdict check_bench only
};

/// Returns true if the diagnosis has a component file, WrittenLaw::augmented: a model was judged, and no invariant of
/// the report is broken.
inline bool hasComponentFile(const Diagnosis& diagnosis) {
  return diagnosis.workings != nullptr && diagnosis.defect.empty();
}

/// Diagnoses one component. All `logs` are of one test piece, in the order of recording; each hold-out is of a new one.
/// Without hold-outs the gaps are those of blocks that took no part in the fit (cross validation). Logs with more
/// samples than the options allow are searched in excerpts, each of which is a log in the report; `gap_as_recorded` is
/// that of the whole logs. Throws LogError for a log that cannot be used or if the logs need more memory than is
/// available, std::invalid_argument for a component that cannot be built.
Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options = {});

/// Diagnoses logs of any length. They are read block by block, up to three times, so that the memory depends on the
/// samples that the search uses, not on the length of the logs. Throws like the overload above.
Diagnosis diagnose(const io::ComponentDescription& component, const log::LogSources& logs,
                   const log::LogSources& hold_out, const DiagnosisOptions& options = {});

/// Returns the report as JSON text, schema rubber_suspension/gap_report/1.
std::string toJson(const Diagnosis& diagnosis);

/// Returns the evidence on which the judgement is based as JSON text; empty unless requested.
std::string evidenceJson(const Diagnosis& diagnosis);

/// Returns the names of the files that a report may consist of, the page last.
std::vector<std::string> reportFiles();

/// Creates the folder and writes the report into it: report.json, augmented.yaml, augmented_full.yaml if requested,
/// next_experiment.csv and .drv if an experiment is proposed, surrogate.yaml and missing_force.csv if there is a
/// surrogate, evidence.json if requested, and the numbers of its figures. Files of an earlier report that this one
/// lacks are removed, and its page in any case. All files are written before the first is renamed. Throws
/// std::runtime_error.
void writeReportData(const Diagnosis& diagnosis, const std::string& folder);

/// Writes the data and then, by scripts/render_report, report.html, a page that needs no network. Returns an empty
/// string, or the reason in one line if there is no page. Throws std::runtime_error.
std::string writeReport(const Diagnosis& diagnosis, const std::string& folder);

}  // namespace rubber_suspension::diagnosis
