// Effects that the logs could have shown, for programs.
#pragma once

#include <nlohmann/json.hpp>

#include "rubber_suspension/diagnosis/could_show.h"

namespace rubber_suspension::diagnosis {

/// Sizes as shares of the force's standard deviation; a size that no effect of all of the force reaches is null.
nlohmann::ordered_json toJson(const CouldShow& could_show);

}  // namespace rubber_suspension::diagnosis
