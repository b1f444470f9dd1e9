// The manifest lists the jobs of a campaign, each of which is one command on one component and its logs, and the files
// that the jobs read.
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
  data,  ///< files for other programs: report.json, augmented.yaml; identification.json, component.yaml; force.csv
  full,  ///< also report.html, whose figures take longer than many a diagnosis
};

// Names, in the order of the enumerators.
const std::vector<std::string> kCommands = {"diagnose", "estimate", "replay"};
const std::vector<std::string> kReports = {"none", "data", "full"};

inline const std::string& toString(Command command) { return kCommands.at(static_cast<std::size_t>(command)); }
inline const std::string& toString(Reports reports) { return kReports.at(static_cast<std::size_t>(reports)); }

/// Options of a job; the commands have options of the same names.
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

/// One job; `config`, `logs` and `hold_out` are indices into the inputs of the manifest.
struct Job {
  std::string id;          ///< SHA-256 by jobId(), 64 hexadecimal digits
  std::string group;       ///< name of its entry in the jobs file
  std::string type;        ///< components of one type are compared with each other
  std::string test_rig;    ///< name of the rig; jobs of one rig may share its compliance
  std::string test_piece;  ///< folder, with the number of the draw if any; distinguishes components of one name
  Command command = Command::diagnose;
  std::string component;
  std::size_t config = 0;
  std::vector<std::size_t> logs;
  std::vector<std::size_t> hold_out;
  std::map<std::string, double> specification;  ///< drawn values in place of those of the file [SI]
  JobOptions options;
};

/// Returns the name of a job for messages: its entry in the jobs file, its test piece and the beginning of its id.
std::string nameOf(const Job& job);

/// Returns the id of a job. It depends on the contents of its files, the names of its logs (which the report shows),
/// its options and the version of the program, but not on the folders of the files.
std::string jobId(const Job& job, const std::vector<InputFile>& inputs, const std::string& version);

void to_json(nlohmann::ordered_json& json, const JobOptions& options);

/// Writes or reads a line of a manifest, which omits options and lists at their defaults. Reading throws
/// std::invalid_argument or nlohmann::json::exception.
void to_json(nlohmann::ordered_json& json, const Job& job);
void from_json(const nlohmann::json& json, Job& job);

struct Manifest {
  std::string version;  ///< version of the program that made the manifest
  std::vector<InputFile> inputs;
  std::vector<Job> jobs;

  /// Returns the indices of the jobs with distinct ids, in the order of the manifest: jobs with equal inputs and
  /// options run once and share the result.
  std::vector<std::size_t> distinctJobs() const;
};

/// Paths in the folder of a campaign.
inline std::string manifestPath(const std::string& folder) { return folder + "/manifest.jsonl"; }
std::string recordPath(const std::string& folder, const std::string& id);

/// Returns the folder of a job's reports, relative to that of the campaign.
std::string reportFolder(const std::string& id);

/// Writes JSON lines: a header with the numbers of inputs and jobs, the inputs, the jobs. Throws std::runtime_error.
void writeManifest(const Manifest& manifest, const std::string& folder);

/// Reads a manifest. Throws std::runtime_error that names the file, the line and what is accepted.
Manifest readManifest(const std::string& folder);

}  // namespace rubber_suspension::campaign
