// Executes one job in this process, by the same calls as its command.
#pragma once

#include <functional>
#include <string>

#include "campaign/make.h"
#include "campaign/manifest.h"
#include "campaign/record.h"

namespace rubber_suspension::campaign {

/// Returns a function that executes a job and writes its report and record. Errors of the job are stored in the record.
/// The function caches files, and throws if the computer lacks memory or disk space. The manifest must outlive the
/// function.
std::function<Record(const Job&)> executorOf(const std::string& folder, const Manifest& manifest,
                                             const LogReader& read_log);

}  // namespace rubber_suspension::campaign
