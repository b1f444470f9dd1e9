// What is left of a campaign at its end: its results as one table, in the order of the manifest, and the fleet report.
#pragma once

#include <string>
#include <vector>

#include "campaign/manifest.h"

namespace rubber_suspension::campaign {

struct CollectSummary {
  std::size_t done = 0;
  std::size_t failed = 0;
  std::size_t missing = 0;          ///< broken records among them
  std::vector<std::string> broken;  ///< what is wrong with those
};

/// Write table.csv, table.json, fleet.json and fleet.html: the same bytes however the jobs were worked off, for nothing
/// of time, place or order of the work stands in them. A job without a result has a row nevertheless. Throws
/// std::runtime_error.
CollectSummary collect(const Manifest& manifest, const std::string& folder);

std::string tableCsvPath(const std::string& folder);
std::string tableJsonPath(const std::string& folder);

}  // namespace rubber_suspension::campaign
