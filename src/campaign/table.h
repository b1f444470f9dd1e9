// The results of a campaign as one table, in the order of the manifest.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "campaign/manifest.h"

namespace rubber_suspension::campaign {

struct Record;

struct CollectSummary {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t missing = 0;          ///< broken records among them
  std::vector<std::string> broken;  ///< what is wrong with those
};

/// Receives each job with its record, nullptr where it has none, in the order of the manifest.
using RowVisitor = std::function<void(const Job& job, const Record* record)>;

/// Write FOLDER/table.csv and FOLDER/table.json: the same bytes however the jobs were worked off, for nothing of time,
/// place or order of the work stands in them. A job without a result has a row nevertheless. Throws
/// std::runtime_error.
CollectSummary writeTables(const Manifest& manifest, const std::string& folder, const RowVisitor& visit);

std::string tableCsvPath(const std::string& folder);
std::string tableJsonPath(const std::string& folder);

}  // namespace rubber_suspension::campaign
