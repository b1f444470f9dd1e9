// Functions for tests that read logs from texts, return refusals, and apply the options that errors advise.
#pragma once

#include "rubber_suspension/log/log.h"
#include "support/scratch_folder.h"
#include "support/test.h"

namespace rubber_suspension {

/// Returns the log that a text contains. The text may be the bytes of a file of any format.
inline log::Log readText(const std::string& text, const log::LogFormat& format = {},
                         const std::string& name = "log.csv") {
  const TemporaryFile file(name, text);
  return log::readLog(file.path(), format);
}

/// Returns the reason why a text is refused, or an empty string if it is accepted.
inline std::string refusalOf(const std::string& text, const log::LogFormat& format = {},
                             const std::string& name = "log.csv") {
  return messageOf<log::LogError>([&] { readText(text, format, name); });
}

inline log::LogFormat byColumns(const std::vector<std::string>& columns, const std::string& units = "",
                                double rate = 0.0) {
  return log::makeLogFormat(columns, units, rate);
}

/// Returns the format that one option with this value gives.
inline log::LogFormat byOption(const std::string& option, const std::string& value) {
  const auto given = [&](const char* name) { return option == name ? value : std::string(); };
  return log::makeLogFormat({}, given("--unit"), option == "--sampling-rate" ? std::stod(value) : 0.0,
                            given("--decimal"), given("--segment"), option == "--bridge" ? std::stod(value) : -1.0,
                            given("--sentinel"));
}

/// Returns the format that one option gives if it has the value that an error advises.
inline log::LogFormat advised(const std::string& error, const std::string& option) {
  const std::size_t at = error.find(option + " ");
  EXPECT_NE(at, std::string::npos) << error;
  const std::string rest = at == std::string::npos ? "0" : error.substr(at + option.size() + 1);
  return byOption(option, rest.substr(0, rest.find_first_of(option == "--decimal" ? " ;" : " ,;")));
}

}  // namespace rubber_suspension
