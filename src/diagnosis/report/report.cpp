// Writes the files of the report, including the numbers of its figures.
#include <fmt/format.h>

#include <algorithm>
#include <boost/algorithm/string/classification.hpp>
#include <boost/algorithm/string/replace.hpp>
#include <boost/algorithm/string/trim.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <regex>
#include <utility>
#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/evidence_json.h"
#include "diagnosis/report/augmented_yaml.h"
#include "diagnosis/report/report_figures.h"
#include "io/output_files.h"
#include "io/page.h"
#include "log/new_file.h"
#include "log/rpc_log.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr const char* kExperiment = "next_experiment.csv";
constexpr const char* kDrive = "next_experiment.drv";
constexpr const char* kComponent = "augmented.yaml";
constexpr const char* kFullComponent = "augmented_full.yaml";
constexpr const char* kSurrogate = "surrogate.yaml";
constexpr const char* kMissingForce = "missing_force.csv";
constexpr const char* kEvidence = "evidence.json";
constexpr const char* kReport = "report.json";
constexpr const char* kPage = "report.html";

// Files that are not yet in place, so that an older report stays until this one is complete. A signal deletes them.
class NewReport {
 public:
  explicit NewReport(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void write(const std::string& name, const std::string& text) {
    files_.emplace_back(name, std::make_unique<log::NewFile>((folder_ / name).string()));
    files_.back().second->write(text);
  }

  // Removes files of an earlier report that this report lacks, because they would seem to belong to this report. The
  // caller has checked that the package wrote these files. The page is removed first, because it refers to the other
  // files.
  void commit() {
    io::removePage((folder_ / kPage).string());
    for (const std::string& name : reportFiles()) {
      if (std::none_of(files_.begin(), files_.end(), [&](const auto& file) { return file.first == name; })) {
        std::error_code failure;
        std::filesystem::remove(folder_ / name, failure);
      }
    }
    for (const auto& [name, file] : files_) {
      file->commit();
    }
  }

 private:
  std::filesystem::path folder_;
  std::vector<std::pair<std::string, std::unique_ptr<log::NewFile>>> files_;
};

std::string experimentCsv(const ProposedExperiment& experiment, bool turns) {
  std::string text = turns ? "time_s,displacement_rad\n" : "time_s,displacement_m\n";
  for (std::size_t i = 0; i < experiment.displacement.size(); ++i) {
    text += fmt::format("{:.9f},{:.9g}\n", static_cast<double>(i) * experiment.dt, experiment.displacement[i]);
  }
  return text;
}

// Returns a drive file for rigs of MTS and Instron, in the unit that these rigs use.
std::string driveFile(const ProposedExperiment& experiment, bool turns) {
  log::RpcChannel channel{"displacement", turns ? "rad" : "mm", experiment.displacement};
  for (double& z : channel.values) {
    z *= turns ? 1.0 : 1e3;
  }
  return log::rpcFile(experiment.dt, {channel});
}

// Returns a column name: "displacement_mm" for "displacement [mm]", "gap" for "gap [-]".
std::string columnOf(const std::string& label) {
  const std::string joined = std::regex_replace(label, std::regex("[^A-Za-z0-9]+"), "_");
  const std::string name = boost::trim_copy_if(joined, boost::is_any_of("_"));
  return name.empty() ? "value" : name;
}

std::string quoted(const std::string& text) {
  return '"' + boost::replace_all_copy(boost::replace_all_copy(text, "\"", "\"\""), "\n", " ") + '"';
}

std::string curveRows(const io::Axes& axes) {
  std::string rows;
  for (const io::Curve& curve : axes.curves) {
    const std::string beginning = quoted(curve.label) + "," + quoted(axes.title);
    for (std::size_t i = 0; i < curve.x.size(); ++i) {
      if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) {
        rows += fmt::format("{},{:.9g},{:.9g}\n", beginning, curve.x[i], curve.y[i]);
      }
    }
  }
  return rows;
}

std::string mapRows(const io::Axes& axes) {
  std::string rows;
  for (const io::HeatMap& map : axes.maps) {
    const std::size_t width = map.x_edges.size() - 1;
    for (std::size_t i = 0; i < map.values.size(); ++i) {
      const std::size_t x = i % width;
      const std::size_t y = i / width;
      if (std::isfinite(map.values[i])) {
        rows += fmt::format("{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", quoted(map.label), quoted(axes.title),
                            map.x_edges[x], map.x_edges[x + 1], map.y_edges[y], map.y_edges[y + 1], map.values[i]);
      }
    }
  }
  return rows;
}

// Returns a table with one line for each cell that has enough samples.
std::string missingForceCsv(const MissingForce& map, bool turns) {
  std::string text = turns ? "displacement_rad,velocity_rad_per_s,missing_moment_N_m,surrogate_moment_N_m,samples\n"
                           : "displacement_m,velocity_m_per_s,missing_force_N,surrogate_force_N,samples\n";
  for (std::size_t cell = 0; cell < map.samples.size(); ++cell) {
    if (std::isnan(map.measured[cell])) {
      continue;
    }
    const std::size_t width = map.displacement.size() - 1;
    const std::size_t x = cell % width;
    const std::size_t y = cell / width;
    text += fmt::format("{:.6g},{:.6g},{:.6g},{:.6g},{}\n", 0.5 * (map.displacement[x] + map.displacement[x + 1]),
                        0.5 * (map.velocity[y] + map.velocity[y + 1]), map.measured[cell], map.surrogate[cell],
                        map.samples[cell]);
  }
  return text;
}

}  // namespace

std::string evidenceJson(const Diagnosis& diagnosis) {
  const bool wanted = diagnosis.workings && diagnosis.workings->write_evidence;
  return wanted ? judge::toJson(diagnosis.workings->evidence) : "";
}

std::vector<std::string> reportFiles() {
  std::vector<std::string> names = {kReport, kComponent, kFullComponent, kExperiment,
                                    kDrive,  kSurrogate, kMissingForce,  kEvidence};
  const std::vector<std::string> figures = report::figureDataFiles();
  names.insert(names.end(), figures.begin(), figures.end());
  names.emplace_back(kPage);
  return names;
}

std::string writeReport(const Diagnosis& diagnosis, const std::string& folder) {
  writeReportData(diagnosis, folder);
  return io::renderPage((std::filesystem::path(folder) / kReport).string());
}

void writeReportData(const Diagnosis& diagnosis, const std::string& folder) {
  io::makeFolder(folder);
  NewReport report(folder);
  report.write(kReport, toJson(diagnosis));
  if (hasComponentFile(diagnosis)) {
    report.write(kComponent, report::augmentedYaml(diagnosis));
  }
  if (diagnosis.write_full_law && hasComponentFile(diagnosis)) {
    report.write(kFullComponent, report::fullYaml(diagnosis));
  }
  if (diagnosis.surrogate) {
    report.write(kSurrogate, io::toYaml({diagnosis.surrogate->component}));
    report.write(kMissingForce, missingForceCsv(diagnosis.surrogate->missing, diagnosis.turns));
  }
  if (const std::string evidence = evidenceJson(diagnosis); !evidence.empty()) {
    report.write(kEvidence, evidence);
  }
  if (!diagnosis.next.proposed.displacement.empty()) {
    report.write(kExperiment, experimentCsv(diagnosis.next.proposed, diagnosis.turns));
    report.write(kDrive, driveFile(diagnosis.next.proposed, diagnosis.turns));
  }
  for (const report::ReportFigure& figure : report::reportFigures(diagnosis)) {
    if (!figure.figure.axes.empty()) {
      report.write(report::figureDataFile(figure.name), report::figureCsv(figure.figure));
    }
  }
  report.commit();
}

std::string report::figureCsv(const io::Figure& figure) {
  if (figure.axes.empty()) {
    return "curve,panel\n";
  }
  const io::Axes& first = figure.axes.front();
  const std::string x = columnOf(first.x_label);
  const std::string y = columnOf(first.y_label);
  std::string text = first.maps.empty() ? fmt::format("curve,panel,{},{}\n", x, y)
                                        : fmt::format("curve,panel,{0}_low,{0}_high,{1}_low,{1}_high,value\n", x, y);
  for (const io::Axes& axes : figure.axes) {
    text += first.maps.empty() ? curveRows(axes) : mapRows(axes);
  }
  return text;
}

}  // namespace rubber_suspension::diagnosis
