// The options of `diagnose`, and functions that its kinds of runs share.
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

/// The options of the command line.
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
  double effect_size = 0.1;  // share of the force's standard deviation [-]
  double noise = 0.005;      // share of the force's standard deviation [-]
  std::uint64_t most_samples = diagnosis::kMostSamples;
  int threads = 2;
  command_line::LogOptions log_options;

  command_line::OptionTable table();
};

/// Returns the target of an option for a share such as "10 %" or 0.1, within these bounds.
command_line::Quantity share(double& value, double least, double most);

/// Show and clear the progress, only on a terminal.
void showStage(const std::string& stage, double fraction);
void clearStage();

/// Returns version, date, command line and every file that is read.
diagnosis::RunRecord runRecord(const DiagnoseOptions& options);

/// Applies the tolerances of --rig.
void setTolerances(const std::vector<std::string>& assignments, io::ComponentDescription& component);

/// Returns the line on excerpts for the terminal; empty if all samples were searched.
std::string excerptsTaken(const diagnosis::Diagnosis& diagnosis);

std::optional<diagnosis::report::EarlierReport> earlierReport(const DiagnoseOptions& options);

/// Warns if a report has no page, with the problem that writing it returned. Returns the path of the page, or else of
/// the report's data.
std::string writtenReport(const std::string& folder, const std::string& name, const std::string& problem);

/// Writes the report of a diagnosis and prints its summary.
int publish(diagnosis::Diagnosis diagnosis, const std::optional<diagnosis::report::EarlierReport>& earlier,
            const DiagnoseOptions& options);

/// The kinds of runs; each returns the exit status.
int runLogs(const DiagnoseOptions& options);
int runDirections(const DiagnoseOptions& options);
int runPlan(const DiagnoseOptions& options);
int runTable(const DiagnoseOptions& options);

}  // namespace rubber_suspension::apps
