// Options that hold a quantity with its unit.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>

#include "apps/command.h"
#include "rubber_suspension/element/parameter.h"
#include "rubber_suspension/log/units.h"

namespace rubber_suspension::apps {

/// The value of a text such as "10 mm" in `unit`. Throws UsageError that names option, text and what is accepted.
inline double quantityOf(const std::string& option, const std::string& text, const std::string& unit,
                         const element::Range& range) {
  double value = 0.0;
  try {
    value = log::parseQuantity(text, unit);
  } catch (const std::invalid_argument& error) {
    throw UsageError(option + ": " + error.what());
  }
  if (!range.contains(value)) {
    throw UsageError(
        fmt::format("{}: '{}' is out of range; accepted: {} {}", option, text, element::describe(range), unit));
  }
  return value;
}

}  // namespace rubber_suspension::apps
