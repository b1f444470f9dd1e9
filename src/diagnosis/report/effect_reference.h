// The reference page of the effects that a diagnosis may name, written from the list that it searches.
#pragma once

#include <string>

namespace rubber_suspension::diagnosis::report {

/// Returns Markdown: every candidate effect, whether it belongs to the rubber or to the rig, its signature, and the
/// elements of its entries in a component file.
std::string effectReference();

}  // namespace rubber_suspension::diagnosis::report
