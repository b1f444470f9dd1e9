// The word that a misspelt one was probably meant to be, for the errors of everything that has names.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace rubber_suspension::element {

/// The names of the rows of a table.
template <class Rows>
std::vector<std::string> namesOf(const Rows& rows) {
  std::vector<std::string> names;
  for (const auto& row : rows) {
    names.push_back(row.name);
  }
  return names;
}

/// Number of letters to change, add, omit or swap with their neighbour to turn one word into the other, regardless of
/// case (optimal string alignment).
std::size_t editDistance(const std::string& one, const std::string& other);

/// The known word that is nearest by editDistance(), at most one letter in three apart (of two letters only the case
/// may differ); else the only known one that has the word as a whole part, as "static_stiffness" has "static" and
/// "sampling-rate" has "rate". Returns nullopt if no word is near, or the word is known.
std::optional<std::string> nearestWord(const std::string& word, const std::vector<std::string>& known);

/// " (did you mean 'NAME'?)", to be put behind what is wrong; empty without a near word.
std::string didYouMean(const std::string& word, const std::vector<std::string>& known);

}  // namespace rubber_suspension::element
