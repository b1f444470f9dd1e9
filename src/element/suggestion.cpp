// Edit distance of two words, and the known word that is nearest to another one.
#include "element/suggestion.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace rubber_suspension::element {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool equal(char one, char other) { return lower(one) == lower(other); }

bool isSeparator(const std::string& text, std::size_t at) { return text[at] == '_' || text[at] == '-'; }

// Returns true if the name contains the part as a whole, between separators or ends of the name.
bool hasPart(const std::string& name, const std::string& part) {
  const std::size_t at = name.find(part);
  if (part.empty() || at == std::string::npos) {
    return false;
  }
  const std::size_t end = at + part.size();
  return (at == 0 || isSeparator(name, at - 1)) && (end == name.size() || isSeparator(name, end));
}

std::optional<std::string> nearestWithin(const std::string& word, const std::vector<std::string>& known) {
  std::optional<std::string> nearest;
  std::size_t least = 0;
  for (const std::string& name : known) {
    const std::size_t limit = std::min(word.size(), name.size()) / 3;
    const std::size_t difference = std::max(word.size(), name.size()) - std::min(word.size(), name.size());
    const std::size_t distance = difference > limit ? difference : editDistance(word, name);
    if (distance <= limit && distance < name.size() && (!nearest || distance < least)) {
      nearest = name;
      least = distance;
    }
  }
  return nearest;
}

const std::vector<std::pair<std::string, std::string>>& symbols() {
  static const std::vector<std::pair<std::string, std::string>> table = {{"m1", "kelvin_voigt"},
                                                                         {"m2", "maxwell"},
                                                                         {"m3", "maxwell_dashpot"},
                                                                         {"m4", "friction"},
                                                                         {"m5", "friction_dashpot"},
                                                                         {"m6", "berg"},
                                                                         {"kst", "static_stiffness"},
                                                                         {"kn", "dynamic_stiffness"},
                                                                         {"kdyn", "dynamic_stiffness"},
                                                                         {"kmax", "maximum_stiffness"},
                                                                         {"kh", "high_frequency_stiffness"},
                                                                         {"fn", "nominal_frequency"},
                                                                         {"fh", "high_frequency"},
                                                                         {"fl", "low_frequency"},
                                                                         {"an", "nominal_amplitude"},
                                                                         {"dn", "relative_damping"},
                                                                         {"delta", "loss_angle"},
                                                                         {"deltan", "loss_angle"},
                                                                         {"fb", "break_frequency"},
                                                                         {"nm", "maxwell_elements"}};
  return table;
}

std::optional<std::string> spelledOut(const std::string& word, const std::vector<std::string>& known) {
  std::string bare;
  for (const char c : word) {
    if (c != '_' && c != ' ') {
      bare += lower(c);
    }
  }
  for (const auto& [symbol, name] : symbols()) {
    if (symbol == bare && std::find(known.begin(), known.end(), name) != known.end()) {
      return name;
    }
  }
  return std::nullopt;
}

}  // namespace

std::size_t editDistance(const std::string& one, const std::string& other) {
  std::vector<std::size_t> before_last;
  std::vector<std::size_t> last;
  std::vector<std::size_t> row(other.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= one.size(); ++i) {
    before_last = std::move(last);
    last = row;
    row[0] = i;
    for (std::size_t j = 1; j <= other.size(); ++j) {
      const std::size_t changed = last[j - 1] + (equal(one[i - 1], other[j - 1]) ? 0 : 1);
      row[j] = std::min({changed, last[j] + 1, row[j - 1] + 1});
      if (i > 1 && j > 1 && equal(one[i - 1], other[j - 2]) && equal(one[i - 2], other[j - 1])) {
        row[j] = std::min(row[j], before_last[j - 2] + 1);
      }
    }
  }
  return row.back();
}

std::optional<std::string> nearestWord(const std::string& word, const std::vector<std::string>& known) {
  if (word.empty() || std::find(known.begin(), known.end(), word) != known.end()) {
    return std::nullopt;
  }
  if (auto name = spelledOut(word, known)) {
    return name;
  }
  if (auto nearest = nearestWithin(word, known)) {
    return nearest;
  }
  const auto has = [&](const std::string& name) { return hasPart(name, word); };
  const auto first = std::find_if(known.begin(), known.end(), has);
  const bool only = first != known.end() && std::find_if(first + 1, known.end(), has) == known.end();
  return only ? std::optional<std::string>(*first) : std::nullopt;
}

std::string didYouMean(const std::string& word, const std::vector<std::string>& known) {
  const std::optional<std::string> nearest = nearestWord(word, known);
  return nearest ? fmt::format(" (did you mean '{}'?)", *nearest) : "";
}

}  // namespace rubber_suspension::element
