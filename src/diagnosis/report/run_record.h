// Records version, date, command line and input files of a run, so that its report can be filed as a test record.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::report {

/// Returns the record of this run. `arguments` are the command line, which is quoted where a shell needs it. `files`
/// are pairs of an option and the path of its file. The date is the current time in UTC, or the environment variable
/// SOURCE_DATE_EPOCH [s since 1970], with which equal runs give equal reports. Throws std::runtime_error if a file
/// cannot be read or SOURCE_DATE_EPOCH is no whole number.
RunRecord makeRunRecord(const std::string& version, const std::vector<std::string>& arguments,
                        const std::vector<std::pair<std::string, std::string>>& files);

/// Returns the record of the run for programs, without the input files.
nlohmann::ordered_json metaJson(const RunRecord& run);

}  // namespace rubber_suspension::diagnosis::report
