// The rules of the standard for modelDescription.xml, those of its tables that a schema cannot say among them.
#pragma once

#include <string>
#include <vector>

#include "fmi/model_description.h"

namespace rubber_suspension::fmi::test {

/// What breaks a rule, one line each; empty where all is well.
std::vector<std::string> brokenRules(const std::string& xml, Version version);

}  // namespace rubber_suspension::fmi::test
