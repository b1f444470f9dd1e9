// A check and its error in one call, for everything that refuses what it was given.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace rubber_suspension::element {

/// Throws an error with this text, in the form of fmt, where something is wrong. The arguments are evaluated in any
/// case.
template <class Error = std::invalid_argument, class... Arguments>
void refuseIf(bool wrong, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  if (wrong) {
    throw Error(fmt::format(text, std::forward<Arguments>(arguments)...));
  }
}

}  // namespace rubber_suspension::element
