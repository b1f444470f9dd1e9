// A report's note on effects that a temperature nobody recorded may look like.
#pragma once

#include <string>
#include <vector>

#include "fit/excitation.h"

namespace rubber_suspension::diagnosis {

/// A sentence for logs without a temperature that name softening or heating; empty for all others.
std::string temperatureNote(const std::vector<std::string>& effects, const fit::Excitation& excitation);

}  // namespace rubber_suspension::diagnosis
