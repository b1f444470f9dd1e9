// campaign: many diagnoses, estimates or replays as one task, by one machine or by a cluster.
#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <memory>

#include "apps/command.h"
#include "apps/output_options.h"
#include "bag/bag_log.h"
#include "campaign/fleet_json.h"
#include "campaign/fleet_report.h"
#include "campaign/make.h"
#include "campaign/run.h"
#include "campaign/slurm.h"
#include "campaign/status.h"
#include "campaign/table.h"
#include "log/new_file.h"

namespace rubber_suspension::apps {
namespace {

struct Options {
  std::string task;
  std::string folder;
  std::string jobs;
  std::string output;
  std::string shard = "1/1";
  int threads = 2;
  bool retry_failed = false;
  double job_minutes = campaign::kJobMinutes;
  std::string engine;
  std::size_t max_running = 0;
  double shard_minutes = campaign::SlurmOptions().shard_minutes;
  std::string partition;
  bool dry_run = false;
  OutputOptions outputs;
};

// What each task takes besides the folder.
const std::map<std::string, std::vector<std::string>>& optionsOfTasks() {
  static const std::map<std::string, std::vector<std::string>> table = {
      {"make", {"--jobs", "--output", "--threads", "--force"}},
      {"run", {"--shard", "--threads", "--job-minutes", "--retry-failed"}},
      {"submit",
       {"--engine", "--max-running", "--shard-minutes", "--partition", "--threads", "--job-minutes", "--dry-run"}},
      {"status", {}},
      {"collect", {"--force"}},
  };
  return table;
}

// No option is without effect, and none that is needed is missing.
void checkUse(const CLI::App& app, const Options& options) {
  const std::vector<std::string>& taken = optionsOfTasks().at(options.task);
  for (const auto& [task, names] : optionsOfTasks()) {
    for (const std::string& name : names) {
      if (std::find(taken.begin(), taken.end(), name) == taken.end()) {
        refuseUnused(app, {name}, "on " + options.task);
      }
    }
  }
  if (options.task == "make" && (options.jobs.empty() || options.output.empty() || !options.folder.empty())) {
    throw UsageError("make: accepted: campaign make --jobs FILE --output FOLDER");
  }
  if (options.task != "make" && options.folder.empty()) {
    throw UsageError(options.task + ": the folder of the campaign is missing; accepted: campaign " + options.task +
                     " FOLDER");
  }
}

log::Log readLog(const std::string& path, const std::string& component, const log::LogFormat& format) {
  return bag::readAnyLog(path, component, format);
}

void say(const std::string& line) { std::cerr << "campaign: " << log::oneLine(line) << '\n'; }

int make(const Options& options) {
  options.outputs.check({{"--jobs", options.jobs}},
                        {{"--output", campaign::manifestPath(options.output), io::FileKind::campaign_manifest}});
  campaign::Expansion expansion;
  try {
    expansion =
        campaign::makeManifest(options.jobs, options.output, RUBBER_SUSPENSION_VERSION, options.threads, readLog);
  } catch (const campaign::BadInputs& error) {
    for (const std::string& problem : error.problems()) {
      printError("campaign", problem);
    }
    return kFailed;
  }
  std::error_code failure;
  std::filesystem::create_directories(options.output, failure);
  if (failure) {
    throw std::runtime_error(options.output + ": cannot be made: " + failure.message());
  }
  campaign::writeManifest(expansion.manifest, options.output);
  for (const std::string& note : expansion.notes) {
    printNote("campaign", note);
  }
  std::cout << fmt::format("{} jobs with {} input files\n{}\n", expansion.manifest.jobs.size(),
                           expansion.manifest.inputs.size(), campaign::manifestPath(options.output));
  return kSuccess;
}

int run(const Options& options) {
  campaign::RunOptions settings;
  try {
    settings.shard = campaign::parseShard(options.shard);
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--shard: ") + error.what());
  }
  settings.workers = options.threads;
  settings.retry_failed = options.retry_failed;
  settings.job_minutes = options.job_minutes;
  const campaign::RunSummary summary = campaign::run(options.folder, RUBBER_SUSPENSION_VERSION, settings, readLog, say);
  std::cout << fmt::format("{} jobs done, {} failed, {} passed over because they have a result\n", summary.done,
                           summary.failed, summary.passed_over);
  if (summary.interrupted) {
    throw std::runtime_error("interrupted; the same command continues");
  }
  return summary.failed == 0 ? kSuccess : kFailed;
}

int submit(const Options& options) {
  if (options.engine.empty()) {
    throw UsageError("submit: --engine is missing; accepted: --engine slurm");
  }
  if (options.partition.find_first_of(" \t\n\r") != std::string::npos) {
    throw UsageError("--partition: '" + options.partition + "'; accepted: the name of a partition, without blanks");
  }
  const campaign::Manifest manifest = campaign::readManifest(options.folder);
  campaign::requireVersion(manifest, options.folder, RUBBER_SUSPENSION_VERSION);
  campaign::SlurmOptions settings;
  settings.program = std::filesystem::read_symlink("/proc/self/exe").string();
  settings.shard_minutes = options.shard_minutes;
  settings.max_running = options.max_running;
  settings.partition = options.partition;
  settings.workers = options.threads;
  settings.job_minutes = options.job_minutes;
  const campaign::SlurmArray array =
      campaign::planArray(campaign::statusOf(manifest, options.folder), options.folder, settings);
  std::cout << array.note << '\n';
  if (array.shards > 0) {
    std::cout << (options.dry_run ? array.script
                                  : "array " + campaign::submitArray(array, options.folder) + " submitted\n");
  }
  return kSuccess;
}

int status(const Options& options) {
  std::cout << campaign::toText(campaign::statusOf(campaign::readManifest(options.folder), options.folder));
  return kSuccess;
}

int collect(const Options& options) {
  options.outputs.check({{"FOLDER", campaign::manifestPath(options.folder)}},
                        {{"FOLDER", campaign::tableCsvPath(options.folder), io::FileKind::campaign_csv},
                         {"FOLDER", campaign::tableJsonPath(options.folder), io::FileKind::campaign_json},
                         {"FOLDER", campaign::fleetJsonPath(options.folder), io::FileKind::fleet_json},
                         {"FOLDER", campaign::fleetReportPath(options.folder), io::FileKind::fleet_report}});
  const campaign::Manifest manifest = campaign::readManifest(options.folder);
  campaign::Fleet fleet;
  const campaign::CollectSummary summary =
      campaign::writeTables(manifest, options.folder, [&](const campaign::Job& job, const campaign::Record* record) {
        if (record != nullptr) {
          fleet.add(job, *record);
        }
      });
  const campaign::FleetFindings findings = fleet.analyse();
  log::writeNewFile(campaign::fleetJsonPath(options.folder), campaign::toJson(findings));
  log::writeNewFile(campaign::fleetReportPath(options.folder), campaign::fleetHtml(findings, summary));
  for (const std::string& problem : summary.broken) {
    printNote("campaign", problem + "; counted as missing");
  }
  std::cout << fmt::format("{} jobs done, {} failed, {} missing\n{}\n{}\n{}\n", summary.done, summary.failed,
                           summary.missing, campaign::tableCsvPath(options.folder),
                           campaign::tableJsonPath(options.folder), campaign::fleetReportPath(options.folder));
  return kSuccess;
}

CommandBody define(CLI::App& app) {
  const std::map<std::string, std::function<int(const Options&)>> tasks = {
      {"make", make}, {"run", run}, {"submit", submit}, {"status", status}, {"collect", collect}};
  auto options = std::make_shared<Options>();
  app.add_option(
         "task", options->task,
         "make: from a jobs file to the folder of a campaign, with every input checked; run: work off what is "
         "not done; submit: the same as a job array of Slurm; status: what is done, failed, missing, running; collect: "
         "tables of the results and the fleet report")
      ->required()
      ->check(CLI::IsMember({"make", "run", "submit", "status", "collect"}));
  app.add_option("folder", options->folder, "folder of the campaign, for all but make");
  app.add_option("--jobs", options->jobs, "jobs file, for make")->type_name("FILE");
  app.add_option("--output", options->output, "folder of the campaign to make")->type_name("FOLDER");
  app.add_option("--shard", options->shard, "run every N-th job only, from the I-th on, such as 3/8; for run")
      ->type_name("I/N")
      ->capture_default_str();
  app.add_option("--threads", options->threads,
                 "jobs at a time, for run and in each element of submit; threads that check inputs, for make")
      ->type_name("COUNT")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  app.add_option("--job-minutes", options->job_minutes,
                 "a job that takes longer is ended and has failed, for run and in each element of submit; 0: no limit")
      ->type_name("MINUTES")
      ->capture_default_str()
      ->check(CLI::Range(0.0, 1000000.0));
  app.add_flag("--retry-failed", options->retry_failed, "work failed jobs off again, for run");
  app.add_option("--engine", options->engine, "what works the jobs off, for submit")
      ->type_name("ENGINE")
      ->check(CLI::IsMember({"slurm"}));
  app.add_option("--shard-minutes", options->shard_minutes, "work of an element of the array, for submit")
      ->type_name("MINUTES")
      ->capture_default_str()
      ->check(CLI::Range(0.001, 10000.0));
  app.add_option("--max-running", options->max_running, "elements that run at a time, for submit; all if absent")
      ->type_name("COUNT")
      ->check(CLI::Range(1, 1000000));
  app.add_option("--partition", options->partition, "partition of the cluster, for submit; its default if absent")
      ->type_name("NAME");
  app.add_flag("--dry-run", options->dry_run, "print the array's script and submit nothing");
  options->outputs.addTo(app);
  return [&app, options, tasks] {
    checkUse(app, *options);
    return tasks.at(options->task)(*options);
  };
}

}  // namespace
}  // namespace rubber_suspension::apps

int main(int argc, char** argv) {
  return rubber_suspension::apps::runCommand(
      argc, argv, "campaign",
      "Works off many diagnoses, estimates and replays: from a jobs file to a table of the results, on one machine, in "
      "shards on several, or as a job array of Slurm.",
      rubber_suspension::apps::define);
}
