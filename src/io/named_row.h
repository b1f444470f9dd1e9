// The row of a table that a user named.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "element/suggestion.h"
#include "log/text.h"

namespace rubber_suspension::io {

/// The row with this `name`. Throws std::invalid_argument that says what it is not ("no tolerance of a rig"), what was
/// probably meant, and what is accepted.
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
