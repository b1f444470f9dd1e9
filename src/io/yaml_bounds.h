// How deep a YAML text may be nested, and how much it may hold: to be asked before it is loaded.
#pragma once

#include <optional>
#include <string>

namespace rubber_suspension::io {

/// The line, from 1, at which a text is nested deeper than any file of this package; nothing where it never is. The
/// parser is recursive, and not every version of it bounds its depth. Brackets in quotes or comments count, too, which
/// no real file notices.
std::optional<int> lineNestedTooDeep(const std::string& text);

/// The problem, with what is accepted.
std::string acceptedNesting();

/// The line, from 1, at which the first document of a text comes to hold more values than any file of this package,
/// where each alias (*name) counts as all that it stands for: aliases of aliases multiply. Nothing where it never does.
/// Throws YAML::Exception where the text is not YAML.
std::optional<int> lineExpandedTooFar(const std::string& text);

/// The problem, with what is accepted.
std::string acceptedExpansion();

}  // namespace rubber_suspension::io
