// What an action is refused with.
#pragma once

#include <string>

namespace rubber_suspension {

/// The message of the error of this type that an action throws; empty where it throws none.
template <class Error, class Action>
std::string messageOf(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

}  // namespace rubber_suspension
