// The fleet report: a page for people, without scripts or network.
#pragma once

#include <string>
#include <vector>

#include "campaign/fleet.h"
#include "campaign/table.h"

namespace rubber_suspension::campaign {

std::string fleetReportPath(const std::string& folder);

/// The page: causes, components that stand out, parameters with their scatter, verdicts that the fleet changes, links
/// to the reports of components, and what types on one rig share. The same bytes for the same results.
std::string fleetHtml(const FleetFindings& fleet, const CollectSummary& summary);

}  // namespace rubber_suspension::campaign
