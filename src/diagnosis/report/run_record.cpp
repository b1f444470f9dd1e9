// The run that made a report.
#include "diagnosis/report/run_record.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <filesystem>
#include <stdexcept>

#include "io/sha256.h"
#include "log/text.h"

namespace rubber_suspension::diagnosis {
namespace {

std::time_t secondsSince1970() {
  const char* const fixed = std::getenv("SOURCE_DATE_EPOCH");
  if (fixed == nullptr || *fixed == '\0') {
    return std::time(nullptr);
  }
  constexpr long long kLast = 253402300799;  // the year 9999
  long long seconds = -1;
  const char* const end = fixed + std::strlen(fixed);
  const auto result = std::from_chars(fixed, end, seconds);
  if (result.ec != std::errc() || result.ptr != end || seconds < 0 || seconds > kLast) {
    throw std::runtime_error(
        fmt::format("SOURCE_DATE_EPOCH: {}; accepted: whole seconds since 1970, 0 to {}", log::quoted(fixed), kLast));
  }
  return static_cast<std::time_t>(seconds);
}

std::string isoDate(std::time_t seconds) {
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  return fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", utc.tm_year + 1900, utc.tm_mon + 1, utc.tm_mday,
                     utc.tm_hour, utc.tm_min, utc.tm_sec);
}

// As it can be typed again.
std::string shellQuoted(const std::string& argument) {
  const char* const plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!argument.empty() && argument.find_first_not_of(plain) == std::string::npos) {
    return argument;
  }
  std::string quoted = "'";
  for (const char c : argument) {
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return quoted + "'";
}

}  // namespace

RunRecord makeRunRecord(const std::string& version, const std::vector<std::string>& arguments,
                        const std::vector<std::pair<std::string, std::string>>& files) {
  RunRecord record;
  record.version = version;
  record.date = isoDate(secondsSince1970());
  for (const std::string& argument : arguments) {
    record.command_line += (record.command_line.empty() ? "" : " ") + shellQuoted(log::toUtf8(argument));
  }
  for (const auto& [option, path] : files) {
    record.files.push_back(
        {option, log::oneLine(std::filesystem::path(path).filename().string()), io::hashFile(path).sha256});
  }
  return record;
}

}  // namespace rubber_suspension::diagnosis
