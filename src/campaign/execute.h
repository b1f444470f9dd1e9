// Works off one job in this process, by the same calls as the command that it stands for.
#pragma once

#include <functional>
#include <string>

#include "campaign/make.h"
#include "campaign/manifest.h"
#include "campaign/record.h"

namespace rubber_suspension::campaign {

/// Works a job off and writes its report and its record; a failure is the record's error. It keeps the files that
/// it read last. The manifest has to live as long. Throws std::runtime_error where no record can be written.
std::function<Record(const Job&)> executorOf(const std::string& folder, const Manifest& manifest,
                                             const LogReader& read_log);

}  // namespace rubber_suspension::campaign
