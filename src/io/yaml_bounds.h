// Limits of the nesting and size of a YAML text, to be checked before it is loaded.
#pragma once

#include <optional>
#include <string>

namespace rubber_suspension::io {

struct YamlProblem {
  int line;          ///< from 1
  std::string text;  ///< with what is accepted
};

/// Where a text is nested deeper, or comes to hold more values, than any file of this package; each alias (*name)
/// counts as all that it stands for, as aliases of aliases multiply. Throws YAML::Exception where the text is not YAML.
std::optional<YamlProblem> beyondYamlBounds(const std::string& text);

/// The line, from 1, at which a second document begins. Throws as beyondYamlBounds() does.
std::optional<int> lineOfSecondDocument(const std::string& text);

}  // namespace rubber_suspension::io
