// The command `campaign` runs many diagnoses, estimates or replays as one task, on one computer or on a cluster.
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <map>

#include "bag/bag_log.h"
#include "campaign/fleet.h"
#include "campaign/make.h"
#include "campaign/run.h"
#include "campaign/slurm.h"
#include "campaign/status.h"
#include "command_line/command.h"
#include "element/refuse.h"
#include "io/output_files.h"
#include "log/text.h"

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  std::string task;
  std::string folder;
  std::string jobs;
  std::string output;
  std::string shard = "1/1";
  int threads = 2;
  double job_minutes = campaign::kJobMinutes;
  campaign::RunOptions run;
  std::string engine;
  campaign::SlurmOptions slurm;
  bool dry_run = false;

  Files madeFiles() const {
    Files files;
    if (!output.empty()) {
      files.outputs = {{"--output", campaign::manifestPath(output), io::file_kind::campaign_manifest}};
    }
    return files;
  }

  Files collectedFiles() const {
    Files files;
    if (task == "collect") {
      files.inputs = {{"FOLDER", campaign::manifestPath(folder)}};
      files.outputs = {{"FOLDER", campaign::tableCsvPath(folder), io::file_kind::campaign_csv},
                       {"FOLDER", campaign::tableJsonPath(folder), io::file_kind::campaign_json},
                       {"FOLDER", campaign::fleetJsonPath(folder), io::file_kind::fleet_json},
                       {"FOLDER", campaign::fleetReportPath(folder), io::file_kind::fleet_report}};
    }
    return files;
  }

  OptionTable table() {
    OptionTable options = {
        Option("task", task, "",
               "make: create the campaign's folder from a jobs file and check every input; run: run the jobs that are "
               "not done; submit: run them as a Slurm job array; status: count the jobs that are done, failed, running "
               "and missing; collect: write the tables of results and the fleet report")
            .required()
            .oneOf({"make", "run", "submit", "status", "collect"}),
        Option("folder", folder, "", "folder of the campaign; for every task except make").standsFor([this] {
          return collectedFiles();
        }),
        Option("--jobs", jobs, "FILE", "jobs file; for make").reads(),
        Option("--output", output, "FOLDER", "folder of the campaign to create; for make").standsFor([this] {
          return madeFiles();
        }),
        Option("--shard", shard, "I/N", "I/N, such as 3/8: run only every N-th job, starting with the I-th; for run")
            .rare(),
        Option("--threads", threads, "COUNT",
               "number of parallel jobs of run, and of each array task of submit; number of threads of make")
            .within(1, 1024),
        Option("--job-minutes", job_minutes, "MINUTES",
               "time limit of a job, for run and submit: a slower job is stopped and counts as failed; 0: no limit")
            .rare()
            .within(0, 1000000),
        Option("--retry-failed", run.retry_failed, "run failed jobs again; for run").rare(),
        Option("--engine", engine, "ENGINE", "batch system that runs the jobs; for submit").rare().oneOf({"slurm"}),
        Option("--shard-minutes", slurm.shard_minutes, "MINUTES", "intended run time of each array task; for submit")
            .rare()
            .within(0.001, 10000),
        Option("--max-running", slurm.max_running, "COUNT",
               "largest number of parallel array tasks; for submit; default: all tasks")
            .rare()
            .within(1, 1000000),
        Option("--partition", slurm.partition, "NAME",
               "partition of the cluster; for submit; default: the default partition of the cluster")
            .rare(),
        Option("--dry-run", dry_run, "print the script of the job array without submitting it").rare()};
    options.needs({"--jobs", "--output"}, {"task make"});
    options.needs({"--force"}, {"task make", "task collect"});
    options.needs({"--shard", "--retry-failed"}, {"task run"});
    options.needs({"--engine", "--shard-minutes", "--max-running", "--partition", "--dry-run"}, {"task submit"});
    options.needs({"--job-minutes"}, {"task run", "task submit"});
    options.needs({"--threads"}, {"task make", "task run", "task submit"});
    return options;
  }
};

void checkUse(const Options& options) {
  element::refuseIf<UsageError>(
      options.task == "make" && (options.jobs.empty() || options.output.empty() || !options.folder.empty()),
      "make: needs the options --jobs and --output, and no other argument; accepted: campaign make --jobs FILE "
      "--output FOLDER");
  element::refuseIf<UsageError>(options.task != "make" && options.folder.empty(),
                                "{}: the folder of the campaign is missing; accepted: campaign {} FOLDER", options.task,
                                options.task);
}

log::Log readLog(const std::string& path, const std::string& component, const log::LogFormat& format) {
  return bag::readAnyLog(path, component, format);
}

void say(const std::string& line) { std::cerr << "campaign: " << log::oneLine(line) << '\n'; }

int make(const Options& options) {
  const campaign::Expansion expansion =
      campaign::makeManifest(options.jobs, options.output, version(), options.threads, readLog);
  for (const std::string& problem : expansion.problems) {
    printError("campaign", problem);
  }
  if (!expansion.problems.empty()) {
    return kFailed;
  }
  io::makeFolder(options.output);
  campaign::writeManifest(expansion.manifest, options.output);
  printNotes("campaign", expansion.notes);
  std::cout << fmt::format("{} jobs with {} input files\n{}\n", expansion.manifest.jobs.size(),
                           expansion.manifest.inputs.size(), campaign::manifestPath(options.output));
  return kSuccess;
}

int run(const Options& options) {
  campaign::RunOptions settings = options.run;
  settings.shard = asUsage("--shard: ", [&] { return campaign::parseShard(options.shard); });
  settings.workers = options.threads;
  settings.job_minutes = options.job_minutes;
  const campaign::RunSummary summary = campaign::run(options.folder, version(), settings, readLog, say);
  std::cout << fmt::format("{} jobs done, {} failed, {} skipped because they have a result{}{}\n", summary.done,
                           summary.failed, summary.passed_over,
                           summary.failed_before > 0 ? fmt::format(", {} of which failed", summary.failed_before) : "",
                           summary.not_done > 0 ? fmt::format("; {} not done", summary.not_done) : "");
  element::refuseIf<std::runtime_error>(summary.interrupted, "interrupted; run the same command again to continue");
  return summary.failed + summary.failed_before + summary.not_done == 0 ? kSuccess : kFailed;
}

int submit(const Options& options) {
  element::refuseIf<UsageError>(options.engine.empty(), "submit: --engine is missing; accepted: --engine slurm");
  campaign::SlurmOptions settings = options.slurm;
  element::refuseIf<UsageError>(settings.partition.find_first_of(" \t\n\r") != std::string::npos,
                                "--partition: '{}' contains blanks; accepted: the name of a partition, without blanks",
                                settings.partition);
  const campaign::Manifest manifest = campaign::readManifest(options.folder);
  campaign::requireVersion(manifest, options.folder, version());
  settings.program = std::filesystem::read_symlink("/proc/self/exe").string();
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
  std::cout << during("reading the records of " + options.folder, [&] {
    return campaign::toText(campaign::statusOf(campaign::readManifest(options.folder), options.folder));
  });
  return kSuccess;
}

int collect(const Options& options) {
  const campaign::Manifest manifest = campaign::readManifest(options.folder);
  const campaign::CollectSummary summary =
      during("reading the records of " + options.folder, [&] { return campaign::collect(manifest, options.folder); });
  for (const std::string& problem : summary.broken) {
    printNote("campaign", problem + "; this job counts as missing");
  }
  if (!summary.page_problem.empty()) {
    printWarning("campaign", summary.page_problem);
  }
  std::cout << fmt::format("{} jobs done, {} failed, {} missing\n{}\n{}\n{}\n", summary.done, summary.failed,
                           summary.missing, campaign::tableCsvPath(options.folder),
                           campaign::tableJsonPath(options.folder),
                           summary.page_problem.empty() ? campaign::fleetReportPath(options.folder)
                                                        : campaign::fleetJsonPath(options.folder));
  return kSuccess;
}

int runTask(const Options& options) {
  const std::map<std::string, std::function<int(const Options&)>> tasks = {
      {"make", make}, {"run", run}, {"submit", submit}, {"status", status}, {"collect", collect}};
  checkUse(options);
  return tasks.at(options.task)(options);
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"campaign",
       "Runs the diagnoses, estimates and replays of a jobs file, and writes a table of their results. The jobs run on "
       "one machine, in shards on several machines, or as a Slurm job array.",
       {{"Create a campaign from a jobs file", "make --jobs jobs.yaml --output campaign"},
        {"Run its jobs, four at the same time", "run campaign --threads 4"},
        {"Write the tables and the fleet report", "collect campaign"}}},
      runTask);
}
