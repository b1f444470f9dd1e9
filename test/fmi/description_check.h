// Rules of the standard for modelDescription.xml, including tables that a schema cannot express.
#pragma once

#include <string>
#include <vector>

#include "fmi/model_description.h"

namespace rubber_suspension::fmi::test {

/// Returns a line for each violation of a rule, so nothing for a valid description.
std::vector<std::string> brokenRules(const std::string& xml, Version version);

}  // namespace rubber_suspension::fmi::test
