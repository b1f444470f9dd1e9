// The files that a command may write over: the one rule for every file that a command or a launch file writes.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace rubber_suspension::io {

/// The kind of a file, told by its content.
enum class FileKind {
  force_csv,            ///< time_s,displacement_m, and force_N, as this package writes them
  gap_csv,              ///< the live gap over time
  vehicle_csv,          ///< positions, displacements and forces of a vehicle
  figure_csv,           ///< the numbers of a figure
  component_file,       ///< YAML with `components:`
  report_json,          ///< report.json of a diagnosis
  report_html,          ///< report.html of a diagnosis
  plan_json,            ///< plan.json of a diagnosis
  plan_html,            ///< plan.html of a diagnosis
  test_report,          ///< XML of GoogleTest
  figure,               ///< SVG, PNG or PDF
  bag,                  ///< ROS bag
  campaign_manifest,    ///< the jobs of a campaign
  campaign_csv,         ///< the results of a campaign
  campaign_json,        ///< the same as JSON
  fleet_json,           ///< what a campaign says of a fleet, as JSON
  fleet_report,         ///< what a campaign says of a fleet
  force_map_csv,        ///< missing_force.csv of a diagnosis
  fmu,                  ///< functional mock-up unit
  characteristics_csv,  ///< stiffness and loss angle over frequency, amplitude and preload
  bushing_file,         ///< bushing property file of Adams or Altair
  state_space_json,     ///< the linear part of components
  mat,                  ///< MATLAB file
  spring_and_dashpot,   ///< k and c of a component
  rpc,                  ///< RPC III, a drive file
  agreement_json,       ///< agreement of a simulated force with a measured one
};

/// A file that a command reads, with the option that names it.
struct InputFile {
  std::string option;
  std::string path;
};

/// A file that a command writes. Where it lies in a folder that the command makes, the option names the folder.
struct OutputFile {
  std::string option;
  std::string path;
  FileKind kind;
};

/// An output that would destroy something: wrong usage. what() is one line.
class OutputRefused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// To be called before anything is read. Throws OutputRefused for an output that is one of the inputs, by whatever
/// name, hard or symbolic link; for two outputs that are one file, or would be where a file system does not tell upper
/// from lower case; for one that is a folder, or lies in what is no folder; and, unless `force`, for an existing file
/// of another kind than that written. An existing file of the same kind, or an empty one, will be replaced. Devices and
/// pipes may be written always. Entries with an empty path are options not given.
void checkOutputs(const std::vector<InputFile>& inputs, const std::vector<OutputFile>& outputs, bool force);

/// To be called before anything is read, with all logs of a command: throws OutputRefused where two are one file, by
/// whatever name or link, or copies of each other to the last byte: evidence does not count twice, and a log that was
/// fitted says nothing held out.
void refuseEqualLogs(const std::vector<InputFile>& logs);

/// True for a file of that kind.
bool isOfKind(const std::string& path, FileKind kind);

/// Makes a folder with those above it; true where it was not there. Throws std::runtime_error that begins with it.
bool makeFolder(const std::string& folder);

/// The folder for the records of a run, which never replaces an earlier one: `folder` itself, made where missing,
/// unless one of the records stands in it or is being written; then the next free number, run_1, run_2 or NAME, NAME_2.
/// `records` are names of files in it. Throws std::runtime_error where it cannot be made.
std::string makeRunFolder(const std::string& folder, const std::vector<std::string>& records);

}  // namespace rubber_suspension::io
