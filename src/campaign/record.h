// Writes and reads the record of a finished job, which contains its findings or its error.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/sha256.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::campaign {

/// Contribution of one job to the statistics of a fleet.
struct Findings {
  std::optional<diagnosis::Verdict> verdict;  ///< only set by a diagnosis
  std::vector<std::string> effects;           ///< named effects
  /// Logarithm of the ratio of the re-estimated to the configured value of each parameter.
  std::map<std::string, double> changes;
};

struct Record {
  std::string id;
  std::string version;                                               ///< version of the program that ran the job
  std::string error;                                                 ///< reason of a failure; empty if the job is done
  nlohmann::ordered_json values = nlohmann::ordered_json::object();  ///< numbers and texts for the table, by name
  Findings findings{};
  std::map<std::string, io::FileHash> files{};  ///< hashes of the files of the report, by name
  double seconds = 0.0;                         ///< duration of the job [s]

  bool failed() const { return !error.empty(); }
};

/// Returns the path of the report (its page, if there is one) in the folder of the campaign, or "" without a report.
std::string reportPath(const Record& record);

/// Writes a record under a temporary name, syncs it and renames it, so that it is never incomplete. The files of the
/// report must exist already. A folder or pipe of the same name is renamed to *.no_record. Throws std::runtime_error.
void writeRecord(const Record& record, const std::string& folder);

/// Result of searching the record of a job. Both members are empty if there is no record.
struct FoundRecord {
  std::optional<Record> record;  ///< record of this job whose report is complete
  /// Error of a record that is damaged, has a damaged report, or belongs to another version or job.
  std::string problem;
};

/// States whether the files of a report are compared with the record by size only, which is fast, or also by digest.
enum class FileCheck { sizes, digests };

/// Reads and checks the record of a job.
FoundRecord findRecord(const std::string& folder, const std::string& id, const std::string& version, FileCheck check);

}  // namespace rubber_suspension::campaign
