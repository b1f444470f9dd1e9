// Limits of the nesting and size of a YAML text. They must be checked before the text is loaded.
#pragma once

#include <optional>
#include <string>

namespace rubber_suspension::io {

struct YamlProblem {
  int line;          ///< from 1
  std::string text;  ///< the problem and the accepted values
};

/// Returns the place where a text exceeds the largest depth or number of values, or nullopt. An alias (*name) counts as
/// many as the values of its anchor, because nested aliases multiply. Throws YAML::Exception if the text is not YAML.
std::optional<YamlProblem> beyondYamlBounds(const std::string& text);

/// Returns the line, counted from 1, at which a second document begins. Throws as beyondYamlBounds() does.
std::optional<int> lineOfSecondDocument(const std::string& text);

}  // namespace rubber_suspension::io
