// The fleet report: for programs, and as a page for people without scripts or network.
#pragma once

#include <string>

#include "campaign/collect.h"
#include "campaign/fleet.h"

namespace rubber_suspension::campaign {

std::string fleetJsonPath(const std::string& folder);
std::string fleetReportPath(const std::string& folder);

/// Schema rubber_suspension/fleet/3: types with verdicts, effects, parameters and values that are far out; parameters
/// by rig and type. Values are logarithms of re-estimated over configured value. The same bytes for the same results.
std::string toJson(const FleetFindings& fleet);

/// The page, with links to the reports of components. The same bytes for the same results.
std::string fleetHtml(const FleetFindings& fleet, const CollectSummary& summary);

}  // namespace rubber_suspension::campaign
