// The command `play_log` plays logs through a running node and records the forces.
#include <fmt/format.h>
#include <ros/init.h>
#include <ros/node_handle.h>

#include <algorithm>

#include "apps/bench_client.h"
#include "command_line/command.h"
#include "command_line/log_options.h"
#include "command_line/plot_option.h"
#include "command_line/warnings.h"
#include "element/refuse.h"
#include "gap/odd_motion.h"
#include "ros_interface/bench_player.h"
#include "ros_interface/command_line.h"
#include "ros_interface/play_control.h"
#include "rubber_suspension/gap/replay.h"

using namespace rubber_suspension;
using namespace rubber_suspension::apps;
using namespace rubber_suspension::command_line;

namespace {

struct Options {
  ros_interface::PlayOptions play;
  std::vector<std::string> components;
  std::vector<std::string> logs;
  LogOptions log_options;
  std::string folder;
  std::string output;
  std::string gap_output;
  std::string bag;
  std::string plot;
  std::string reset;
  std::string rotation;
  std::uint64_t passes = 1;
  std::uint64_t step = 0;
  bool paused = false;

  OptionTable table();
  OptionTable recordTable();
};

OptionTable Options::recordTable() {
  return {
      Option("--output", output, "FILE",
             "CSV file for the forces: time_s,displacement_m,force_N; for poses: the wrenches of the last pass")
          .writes(io::file_kind::force_csv),
      Option("--gap", gap_output, "FILE", "CSV file for the live gap; needs a log with a measured force")
          .rare()
          .writes(io::file_kind::gap_csv),
      Option("--bag", bag, "FILE", "bag for displacements, measured forces, forces and gap")
          .rare()
          .writes(io::file_kind::bag),
      plotOption(plot, "forces over time and displacement"),
      Option("--folder", folder, "FOLDER",
             "folder for <component>_force.csv, <component>_gap.csv and <component>.bag of every component; if the "
             "folder has earlier records, this run writes into the next one: RUN_2 after RUN_1, NAME_2 after NAME")};
}

OptionTable Options::table() {
  OptionTable options = {
      Option("--component", components, "NAME", "name of each component").required(),
      Option("--log", logs, "FILE",
             "logs to play: text (CSV), .mat, HDF5, RPC III, or .bag with the node's topics; one for each component or "
             "one for all")
          .required()
          .reads(),
      log_options.table(),
      recordTable(),
      playerTable(play, "node"),
      Option("--rotation", rotation, "MEASURE",
             "measure of the rotations, `vector` or `cardan`, as in the component file; for logs with poses of "
             "components of six directions (columns x_mm, y_mm, z_mm, rx_deg, ry_deg, rz_deg in any unit, or a bag "
             "with COMPONENT/pose)")
          .rare()
          .oneOf({"vector", "cardan"}),
      Option("--loop", passes, "COUNT",
             "number of passes through the logs (0: until interrupted); from pass to pass the time continues and the "
             "component keeps its state"),
      Option("--step", step, "COUNT",
             "play step by step: number of samples of each component that each call of the service ~step plays; a call "
             "of ~pause with false resumes the continuous playback")
          .rare(),
      Option("--paused", paused, "start paused; the service ~pause with false starts the playback").rare(),
      Option(
          "--listeners", play.listeners, "COUNT",
          "number of subscribers of <component>/measured_force to wait for, besides the node that serves the component")
          .rare()
          .within(0, 100),
      Option("--reset", reset, "SERVICE",
             "service that resets the component before the first sample, such as /simulate/reset")
          .rare()};
  return options.excludes({"--paused"}, {"--step"}).excludes({"--gap", "--bag", "--plot"}, {"--rotation"});
}

void checkCounts(const Options& options) {
  element::refuseIf<UsageError>(options.logs.size() != 1 && options.logs.size() != options.components.size(),
                                "--log: {} logs for {} components; accepted: one log for all, or one for each",
                                options.logs.size(), options.components.size());
  element::refuseIf<UsageError>(
      options.components.size() > 1 && !(options.output + options.gap_output + options.bag + options.plot).empty(),
      "--output, --gap, --bag and --plot accept only one component; accepted with several components: --folder");
}

ros_interface::RecordPaths recordPaths(const Options& options, const std::string& component) {
  ros_interface::RecordPaths paths =
      options.folder.empty() ? ros_interface::RecordPaths() : ros_interface::recordPathsIn(options.folder, component);
  const auto prefer = [](const std::string& given, std::string& path) { path = given.empty() ? path : given; };
  prefer(options.output, paths.forces);
  prefer(options.gap_output, paths.gaps);
  prefer(options.bag, paths.bag);
  return paths;
}

// Reads a log of poses. track.log receives its stamps, temperatures and first coordinate, which all players need.
ros_interface::BenchTrack poseTrack(const Options& options, const std::string& component, const std::string& path) {
  ros_interface::BenchTrack track;
  track.component = component;
  track.wrenches = recordPaths(options, component).forces;
  track.poses = options.log_options.readPoses("play_log", path, component, *options.play.rotation);
  track.log.name = track.poses->name;
  track.log.stamp = track.poses->stamp;
  track.log.displacement = track.poses->coordinate[0];
  track.log.temperature = track.poses->temperature;
  return track;
}

// Reads the log of a component. The gap is not recorded if the log has no measured force.
ros_interface::BenchTrack readTrack(const Options& options, std::size_t i) {
  ros_interface::BenchTrack track;
  track.component = options.components[i];
  const std::string& path = options.logs[options.logs.size() == 1 ? 0 : i];
  if (options.play.rotation) {
    return poseTrack(options, track.component, path);
  }
  track.log = options.log_options.read("play_log", path, track.component);
  track.paths = recordPaths(options, track.component);
  if (track.log.force.empty()) {
    element::refuseIf<UsageError>(
        !options.gap_output.empty(),
        "--gap has no effect: {} has no measured force; accepted: a log with a measured force, or no --gap", path);
    track.paths.gaps.clear();
  }
  return track;
}

// Checks the files of the new folder and the files of options such as --output, which may lie in the new folder.
void checkRecords(const Options& options) {
  std::vector<io::OutputFile> outputs = {{"--plot", options.plot, io::file_kind::figure}};
  for (const std::string& component : options.components) {
    const ros_interface::RecordPaths paths = recordPaths(options, component);
    outputs.push_back({"forces", paths.forces, io::file_kind::force_csv});
    outputs.push_back({"gap", paths.gaps, io::file_kind::gap_csv});
    outputs.push_back({"bag", paths.bag, io::file_kind::bag});
  }
  io::checkOutputs({}, outputs, true);
}

std::vector<ros_interface::BenchTrack> readTracks(const Options& options) {
  std::vector<ros_interface::BenchTrack> tracks;
  for (std::size_t i = 0; i < options.components.size(); ++i) {
    tracks.push_back(readTrack(options, i));
  }
  return tracks;
}

// Makes a new folder if the given one contains records, so that a run never overwrites an earlier one.
void makeFolder(Options& options) {
  if (options.folder.empty()) {
    return;
  }
  std::vector<std::string> records;
  for (const std::string& component : options.components) {
    const ros_interface::RecordPaths names = ros_interface::recordPathsIn("", component);
    records.insert(records.end(), {names.forces, names.gaps, names.bag});
  }
  const std::string folder = io::makeRunFolder(options.folder, records);
  printNote("play_log",
            folder == options.folder
                ? "records go to " + folder
                : fmt::format("{} contains records of an earlier run; the new ones go to {}", options.folder, folder));
  options.folder = folder;
}

std::string describe(const ros_interface::BenchCount& count) {
  std::string text =
      fmt::format("{}: {} samples, {} answered, {} forces with unexpected stamps; {:.3g} s, {:.0f} samples per second",
                  count.component, count.samples, count.answered, count.unexpected + count.repeated, count.duration,
                  static_cast<double>(count.answered) / std::max(count.duration, 1e-9));
  return count.gaps > 0 ? text + fmt::format("; gap published {} times", count.gaps) : text;
}

// Returns why a playback failed, or an empty text. An interrupt is a failure unless the playback is endless.
std::string failureOf(const ros_interface::BenchCount& count, bool endless) {
  if (!count.exactlyOneEach()) {
    return "not every sample had exactly one force";
  }
  return count.complete || endless
             ? ""
             : fmt::format("interrupted before the end of {}: each sample so far had exactly one force", count.of);
}

int report(const std::vector<ros_interface::BenchCount>& counts, bool endless) {
  std::string failed;
  for (const ros_interface::BenchCount& count : counts) {
    const std::string failure = failureOf(count, endless);
    if (failure.empty()) {
      std::cout << describe(count) << "; every sample had exactly one force\n";
    } else {
      failed += (failed.empty() ? "" : "; ") + describe(count) + "; " + failure;
    }
  }
  element::refuseIf<ros_interface::PlayError>(!failed.empty(), "{}", failed);
  return kSuccess;
}

int playAll(ros_interface::RosCommandLine& line, Options& options) {
  checkCounts(options);
  if (!options.rotation.empty()) {
    options.play.rotation =
        options.rotation == "vector" ? component::RotationMeasure::vector : component::RotationMeasure::cardan;
  }
  options.log_options.requireUse(options.logs);
  makeFolder(options);
  checkRecords(options);
  std::vector<ros_interface::BenchTrack> tracks = readTracks(options);
  line.initialise("play_log", 0, options.play.connect_timeout);
  ros::NodeHandle handle;
  noteOpenness("play_log");
  ros_interface::PlayControl control(std::max<std::size_t>(options.step, 1), options.paused || options.step > 0);
  const ros_interface::PlayControlServices services(ros::NodeHandle("~"), control);
  options.play.control = &control;
  const log::Log first_log = tracks.front().log;
  ros_interface::BenchPlayer player(handle, withNotes(options.play, "play_log"), std::move(tracks));
  player.connect();
  resetComponent(handle, options.reset);
  const std::vector<ros_interface::BenchCount> counts = player.play(options.passes);
  if (counts.front().complete && !options.play.rotation) {
    warnOf("play_log", options.logs.front(), gap::oddMotion(first_log, player.lastForces(0), {}));
  }
  if (!options.plot.empty() && !counts.front().complete) {
    printNote("play_log", options.plot + " is not drawn because the log was not played to its end");
  } else {
    drawPlot(options.plot,
             [&] { return gap::replayFigure(options.components.front(), first_log, player.lastForces(0)); });
  }
  return report(counts, options.passes == 0);
}

}  // namespace

int main(int argc, char** argv) {
  ros_interface::RosCommandLine line(argc, argv);
  return runCommand<Options>(
      line.argc(), line.argv(),
      {"play_log",
       "Plays logs through a running node and records the forces.\n\nThe node publishes the forces on "
       "<component>/force; see launch/replay.launch and launch/bench.launch.",
       {{"As fast as the node answers", "--component bush --log log.csv --output force.csv"},
        {"In real time, repeated until interrupted",
         "--component bush --log log.csv --playback-speed 1 --loop 0 --folder runs/run"},
        {"Two components side by side", "--component left right --log left.csv right.csv --folder runs/run"}}},
      [&](Options& options) { return playAll(line, options); });
}
