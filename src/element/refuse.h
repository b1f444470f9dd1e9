// A check of an input and its error in one call.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace rubber_suspension::element {

/// Throws an error with a text formatted by fmt if `wrong` is true. The arguments are always evaluated.
template <class Error = std::invalid_argument, class... Arguments>
void refuseIf(bool wrong, fmt::format_string<Arguments...> text, Arguments&&... arguments) {
  if (wrong) {
    throw Error(fmt::format(text, std::forward<Arguments>(arguments)...));
  }
}

}  // namespace rubber_suspension::element
