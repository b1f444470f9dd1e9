// Look-up of a row of a table by the name that a user gave.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "element/suggestion.h"
#include "log/text.h"

namespace rubber_suspension::io {

/// Returns the row whose `name` is `key`. If there is none, throws std::invalid_argument with the key, the text
/// `otherwise` (such as "not a tolerance of a rig"), the most similar name and the accepted names.
template <class Row>
const Row& namedRow(const std::vector<Row>& table, const std::string& key, const std::string& otherwise) {
  const auto found = std::find_if(table.begin(), table.end(), [&](const Row& row) { return row.name == key; });
  if (found == table.end()) {
    const std::vector<std::string> names = element::namesOf(table);
    throw std::invalid_argument(fmt::format("{}: {}{}; accepted: {}", log::quoted(key), otherwise,
                                            element::didYouMean(key, names), log::join(names)));
  }
  return *found;
}

}  // namespace rubber_suspension::io
