// Judges the evidence of many diagnoses again, with each criterion moved: which verdicts hang on which number.
//
// judge_again [--verdicts | --change SHARE] EVIDENCE [LABEL] ...: files evidence.json of `diagnose --evidence`, each
// followed by the label of its case where there is one. Prints a table in Markdown, a row for each criterion; with
// --verdicts, the verdict of each case as it is.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

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

  bool operator!=(const Answer& other) const { return verdict != other.verdict || effects != other.effects; }
};

struct Criterion {
  const char* name;
  double Criteria::*value;
};

const std::vector<Criterion> kCriteria = {
    {"floor_margin", &Criteria::floor_margin},
    {"insignificant_gap", &Criteria::insignificant_gap},
    {"discretisation", &Criteria::discretisation},
    {"within_noise", &Criteria::within_noise},
    {"share_of_gap_enough", &Criteria::share_of_gap_enough},
    {"trend_penalty", &Criteria::trend_penalty},
    {"shows", &Criteria::shows},
    {"contributes", &Criteria::contributes},
    {"share_left_by_parameters", &Criteria::share_left_by_parameters},
    {"above_noise_by_parameters", &Criteria::above_noise_by_parameters},
    {"share_left_by_elements", &Criteria::share_left_by_elements},
    {"share_left_before_elements", &Criteria::share_left_before_elements},
    {"changed_far", &Criteria::changed_far},
    {"changed_little", &Criteria::changed_little},
    {"hides", &Criteria::hides},
    {"hides_as_specified", &Criteria::hides_as_specified},
    {"family_gain", &Criteria::family_gain},
    {"chance", &Criteria::chance},
    {"needs_another", &Criteria::needs_another},
    {"worth_naming", &Criteria::worth_naming},
    {"unknown", &Criteria::unknown},
    {"partly", &Criteria::partly},
    {"last_resort_left", &Criteria::last_resort_left},
    {"last_resort_of_others", &Criteria::last_resort_of_others},
    {"sharpness", &Criteria::sharpness},
    {"noise_blur", &Criteria::noise_blur},
    {"gap_blur", &Criteria::gap_blur},
    {"set_probability", &Criteria::set_probability},
    {"predicts", &Criteria::predicts},
    {"predicts_clearly_more", &Criteria::predicts_clearly_more},
    {"least_closed_unseen", &Criteria::least_closed_unseen},
    {"little_lost_unseen", &Criteria::little_lost_unseen},
    {"shows_nothing", &Criteria::shows_nothing},
    {"unconfirmed_is_noise", &Criteria::unconfirmed_is_noise},
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

Answer answer(const Case& known, const Criteria& criteria) {
  const Judgement judgement = judge(known.named.evidence, criteria);
  if (judgement.missing) {
    throw std::runtime_error(known.path + ": lacks errors on unseen logs; was it made with --evidence?");
  }
  Answer result{toString(judgement.verdict), {}};
  for (const int effect : judgement.effects) {
    result.effects.push_back(known.named.effects.at(static_cast<std::size_t>(effect)));
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

int run(std::vector<std::string> arguments) {
  double change = 0.3;
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
