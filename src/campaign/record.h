// Files of a finished job: a record of its findings or its error, and the files of its report.
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
  std::optional<diagnosis::Verdict> verdict;  ///< only of a diagnosis
  std::vector<std::string> effects;           ///< named effects
  /// Logarithm of re-estimated over configured value, by parameter.
  std::map<std::string, double> changes;
};

struct Record {
  std::string id;
  std::string version;                                               ///< version of the program that ran the job
  std::string error;                                                 ///< reason of a failure; empty: done
  nlohmann::ordered_json values = nlohmann::ordered_json::object();  ///< numbers and texts by name, for the table
  Findings findings{};
  std::map<std::string, io::FileHash> files{};  ///< files of the report, by name
  double seconds = 0.0;                         ///< duration of the job [s]

  bool failed() const { return !error.empty(); }
};

/// Returns the path of the report in the campaign's folder, of the page if there is one; "" without a report.
std::string reportPath(const Record& record);

/// Writes a record under a temporary name, syncs and renames it, so that it exists completely or not at all. The files
/// of its report must already exist. A folder or pipe in its place is renamed to *.no_record. Throws
/// std::runtime_error.
void writeRecord(const Record& record, const std::string& folder);

/// Result of reading a job's record; both members are empty if there is none.
struct FoundRecord {
  std::optional<Record> record;  ///< record of this job, all files of whose report exist
  std::string problem;  ///< error of a record that is damaged, has a damaged report, or is of another version or job
};

/// Comparison of the files of a report with the record, by size, which is fast, or by size and digest.
enum class FileCheck { sizes, digests };

/// Reads and checks the record of a job.
FoundRecord findRecord(const std::string& folder, const std::string& id, const std::string& version, FileCheck check);

}  // namespace rubber_suspension::campaign
