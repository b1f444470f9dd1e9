// Reads cases and decides whether answers are right.
#include "judged_case.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "judge/read_evidence.h"

namespace rubber_suspension::blind_trial {
namespace {

namespace fs = std::filesystem;
using diagnosis::Verdict;
using diagnosis::judge::Evidence;
using diagnosis::judge::LogEvidence;

std::string textOf(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(path.string() + ": cannot be read");
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

bool has(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool areAll(const std::vector<std::string>& names, const std::vector<std::string>& wanted) {
  return std::all_of(wanted.begin(), wanted.end(), [&](const std::string& name) { return has(names, name); });
}

// Label in rigs by other authors for an effect that was not in the list then, and the present name of the effect.
constexpr std::pair<const char*, const char*> kListedSince = {"hydraulic_resonance", "fluid_inertia"};

Truth truthOf(const nlohmann::json& label) {
  constexpr double kSmallGap = 0.035;
  Truth truth;
  truth.kind = label.at("kind").get<std::string>();
  truth.effects = label.at("effects").get<std::vector<std::string>>();
  truth.also = label.value("also", std::vector<std::string>{});
  truth.unlisted = label.contains("unknown") && !label.at("unknown").is_null();
  if (truth.unlisted && label.at("unknown") == kListedSince.first) {
    truth.effects.emplace_back(kListedSince.second);
    truth.kind = truth.effects.size() == 1 ? "single" : "pair";
    truth.unlisted = false;
  }
  const double gap = label.contains("gap") ? label.at("gap").value("wanted", 0.0) : 0.0;
  truth.small = truth.kind == "single" && gap > 0.0 && gap < kSmallGap;
  truth.bench = label.contains("bench") && label.at("bench") != "clean";
  return truth;
}

TrialCase caseOf(const fs::path& folder, const fs::path& label, const fs::path& evidence) {
  try {
    TrialCase result{(folder.filename() / label.stem()).string(), folder.parent_path().filename().string(),
                     truthOf(nlohmann::json::parse(textOf(label))), std::nullopt};
    if (fs::exists(evidence)) {
      result.evidence = diagnosis::parseEvidence(textOf(evidence));
    }
    return result;
  } catch (const nlohmann::json::exception& error) {
    throw std::invalid_argument(label.string() + ": " + error.what());
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(evidence.string() + ": " + error.what());
  }
}

std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

std::string withoutSlash(const std::string& folder) { return folder.substr(0, folder.find_last_not_of('/') + 1); }

}  // namespace

double leftBeyondNoise(const Evidence& evidence, int hypothesis) {
  double left = 0.0;
  double weight = 0.0;
  for (std::size_t l = 0; l < evidence.logs.size(); ++l) {
    const LogEvidence& log = evidence.logs[l];
    const double counts = log.unseen ? 0.0 : log.weight;
    left += counts * (evidence.at(hypothesis).log_errors.at(l) - log.floor * log.floor);
    weight += counts;
  }
  return std::sqrt(std::max(0.0, left / weight));
}

bool TrialCase::isHidden() const {
  constexpr double kHidden = 0.007;  // relative to the force
  return !truth.effects.empty() && evidence && leftBeyondNoise(*evidence, Evidence::kReEstimated) < kHidden;
}

bool TrialCase::isRight(const Said& said) const {
  const bool names_something = !said.effects.empty();
  if (truth.kind == "machine") {
    return names_something && has(truth.effects, said.effects.front()) && !namesTooMuch(said);
  }
  if (isHidden() && said.verdict == Verdict::parameter_error) {
    return true;
  }
  // A linear model with a series spring is again a linear model, so other values explain it.
  if (truth.effects == std::vector<std::string>{"series_compliance"} && !truth.unlisted &&
      (said.verdict == Verdict::parameter_error || said.verdict == Verdict::confounded)) {
    return true;
  }
  if (truth.unlisted && truth.effects.empty()) {
    return said.verdict == Verdict::unknown || said.verdict == Verdict::partly;
  }
  if (truth.unlisted) {
    return said.verdict == Verdict::partly &&
           std::any_of(said.effects.begin(), said.effects.end(),
                       [&](const std::string& effect) { return has(truth.effects, effect); });
  }
  if (truth.effects.empty()) {
    return said.verdict == Verdict::parameter_error || (truth.kind == "none" && said.verdict == Verdict::none);
  }
  const auto count = static_cast<std::ptrdiff_t>(std::min(said.effects.size(), truth.effects.size()));
  return areAll({said.effects.begin(), said.effects.begin() + count}, truth.effects);
}

bool TrialCase::namesTooMuch(const Said& said) const {
  return std::any_of(said.effects.begin(), said.effects.end(), [&](const std::string& effect) {
    return !has(truth.effects, effect) && !has(truth.also, effect);
  });
}

std::string TrialCase::group() const {
  return truth.kind + (truth.small ? ", 3 %" : "") + (truth.bench ? ", as benches are" : "");
}

std::vector<TrialCase> casesOfFolder(const std::string& folder) {
  const std::string stem = withoutSlash(folder);
  if (!fs::is_directory(stem + "_labels")) {
    throw std::runtime_error(stem + "_labels: no such folder; accepted: a folder of cases with its labels beside it");
  }
  std::vector<TrialCase> cases;
  for (const fs::path& label : filesIn(stem + "_labels")) {
    const std::string name = label.stem().string();
    if (fs::exists(stem + "_reports/" + name + "/run.json")) {  // skips cases that are still running
      cases.push_back(caseOf(fs::absolute(stem), label, stem + "_reports/" + name + "/evidence.json"));
    }
  }
  return cases;
}

}  // namespace rubber_suspension::blind_trial
