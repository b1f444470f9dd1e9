// The fleet report: for programs, and as a page for people without scripts or network.
#pragma once

#include <string>
#include <vector>

#include "campaign/fleet.h"
#include "campaign/table.h"

namespace rubber_suspension::campaign {

std::string fleetJsonPath(const std::string& folder);
std::string fleetReportPath(const std::string& folder);

/// Schema rubber_suspension/fleet/2: types with verdicts, causes, parameters, components that stand out and verdicts
/// that the fleet changes; means by rig and type. Values of parameters are logarithms of re-estimated over configured
/// value. The same bytes for the same results.
std::string toJson(const FleetFindings& fleet);

/// The page: causes, components that stand out, parameters with their scatter, verdicts that the fleet changes, links
/// to the reports of components, and what types on one rig share. The same bytes for the same results.
std::string fleetHtml(const FleetFindings& fleet, const CollectSummary& summary);

}  // namespace rubber_suspension::campaign
