// Parts of the reports for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis {

/// Effects that the logs could have shown. Sizes as shares of the force's standard deviation; a size that no effect of
/// all of the force reaches is null.
nlohmann::ordered_json toJson(const CouldShow& could_show);

/// The program that made a report, without the files that it read.
nlohmann::ordered_json metaJson(const RunRecord& run);

}  // namespace rubber_suspension::diagnosis
