// The manifest as JSON lines.
#include "campaign/manifest.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <unordered_set>

#include "campaign/job_json.h"
#include "log/new_file.h"

namespace rubber_suspension::campaign {
namespace {

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
    if (!std::getline(file_, line) || file_.eof()) {
      refuse("the file is cut off");
    }
    try {
      return nlohmann::json::parse(line);
    } catch (const nlohmann::json::exception&) {
      refuse("no JSON");
    }
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

InputFile inputFromJson(const nlohmann::json& json) {
  return {json.at("path").get<std::string>(), json.at("sha256").get<std::string>(),
          json.at("size").get<std::uint64_t>()};
}

bool isId(const std::string& id) {
  return id.size() == 64 && id.find_first_not_of("0123456789abcdef") == std::string::npos;
}

// Throws std::invalid_argument where a job names what is not there.
void checkJob(const Job& job, std::size_t inputs) {
  std::vector<std::size_t> files = {job.config};
  files.insert(files.end(), job.logs.begin(), job.logs.end());
  files.insert(files.end(), job.hold_out.begin(), job.hold_out.end());
  for (const std::size_t file : files) {
    if (file >= inputs) {
      throw std::invalid_argument(fmt::format("input {} is not among the {} inputs", file, inputs));
    }
  }
  if (!isId(job.id) || job.logs.empty()) {
    throw std::invalid_argument("a job without id or logs");
  }
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
  const std::string path = manifestPath(folder);
  log::NewFile file(path);
  std::ofstream stream(file.writingPath(), std::ios::binary);
  stream << nlohmann::ordered_json({{"schema", kManifestSchema},
                                    {"version", manifest.version},
                                    {"inputs", manifest.inputs.size()},
                                    {"jobs", manifest.jobs.size()}})
         << '\n';
  for (const InputFile& input : manifest.inputs) {
    stream << nlohmann::ordered_json({{"path", input.path}, {"sha256", input.sha256}, {"size", input.size}}) << '\n';
  }
  for (const Job& job : manifest.jobs) {
    stream << jobJson(job) << '\n';
  }
  stream.close();
  if (!stream) {
    throw std::runtime_error(path + ": cannot be written: " + std::strerror(errno));
  }
  file.commit();
}

Manifest readManifest(const std::string& folder) {
  LineReader lines(manifestPath(folder));
  Manifest manifest;
  try {
    const nlohmann::json header = lines.next();
    if (header.at("schema") != kManifestSchema) {
      lines.refuse("another schema");
    }
    manifest.version = header.at("version").get<std::string>();
    const auto inputs = header.at("inputs").get<std::size_t>();
    for (std::size_t i = 0; i < inputs; ++i) {
      manifest.inputs.push_back(inputFromJson(lines.next()));
    }
    const auto jobs = header.at("jobs").get<std::size_t>();
    for (std::size_t i = 0; i < jobs; ++i) {
      manifest.jobs.push_back(jobFromJson(lines.next()));
      checkJob(manifest.jobs.back(), inputs);
    }
  } catch (const nlohmann::json::exception& error) {
    lines.refuse(error.what());
  } catch (const std::invalid_argument& error) {
    lines.refuse(error.what());
  }
  return manifest;
}

}  // namespace rubber_suspension::campaign
