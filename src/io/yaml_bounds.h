// Limits of the nesting and size of a YAML text, to be checked before it is loaded.
#pragma once

#include <optional>
#include <string>

namespace rubber_suspension::io {

struct YamlProblem {
  int line;          ///< from 1
  std::string text;  ///< with what is accepted
};

/// Returns where a text exceeds the depth or the number of values of any file of this package; an alias (*name) counts
/// as all values of its anchor, because nested aliases multiply. Throws YAML::Exception if the text is not YAML.
std::optional<YamlProblem> beyondYamlBounds(const std::string& text);

/// Returns the line, from 1, at which a second document begins. Throws as beyondYamlBounds() does.
std::optional<int> lineOfSecondDocument(const std::string& text);

}  // namespace rubber_suspension::io
