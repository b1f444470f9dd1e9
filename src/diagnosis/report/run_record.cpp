// Records the run that made a report.
#include "diagnosis/report/run_record.h"

#include <fmt/chrono.h>

#include <boost/algorithm/string/replace.hpp>
#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "element/each.h"
#include "element/refuse.h"
#include "io/sha256.h"
#include "log/text.h"

namespace rubber_suspension::diagnosis::report {
namespace {

std::time_t secondsSince1970() {
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  if (fixed == nullptr || *fixed == '\0') {
    return std::time(nullptr);
  }
  constexpr long long kLast = 253402300799;  // the end of the year 9999
  long long seconds = -1;
  const char* const end = fixed + std::strlen(fixed);
  const auto result = std::from_chars(fixed, end, seconds);
  element::refuseIf<std::runtime_error>(result.ec != std::errc() || result.ptr != end || seconds < 0 || seconds > kLast,
                                        "SOURCE_DATE_EPOCH: {}; accepted: whole seconds since 1970, 0 to {}",
                                        log::quoted(fixed), kLast);
  return static_cast<std::time_t>(seconds);
}

std::string shellQuoted(const std::string& argument) {
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) {
    return argument;
  }
  return "'" + boost::replace_all_copy(argument, "'", "'\\''") + "'";
}

}  // namespace

RunRecord makeRunRecord(const std::string& version, const std::vector<std::string>& arguments,
                        const std::vector<std::pair<std::string, std::string>>& files) {
  RunRecord record;
  record.version = version;
  record.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(secondsSince1970()));
  record.command_line = element::joined(arguments, " ", [](const auto& one) { return shellQuoted(log::toUtf8(one)); });
  record.files = element::each(files, [](const auto& file) -> InputFile {
    const auto& [option, path] = file;
    return {option, log::oneLine(std::filesystem::path(path).filename().string()), io::hashFile(path).sha256};
  });
  return record;
}

nlohmann::ordered_json metaJson(const RunRecord& run) {
  return {{"version", run.version}, {"date", run.date}, {"command_line", run.command_line}};
}

}  // namespace rubber_suspension::diagnosis::report
