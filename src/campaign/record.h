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

/// Part of one job in the statistics of a fleet.
struct Findings {
  std::optional<diagnosis::Verdict> verdict;  ///< of diagnose
  std::vector<std::string> effects;           ///< that are named
  /// By parameter: logarithm of re-estimated over configured value.
  std::map<std::string, double> changes;
};

struct Record {
  std::string id;
  std::string version;                                               ///< of the program that worked the job off
  std::string error;                                                 ///< why it failed; empty: done
  nlohmann::ordered_json values = nlohmann::ordered_json::object();  ///< numbers and texts by name, for the table
  Findings findings{};
  std::map<std::string, io::FileHash> files{};  ///< of the report, by name
  double seconds = 0.0;                         ///< that the job took

  bool failed() const { return !error.empty(); }
};

/// Path of its report within the campaign's folder, preferably of the page; "" without a report.
std::string reportPath(const Record& record);

/// Writes it under a temporary name, syncs and renames it: it is there completely or not at all. The files that it
/// names have to be there already. A folder or pipe in its place is given another name (.no_record). Throws
/// std::runtime_error.
void writeRecord(const Record& record, const std::string& folder);

/// The entry in the place of a job's record; neither where there is none.
struct FoundRecord {
  std::optional<Record> record;  ///< of this job, and all files of its report are there
  std::string problem;  ///< of one that is cut off or changed, of another version or job, or with a damaged report
};

/// Comparison of the files of a report with the record: by size, which is fast, or by size and digest.
enum class FileCheck { sizes, digests };

/// Reads and checks a job's record.
FoundRecord findRecord(const std::string& folder, const std::string& id, const std::string& version, FileCheck check);

}  // namespace rubber_suspension::campaign
