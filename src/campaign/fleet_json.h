// What a fleet says, for programs.
#pragma once

#include <string>

#include "campaign/fleet.h"

namespace rubber_suspension::campaign {

std::string fleetJsonPath(const std::string& folder);

/// Schema rubber_suspension/fleet/1: types with verdicts, causes, parameters, components that stand out and verdicts
/// that the fleet changes; rigs. Values of parameters are logarithms of re-estimated over configured value. The same
/// bytes for the same results.
std::string toJson(const FleetFindings& fleet);

}  // namespace rubber_suspension::campaign
