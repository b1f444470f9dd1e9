// Rules that determine which existing files a command or a launch file may replace.
#pragma once

#include <array>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "log/text.h"

namespace rubber_suspension::io {

/// A kind of file, recognised by its first 64 KiB.
struct FileKind {
  std::string_view name;                              ///< name with its article, for error messages
  std::array<std::string_view, 4> beginnings = {{}};  ///< the file begins with one of these texts, if there are any
  std::array<std::string_view, 3> parts = {{}};       ///< its first 64 KiB contain one of these texts, if there are any
};

/// Kinds of files that this package writes. JSON files are recognised by their schema.
namespace file_kind {

inline constexpr FileKind force_csv = {"a log as this command writes it (time_s,displacement_m,force_N)",
                                       {"time_s,displacement_m\n", "time_s,displacement_rad\n",
                                        "time_s,displacement_m,force_N\n", "time_s,x_m,y_m,z_m,rx_rad,"}};
inline constexpr FileKind gap_csv = {"a record of the live gap", {"time_s,level,"}};
inline constexpr FileKind vehicle_csv = {"a record of a vehicle", {"time_s,frame_m,"}};
inline constexpr FileKind figure_csv = {"the numbers of a figure", {"curve,"}};
inline constexpr FileKind force_map_csv = {
    "a map of the missing force", {"displacement_m,velocity_m_per_s,", "displacement_rad,velocity_rad_per_s,"}};
inline constexpr FileKind characteristics_csv = {"a table of characteristics", {"frequency_Hz,amplitude_m,"}};
inline constexpr FileKind campaign_csv = {"a table of a campaign", {"id,group,type,"}};
inline constexpr FileKind campaign_json = {"a table of a campaign", {"{"}, {"rubber_suspension/campaign_table/"}};
inline constexpr FileKind campaign_manifest = {"the manifest of a campaign",
                                               {"{\"schema\":\"rubber_suspension/campaign/"}};
inline constexpr FileKind fleet_json = {"the findings on a fleet", {"{"}, {"rubber_suspension/fleet/"}};
inline constexpr FileKind fleet_report = {"a fleet report", {"<!DOCTYPE html>", "<!doctype html>"}, {"Fleet report"}};
inline constexpr FileKind report_json = {
    "a report of a diagnosis", {"{"}, {"rubber_suspension/gap_report/", "rubber_suspension/evidence/"}};
inline constexpr FileKind report_html = {
    "a report of a diagnosis", {"<!DOCTYPE html>", "<!doctype html>"}, {"Gap report"}};
inline constexpr FileKind plan_json = {"a plan of experiments", {"{"}, {"rubber_suspension/experiment_plan/"}};
inline constexpr FileKind plan_html = {
    "a plan of experiments", {"<!DOCTYPE html>", "<!doctype html>"}, {"Experiment plan"}};
inline constexpr FileKind agreement_json = {"an agreement of forces", {"{"}, {"rubber_suspension/agreement/"}};
inline constexpr FileKind state_space_json = {"a state-space model", {"{"}, {"rubber_suspension/state_space/"}};
inline constexpr FileKind mat = {"a state-space model", {"rubber_suspension"}};
inline constexpr FileKind component_file = {"a component file", {}, {"\ncomponents:"}};
inline constexpr FileKind spring_and_dashpot = {"k and c of a component", {"# "}, {"\nk_N_per_m: "}};
inline constexpr FileKind bushing_file = {"a bushing property file", {"$", "["}, {"'bus'", "'gbs'"}};
inline constexpr FileKind test_report = {"a report of a test", {"<?xml", "<testsuite"}, {"<testsuite"}};
inline constexpr FileKind figure = {
    "a figure (SVG, PNG, PDF)", {"<?xml", "<svg", "\x89PNG", "%PDF"}, {"<svg", "\x89PNG", "%PDF"}};
inline constexpr FileKind bag = {"a ROS bag", {"#ROSBAG V"}};
inline constexpr FileKind fmu = {"an FMU", {"PK\x03\x04"}, {"modelDescription.xml"}};
inline constexpr FileKind rpc = {"a file of RPC III", {std::string_view("FORMAT\0", 7)}};

}  // namespace file_kind

struct InputFile {
  std::string option;
  std::string path;
};

/// A file that a command writes. For a file in a folder that the command creates, the option names the folder.
struct OutputFile {
  std::string option;
  std::string path;
  FileKind kind;
};

/// Thrown if an output would overwrite a file that must not be replaced, or cannot be written. what() is one line.
class OutputRefused : public std::runtime_error {
 public:
  explicit OutputRefused(const std::string& message) : std::runtime_error(log::oneLine(message)) {}
};

/// Throws OutputRefused in these cases: an output is also an input, under any name or link; two outputs are one file,
/// or would be one on a file system that ignores case; an output is a folder, or its parent is not a folder; or an
/// output exists and is of another kind, unless `force` is set. An existing file of the same kind, or an empty file,
/// may be replaced. Devices and pipes are always accepted. An empty path means that the option was not given. Call this
/// before any input is read.
void checkOutputs(const std::vector<InputFile>& inputs, const std::vector<OutputFile>& outputs, bool force);

/// Throws OutputRefused if two logs of a command are the same file, under any name or link, or identical copies. The
/// same evidence must not count twice, and a log that was fitted cannot serve as a held-out log. Call this before any
/// input is read.
void refuseEqualLogs(const std::vector<InputFile>& logs);

bool isOfKind(const std::string& path, const FileKind& kind);

/// Creates a folder and its parents; returns true if it did not exist. Throws std::runtime_error.
bool makeFolder(const std::string& folder);

/// Returns a folder for the records of a run, so that no earlier run is replaced, and creates it if it is missing. It
/// is `folder` itself, unless this contains one of the files `records` or one of them is being written there. In this
/// case it is a folder with the next free number: run_2 after run_1, NAME_2 after NAME. Throws std::runtime_error if
/// the folder cannot be created.
std::string makeRunFolder(const std::string& folder, const std::vector<std::string>& records);

}  // namespace rubber_suspension::io
