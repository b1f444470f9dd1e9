// The run that made a report: version, date, command line and the files read, so that it can be filed as a test record.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// Returns the record of this run. `arguments`: the command line, which is quoted where a shell needs it; `files`: the
/// option that names each, and its path. The date is now in UTC, or that of the environment's SOURCE_DATE_EPOCH [s
/// since 1970], with which the same run gives the same report to the byte. Throws std::runtime_error for a file that
/// cannot be read, and for a SOURCE_DATE_EPOCH that is no whole number.
RunRecord makeRunRecord(const std::string& version, const std::vector<std::string>& arguments,
                        const std::vector<std::pair<std::string, std::string>>& files);

/// Returns the record of the run for programs, without the files that were read.
nlohmann::ordered_json metaJson(const RunRecord& run);

}  // namespace rubber_suspension::diagnosis::report
