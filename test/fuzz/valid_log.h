// What every reader of logs owes: a valid log, or one line of error.
#pragma once

#include <cstdio>
#include <cstdlib>
#include <string>

#include "rubber_suspension/log/log.h"

namespace rubber_suspension::fuzz {

/// Call a reader; aborts where it breaks its promise.
template <class Read>
void requireValidLogOrError(Read read) {
  try {
    const log::Log log = read();
    try {
      log::checkLog(log);
    } catch (const log::LogError& error) {
      std::fprintf(stderr, "violated: a log that was read is valid: %s\n", error.what());
      std::abort();
    }
  } catch (const log::LogError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) {
      std::fprintf(stderr, "violated: an error is one line: %s\n", error.what());
      std::abort();
    }
  }
}

}  // namespace rubber_suspension::fuzz
