// Effects that planned logs could show, predicted from their displacement programmes alone.
#pragma once

#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/could_show.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis {

struct PlanOptions {
  double size = 0.1;     ///< RMS force of the added effects divided by the standard deviation of the force
  double noise = 0.005;  ///< RMS noise of the measured force divided by its standard deviation
  int threads = 2;
};

/// A displacement programme and the response of the component to it.
struct PlannedLog {
  std::string log;
  double duration = 0.0;              ///< [s]
  double dt = 0.0;                    ///< [s]
  double largest_displacement = 0.0;  ///< [m]
  double highest_rate = 0.0;          ///< [m/s]
  double largest_force = 0.0;         ///< largest force of the component as configured [N]
};

struct Plan {
  std::string component;
  std::vector<PlannedLog> logs;
  CouldShow could_show;
  RunRecord run;
};

/// Predicts which effects a diagnosis of the planned logs would find. The logs contain the displacements in the order
/// of recording on one component. Their forces are ignored: the force of the component is simulated, with white noise.
/// Throws LogError for a log that cannot be used, std::invalid_argument for a component that cannot be built.
Plan plan(const io::ComponentDescription& component, const std::vector<log::Log>& logs, const PlanOptions& options);

/// Returns a table for a terminal with a line for each effect.
std::string toText(const CouldShow& could_show);

/// Returns the plan as JSON text, schema rubber_suspension/experiment_plan/1.
std::string toJson(const Plan& plan);

/// Returns the names of the files that writePlan() writes.
std::vector<std::string> planFiles();

/// Writes plan.json and then plan.html, a page that needs no network, into a folder, which is created if needed.
/// Returns an empty string, or the reason in one line if there is no page. Throws std::runtime_error.
std::string writePlan(const Plan& plan, const std::string& folder);

}  // namespace rubber_suspension::diagnosis
