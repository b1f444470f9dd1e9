// What is left of a campaign at its end: its results as one table, in the order of the manifest, and the fleet report.
#pragma once

#include <string>
#include <vector>

#include "campaign/fleet.h"
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

std::string fleetJsonPath(const std::string& folder);
std::string fleetReportPath(const std::string& folder);

/// The fleet report for programs: schema rubber_suspension/fleet/3: types with verdicts, effects, parameters and values
/// that are far out; parameters by rig and type. Values are logarithms of re-estimated over configured value. The same
/// bytes for the same results.
std::string toJson(const FleetFindings& fleet);

/// The fleet report as a page for people without scripts or network, with links to the reports of components. The same
/// bytes for the same results.
std::string fleetHtml(const FleetFindings& fleet, const CollectSummary& summary);

}  // namespace rubber_suspension::campaign
