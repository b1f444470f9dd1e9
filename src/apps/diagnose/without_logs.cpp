// Runs `diagnose` without logs: predicts what displacement programmes would show, or diagnoses a measured table.
#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <utility>

#include "apps/diagnose/run.h"
#include "command/measured_table.h"
#include "command_line/command.h"
#include "command_line/warnings.h"
#include "fit/parallel.h"
#include "io/folder_lock.h"
#include "io/progress.h"
#include "rubber_suspension/diagnosis/plan.h"
#include "rubber_suspension/diagnosis/table_diagnosis.h"
#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/fit/measured_table.h"

namespace rubber_suspension::apps {
namespace {

using namespace command_line;

std::vector<log::Log> readLogs(const std::vector<std::string>& paths, const io::ComponentDescription& component,
                               const DiagnoseOptions& options) {
  std::vector<std::vector<log::Log>> of_path(paths.size());
  fit::parallelFor(paths.size(), options.threads,
                   [&](std::size_t i) { of_path[i] = options.log_options.readAll(paths[i], component.name); });
  std::vector<log::Log> logs;
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (log::Log& log : of_path[i]) {
      LogOptions::printNotes("diagnose", paths[i], log.notes);
      warnOfTemperature("diagnose", paths[i], !log.temperature.empty(), component);
      logs.push_back(std::move(log));
    }
  }
  return logs;
}

// Combines the relative uncertainties of magnitude and phase of K*, which are perpendicular in the complex plane.
std::optional<double> uncertaintyOf(const std::vector<std::string>& texts) {
  if (texts.empty()) {
    return std::nullopt;
  }
  constexpr double kMostDegrees = 45.0;
  double of_stiffness = 0.0;
  double of_angle = 0.0;
  of_stiffness = quantityOf("--uncertainty", texts[0], share(of_stiffness, 1e-4, 1.0));
  if (texts.size() > 1) {
    of_angle = quantityOf("--uncertainty", texts[1],
                          {&of_angle, "rad", element::Range::closed(0.0, kMostDegrees * element::kPi / 180.0),
                           fmt::format("an angle from 0 to {:g} degrees, such as \"0.5 deg\"", kMostDegrees)});
  }
  return std::hypot(of_stiffness, of_angle);
}

}  // namespace

int runPlan(const DiagnoseOptions& options) {
  diagnosis::PlanOptions settings;
  settings.size = options.effect_size;
  settings.noise = options.noise;
  settings.threads = options.threads;
  options.log_options.requireUse(options.plan);
  io::ComponentDescription component = options.component.read("diagnose");
  setTolerances(options.rig, component);
  const std::vector<log::Log> programmes = readLogs(options.plan, component, options);
  std::optional<io::Activity> planning("predicting which effects the programmes would show");
  diagnosis::Plan plan = diagnosis::plan(component, programmes, settings);
  plan.run = runRecord(options);
  const std::string problem = diagnosis::writePlan(plan, options.output);
  planning.reset();
  fmt::print("{}plan: {}\n", diagnosis::toText(plan.could_show), writtenReport(options.output, "plan", problem));
  return kSuccess;
}

int runTable(const DiagnoseOptions& options) {
  const std::optional<double> uncertainty = uncertaintyOf(options.uncertainty);
  const io::FolderLock lock(options.output);
  io::ComponentDescription component = options.component.read("diagnose");
  setTolerances(options.rig, component);
  const std::optional<diagnosis::report::EarlierReport> earlier = earlierReport(options);
  fit::MeasuredTable table = command::readTable(options.table_path);
  table.uncertainty = uncertainty;
  table.accept_units = options.log_options.acceptsUnits();
  for (const std::string& note : table.notes) {
    printWarning("diagnose", options.table_path + ": " + note);
  }
  diagnosis::DiagnosisOptions settings;
  settings.threads = options.threads;
  settings.progress = showStage;
  settings.evidence = options.evidence;
  settings.excluded = options.exclude;
  return publish(diagnosis::diagnoseTable(component, table, settings), earlier, options);
}

}  // namespace rubber_suspension::apps
