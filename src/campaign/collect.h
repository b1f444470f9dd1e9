// What is left of a campaign at its end: its table and what its fleet says.
#pragma once

#include <string>

#include "campaign/manifest.h"
#include "campaign/table.h"

namespace rubber_suspension::campaign {

/// Write the tables, and fleet.json and fleet.html beside them. Throws std::runtime_error.
CollectSummary collect(const Manifest& manifest, const std::string& folder);

}  // namespace rubber_suspension::campaign
