// Runs a campaign as a job array of Slurm, with the commands of Slurm.
#include "campaign/slurm.h"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "element/refuse.h"
#include "io/output_files.h"
#include "log/new_file.h"
#include "log/text.h"

namespace rubber_suspension::campaign {
namespace {

namespace fs = std::filesystem;

// Quotes a text as one word for a shell.
std::string shellWord(const std::string& text) { return "'" + boost::replace_all_copy(text, "'", "'\\''") + "'"; }

std::string absolutePath(const std::string& folder) { return fs::absolute(folder).lexically_normal().string(); }

struct Said {
  int status = 0;
  std::string text;  // stdout and stderr
};

Said ask(const std::string& command) {
  std::FILE* const pipe = popen((command + " 2>&1").c_str(), "re");
  element::refuseIf<std::runtime_error>(pipe == nullptr, "{}: the command cannot be run", command);
  Said said;
  std::array<char, 4096> piece{};
  while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), pipe)) {
    said.text.append(piece.data(), count);
  }
  const int status = pclose(pipe);
  said.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  boost::trim_right(said.text);
  return said;
}

// Returns the leading digits, which may be none.
std::string numberIn(const std::string& text) { return text.substr(0, text.find_first_not_of("0123456789")); }

// Returns the path of the file with the number of the array that was submitted last from this folder.
std::string submittedPath(const std::string& folder) { return folder + "/slurm/submitted"; }

void refuseSecond(const std::string& folder) {
  std::string array;
  std::ifstream(submittedPath(folder)) >> array;
  array = numberIn(array);
  if (array.empty()) {
    return;
  }
  const Said said = ask("squeue --noheader --states=all --format=%T --jobs=" + array);
  element::refuseIf<std::runtime_error>(said.status != 0 && said.text.find("Invalid job id") == std::string::npos,
                                        "squeue: {}", said.text);
  for (const char* state : {"PENDING", "RUNNING", "COMPLETING", "CONFIGURING", "REQUEUE", "SUSPENDED"}) {
    element::refuseIf<std::runtime_error>(said.status == 0 && said.text.find(state) != std::string::npos,
                                          "{}: job array {} of this campaign is still {}; accepted: submit again after "
                                          "it has ended (squeue --jobs={}) or after scancel {}",
                                          folder, array, log::lowerCase(state), array, array);
  }
}

}  // namespace

SlurmArray planArray(const Status& status, const std::string& folder, const SlurmOptions& options) {
  SlurmArray array;
  const std::size_t left = status.all.jobs - status.all.done - status.all.failed;
  if (left == 0) {
    array.note = "every job has a result; nothing to submit";
    return array;
  }
  const bool known = status.seconds_per_job > 0.0;
  const double seconds = known ? status.seconds_per_job : kAssumedSeconds;
  const double work = static_cast<double>(left) * seconds / options.workers;
  const double wanted = std::ceil(work / (60.0 * options.shard_minutes));
  array.shards = std::min({static_cast<std::size_t>(std::max(wanted, 1.0)), left, kMostElements});
  array.note = fmt::format("{} jobs remain, {:.3g} s each{}: {} array tasks of about {:.3g} min", left, seconds,
                           known ? "" : " (assumed, because no job is done yet)", array.shards,
                           work / 60.0 / static_cast<double>(array.shards));
  array.script = fmt::format(
      "#!/bin/sh\n"
      "# Runs the jobs of a campaign; an array task that is requeued continues where it stopped.\n"
      "#SBATCH --job-name=rubber_suspension_campaign\n"
      "#SBATCH --array=1-{}{}\n"
      "#SBATCH --requeue\n"
      "#SBATCH --open-mode=append\n"
      "#SBATCH --cpus-per-task={}\n"
      "{}"
      "exec {} run {} --shard \"$SLURM_ARRAY_TASK_ID/{}\" --threads {} --job-minutes {}\n",
      array.shards, options.max_running > 0 ? fmt::format("%{}", options.max_running) : "", options.workers,
      options.partition.empty() ? "" : "#SBATCH --partition=" + options.partition + "\n", shellWord(options.program),
      shellWord(absolutePath(folder)), array.shards, options.workers, options.job_minutes);
  return array;
}

std::string submitArray(const SlurmArray& array, const std::string& folder) {
  refuseSecond(folder);
  io::makeFolder(folder + "/slurm");
  const std::string script = folder + "/slurm/array.sh";
  log::writeNewFile(script, array.script);
  // The log file of a task. A % begins a placeholder of Slurm.
  const std::string log = boost::replace_all_copy(absolutePath(folder), "%", "%%") + "/slurm/%A_%a.log";
  const Said said = ask("sbatch --parsable --output=" + shellWord(log) + " " + shellWord(script));
  std::string id = numberIn(said.text);
  element::refuseIf<std::runtime_error>(said.status != 0 || id.empty(), "sbatch: {}", said.text);
  log::writeNewFile(submittedPath(folder), id + "\n");
  return id;
}

}  // namespace rubber_suspension::campaign
