// Effects that the logs could have shown, on the report's page.
#pragma once

#include <string>

#include "rubber_suspension/diagnosis/could_show.h"

namespace rubber_suspension::diagnosis {

/// The tables, without a heading: what would be found of each effect, and what would be taken for what.
std::string couldShowHtml(const CouldShow& could_show);

/// "found", "taken for another", ...: an outcome for people.
std::string outcomeText(const std::string& outcome);

}  // namespace rubber_suspension::diagnosis
