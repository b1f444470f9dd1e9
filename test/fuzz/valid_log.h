// The contract of all readers of logs: they return a valid log, or report an error in one line.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::fuzz {

/// Checks an error or a note, which is printed to a terminal: it must be one line without control characters.
inline void requireForTerminal(const std::string& text) {
  for (const unsigned char c : text) {
    if (c < 0x20 || c == 0x7F) {
      std::fprintf(stderr, "violated: a terminal may show it: %s\n", text.c_str());
      std::abort();
    }
  }
}

/// Calls a reader, and aborts if the reader violates the contract.
template <class Read>
void requireValidLogOrError(Read read) {
  try {
    const log::Log log = read();
    for (const std::string& note : log.notes) {
      requireForTerminal(note);
    }
    try {
      log::checkLog(log);
    } catch (const log::LogError& error) {
      std::fprintf(stderr, "violated: a log that was read is valid: %s\n", error.what());
      std::abort();
    }
  } catch (const log::LogError& error) {
    requireForTerminal(error.what());
  }
}

}  // namespace rubber_suspension::fuzz
