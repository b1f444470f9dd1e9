// The command `diagnose` finds where a simulation differs from logs, and which effect the model lacks.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "apps/diagnose/run.h"
#include "command_line/command.h"
#include "command_line/plot_option.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/report/run_record.h"
#include "diagnosis/words/model_values.h"
#include "diagnosis/words/text.h"
#include "element/refuse.h"
#include "io/effect_names.h"
#include "log/text.h"
#include "rubber_suspension/diagnosis/plan.h"
#include "rubber_suspension/diagnosis/six_directions.h"

namespace rubber_suspension::apps {
namespace {

using namespace command_line;

io::FileKind kindOf(const std::string& name) {
  // Kinds of files by name, or by extension for all other names.
  static const std::map<std::string, io::FileKind> kinds = {{"plan.json", io::file_kind::plan_json},
                                                            {"plan.html", io::file_kind::plan_html},
                                                            {"missing_force.csv", io::file_kind::force_map_csv},
                                                            {"next_experiment.csv", io::file_kind::force_csv},
                                                            {"next_experiment.drv", io::file_kind::rpc},
                                                            {".json", io::file_kind::report_json},
                                                            {".html", io::file_kind::report_html},
                                                            {".yaml", io::file_kind::component_file},
                                                            {".csv", io::file_kind::figure_csv}};
  const auto found = kinds.find(name);
  return found != kinds.end() ? found->second : kinds.at(std::filesystem::path(name).extension().string());
}

// Returns all files that the report can consist of.
Files reportFiles(const DiagnoseOptions& options) {
  Files files;
  const auto add = [&](const std::filesystem::path& folder, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      files.outputs.push_back({"--output", (folder / name).string(), kindOf(name)});
    }
  };
  if (options.directions.empty()) {
    add(options.output, options.plan.empty() ? diagnosis::reportFiles() : diagnosis::planFiles());
    return files;
  }
  add(options.output, diagnosis::sixDirectionsFiles());
  for (const std::string& direction : std::set<std::string>(options.directions.begin(), options.directions.end())) {
    add(std::filesystem::path(options.output) / direction, diagnosis::reportFiles());
  }
  return files;
}

// Describes the removed parts of the first few logs. The report lists all of them.
std::string takenOut(const diagnosis::Diagnosis& diagnosis) {
  constexpr std::size_t kMostLogs = 8;
  std::vector<std::string> phrases = diagnosis::words::describeTakenOut(diagnosis.logs.taken_out);
  if (phrases.size() > kMostLogs) {
    const std::size_t more = phrases.size() - kMostLogs;
    phrases.resize(kMostLogs);
    phrases.push_back(fmt::format("{} more, listed in the report", more));
  }
  return phrases.empty() ? "" : log::oneLine(fmt::format("removed from the logs: {}", fmt::join(phrases, "; "))) + "\n";
}

int run(const DiagnoseOptions& options) {
  if (!options.plan.empty()) {
    return runPlan(options);
  }
  if (!options.table_path.empty()) {
    return runTable(options);
  }
  element::refuseIf<UsageError>(options.logs.empty(),
                                "--log is missing; accepted: measured logs, --from-table with a table of stiffness and "
                                "loss angle, or --plan with programmes of displacement");
  std::vector<std::string> all_logs = options.logs;
  all_logs.insert(all_logs.end(), options.hold_out.begin(), options.hold_out.end());
  options.log_options.requireUse(all_logs);
  if (!options.directions.empty()) {
    return runDirections(options);
  }
  return runLogs(options);
}

}  // namespace

OptionTable DiagnoseOptions::table() {
  OptionTable options = {
      component.table(),
      Option("--direction", directions, "NAME",
             "directions to diagnose, for a component of six directions; the report of each is written into a folder "
             "with its name, and a map shows which directions are coupled")
          .oneOf({"x", "y", "z", "rx", "ry", "rz"}),
      Option("--log", logs, "FILE",
             "measured logs of one component in the order of recording; text (CSV), .mat, HDF5, RPC III or .bag")
          .readsEachOnce(),
      Option("--plan", plan, "FILE",
             "instead of --log: displacement programmes (time and displacement only); predicts which effects logs of "
             "these programmes would show or confuse, and the smallest visible size of each effect")
          .readsEachOnce(),
      Option("--from-table", table_path, "FILE",
             "instead of --log: measured table of stiffness and loss angle; over frequency and amplitude, optionally "
             "with mean displacement and temperature")
          .reads(),
      Option("--uncertainty", uncertainty, "SHARE ANGLE",
             "with --from-table: standard deviations of its stiffness and loss angle, such as \"1 %\" \"0.5 deg\"; "
             "default: estimated from repeated rows or from the residual of a smooth surface")
          .rare()
          .values(1, 2),
      Option("--effect-size", share(effect_size, 1e-4, 1.0), "SHARE",
             "with --plan: size of each effect as a share of the force's standard deviation")
          .rare()
          .defaultText("10 %"),
      Option("--noise", share(noise, 1e-6, 1.0), "SHARE",
             "with --plan: noise of the measured force as a share of its standard deviation")
          .rare()
          .defaultText("0.5 %"),
      Option("--hold-out", hold_out, "FILE",
             "logs that take no part in the fit; the component starts as new in each log")
          .readsEachOnce(),
      Option("--rig", rig, "KEY=VALUE",
             "tolerances of the rig, such as force_zero=\"50 N\" or gain=\"1 %\"; errors of this size are not reported "
             "as effects; same names and values as in the key `rig:` of a component file"),
      Option("--exclude", exclude, "EFFECT",
             "effects that the design rules out (bonded, dry, no joint), in addition to `excluded_effects:` of the "
             "component file; they are never named, and the report states how probable they would otherwise be")
          .rare()
          .oneOf(io::effectNames()),
      Option("--limits", limits, "KEY=VALUE",
             "limits of the test machine for the next experiment, such as stroke=\"20 mm\" speed=\"0.3 m/s\" "
             "frequency=\"15 Hz\" force=\"30 kN\" duration=\"60 s\"; default: the values that the logs reached")
          .rare(),
      Option("--output", output, "FOLDER", "folder of the report; created if missing").required().standsFor([this] {
        return reportFiles(*this);
      }),
      Option("--compare", compare, "FILE",
             "report.json of an earlier diagnosis; prints the values whose change exceeds the noise and the intervals")
          .rare()
          .reads(),
      Option("--evidence", evidence,
             "also write evidence.json: the residuals of every hypothesis, on which the judgement is based")
          .rare(),
      Option("--law", law, "LAW",
             "simplest: write only augmented.yaml, in which each effect has the simplest law that fits nearly as well "
             "as its full law; full: also write augmented_full.yaml with the full laws")
          .rare()
          .oneOf({"simplest", "full"}),
      plotOption(plot, "loops, residuals and gap").rare(),
      Option("--most-samples", most_samples, "COUNT",
             "largest number of samples that are searched in all logs together; if the logs have more, excerpts that "
             "cover all amplitudes are searched")
          .rare()
          .within(1000, 100000000),
      Option("--threads", threads, "COUNT", "number of threads").rare().within(1, 64),
      log_options.acceptUnits(),
      log_options.table()};
  options.needs({"--effect-size", "--noise"}, {"--plan"});
  options.excludes({"--log", "--from-table", "--hold-out", "--limits", "--compare", "--plot", "--most-samples",
                    "--accept-units", "--exclude"},
                   {"--plan"});
  options.excludes({"--plan", "--from-table", "--compare", "--plot"}, {"--direction"});
  options.needs({"--uncertainty"}, {"--from-table"});
  options.excludes({"--log", "--hold-out", "--limits", "--most-samples"}, {"--from-table"});
  return options.excludes(LogOptions::names(), {"--from-table"});
}

Quantity share(double& value, double least, double most) {
  return {
      &value, "1", element::Range::closed(least, most),
      fmt::format("a share of the force from {:g} to {:g} %, such as \"1 %\" or 0.01", 100.0 * least, 100.0 * most)};
}

void showStage(const std::string& stage, double fraction) {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K[{:3.0f} %] {}", 100.0 * fraction, stage);
  }
}

void clearStage() {
  if (isatty(STDERR_FILENO) != 0) {
    fmt::print(stderr, "\r\033[K");
  }
}

diagnosis::RunRecord runRecord(const DiagnoseOptions& options) {
  std::vector<std::pair<std::string, std::string>> files = {{"--config", options.component.config}};
  const auto add = [&](const std::string& option, const std::vector<std::string>& paths) {
    for (const std::string& path : paths) {
      if (!path.empty()) {
        files.emplace_back(option, path);
      }
    }
  };
  add("--compare", {options.compare});
  add("--log", options.logs);
  add("--plan", options.plan);
  add("--from-table", {options.table_path});
  add("--hold-out", options.hold_out);
  return diagnosis::report::makeRunRecord(version(), options.command_line, files);
}

void setTolerances(const std::vector<std::string>& assignments, io::ComponentDescription& component) {
  io::RigTolerances tolerances = component.rig.value_or(io::RigTolerances{});
  for (const std::string& assignment : assignments) {
    asUsage("--rig: ", [&] { io::setRigTolerance(tolerances, assignment); });
  }
  if (!assignments.empty()) {
    component.rig = tolerances;
  }
}

std::string excerptsTaken(const diagnosis::Diagnosis& diagnosis) {
  return diagnosis.samples.searched == diagnosis.samples.recorded
             ? ""
             : fmt::format("only excerpts were searched: {} of {} samples (limit: option --most-samples)\n",
                           diagnosis.samples.searched, diagnosis.samples.recorded);
}

std::optional<diagnosis::report::EarlierReport> earlierReport(const DiagnoseOptions& options) {
  return options.compare.empty() ? std::nullopt : std::optional<diagnosis::report::EarlierReport>(options.compare);
}

std::string writtenReport(const std::string& folder, const std::string& name, const std::string& problem) {
  if (!problem.empty()) {
    clearStage();
    printWarning("diagnose", problem);
  }
  return fmt::format("{}/{}.{}", folder, name, problem.empty() ? "html" : "json");
}

int publish(diagnosis::Diagnosis diagnosis, const std::optional<diagnosis::report::EarlierReport>& earlier,
            const DiagnoseOptions& options) {
  diagnosis.run = runRecord(options);
  diagnosis.write_full_law = options.law == "full";
  if (earlier) {
    diagnosis.comparison = earlier->compare(diagnosis);
  }
  showStage("writing the report", 0.95);
  const std::string page = writtenReport(options.output, "report", diagnosis::writeReport(diagnosis, options.output));
  if (!options.plot.empty() && hasComponentFile(diagnosis)) {
    io::drawFigure(diagnosis::report::overviewFigure(diagnosis), options.plot);
  }
  clearStage();
  const std::string whole = diagnosis::words::wholeText(diagnosis);
  fmt::print("{}\n{}{}{}{}report: {}\n", log::oneLine(diagnosis.sentence), whole.empty() ? "" : whole + "\n",
             takenOut(diagnosis), excerptsTaken(diagnosis), diagnosis::report::toText(diagnosis.comparison), page);
  return diagnosis.defect.empty() ? kSuccess : kDefect;
}

}  // namespace rubber_suspension::apps

int main(int argc, char** argv) {
  using namespace rubber_suspension;
  apps::DiagnoseOptions options;
  options.command_line = {"rosrun", "rubber_suspension", "diagnose"};
  options.command_line.insert(options.command_line.end(), argv + std::min(argc, 1), argv + argc);
  return command_line::runCommand(
      argc, argv,
      {"diagnose",
       "Finds where a model differs from logs, which effect it lacks, and how far the effect closes the gap.",
       {{"Find what a model lacks, from two logs", "--config component.yaml --log log.csv log_2.csv --output report"},
        {"The same, if the force sensor of the rig has a zero error of about 50 N",
         "--config component.yaml --log log.csv --rig force_zero=\"50 N\" --output report"},
        {"Predict what a programme would show", "--config component.yaml --plan programme.csv --output plan"}}},
      options.table(), [&] { return apps::run(options); });
}
