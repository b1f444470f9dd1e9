// Writes the reference page of the effects that a diagnosis may name, from the list of candidates.
#pragma once

#include <string>

namespace rubber_suspension::diagnosis::report {

/// Returns a page in Markdown: every candidate effect, whether it belongs to the rubber or to the rig, its signature,
/// and the elements that its entries in a component file have.
std::string effectReference();

}  // namespace rubber_suspension::diagnosis::report
