// Rules that determine which existing files a command or a launch file may replace.
#include "io/output_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "element/refuse.h"
#include "log/new_file.h"

namespace rubber_suspension::io {
namespace {

namespace fs = std::filesystem;
using element::refuseIf;

// Returns true if both paths lead to one file. Existing files are compared by identity. Other names are compared
// without case, because some file systems do not distinguish upper from lower case.
bool areOneFile(const std::string& one, const std::string& other) {
  std::error_code ignored;
  return fs::exists(one, ignored) || fs::exists(other, ignored)
             ? fs::equivalent(one, other, ignored)
             : log::lowerCase(log::followedPath(one)) == log::lowerCase(log::followedPath(other));
}

void refuseInput(const OutputFile& output, const std::vector<InputFile>& inputs) {
  for (const InputFile& input : inputs) {
    refuseIf<OutputRefused>(!input.path.empty() && areOneFile(output.path, input.path),
                            "{}: {} is also the input file of {}{}; accepted: another file", output.option, output.path,
                            input.option, output.path == input.path ? "" : ", " + input.path);
  }
}

void refuseTwin(const OutputFile& output, const OutputFile& other) {
  refuseIf<OutputRefused>(!other.path.empty() && !log::isStream(other.path) && areOneFile(output.path, other.path),
                          "{} and {}: both write {}{}; accepted: a separate file for each", output.option, other.option,
                          output.path, output.path == other.path ? "" : ", the same file as " + other.path);
}

void refusePlace(const OutputFile& output) {
  std::error_code ignored;
  refuseIf<OutputRefused>(fs::is_directory(output.path, ignored), "{}: {} is a folder; accepted: a file", output.option,
                          output.path);
  const fs::path parent = fs::path(log::followedPath(output.path)).parent_path();
  refuseIf<OutputRefused>(fs::exists(parent, ignored) && !fs::is_directory(parent, ignored),
                          "{}: {} is not a folder; accepted: a folder", output.option, parent.string());
}

void refuseOtherKind(const OutputFile& output) {
  std::error_code missing;
  const bool holds_something = fs::file_size(output.path, missing) > 0 && !missing;
  refuseIf<OutputRefused>(holds_something && !isOfKind(output.path, output.kind),
                          "{}: {} exists and is not {}; accepted: another name, or --force to replace it",
                          output.option, output.path, output.kind.name);
}

// Returns true if the folder contains one of the records, or a temporary file that will become a record.
bool holdsRecord(const fs::path& folder, const std::vector<std::string>& records) {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    const std::string name = entry.path().filename().string();
    for (const std::string& record : records) {
      if (name == record || log::startsWith(name, "." + fs::path(record).stem().string() + ".")) {
        return true;
      }
    }
  }
  return false;
}

// Splits a name such as "run_1" into "run_" and 1. A name without a number, such as "bush", yields "bush_" and 1.
std::pair<std::string, unsigned long> numberedName(const std::string& folder) {
  constexpr std::size_t kMostDigits = 9;
  const std::size_t bar = folder.find_last_of('_');
  const std::string digits = bar == std::string::npos ? "" : folder.substr(bar + 1);
  const bool numbered =
      !digits.empty() && digits.size() <= kMostDigits && digits.find_first_not_of("0123456789") == std::string::npos;
  return numbered ? std::pair(folder.substr(0, bar + 1), std::stoul(digits)) : std::pair(folder + "_", 1UL);
}

// Returns true for regular files with the same content. A pipe is not compared, because it can be read only once.
bool isCopy(const std::string& one, const std::string& other) {
  std::error_code error;
  if (!fs::is_regular_file(one, error) || !fs::is_regular_file(other, error) ||
      fs::file_size(one, error) != fs::file_size(other, error) || error) {
    return false;
  }
  std::ifstream first(one, std::ios::binary);
  std::ifstream second(other, std::ios::binary);
  return first && second &&
         std::equal(std::istreambuf_iterator<char>(first), std::istreambuf_iterator<char>(),
                    std::istreambuf_iterator<char>(second));
}

// Returns true if any of the texts fulfils the condition, or if there are no texts.
template <std::size_t most, class Condition>
bool fulfilled(const std::array<std::string_view, most>& texts, const Condition& condition) {
  return texts[0].empty() || std::any_of(texts.begin(), texts.end(),
                                         [&](std::string_view text) { return !text.empty() && condition(text); });
}

}  // namespace

bool isOfKind(const std::string& path, const FileKind& kind) {
  constexpr std::size_t kHead = 64 * 1024;  // a component file may begin with a long comment
  std::ifstream file(path, std::ios::binary);
  std::string head(kHead, '\0');
  file.read(head.data(), kHead);
  head.resize(static_cast<std::size_t>(file.gcount()));
  return fulfilled(kind.beginnings, [&](std::string_view text) { return log::startsWith(head, text); }) &&
         fulfilled(kind.parts, [lines = "\n" + head](std::string_view text) { return lines.find(text) != lines.npos; });
}

void checkOutputs(const std::vector<InputFile>& inputs, const std::vector<OutputFile>& outputs, bool force) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].path.empty() || log::isStream(outputs[i].path)) {
      continue;
    }
    refuseInput(outputs[i], inputs);
    for (std::size_t j = 0; j < i; ++j) {
      refuseTwin(outputs[i], outputs[j]);
    }
    refusePlace(outputs[i]);
    if (!force) {
      refuseOtherKind(outputs[i]);
    }
  }
}

void refuseEqualLogs(const std::vector<InputFile>& logs) {
  for (std::size_t i = 0; i < logs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code ignored;
      const bool same = fs::equivalent(logs[i].path, logs[j].path, ignored);
      refuseIf<OutputRefused>(same || isCopy(logs[i].path, logs[j].path),
                              "{}: {} is {} as {} {}; accepted: each log only once", logs[i].option, logs[i].path,
                              same ? "the same file" : "byte by byte the same", logs[j].option, logs[j].path);
    }
  }
}

bool makeFolder(const std::string& folder) {
  std::error_code error;
  const bool made = fs::create_directories(folder, error);
  refuseIf<std::runtime_error>(static_cast<bool>(error), "{}: cannot be created: {}", folder, error.message());
  return made;
}

std::string makeRunFolder(const std::string& folder, const std::vector<std::string>& records) {
  std::string base = (fs::path(folder) / "").parent_path().string();  // without a slash at the end
  makeFolder(base);
  if (!holdsRecord(base, records)) {
    return base;
  }
  const auto [name, number] = numberedName(base);
  for (unsigned long next = number + 1;; ++next) {
    std::string path = name + std::to_string(next);
    std::error_code error;
    if (fs::create_directory(path, error) || (!error && !holdsRecord(path, records))) {  // one run alone can create it
      return path;
    }
    refuseIf<std::runtime_error>(error && error != std::errc::file_exists, "{}: cannot be created: {}", path,
                                 error.message());
  }
}

}  // namespace rubber_suspension::io
