// The files that a command may write over: the one rule for every file that a command or a launch file writes.
#include "io/output_files.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>

#include "log/new_file.h"
#include "log/text.h"

namespace rubber_suspension::io {
namespace {

namespace fs = std::filesystem;

// A kind of file is told by how it begins, or by a text among its first bytes.
struct KindInfo {
  FileKind kind;
  const char* name;
  std::vector<std::string> beginnings;
  std::vector<std::string> contents;  // of which one has to be there; none: the beginning is enough
};

const KindInfo& infoOf(FileKind kind) {
  static const std::vector<KindInfo> table = {
      {FileKind::force_csv,
       "a log as this command writes it (time_s,displacement_m,force_N)",
       {"time_s,displacement_m\n", "time_s,displacement_rad\n", "time_s,displacement_m,force_N\n",
        "time_s,x_m,y_m,z_m,rx_rad,"},
       {}},
      {FileKind::gap_csv, "a record of the live gap", {"time_s,level,"}, {}},
      {FileKind::vehicle_csv, "a record of a vehicle", {"time_s,frame_m,"}, {}},
      {FileKind::figure_csv, "the numbers of a figure", {"curve,"}, {}},
      {FileKind::component_file, "a component file", {""}, {"components:"}},
      {FileKind::report_json,
       "a report of a diagnosis",
       {"{"},
       {"rubber_suspension/gap_report/", "rubber_suspension/evidence/"}},
      {FileKind::report_html, "a report of a diagnosis", {"<!DOCTYPE html>", "<!doctype html>"}, {"Gap report"}},
      {FileKind::plan_json, "a plan of experiments", {"{"}, {"rubber_suspension/experiment_plan/"}},
      {FileKind::plan_html, "a plan of experiments", {"<!DOCTYPE html>", "<!doctype html>"}, {"Experiment plan"}},
      {FileKind::test_report, "a report of a test", {"<?xml", "<testsuite"}, {"<testsuite"}},
      {FileKind::figure, "a figure (SVG, PNG, PDF)", {"<?xml", "<svg", "\x89PNG", "%PDF"}, {"<svg", "\x89PNG", "%PDF"}},
      {FileKind::bag, "a ROS bag", {"#ROSBAG V"}, {}},
      {FileKind::campaign_manifest, "the manifest of a campaign", {"{\"schema\":\"rubber_suspension/campaign/"}, {}},
      {FileKind::campaign_csv, "a table of a campaign", {"id,group,type,"}, {}},
      {FileKind::campaign_json, "a table of a campaign", {"{"}, {"rubber_suspension/campaign_table/"}},
      {FileKind::fleet_json, "the findings on a fleet", {"{"}, {"rubber_suspension/fleet/"}},
      {FileKind::fleet_report, "a fleet report", {"<!DOCTYPE html>", "<!doctype html>"}, {"Fleet report"}},
      {FileKind::force_map_csv,
       "a map of the missing force",
       {"displacement_m,velocity_m_per_s,", "displacement_rad,velocity_rad_per_s,"},
       {}},
      {FileKind::fmu, "an FMU", {"PK\x03\x04"}, {"modelDescription.xml"}},
      {FileKind::characteristics_csv, "a table of characteristics", {"frequency_Hz,amplitude_m,"}, {}},
      {FileKind::bushing_file, "a bushing property file", {"$", "["}, {"'bus'", "'gbs'"}},
      {FileKind::state_space_json, "a state-space model", {"{"}, {"rubber_suspension/state_space/"}},
      {FileKind::mat, "a state-space model", {"rubber_suspension"}, {}},
      {FileKind::spring_and_dashpot, "k and c of a component", {"# "}, {"\nk_N_per_m: "}},
      {FileKind::rpc, "a file of RPC III", {std::string("FORMAT\0", 7)}, {}},
      {FileKind::agreement_json, "an agreement of forces", {"{"}, {"rubber_suspension/agreement/"}},
  };
  return table[static_cast<std::size_t>(kind)];
}

constexpr std::size_t kHead = 64 * 1024;  // bytes that tell the kind; a component file may begin with a long comment

std::string headOf(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(kHead, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

bool holdsLine(const std::string& text, const std::string& start) {
  return log::startsWith(text, start) || text.find("\n" + start) != std::string::npos;
}

std::optional<struct stat> statusOf(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? std::optional<struct stat>(status) : std::nullopt;
}

// Existing files are one by device and number, whatever their names; those to come by their names, of which a file
// system may not tell the case.
bool areOneFile(const std::string& one, const std::string& other) {
  const auto first = statusOf(one);
  const auto second = statusOf(other);
  if (first && second) {
    return first->st_dev == second->st_dev && first->st_ino == second->st_ino;
  }
  return !first && !second && log::lowerCase(log::followedPath(one)) == log::lowerCase(log::followedPath(other));
}

[[noreturn]] void refuse(const std::string& reason) { throw OutputRefused(log::oneLine(reason)); }

void refuseInput(const OutputFile& output, const std::vector<InputFile>& inputs) {
  for (const InputFile& input : inputs) {
    if (!input.path.empty() && areOneFile(output.path, input.path)) {
      refuse(fmt::format("{}: {} is the file that {} reads{}; accepted: another file", output.option, output.path,
                         input.option, output.path == input.path ? "" : ", " + input.path));
    }
  }
}

void refuseTwin(const OutputFile& output, const OutputFile& other) {
  if (!other.path.empty() && !log::isStream(other.path) && areOneFile(output.path, other.path)) {
    refuse(fmt::format("{} and {}: {} is one file{}; accepted: one for each", output.option, other.option, output.path,
                       output.path == other.path ? "" : " with " + other.path));
  }
}

void refusePlace(const OutputFile& output) {
  const auto status = statusOf(output.path);
  if (status && S_ISDIR(status->st_mode)) {
    refuse(fmt::format("{}: {} is a folder; accepted: a file", output.option, output.path));
  }
  const std::string parent = fs::path(log::followedPath(output.path)).parent_path().string();
  const auto folder = statusOf(parent);
  if (folder && !S_ISDIR(folder->st_mode)) {
    refuse(fmt::format("{}: {} is no folder; accepted: a folder", output.option, parent));
  }
}

void refuseOtherKind(const OutputFile& output) {
  const auto status = statusOf(output.path);
  if (status && status->st_size > 0 && !isOfKind(output.path, output.kind)) {
    refuse(fmt::format("{}: {} exists and is not {}; accepted: another name, or --force to replace it", output.option,
                       output.path, infoOf(output.kind).name));
  }
}

// Records stand there, or are being written beside their names.
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

// "run_1" is "run_" and 1, "bush" is "bush_" and 1.
std::pair<std::string, unsigned long> numberedName(const std::string& folder) {
  constexpr std::size_t kMostDigits = 9;
  const std::size_t bar = folder.find_last_of('_');
  const std::string digits = bar == std::string::npos ? "" : folder.substr(bar + 1);
  const bool numbered =
      !digits.empty() && digits.size() <= kMostDigits && digits.find_first_not_of("0123456789") == std::string::npos;
  return numbered ? std::pair(folder.substr(0, bar + 1), std::stoul(digits)) : std::pair(folder + "_", 1UL);
}

[[noreturn]] void failToMake(const std::string& folder, const std::string& reason) {
  throw std::runtime_error(fmt::format("{}: cannot be made: {}", folder, reason));
}

// Of regular files alone: a pipe can be read once.
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

}  // namespace

bool isOfKind(const std::string& path, FileKind kind) {
  const KindInfo& info = infoOf(kind);
  const std::string head = headOf(path);
  const auto begins = [&](const std::string& beginning) { return log::startsWith(head, beginning); };
  const auto holds = [&](const std::string& content) {
    return kind == FileKind::component_file ? holdsLine(head, content) : head.find(content) != std::string::npos;
  };
  return std::any_of(info.beginnings.begin(), info.beginnings.end(), begins) &&
         (info.contents.empty() || std::any_of(info.contents.begin(), info.contents.end(), holds));
}

void checkOutputs(const std::vector<InputFile>& inputs, const std::vector<OutputFile>& outputs, bool force) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const OutputFile& output = outputs[i];
    if (output.path.empty() || log::isStream(output.path)) {
      continue;
    }
    refuseInput(output, inputs);
    for (std::size_t j = 0; j < i; ++j) {
      refuseTwin(output, outputs[j]);
    }
    refusePlace(output);
    if (!force) {
      refuseOtherKind(output);
    }
  }
}

void refuseEqualLogs(const std::vector<InputFile>& logs) {
  for (std::size_t i = 0; i < logs.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      std::error_code ignored;
      const bool same = fs::equivalent(logs[i].path, logs[j].path, ignored);
      if (same || isCopy(logs[i].path, logs[j].path)) {
        throw OutputRefused(fmt::format("{}: {} is {} as {} {}; accepted: each log once", logs[i].option, logs[i].path,
                                        same ? "the same file" : "the same to the last byte", logs[j].option,
                                        logs[j].path));
      }
    }
  }
}

bool makeFolder(const std::string& folder) {
  std::error_code error;
  const bool made = fs::create_directories(folder, error);
  if (error) {
    failToMake(folder, error.message());
  }
  return made;
}

std::string makeRunFolder(const std::string& folder, const std::vector<std::string>& records) {
  fs::path base(folder);
  base = base.has_filename() ? base : base.parent_path();  // without a slash at the end
  std::error_code error;
  fs::create_directories(base, error);
  if (error) {
    failToMake(folder, error.message());
  }
  if (!holdsRecord(base, records)) {
    return base.string();
  }
  const auto [name, number] = numberedName(base.string());
  for (unsigned long next = number + 1;; ++next) {
    std::string path = name + std::to_string(next);
    if (mkdir(path.c_str(), 0777) == 0) {  // one run alone succeeds in it
      return path;
    }
    if (errno != EEXIST) {
      failToMake(path, std::strerror(errno));
    }
    if (fs::is_directory(path, error) && !holdsRecord(path, records)) {
      return path;
    }
  }
}

}  // namespace rubber_suspension::io
