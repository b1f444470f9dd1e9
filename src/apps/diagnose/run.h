// The options of `diagnose`, and functions that its different runs share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "command_line/component_options.h"
#include "command_line/log_options.h"
#include "command_line/option_table.h"
#include "diagnosis/report/compare.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::apps {

struct DiagnoseOptions {
  std::vector<std::string> command_line;
  command_line::ComponentOptions component;
  std::vector<std::string> directions;
  std::vector<std::string> logs;
  std::vector<std::string> hold_out;
  std::string output;
  std::string plot;
  std::string compare;
  bool evidence = false;
  std::string law = "simplest";
  std::vector<std::string> rig;
  std::vector<std::string> exclude;
  std::vector<std::string> limits;
  std::vector<std::string> plan;
  std::string table_path;
  std::vector<std::string> uncertainty;
  double effect_size = 0.1;  // share of the standard deviation of the force [-]
  double noise = 0.005;      // share of the standard deviation of the force [-]
  std::uint64_t most_samples = diagnosis::kMostSamples;
  int threads = 2;
  command_line::LogOptions log_options;

  command_line::OptionTable table();
};

/// Returns `value` as the target of an option that accepts a share, such as "10 %" or 0.1, from `least` to `most`.
command_line::Quantity share(double& value, double least, double most);

/// These functions show and remove the progress. They do nothing unless stderr is a terminal.
void showStage(const std::string& stage, double fraction);
void clearStage();

/// Returns the version, the date, the command line and the files that are read.
diagnosis::RunRecord runRecord(const DiagnoseOptions& options);

/// Sets the tolerances of --rig in the component.
void setTolerances(const std::vector<std::string>& assignments, io::ComponentDescription& component);

/// Returns a line that states that only excerpts were searched; empty if all samples were searched.
std::string excerptsTaken(const diagnosis::Diagnosis& diagnosis);

std::optional<diagnosis::report::EarlierReport> earlierReport(const DiagnoseOptions& options);

/// Prints `problem`, the reason why the report has no page, as a warning unless it is empty. Returns the path of the
/// page, or the path of the data of the report if there is no page.
std::string writtenReport(const std::string& folder, const std::string& name, const std::string& problem);

/// Writes the report of a diagnosis and prints its summary. Returns the exit status.
int publish(diagnosis::Diagnosis diagnosis, const std::optional<diagnosis::report::EarlierReport>& earlier,
            const DiagnoseOptions& options);

/// These functions run the different kinds of diagnosis and return the exit status.
int runLogs(const DiagnoseOptions& options);
int runDirections(const DiagnoseOptions& options);
int runPlan(const DiagnoseOptions& options);
int runTable(const DiagnoseOptions& options);

}  // namespace rubber_suspension::apps
