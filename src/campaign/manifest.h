// Defines the manifest. It lists the jobs of a campaign, each of which is one command on one component and its logs.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/sha256.h"

namespace rubber_suspension::campaign {

enum class Command {
  diagnose,
  estimate,  ///< estimate --from-log
  replay,    ///< replay of one log
};

/// Files that a job writes besides its record.
enum class Reports {
  none,  ///< only the record of the job
  /// Files for other programs: report.json and augmented.yaml, identification.json and component.yaml, or force.csv.
  data,
  full,  ///< also report.html, whose figures may take longer than the diagnosis
};

// Names, in the order of the enumerators.
const std::vector<std::string> kCommands = {"diagnose", "estimate", "replay"};
const std::vector<std::string> kReports = {"none", "data", "full"};

inline const std::string& toString(Command command) { return kCommands.at(static_cast<std::size_t>(command)); }
inline const std::string& toString(Reports reports) { return kReports.at(static_cast<std::size_t>(reports)); }

/// Options of a job. The comment on each names the option of the command that has the same meaning.
struct JobOptions {
  Reports reports = Reports::data;
  bool evidence = false;                   ///< --evidence of diagnose
  std::vector<std::string> columns;        ///< --columns
  std::string unit;                        ///< --unit
  double sampling_rate = 0.0;              ///< --sampling-rate [Hz]; 0 if not given
  std::string decimal;                     ///< --decimal
  std::string segment;                     ///< --segment
  double bridge = -1.0;                    ///< --bridge [s]; negative if not given
  std::string sentinel;                    ///< --sentinel
  std::string clock;                       ///< --clock
  bool accept_units = false;               ///< --accept-units
  bool large = false;                      ///< --large
  bool without_rig = false;                ///< --without-rig
  std::map<std::string, std::string> rig;  ///< --rig of diagnose
  std::vector<std::string> exclude;        ///< --exclude of diagnose
  std::vector<std::string> hold;           ///< --hold of estimate
  int starts = 0;                          ///< --starts of estimate; 0 if not given
};

/// Calls visit(key, pointer to member) for each option, with the keys that jobs files and manifests use.
template <class Visit>
void forEachOption(Visit visit) {
  visit("reports", &JobOptions::reports);
  visit("evidence", &JobOptions::evidence);
  visit("columns", &JobOptions::columns);
  visit("unit", &JobOptions::unit);
  visit("sampling_rate", &JobOptions::sampling_rate);
  visit("decimal", &JobOptions::decimal);
  visit("segment", &JobOptions::segment);
  visit("bridge", &JobOptions::bridge);
  visit("sentinel", &JobOptions::sentinel);
  visit("clock", &JobOptions::clock);
  visit("accept_units", &JobOptions::accept_units);
  visit("large", &JobOptions::large);
  visit("without_rig", &JobOptions::without_rig);
  visit("rig", &JobOptions::rig);
  visit("exclude", &JobOptions::exclude);
  visit("hold", &JobOptions::hold);
  visit("starts", &JobOptions::starts);
}

/// A file that jobs read, and its hash at the time when the manifest was made.
struct InputFile {
  std::string path;  ///< absolute
  io::FileHash content;
};

/// One job. `config`, `logs` and `hold_out` are indices into the inputs of the manifest.
struct Job {
  std::string id;        ///< SHA-256 digest that jobId() returns, as 64 hexadecimal digits
  std::string group;     ///< name of the entry in the jobs file
  std::string type;      ///< components of the same type are compared with each other
  std::string test_rig;  ///< name of the rig; jobs on the same rig may share its compliance
  /// Folder, and number of the draw if there is one. Distinguishes components with equal names.
  std::string test_piece;
  Command command = Command::diagnose;
  std::string component;
  std::size_t config = 0;
  std::vector<std::size_t> logs;
  std::vector<std::size_t> hold_out;
  std::map<std::string, double> specification;  ///< drawn values that replace those in the file [SI]
  JobOptions options;
};

/// Returns the name of a job for messages: name of its entry in the jobs file, test piece, and beginning of its id.
std::string nameOf(const Job& job);

/// Returns the id of a job. It depends on the contents of the files, the names of the logs (which the report shows),
/// the options and the version of the program, but not on the folders of the files.
std::string jobId(const Job& job, const std::vector<InputFile>& inputs, const std::string& version);

void to_json(nlohmann::ordered_json& json, const JobOptions& options);

/// Writes or reads a line of a manifest. The line omits options and lists with their default values. Reading throws
/// std::invalid_argument or nlohmann::json::exception.
void to_json(nlohmann::ordered_json& json, const Job& job);
void from_json(const nlohmann::json& json, Job& job);

struct Manifest {
  std::string version;
  std::vector<InputFile> inputs;
  std::vector<Job> jobs;

  /// Returns the indices of the jobs with distinct ids, in the order of the manifest. Jobs with equal inputs and
  /// options have the same id, run once and share the result.
  std::vector<std::size_t> distinctJobs() const;
};

inline std::string manifestPath(const std::string& folder) { return folder + "/manifest.jsonl"; }
std::string recordPath(const std::string& folder, const std::string& id);

/// Returns the folder of the reports of a job, relative to the folder of the campaign.
std::string reportFolder(const std::string& id);

/// Writes JSON lines: a header with the numbers of inputs and jobs, inputs, jobs. Throws std::runtime_error.
void writeManifest(const Manifest& manifest, const std::string& folder);

/// Reads a manifest. Throws std::runtime_error with the name of the file, the line and what is accepted.
Manifest readManifest(const std::string& folder);

}  // namespace rubber_suspension::campaign
