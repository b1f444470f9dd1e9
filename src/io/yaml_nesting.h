// How deep a YAML text may be nested: to be asked before it is parsed.
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

}  // namespace rubber_suspension::io
