// The report's files.
#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "diagnosis/hypotheses/workings.h"
#include "diagnosis/judge/evidence_json.h"
#include "diagnosis/report/report_figures.h"
#include "diagnosis/results/missing_force.h"
#include "diagnosis/results/rounding.h"
#include "io/output_files.h"
#include "log/new_file.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr const char* kExperiment = "next_experiment.csv";
constexpr const char* kComponent = "augmented.yaml";
constexpr const char* kFullComponent = "augmented_full.yaml";
constexpr const char* kSurrogate = "surrogate.yaml";
constexpr const char* kMissingForce = "missing_force.csv";
constexpr const char* kEvidence = "evidence.json";
constexpr const char* kPage = "report.html";

// Files that are written, not yet in place: the report is complete or the older one stays. A signal removes them.
class NewReport {
 public:
  explicit NewReport(std::filesystem::path folder) : folder_(std::move(folder)) {}

  void write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_ / name;
    auto file = std::make_unique<log::NewFile>(path.string());
    errno = 0;
    std::ofstream stream(file->writingPath(), std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
      throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno == 0 ? EIO : errno));
    }
    files_.push_back({name, std::move(file)});
  }

  // Files of an earlier report that this one lacks would be taken for part of it. Of these, only what is of the
  // package's own making goes: the caller has checked. The page comes last: it speaks of the others.
  void commit() {
    for (const std::string& name : reportFiles()) {
      if (!has(name)) {
        std::error_code failure;
        std::filesystem::remove(folder_ / name, failure);
      }
    }
    for (const auto& [name, file] : files_) {
      file->commit();
    }
  }

 private:
  bool has(const std::string& name) const {
    for (const auto& [written, file] : files_) {
      if (written == name) {
        return true;
      }
    }
    return false;
  }

  std::filesystem::path folder_;
  std::vector<std::pair<std::string, std::unique_ptr<log::NewFile>>> files_;
};

std::string experimentCsv(const ProposedExperiment& experiment) {
  std::string text = "time_s,displacement_m\n";
  for (std::size_t i = 0; i < experiment.displacement.size(); ++i) {
    text += fmt::format("{:.9f},{:.9g}\n", static_cast<double>(i) * experiment.dt, experiment.displacement[i]);
  }
  return text;
}

}  // namespace

std::string evidenceJson(const Diagnosis& diagnosis) {
  const bool wanted = diagnosis.workings && diagnosis.workings->write_evidence;
  return wanted ? toJson(diagnosis.workings->evidence) : "";
}

std::vector<std::string> reportFiles() {
  std::vector<std::string> names = {"report.json", kComponent,    kFullComponent, kExperiment,
                                    kSurrogate,    kMissingForce, kEvidence};
  const std::vector<std::string> figures = figureDataFiles();
  names.insert(names.end(), figures.begin(), figures.end());
  names.emplace_back(kPage);
  return names;
}

void writeReport(const Diagnosis& diagnosis, const std::string& folder) {
  io::makeFolder(folder);
  NewReport report(folder);
  report.write("report.json", toJson(diagnosis));
  if (diagnosis.workings) {
    report.write(kComponent, augmentedYaml(diagnosis));
  }
  if (diagnosis.write_full_law && diagnosis.workings) {
    report.write(kFullComponent, fullYaml(diagnosis));
  }
  if (diagnosis.surrogate) {
    report.write(kSurrogate, io::toYaml({diagnosis.surrogate->component}));
    report.write(kMissingForce, toCsv(missingForce(diagnosis)));
  }
  if (const std::string evidence = evidenceJson(diagnosis); !evidence.empty()) {
    report.write(kEvidence, evidence);
  }
  if (!diagnosis.proposed.displacement.empty()) {
    report.write(kExperiment, experimentCsv(diagnosis.proposed));
  }
  for (const ReportFigure& figure : reportFigures(diagnosis)) {
    if (!figure.figure.axes.empty()) {
      report.write(figureDataFile(figure.name), figureCsv(figure.figure));
    }
  }
  report.write(kPage, toHtml(diagnosis));
  report.commit();
}

}  // namespace rubber_suspension::diagnosis
