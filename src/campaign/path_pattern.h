// Files and folders that a pattern of the shell names.
#pragma once

#include <string>
#include <vector>

namespace rubber_suspension::campaign {

/// What `pattern` (*, ?, [...]) names, relative to `folder` unless it begins with a slash: absolute paths without
/// symbolic links resolved, sorted byte by byte, so that the order is that of no locale. Empty where nothing matches.
std::vector<std::string> matchPattern(const std::string& folder, const std::string& pattern);

}  // namespace rubber_suspension::campaign
