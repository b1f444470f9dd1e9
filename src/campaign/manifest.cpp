// The manifest as JSON lines.
#include "campaign/manifest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <unordered_set>

#include "element/refuse.h"
#include "io/line_file.h"

namespace rubber_suspension::campaign {
namespace {

using nlohmann::ordered_json;

const char* const kManifestSchema = "rubber_suspension/campaign/1";

// Two letters of the id make a folder each, so that none holds more than some hundred entries.
constexpr std::size_t kPrefix = 2;

std::string split(const std::string& id) { return id.substr(0, kPrefix) + "/" + id.substr(kPrefix); }

class LineReader {
 public:
  explicit LineReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!file_) {
      throw std::runtime_error(fmt::format("{}: cannot be read: {}; accepted: a folder that `campaign make` made", path,
                                           std::strerror(errno)));
    }
  }

  nlohmann::json next() {
    ++number_;
    std::string line;
    element::refuseIf(!std::getline(file_, line) || file_.eof(), "the file is cut off");
    return nlohmann::json::parse(line);
  }

  [[noreturn]] void refuse(const std::string& problem) const {
    throw std::runtime_error(
        fmt::format("{}:{}: {}; accepted: a manifest as `campaign make` writes it", path_, number_, problem));
  }

 private:
  std::string path_;
  std::ifstream file_;
  std::size_t number_ = 0;
};

bool isId(const std::string& id) {
  return id.size() == 64 && id.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// Throws std::invalid_argument where a job names what is not there.
void checkJob(const Job& job, std::size_t inputs) {
  std::vector<std::size_t> files = job.logs;
  files.insert(files.end(), job.hold_out.begin(), job.hold_out.end());
  files.push_back(job.config);
  const std::size_t last = *std::max_element(files.begin(), files.end());
  element::refuseIf(last >= inputs, "input {} is not among the {} inputs", last, inputs);
  element::refuseIf(!isId(job.id) || job.logs.empty(), "a job without id or logs");
}

Manifest readLines(LineReader& lines) {
  Manifest manifest;
  const nlohmann::json header = lines.next();
  element::refuseIf(header.at("schema") != kManifestSchema, "another schema");
  header.at("version").get_to(manifest.version);
  const auto inputs = header.at("inputs").get<std::size_t>();
  for (std::size_t i = 0; i < inputs; ++i) {
    const nlohmann::json line = lines.next();
    manifest.inputs.push_back({line.at("path"), line.at("sha256"), line.at("size")});
  }
  const auto jobs = header.at("jobs").get<std::size_t>();
  for (std::size_t i = 0; i < jobs; ++i) {
    manifest.jobs.push_back(jobFromJson(lines.next()));
    checkJob(manifest.jobs.back(), inputs);
  }
  return manifest;
}

}  // namespace

std::vector<std::size_t> Manifest::distinctJobs() const {
  std::unordered_set<std::string_view> seen;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (seen.insert(jobs[i].id).second) {
      result.push_back(i);
    }
  }
  return result;
}

std::string manifestPath(const std::string& folder) { return folder + "/manifest.jsonl"; }

std::string recordPath(const std::string& folder, const std::string& id) {
  return folder + "/results/" + split(id) + ".json";
}

std::string reportFolder(const std::string& id) { return "reports/" + split(id); }

void writeManifest(const Manifest& manifest, const std::string& folder) {
  io::LineFile file(manifestPath(folder));
  file.line(ordered_json({{"schema", kManifestSchema},
                          {"version", manifest.version},
                          {"inputs", manifest.inputs.size()},
                          {"jobs", manifest.jobs.size()}})
                .dump());
  for (const InputFile& input : manifest.inputs) {
    file.line(ordered_json({{"path", input.path}, {"sha256", input.sha256}, {"size", input.size}}).dump());
  }
  for (const Job& job : manifest.jobs) {
    file.line(jobJson(job).dump());
  }
  file.close();
}

Manifest readManifest(const std::string& folder) {
  LineReader lines(manifestPath(folder));
  try {
    return readLines(lines);
  } catch (const nlohmann::json::exception& error) {
    lines.refuse(error.what());
  } catch (const std::invalid_argument& error) {
    lines.refuse(error.what());
  }
}

}  // namespace rubber_suspension::campaign
