// Judges the evidence of many diagnoses again, with each criterion moved: which verdicts hang on which number.
//
// judge_again [--verdicts | --change SHARE | --calibrate] EVIDENCE [LABEL] ...: files evidence.json of
// `diagnose --evidence`, each followed by the label of its case where there is one; or, in their place,
// --campaign FOLDER --labels FOLDER ...: all cases of these folders of labels, SET_labels, in a campaign over a jobs
// file of as_campaign.py. Prints a table in Markdown, a row for each criterion; with --verdicts, the verdict of each
// case as it is; with --calibrate, also whether stated probabilities are true, and the weights of the probabilities at
// which the truth would have been most probable.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "campaign/manifest.h"
#include "diagnosis/judge/evidence_json.h"
#include "diagnosis/judge/judge.h"

namespace {

using namespace rubber_suspension::diagnosis;

struct Label {
  std::string kind;
  std::vector<std::string> effects;
};

struct Case {
  std::string path;
  NamedEvidence named;
  std::optional<Label> label;
};

struct Answer {
  std::string verdict;
  std::vector<std::string> effects;
  double stated = 0.0;    // probability of the first effect, or of a verdict without one
  double of_truth = 0.0;  // probability of what the label says

  bool operator!=(const Answer& other) const { return verdict != other.verdict || effects != other.effects; }
};

struct Criterion {
  const char* name;
  double Criteria::*value;
};

const std::vector<Criterion> kCriteria = {
    {"floor_margin", &Criteria::floor_margin},
    {"insignificant_gap", &Criteria::insignificant_gap},
    {"within_noise", &Criteria::within_noise},
    {"share_left_before_elements", &Criteria::share_left_before_elements},
    {"changed_little", &Criteria::changed_little},
    {"chance", &Criteria::chance},
    {"needs_another", &Criteria::needs_another},
    {"clearly_less", &Criteria::clearly_less},
    {"unknown", &Criteria::unknown},
    {"partly", &Criteria::partly},
    {"larger_part", &Criteria::larger_part},
    {"sharpness", &Criteria::sharpness},
    {"noise_blur", &Criteria::noise_blur},
    {"gap_blur", &Criteria::gap_blur},
    {"set_probability", &Criteria::set_probability},
    {"shows_nothing", &Criteria::shows_nothing},
    {"beyond_noise", &Criteria::beyond_noise},
    {"beyond_noise_of_floor", &Criteria::beyond_noise_of_floor},
};

std::string textOf(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    throw std::runtime_error(path + ": cannot be read");
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::vector<Case> readCases(const std::vector<std::string>& paths) {
  std::vector<Case> cases;
  for (const std::string& path : paths) {
    const std::string text = textOf(path);
    const auto value = nlohmann::json::parse(text);
    if (value.contains("schema")) {
      cases.push_back({path, parseEvidence(text), std::nullopt});
    } else if (!cases.empty()) {
      cases.back().label = {value.at("kind").get<std::string>(), value.at("effects").get<std::vector<std::string>>()};
    } else {
      throw std::invalid_argument(path + ": a label without evidence before it");
    }
  }
  return cases;
}

// The first true effect among the candidates, or the answer that needs none.
double probabilityOf(const Label& label, const Case& known, const Judgement& judgement) {
  if (label.kind == "unknown") {
    return judgement.posterior.none_of_these;
  }
  if (label.effects.empty()) {
    return label.kind == "none" ? judgement.posterior.none : judgement.posterior.parameter_error;
  }
  const auto& names = known.named.effects;
  const auto found = std::find(names.begin(), names.end(), label.effects.front());
  return found == names.end()
             ? 0.0
             : judgement.probabilities.at(static_cast<std::size_t>(std::distance(names.begin(), found)));
}

double probabilityOfVerdict(const Judgement& judgement) {
  switch (judgement.verdict) {
    case Verdict::none:
      return judgement.posterior.none;
    case Verdict::parameter_error:
      return judgement.posterior.parameter_error;
    default:
      return judgement.posterior.none_of_these;
  }
}

Answer answer(const Case& known, const Criteria& criteria) {
  const Judgement judgement = judge(known.named.evidence, criteria);
  Answer result;
  result.verdict = toString(judgement.verdict);
  for (const int effect : judgement.effects) {
    result.effects.push_back(known.named.effects.at(static_cast<std::size_t>(effect)));
  }
  result.stated = judgement.effects.empty()
                      ? probabilityOfVerdict(judgement)
                      : judgement.probabilities.at(static_cast<std::size_t>(judgement.effects.front()));
  if (known.label) {
    result.of_truth = probabilityOf(*known.label, known, judgement);
  }
  return result;
}

bool isRight(const Label& label, const Answer& given) {
  if (label.kind == "single") {
    return !given.effects.empty() && given.effects.front() == label.effects.front();
  }
  if (label.kind == "unknown") {
    return given.verdict == "unknown" || given.verdict == "partly";
  }
  if (label.effects.empty()) {
    return given.verdict == label.kind;
  }
  return std::is_permutation(label.effects.begin(), label.effects.end(), given.effects.begin(), given.effects.end());
}

// "3 (+1 -2)": verdicts that change, of which so many become right and so many wrong.
std::string changes(const std::vector<Case>& cases, const std::vector<Answer>& before, const Criteria& criteria) {
  int changed = 0;
  int better = 0;
  int worse = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Answer after = answer(cases[i], criteria);
    if (after != before[i]) {
      ++changed;
      const bool was = cases[i].label && isRight(*cases[i].label, before[i]);
      const bool is = cases[i].label && isRight(*cases[i].label, after);
      better += !was && is ? 1 : 0;
      worse += was && !is ? 1 : 0;
    }
  }
  return changed == 0 ? "0" : fmt::format("{} (+{} -{})", changed, better, worse);
}

// An effect that is named counts as right if it is one of those of the rig.
bool isTrue(const Label& label, const Answer& given) {
  if (given.effects.empty()) {
    return isRight(label, given);
  }
  return std::find(label.effects.begin(), label.effects.end(), given.effects.front()) != label.effects.end();
}

void printReliability(const std::vector<Case>& cases, const std::vector<Answer>& answers) {
  constexpr std::array kLimits = {0.0, 0.5, 0.8, 0.95, 0.99, 1.0 + 1e-9};
  std::cout << "\n| stated | cases | mean stated | right |\n|---|---|---|---|\n";
  for (std::size_t bin = 0; bin + 1 < kLimits.size(); ++bin) {
    int count = 0;
    int right = 0;
    double stated = 0.0;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (cases[i].label && answers[i].stated >= kLimits[bin] && answers[i].stated < kLimits[bin + 1]) {
        ++count;
        right += isTrue(*cases[i].label, answers[i]) ? 1 : 0;
        stated += answers[i].stated;
      }
    }
    if (count > 0) {
      std::cout << fmt::format("| {} to {:.2g} | {} | {:.2f} | {:.2f} |\n", kLimits[bin], kLimits[bin + 1], count,
                               stated / count, static_cast<double>(right) / count);
    }
  }
}

// Logarithms of the probability of the truth. One that a test refuted is far below; it must not outweigh all others.
std::vector<double> scores(const std::vector<Case>& cases, const Criteria& criteria) {
  constexpr double kLeast = 1e-3;
  std::vector<double> result;
  for (const Case& known : cases) {
    if (known.label) {
      result.push_back(std::log(std::max(answer(known, criteria).of_truth, kLeast)));
    }
  }
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) {
    sum += value;
  }
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

struct Gain {
  double mean = 0.0;
  double error = 0.0;  // standard error, by cases
};

Gain gainOf(const std::vector<double>& before, const std::vector<double>& after) {
  std::vector<double> differences;
  std::transform(after.begin(), after.end(), before.begin(), std::back_inserter(differences), std::minus<>());
  const double middle = mean(differences);
  double squares = 0.0;
  for (const double difference : differences) {
    squares += (difference - middle) * (difference - middle);
  }
  const auto count = static_cast<double>(differences.size());
  return {middle, count > 1.0 ? std::sqrt(squares / (count - 1.0) / count) : 0.0};
}

// Step by step to the weights at which the truth is most probable, each step one weight by a factor.
Criteria mostLikely(const std::vector<Case>& cases, const std::vector<double Criteria::*>& weights) {
  Criteria best;
  double score = mean(scores(cases, best));
  for (double factor = 2.0; factor > 1.05; factor = std::sqrt(factor)) {
    for (bool found = true; found;) {
      found = false;
      for (const auto weight : weights) {
        for (const double step : {factor, 1.0 / factor}) {
          Criteria moved = best;
          moved.*weight *= step;
          const bool within = moved.*weight > 0.05 * Criteria().*weight && moved.*weight < 20.0 * Criteria().*weight;
          const double moved_score = within ? mean(scores(cases, moved)) : score;
          if (moved_score > score) {
            best = moved;
            score = moved_score;
            found = true;
          }
        }
      }
    }
  }
  return best;
}

void printWeights(const std::vector<Case>& cases) {
  const std::vector<double Criteria::*> weights = {&Criteria::sharpness, &Criteria::noise_blur, &Criteria::gap_blur};
  const std::vector<double> before = scores(cases, {});
  const Criteria best = mostLikely(cases, weights);
  const Gain gain = gainOf(before, scores(cases, best));
  std::cout << "\n| weight | value | most likely here |\n|---|---|---|\n";
  for (const Criterion& criterion : kCriteria) {
    if (std::find(weights.begin(), weights.end(), criterion.value) != weights.end()) {
      std::cout << fmt::format("| `{}` | {:g} | {:.3g} |\n", criterion.name, Criteria().*criterion.value,
                               best.*criterion.value);
    }
  }
  std::cout << fmt::format(
      "\nMean logarithm of the probability of the truth: {:.3f}; with the most likely weights {:+.3f} "
      "(standard error {:.3f}), on the cases that they were fitted to.\n",
      mean(before), gain.mean, gain.error);
}

// Evidence and labels of a campaign, in the order that readCases() takes. SET_labels/CASE.json goes with the job
// SET_CASE.
std::vector<std::string> pathsOfCampaign(const std::string& folder, const std::vector<std::string>& label_folders) {
  namespace fs = std::filesystem;
  namespace campaign = rubber_suspension::campaign;
  const campaign::Manifest manifest = campaign::readManifest(folder);
  std::vector<std::string> paths;
  for (const std::string& labels : label_folders) {
    const std::string name = fs::path(labels + "/").lexically_normal().parent_path().filename().string();
    const std::string prefix = name.substr(0, name.rfind("_labels")) + "_";
    for (const campaign::Job& job : manifest.jobs) {
      const std::string label = labels + "/" + job.group.substr(std::min(prefix.size(), job.group.size())) + ".json";
      if (job.group.compare(0, prefix.size(), prefix) == 0 && fs::exists(label)) {
        paths.push_back(folder + "/" + campaign::reportFolder(job.id) + "/evidence.json");
        paths.push_back(label);
        if (!fs::exists(paths[paths.size() - 2])) {  // failed, or logs that cannot be what they say
          std::cerr << "judge_again: " << job.group << " left no evidence\n";
          paths.resize(paths.size() - 2);
        }
      }
    }
  }
  return paths;
}

// --campaign and --labels, replaced by the files that they stand for.
std::vector<std::string> expanded(const std::vector<std::string>& arguments) {
  std::vector<std::string> rest;
  std::vector<std::string> labels;
  std::string folder;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const bool has_value = i + 1 < arguments.size();
    if (arguments[i] == "--campaign" && has_value) {
      folder = arguments[++i];
    } else if (arguments[i] == "--labels" && has_value) {
      labels.push_back(arguments[++i]);
    } else {
      rest.push_back(arguments[i]);
    }
  }
  if (!folder.empty()) {
    const std::vector<std::string> paths = pathsOfCampaign(folder, labels);
    rest.insert(rest.end(), paths.begin(), paths.end());
  }
  return rest;
}

int run(std::vector<std::string> arguments) {
  arguments = expanded(arguments);
  double change = 0.3;
  const bool calibrate = !arguments.empty() && arguments.front() == "--calibrate";
  if (calibrate) {
    arguments.erase(arguments.begin());
  }
  const bool verdicts = !arguments.empty() && arguments.front() == "--verdicts";
  if (verdicts) {
    arguments.erase(arguments.begin());
  } else if (arguments.size() > 1 && arguments.front() == "--change") {
    change = std::stod(arguments[1]);
    arguments.erase(arguments.begin(), arguments.begin() + 2);
  }
  const std::vector<Case> cases = readCases(arguments);
  std::vector<Answer> before;
  int right = 0;
  int labelled = 0;
  for (const Case& known : cases) {
    before.push_back(answer(known, {}));
    labelled += known.label ? 1 : 0;
    right += known.label && isRight(*known.label, before.back()) ? 1 : 0;
  }
  if (verdicts) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
      std::cout << fmt::format("{}: {} {}\n", cases[i].path, before[i].verdict, fmt::join(before[i].effects, ", "));
    }
    return 0;
  }
  std::cout << fmt::format("{} cases, {} of {} right\n\n", cases.size(), right, labelled);
  std::cout << fmt::format("| criterion | value | times {:.2g} | times {:.2g} |\n|---|---|---|---|\n", 1.0 - change,
                           1.0 + change);
  for (const Criterion& criterion : kCriteria) {
    Criteria less;
    Criteria more;
    less.*criterion.value *= 1.0 - change;
    more.*criterion.value *= 1.0 + change;
    if (criterion.value == &Criteria::set_probability) {  // a probability: its complement is moved
      more.set_probability = 1.0 - (1.0 - change) * (1.0 - Criteria().set_probability);
    }
    std::cout << fmt::format("| `{}` | {:g} | {} | {} |\n", criterion.name, Criteria().*criterion.value,
                             changes(cases, before, less), changes(cases, before, more));
  }
  if (calibrate) {
    printReliability(cases, before);
    printWeights(cases);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  } catch (const std::exception& error) {
    std::cerr << "judge_again: " << error.what() << "\n";
    return 1;
  }
}
