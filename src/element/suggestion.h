// The known word that a misspelt word probably means, for error messages.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::element {

template <class Rows>
std::vector<std::string> namesOf(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    names.push_back(row.name);
  }
  return names;
}

/// Returns the number of letters to change, add, omit or swap with their neighbour to turn one word into the other
/// (optimal string alignment). Case is ignored.
std::size_t editDistance(const std::string& one, const std::string& other);

/// Returns the known word that is probably meant: the name for a symbol of the literature, or else the known word
/// nearest by editDistance(), if at most one letter in three is wrong, or else the only known word that contains `word`
/// as a whole part, as "static_stiffness" contains "static". Returns nullopt if there is none or `word` itself is
/// known.
std::optional<std::string> nearestWord(const std::string& word, const std::vector<std::string>& known);

/// Returns " (did you mean 'NAME'?)" to append to an error message, or an empty text if nearestWord() returns nullopt.
std::string didYouMean(const std::string& word, const std::vector<std::string>& known);

}  // namespace rubber_suspension::element
