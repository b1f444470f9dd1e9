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

/// Default for the largest number of samples of a search. The memory and the time of a search grow with this number.
constexpr std::size_t kMostSamples = 300000;

/// Value of a number that was not computed, as in a report with the verdict check_bench; null in report.json.
constexpr double kNotComputed = std::numeric_limits<double>::quiet_NaN();

/// The options of a diagnosis besides the component and the logs.
struct DiagnosisOptions {
  int threads = 2;
  /// Called with the stage's name and the fraction done.
  std::function<void(const std::string& stage, double fraction)> progress;
  unsigned seed = 1;                       ///< seeds the random draws for intervals
  int resamplings = 400;                   ///< number of random draws for intervals
  ExperimentLimits limits;                 ///< limits of the proposed experiment
  std::vector<std::string> excluded = {};  ///< effects to exclude in addition to those that the component file excludes
  bool evidence = false;  ///< the report includes the evidence: the errors of every hypothesis on held-out data
  std::uint64_t available_memory = 0;  ///< limit in bytes; 0 stands for all memory that is available to this process
  /// Largest number of samples that a search uses in total. Longer logs and hold-outs are searched in excerpts.
  std::size_t most_samples = kMostSamples;
  bool turns = false;  ///< the component is a rotation: in its file and its logs, m stands for rad and N for N m
};

/// The result of the diagnosis on one candidate effect.
struct CandidateResult {
  std::string effect;
  std::string documentation;
  bool on_rig = false;
  double probability = 0.0;  ///< sum of the probabilities of all sets that contain this effect
  double gap = 0.0;          ///< held-out gap of the model with this effect alone added
  double closed = 0.0;       ///< fraction of the closable gap that the effect closes
  /// 95 % interval of `closed` on further logs of the same rig.
  std::array<double, 2> interval{};
  bool testable = false;       ///< the effect is named, or an effect of typical size would be visible in these logs
  double visible_share = 0.0;  ///< part of its typical force that re-estimated model parameters do not absorb [-]
  std::map<std::string, double> parameters;
  std::vector<element::ElementDescription> add;  ///< entries for `add` of a component file
  /// True if the numbers above are those of the written component, false if those of the effect's full law alone.
  bool written = false;
};

/// An explanation of the logs other than the reported one.
struct Alternative {
  Verdict verdict = Verdict::none;   ///< `named` if the explanation is a set of effects
  std::vector<std::string> effects;  ///< the effects of the set
  double probability = 0.0;
};

/// An excluded effect, with the probability that it would have if no effect were excluded.
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

/// The force that a model lacks, averaged over all logs in cells of displacement and velocity.
struct MissingForce {
  std::vector<double> displacement;  ///< edges of the cells [m]
  std::vector<double> velocity;      ///< edges of the cells [m/s]
  /// The next three lists contain the cells in rows of constant velocity; a force is NaN if its cell has few samples.
  std::vector<double> measured;   ///< mean of measured minus augmented force [N]
  std::vector<double> surrogate;  ///< mean force of the surrogate [N]
  std::vector<int> samples;
};

/// A component that closes a gap that no effect explains. It reproduces the residual force, but states no cause.
struct Surrogate {
  io::ComponentDescription component;  ///< the augmented component with an element `residual` added
  double gap = 0.0;                    ///< gap on the logs as recorded, as `replay` reports it for this component
  double unseen_before = 0.0;  ///< gap of the augmented component on logs or blocks that took no part in the fit
  double unseen_after = 0.0;   ///< gap on the same data of surrogates that were fitted to the other logs or blocks
  double share = 0.0;          ///< part of the squared residual beyond noise that such surrogates predict
  double chance = 1.0;         ///< p-value of this prediction
  bool beyond_chance = false;  ///< the prediction is significant
  bool function_of_the_motion = false;  ///< the prediction is significant and covers the larger part of the residual
  MissingForce missing;                 ///< the force to which the surrogate is fitted
};

/// Errors of the characteristics on held-out data: root mean squares of the relative errors of windows.
struct CharacteristicErrors {
  double stiffness = kNotComputed;   ///< [-]
  double loss_angle = kNotComputed;  ///< [rad]
  double energy = kNotComputed;      ///< relative error of the loss per cycle [-]
};

/// Ratings of a recorded log by ISO/TS 18571.
struct LogRating {
  gap::Iso18571 as_configured;
  gap::Iso18571 augmented;
};

/// A log that passed the checks of the bench, with its properties.
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
  /// Square root of the mean squared residual that was removed, divided by the standard deviation of the force;
  /// negative if the residual grew. The sum of the squares for a log, with these signs, is recorded^2 - left^2 of its
  /// Admission.
  double share = 0.0;
};

/// Re-estimated value of each parameter divided by its configured value, by name.
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
  std::string owner;  ///< "specification", the type of an element, or the effect to which the number belongs
  std::string name;
  std::string unit;  ///< in SI units; "1" for a dimensionless number
  /// NaN if the component file does not state the number
  double configured = std::numeric_limits<double>::quiet_NaN();
  double value = 0.0;
  std::array<double, 2> interval_95{};  ///< posterior predictive: covers logs, form of the law and choice of the law
  std::array<bool, 2> at_bound{};       ///< for each end of the interval: true if a bound of the fit limits it
  std::string text = {};  ///< the number as rounded for a component file; empty if it is written with all digits
};

/// Part of the configured gap that re-estimated values or one effect remove.
struct GapShare {
  std::string by;  ///< "values", or the name of the effect
  double share = 0.0;
  /// For an effect: 95 % lower bound of the squared residual that its law removes from held-out parts of the logs,
  /// divided by the variance of the force.
  double squares_at_least = kNotComputed;
};

/// Deviation from the data sheet of a number that the logs determine.
struct SheetDeviation {
  std::string name;         ///< a key of the specification
  double tolerances = 0.0;  ///< (value in the logs - value of the data sheet) / tolerance
};

/// Stiffness and loss angle of the whole component at one frequency and amplitude, as configured and as augmented.
struct WholeStiffness {
  double frequency = 0.0;              ///< [Hz]
  double amplitude = 0.0;              ///< [m]
  bool nominal_amplitude = false;      ///< true: amplitude of the specification; false: median of the logs
  std::array<double, 2> stiffness{};   ///< dynamic stiffness as configured and as augmented [N/m]
  std::array<double, 2> loss_angle{};  ///< loss angle as configured and as augmented [rad]
};

/// An experiment to run on the bench.
struct ProposedExperiment {
  std::string description;
  double dt = 0.0;                   ///< [s]
  std::vector<double> displacement;  ///< samples at constant time steps [m]; empty if no experiment is proposed
  std::string decides;               ///< effects of the reported explanation
  std::vector<std::string> against;  ///< effects of each competing explanation
  double difference = 0.0;   ///< RMS force error of the nearest competitor after a refit, if `decides` is right [N]
  double open_before = 0.0;  ///< entropy of the question which effects are at work, summed over the effects [bit]
  double open_after = 0.0;   ///< expected entropy once this log is diagnosed together with the others [bit]
  double probability = 0.0;  ///< expected probability that the right explanation is then the only likely one
};

/// A value that both of two compared reports state.
struct ReportChange {
  std::string what;
  std::string before;  ///< value with unit and interval
  std::string after;
  bool differs = false;  ///< the difference exceeds noise and intervals
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

struct BenchEvidence;  // data for the figures of logs that fail the checks of the bench
struct Workings;       // data for the report: all hypotheses that were fitted, and simulated forces

/// The verdict, with the names of effects.
struct Answered {
  Verdict verdict = Verdict::none;
  double probability = kNotComputed;  ///< probability of the verdict; if effects are named, of the set of these effects
  std::vector<std::string> effects;   ///< named effects, the most important first
  /// If effects are named: the likeliest sets of effects, which together have 90 % of the probability of all sets. Sets
  /// that contain an improbable effect are omitted.
  std::vector<std::vector<std::string>> confounded;
  std::vector<Alternative> alternatives;  ///< the likeliest first
  std::vector<ExcludedEffect> excluded;   ///< effects that the component file or the options exclude
  Posterior posterior;  ///< probabilities of the four answers; the verdict follows from the largest one
};

/// The gap before and after the effects are added, and the fraction that they close.
struct Gaps {
  Gap unseen;                    ///< gaps on held-out data after removal of the errors of the rig
  double closed = kNotComputed;  ///< (re_estimated - augmented) / (re_estimated - noise_floor), at most 1
  /// 95 % interval of `closed` on further logs of the same rig; [closed, closed] if no effect is named.
  std::array<double, 2> closed_interval = {kNotComputed, kNotComputed};
  /// Gap that is predicted for a further log of which only an offset is removed. The prediction fits the written law to
  /// all logs but one, for each log in turn, and needs at least three logs and no hold-outs.
  double further_log = kNotComputed;
  std::string noise_source;
};

/// Gaps of the configured and of the written component on a log. The reported errors of the rig are removed, and an
/// offset and an initial state are fitted for each component.
struct LeftOfLog {
  std::string log;
  double configured = 0.0;
  double written = 0.0;
  double allowed = 0.0;  ///< limit for written^2 - configured^2
};

/// An effect that is named but not written, because the file would have a larger gap on a log than as configured.
struct Withheld {
  std::string effect;   ///< name of the effect, or "values" for the re-estimated values
  std::string log;      ///< log on which the gap grows most; "all logs" if the gap grows only for all logs together
  double before = 0.0;  ///< gap on this log as configured
  double after = 0.0;   ///< gap on this log with the effect
};

/// The component that a diagnosis writes, and the law that was judged.
struct WrittenLaw {
  /// The re-estimated component with the simplest law of each named effect, rounded as in augmented.yaml.
  io::ComponentDescription augmented;
  io::ComponentDescription full;      ///< the same component with the judged laws and unrounded numbers
  double gap_of_full = kNotComputed;  ///< held-out gap of `full`; that of `augmented` is Gaps::unseen.augmented
  /// For each entry that `augmented` has in addition to the configured ones: the effect to which it belongs.
  std::vector<std::string> added_for;
  std::vector<SizedValue> numbers;       ///< unrounded numbers of `augmented`, in the order of io::numberPlace
  std::vector<SizedValue> model_sizes;   ///< model parameters of the judged model
  std::vector<SizedValue> effect_sizes;  ///< sizes of the effects that are written
  std::vector<LeftOfLog> left_of_logs;   ///< the logs of the fit, followed by the held-out logs
  std::vector<Withheld> withheld;        ///< in the order in which they were withheld
};

/// The errors of a component: its gap in each cell, and the errors of its characteristics.
struct Where {
  std::vector<gap::GapCell> before;  ///< cells of the configured component
  std::vector<gap::GapCell> after;   ///< cells of the augmented component
  CharacteristicErrors re_estimated;
  CharacteristicErrors augmented;
};

/// The model parameters and their deviations from the data sheet.
struct OwnParameters {
  ParameterRatios ratios;
  std::vector<SheetDeviation> sheet_deviations;  ///< deviations of the judged model, the largest first
  std::vector<std::string> at_bounds;            ///< parameters of the judged model at a bound of the fit
  bool guess = false;  ///< the data sheet is a guess, so that its values are identified from the logs
};

/// The logs, and the errors that were removed from each.
struct AdmittedLogs {
  std::vector<Admission> admission;
  std::vector<TakenOut> taken_out;  ///< errors in the order of the logs
};

/// The recommended next step.
struct NextStep {
  std::string text;
  ProposedExperiment proposed;
};

/// Numbers of samples that a search used and that the logs contain.
struct Samples {
  std::size_t searched = 0;
  std::size_t recorded = 0;  ///< samples of the logs; more than `searched` if the search used excerpts
};

/// The result of a diagnosis. If the verdict is check_bench or defect, numbers are kNotComputed and lists are empty.
struct Diagnosis {
  std::string component;
  bool turns = false;    ///< the component is a rotation: [m] stands for [rad] and [N] for [N m]
  std::string sentence;  ///< states the verdict for an engineer
  std::string defect;    ///< broken invariants; empty except for Verdict::defect
  Answered answer;
  Gaps gaps;
  Gap gap_as_recorded;  ///< gaps on the logs as recorded, as `replay` reports them; without a noise floor
  /// Shares of the gap that values and each effect of the judged model remove, which add up to the removed part. The
  /// share of an effect depends on which others are already present, so it is averaged over all orders (Shapley, 1953).
  std::vector<GapShare> shares;
  std::vector<CandidateResult> candidates;  ///< sorted by probability, the largest first
  Where where;
  CouldShow could_show;  ///< effects that these logs could have shown
  NextStep next;
  io::ComponentDescription configured;
  io::ComponentDescription re_estimated;
  WrittenLaw law;
  bool write_full_law = false;                        ///< the report includes augmented_full.yaml
  std::optional<Surrogate> surrogate;                 ///< present for the verdicts unknown and partly
  std::optional<DiagnosedTable> table;                ///< empty if logs were diagnosed
  std::vector<measurement::RigFinding> rig_findings;  ///< errors of the rig
  Samples samples;
  AdmittedLogs logs;
  OwnParameters parameters;
  std::optional<WholeStiffness> whole;  ///< empty for a component that has no settled loop
  RunRecord run;
  Comparison comparison;
  std::shared_ptr<const Workings> workings;             ///< null for the verdict check_bench
  std::shared_ptr<const BenchEvidence> bench_evidence;  ///< present for the verdict check_bench only
};

/// Returns true if the diagnosis provides a component file, WrittenLaw::augmented. This requires that a model was
/// judged and that the report breaks no invariant.
inline bool hasComponentFile(const Diagnosis& diagnosis) {
  return diagnosis.workings != nullptr && diagnosis.defect.empty();
}

/// Diagnoses one component. All `logs` are of one test piece, in the order of recording; each log of `hold_out` is of a
/// new test piece. If `hold_out` is empty, the gaps are those of blocks that took no part in the fit (cross
/// validation). If the logs have more samples than the options allow, they are searched in excerpts. The report then
/// lists each excerpt as a log, but `gap_as_recorded` refers to the whole logs. Throws LogError if a log cannot be used
/// or if the logs need more memory than is available, and std::invalid_argument if the component cannot be built.
Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options = {});

/// Diagnoses logs of any length. They are read in parts, up to three times, so that the memory depends on the number of
/// samples that the search uses and not on the length of the logs. Throws like the overload above.
Diagnosis diagnose(const io::ComponentDescription& component, const log::LogSources& logs,
                   const log::LogSources& hold_out, const DiagnosisOptions& options = {});

/// Returns the report as JSON text, schema rubber_suspension/gap_report/1.
std::string toJson(const Diagnosis& diagnosis);

/// Returns the evidence on which the judgement is based as JSON text; empty unless requested.
std::string evidenceJson(const Diagnosis& diagnosis);

/// Returns the names of the files that a report may consist of, the page last.
std::vector<std::string> reportFiles();

/// Creates the folder and writes the files of the report and the numbers of its figures. report.json is always written.
/// augmented.yaml is written if hasComponentFile(), next_experiment.csv and .drv if an experiment is proposed,
/// surrogate.yaml and missing_force.csv if there is a surrogate, and augmented_full.yaml and evidence.json if
/// requested. The page of an earlier report is removed, and so are its files that this report does not replace. All
/// files are written before the first is renamed. Throws std::runtime_error.
void writeReportData(const Diagnosis& diagnosis, const std::string& folder);

/// Writes the data of the report, and then runs scripts/render_report to write report.html, a page that needs no
/// network. Returns an empty string, or the reason in one line if there is no page. Throws std::runtime_error.
std::string writeReport(const Diagnosis& diagnosis, const std::string& folder);

}  // namespace rubber_suspension::diagnosis
