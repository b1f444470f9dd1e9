// Where the model fails, which unmodelled effect causes it, how far the gap shrinks: the diagnosis as one call.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/gap/where.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"
#include "rubber_suspension/measurement/rig_finding.h"

namespace rubber_suspension::diagnosis {

/// What a diagnosis is told besides the component and the logs.
struct DiagnosisOptions {
  int threads = 2;
  /// Called with the stage's name and the fraction done.
  std::function<void(const std::string& stage, double fraction)> progress;
  unsigned seed = 1;  ///< of the resampling for intervals
  int resamplings = 400;
};

/// What the diagnosis says of one candidate effect.
struct CandidateResult {
  std::string effect;
  std::string documentation;
  bool on_rig = false;
  double probability = 0.0;          ///< that this is the (most important) effect
  double gap = 0.0;                  ///< held out, with this effect alone added
  double closed = 0.0;               ///< fraction of the closable gap
  std::array<double, 2> interval{};  ///< 95 % interval of `closed`
  bool testable = false;             ///< a typical size of it would be visible in these logs, or what was fitted is
  double visible_share = 0.0;        ///< of a typical effect's force, the part that re-estimation does not hide [-]
  std::map<std::string, double> parameters;
  std::vector<element::ElementDescription> add;  ///< its entries for a component file
};

/// RMS of measured minus simulated force over the standard deviation of the measured force, on data that took no part
/// in the fit.
struct Gap {
  double as_configured = 0.0;
  double re_estimated = 0.0;
  double augmented = 0.0;
  double noise_floor = 0.0;
};

/// Errors of the characteristics on held-out data, relative RMS over windows.
struct CharacteristicErrors {
  double stiffness = 0.0;   ///< [-]
  double loss_angle = 0.0;  ///< [rad]
  double energy = 0.0;      ///< of the loss per cycle [-]
};

/// A log as it was admitted.
struct Admission {
  std::string log;
  bool hold_out = false;
  double duration = 0.0;              ///< [s]
  double dt = 0.0;                    ///< [s]
  double largest_displacement = 0.0;  ///< [m]
  double highest_frequency = 0.0;     ///< [Hz]
  double noise = 0.0;                 ///< floor in units of the force's standard deviation
  double repeats = 0.0;               ///< share of the log that repeats an earlier motion
  std::vector<std::string> notes;
};

/// Re-estimated over configured value, by the parameter's name.
using ParameterRatios = std::vector<std::pair<std::string, double>>;

/// Model parameters that each log alone would want.
struct ParameterByLog {
  std::string log;
  double amplitude = 0.0;  ///< sqrt(2) times the standard deviation of the displacement [m]
  double frequency = 0.0;  ///< mean frequency of the motion [Hz]
  ParameterRatios ratios;
};

struct Workings;  // what the report draws and lists besides: every hypothesis that was tried, the simulated forces

/// What a diagnosis found.
struct Diagnosis {
  std::string component;
  std::string verdict;               ///< none, parameter_error, named, confounded, unknown, partly or check_bench
  std::string sentence;              ///< the verdict for an engineer
  std::vector<std::string> effects;  ///< named, most important first
  Gap gap;                           ///< what the rig did to each log taken out
  Gap gap_as_recorded;               ///< the same of the logs as they are, which `replay` gives; without a floor
  std::string noise_source;
  double closed = 0.0;  ///< fraction of the closable gap
  std::array<double, 2> closed_interval{};
  std::vector<std::vector<std::string>>
      confounded;                           ///< for each effect named, those that these logs cannot tell from it
  std::vector<CandidateResult> candidates;  ///< most probable first
  double probability_none = 0.0;            ///< that no effect of the list is at work
  std::vector<gap::GapCell> where;
  std::string next_experiment;
  io::ComponentDescription re_estimated;
  io::ComponentDescription augmented;  ///< re-estimated, with the effects named

  std::vector<measurement::RigFinding> rig_findings;  ///< what the rig did to each log

  std::vector<Admission> admission;
  ParameterRatios parameter_ratios;
  std::vector<ParameterByLog> by_log;
  CharacteristicErrors errors_re_estimated;
  CharacteristicErrors errors_augmented;

  std::shared_ptr<const Workings> workings;
};

/// Diagnose one component. Logs in the order of recording, on one component; each hold-out starts with a new one.
/// Without hold-outs the gaps are those of blocks that took no part in the fit (cross validation).
/// Throws LogError for a log that cannot be used, std::invalid_argument for a component that cannot be built.
Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, const DiagnosisOptions& options = {});

/// The report as JSON text, schema rubber_suspension/gap_report/1.
std::string toJson(const Diagnosis& diagnosis);

/// The report as a page that needs no network.
std::string toHtml(const Diagnosis& diagnosis);

/// Write report.json, report.html and augmented.yaml into a folder, which is made. Throws std::runtime_error.
void writeReport(const Diagnosis& diagnosis, const std::string& folder);

}  // namespace rubber_suspension::diagnosis
