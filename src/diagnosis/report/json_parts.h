// Parts of the reports for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Effects that the logs could have shown. Sizes as shares of the force's standard deviation; a size that no effect of
/// all of the force reaches is null.
nlohmann::ordered_json toJson(const CouldShow& could_show);

/// A table that was diagnosed, and its rows.
nlohmann::ordered_json tableJson(const DiagnosedTable& table);

}  // namespace rubber_suspension::diagnosis
