// The manifest: every job of a campaign, one command on one component with its logs, its identity, the files that it
// reads, and its folder.
#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/sha256.h"

namespace rubber_suspension::campaign {

/// Task of a job; each is the command of that name.
enum class Command {
  diagnose,  ///< diagnose
  estimate,  ///< estimate --from-log
  replay,    ///< replay of one log
};

/// Files that a job writes besides its record.
enum class Reports {
  none,  ///< its record only
  data,  ///< what other programs read: report.json, augmented.yaml; identification.json, component.yaml; force.csv
  full,  ///< and the page for people, report.html, whose figures take longer than many a diagnosis
};

// In the order of the enumerations.
const std::vector<std::string> kCommands = {"diagnose", "estimate", "replay"};
const std::vector<std::string> kReports = {"none", "data", "full"};

inline const std::string& toString(Command command) { return kCommands.at(static_cast<std::size_t>(command)); }
inline const std::string& toString(Reports reports) { return kReports.at(static_cast<std::size_t>(reports)); }

/// The options of a job, those of the commands under the same names.
struct JobOptions {
  Reports reports = Reports::data;
  bool evidence = false;                   ///< as --evidence, of diagnose
  std::vector<std::string> columns;        ///< as --columns
  std::string unit;                        ///< as --unit
  double sampling_rate = 0.0;              ///< as --sampling-rate [Hz]; 0: not given
  std::string decimal;                     ///< as --decimal
  std::string segment;                     ///< as --segment
  double bridge = -1.0;                    ///< as --bridge [s]; less than 0: not given
  std::string sentinel;                    ///< as --sentinel
  std::string clock;                       ///< as --clock
  bool accept_units = false;               ///< as --accept-units
  bool large = false;                      ///< as --large
  bool without_rig = false;                ///< as --without-rig
  std::map<std::string, std::string> rig;  ///< as --rig, of diagnose
  std::vector<std::string> exclude;        ///< as --exclude, of diagnose
  std::vector<std::string> hold;           ///< as --hold, of estimate
  int starts = 0;                          ///< as --starts, of estimate; 0: not given
};

/// Calls visit(key, pointer to member) for each option, by the keys of jobs files and manifests.
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

/// A file that jobs read, with its hash when the manifest was made.
struct InputFile {
  std::string path;  ///< absolute
  io::FileHash content;
};

/// Numbers are places in the manifest's list of inputs.
struct Job {
  std::string id;          ///< SHA-256 of what decides its result, 64 hexadecimal digits
  std::string group;       ///< name of its entry in the jobs file
  std::string type;        ///< components of one type are compared with each other
  std::string test_rig;    ///< what is tested on one rig may share its stiffness
  std::string test_piece;  ///< distinguishes components of one name: the folder, or the number of the draw
  Command command = Command::diagnose;
  std::string component;
  std::size_t config = 0;
  std::vector<std::size_t> logs;
  std::vector<std::size_t> hold_out;
  std::map<std::string, double> specification;  ///< drawn values in place of those of the file [SI]
  JobOptions options;
};

/// Its name for a user: its entry in the jobs file, test piece, and the beginning of its id.
std::string nameOf(const Job& job);

/// Id of a job. It depends on the contents of its files, the names of its logs (which the report shows), its options
/// and the version of the program, not on the folders of the files.
std::string jobId(const Job& job, const std::vector<InputFile>& inputs, const std::string& version);

void to_json(nlohmann::ordered_json& json, const JobOptions& options);

/// A line of a manifest; of options and lists only what is not the default. Reading it throws std::invalid_argument or
/// nlohmann::json::exception.
void to_json(nlohmann::ordered_json& json, const Job& job);
void from_json(const nlohmann::json& json, Job& job);

struct Manifest {
  std::string version;  ///< of the program that made it
  std::vector<InputFile> inputs;
  std::vector<Job> jobs;

  /// Places of the jobs of different ids, each once, in the order of the manifest: jobs of the same inputs and options
  /// are worked off once and share their result.
  std::vector<std::size_t> distinctJobs() const;
};

/// Where things lie in the folder of a campaign.
inline std::string manifestPath(const std::string& folder) { return folder + "/manifest.jsonl"; }
std::string recordPath(const std::string& folder, const std::string& id);

/// The folder of a job's reports, relative to that of the campaign.
std::string reportFolder(const std::string& id);

/// JSON lines: a header with the numbers of lines, the inputs, the jobs. Throws std::runtime_error.
void writeManifest(const Manifest& manifest, const std::string& folder);

/// Throws std::runtime_error that names the file, the line and what is accepted.
Manifest readManifest(const std::string& folder);

}  // namespace rubber_suspension::campaign
