// Executes one job in this process, by the same calls as its command.
#pragma once

#include <functional>
#include <string>

#include "campaign/make.h"
#include "campaign/manifest.h"
#include "campaign/record.h"

namespace rubber_suspension::campaign {

/// Returns a function that executes a job and writes its report and record; a failure is the record's error. It caches
/// the files read last. The manifest has to outlive it. Throws std::runtime_error where no record can be written.
std::function<Record(const Job&)> executorOf(const std::string& folder, const Manifest& manifest,
                                             const LogReader& read_log);

}  // namespace rubber_suspension::campaign
