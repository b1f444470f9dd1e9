// What runs at the moment. None of it decides anything: it is for people who ask, and may be deleted.
#include "campaign/heartbeat.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

namespace rubber_suspension::campaign {
namespace {

namespace fs = std::filesystem;

constexpr auto kPause = std::chrono::seconds(5);

std::string folderOf(const std::string& folder) { return folder + "/running"; }

std::string hostName() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "host";
}

// The present of the file system, whose clock may be that of another machine.
fs::file_time_type nowThere(const std::string& folder) {
  const std::string probe = fmt::format("{}/.now.{}", folder, getpid());
  std::ofstream(probe) << '\n';
  std::error_code failure;
  const fs::file_time_type now = fs::last_write_time(probe, failure);
  const fs::file_time_type result = failure ? fs::file_time_type::clock::now() : now;
  fs::remove(probe, failure);
  return result;
}

}  // namespace

Heartbeat::Heartbeat(const std::string& folder)
    : path_(fmt::format("{}/{}.{}", folderOf(folder), hostName(), getpid())) {
  std::error_code ignored;
  fs::create_directories(folderOf(folder), ignored);
}

Heartbeat::~Heartbeat() {
  std::error_code ignored;
  fs::remove(path_, ignored);
}

void Heartbeat::beat(const Manifest& manifest, const std::vector<std::size_t>& running) {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < kPause) {
    return;
  }
  last_ = now;
  const std::string beside = path_ + ".new";
  std::ofstream file(beside);
  for (const std::size_t job : running) {
    file << manifest.jobs[job].id << '\n';
  }
  file.close();
  std::rename(beside.c_str(), path_.c_str());
}

std::vector<RunningRun> findRuns(const std::string& folder) {
  std::vector<RunningRun> runs;
  std::error_code failure;
  if (!fs::is_directory(folderOf(folder), failure)) {
    return runs;
  }
  const fs::file_time_type now = nowThere(folderOf(folder));
  for (const auto& entry : fs::directory_iterator(folderOf(folder), failure)) {
    const std::string name = entry.path().filename().string();
    const fs::file_time_type beat = entry.last_write_time(failure);
    if (failure || name.front() == '.' || entry.path().extension() == ".new") {
      continue;
    }
    RunningRun run{name, {}, std::chrono::duration<double>(now - beat).count()};
    std::ifstream file(entry.path());
    for (std::string id; file >> id;) {
      run.ids.push_back(id);
    }
    runs.push_back(run);
  }
  std::sort(runs.begin(), runs.end(), [](const RunningRun& a, const RunningRun& b) { return a.where < b.where; });
  return runs;
}

}  // namespace rubber_suspension::campaign
