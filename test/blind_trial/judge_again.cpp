// Judges the evidence of many diagnoses again: both judges side by side, the fit of the numbers of the judgement by
// posterior, and which verdicts of the judgement by criteria hang on which number.
//
// Cases are folders FOLDER with FOLDER_labels and FOLDER_reports beside them, as `generate.py` and `run.py --evidence`
// leave them, or those of a campaign that folders of labels have labels of.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <ctime>
#include <exception>
#include <fstream>
#include <functional>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "calibration.h"
#include "diagnosis/judge/answer.h"
#include "judged_case.h"

namespace rubber_suspension::blind_trial {
namespace {

using diagnosis::Criteria;
using diagnosis::JudgeNumbers;
using diagnosis::NamedEvidence;

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

std::vector<std::string> namesOf(const std::vector<int>& effects, const NamedEvidence& named) {
  std::vector<std::string> names;
  std::transform(effects.begin(), effects.end(), std::back_inserter(names),
                 [&](int effect) { return named.effects.at(static_cast<std::size_t>(effect)); });
  return names;
}

double probabilityOfVerdict(const diagnosis::Judgement& judgement) {
  switch (judgement.verdict) {
    case diagnosis::Verdict::none:
      return judgement.posterior.none;
    case diagnosis::Verdict::parameter_error:
      return judgement.posterior.parameter_error;
    default:
      return judgement.posterior.none_of_these;
  }
}

const Said kNothing = {"check_bench", {}, 0.0};  // the diagnosis refused the logs, or failed

Said byCriteria(const TrialCase& known, const Criteria& criteria) {
  if (!known.named) {
    return kNothing;
  }
  const diagnosis::Judgement judgement = judge(known.named->evidence, criteria);
  const double stated = judgement.effects.empty()
                            ? probabilityOfVerdict(judgement)
                            : judgement.probabilities.at(static_cast<std::size_t>(judgement.effects.front()));
  return {toString(judgement.verdict), namesOf(judgement.effects, *known.named), stated};
}

Said byPosterior(const TrialCase& known, const JudgeNumbers& numbers) {
  if (!known.named) {
    return kNothing;
  }
  const diagnosis::Answer answer = diagnosis::answer(*known.named, numbers);
  return {toString(answer.verdict), namesOf(answer.effects, *known.named), answer.probability};
}

// ---- criteria moved
// --------------------------------------------------------------------------------------------------

// "3 (+1 -2)": verdicts that change, of which so many become right and so many wrong.
std::string changes(const std::vector<TrialCase>& cases, const std::vector<Said>& before, const Criteria& criteria) {
  int changed = 0;
  int better = 0;
  int worse = 0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const Said after = byCriteria(cases[i], criteria);
    if (after.verdict != before[i].verdict || after.effects != before[i].effects) {
      const bool was = cases[i].isRight(before[i]);
      const bool is = cases[i].isRight(after);
      ++changed;
      better += !was && is ? 1 : 0;
      worse += was && !is ? 1 : 0;
    }
  }
  return changed == 0 ? "0" : fmt::format("{} (+{} -{})", changed, better, worse);
}

void printCriteria(const std::vector<TrialCase>& cases, double change) {
  std::vector<Said> before;
  long right = 0;
  for (const TrialCase& known : cases) {
    before.push_back(byCriteria(known, {}));
    right += known.isRight(before.back()) ? 1 : 0;
  }
  std::cout << fmt::format("{} cases, {} right by criteria\n\n", cases.size(), right);
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
}

// ---- judges side by side
// ---------------------------------------------------------------------------------------------

// A case under both judges.
struct Judged {
  const TrialCase* known;
  Said criteria;
  Said posterior;
};

using SaidOf = const Said Judged::*;

struct Counts {
  long cases = 0;
  long right = 0;
  long too_many = 0;

  std::string text() const {
    return fmt::format("{:.1f} % | {:.1f} %", 100.0 * static_cast<double>(right) / static_cast<double>(cases),
                       100.0 * static_cast<double>(too_many) / static_cast<double>(cases));
  }
};

Counts count(const std::vector<Judged>& judged, SaidOf of, const std::string& group) {
  Counts counts;
  for (const Judged& one : judged) {
    if (group.empty() || one.known->group() == group) {
      ++counts.cases;
      counts.right += one.known->isRight(one.*of) ? 1 : 0;
      counts.too_many += one.known->namesTooMuch(one.*of) ? 1 : 0;
    }
  }
  return counts;
}

// 95 % interval of a share by Wilson's method, in percent.
std::string interval(const Counts& counts) {
  using Binomial = boost::math::binomial;
  constexpr double kTail = 0.025;
  const auto n = static_cast<double>(counts.cases);
  const auto k = static_cast<double>(counts.right);
  return fmt::format("{:.0f} to {:.0f} %", 100.0 * Binomial::find_lower_bound_on_p(n, k, kTail),
                     100.0 * Binomial::find_upper_bound_on_p(n, k, kTail));
}

void printGroups(const std::vector<Judged>& judged) {
  std::map<std::string, bool> groups;
  for (const Judged& one : judged) {
    groups[one.known->group()] = true;
  }
  std::cout << "| cases | number | criteria: right | an effect too many | posterior: right | an effect too many |\n"
               "|---|---|---|---|---|---|\n";
  const auto row = [&](const std::string& name, const std::string& group) {
    const Counts criteria = count(judged, &Judged::criteria, group);
    const Counts posterior = count(judged, &Judged::posterior, group);
    std::cout << fmt::format("| {} | {} | {} | {} |\n", name, criteria.cases, criteria.text(), posterior.text());
  };
  for (const auto& [group, present] : groups) {
    row(group, group);
  }
  row("all", "");
  std::cout << fmt::format("\nRight, 95 % interval: {} by criteria, {} by the posterior.\n",
                           interval(count(judged, &Judged::criteria, "")),
                           interval(count(judged, &Judged::posterior, "")));
}

// How probable so uneven a split of the cases that differ would be if neither judge were better.
double signTest(long to_right, long to_wrong) {
  const long differ = to_right + to_wrong;
  if (differ == 0) {
    return 1.0;
  }
  const boost::math::binomial even(static_cast<double>(differ), 0.5);
  return std::min(1.0, 2.0 * cdf(even, static_cast<double>(std::min(to_right, to_wrong))));
}

std::string inWords(const Truth& truth) {
  const std::string effects = fmt::format("{}", fmt::join(truth.effects, ", "));
  return truth.unlisted ? effects + (effects.empty() ? "unlisted" : " beside an unlisted one")
                        : (effects.empty() ? truth.kind : effects);
}

// The cases that a judge is wrong about.
void printDifferences(const std::vector<Judged>& judged) {
  long to_right = 0;
  long to_wrong = 0;
  for (const Judged& one : judged) {
    const bool before = one.known->isRight(one.criteria);
    const bool after = one.known->isRight(one.posterior);
    to_right += !before && after ? 1 : 0;
    to_wrong += before && !after ? 1 : 0;
    if (!before || !after) {
      const char* change = before ? "to wrong" : after ? "to right" : "wrong in both";
      std::cout << fmt::format("{}: {} ({}): {} [{}] -> {} [{}] ({:.2f})\n", change, one.known->name,
                               inWords(one.known->truth), one.criteria.verdict, fmt::join(one.criteria.effects, ", "),
                               one.posterior.verdict, fmt::join(one.posterior.effects, ", "), one.posterior.stated);
    }
  }
  std::cout << fmt::format("{} to right, {} to wrong; by chance as uneven with probability {:.2g}\n\n", to_right,
                           to_wrong, signTest(to_right, to_wrong));
}

void printStated(const std::vector<Judged>& judged, const char* judge, SaidOf of) {
  constexpr std::array kLimits = {0.0, 0.5, 0.8, 0.95, 1.0 + 1e-9};
  std::cout << fmt::format("\n| stated by {} | cases | mean | right |\n|---|---|---|---|\n", judge);
  for (std::size_t bin = 0; bin + 1 < kLimits.size(); ++bin) {
    double cases = 0.0;
    double right = 0.0;
    double stated = 0.0;
    for (const Judged& one : judged) {
      const Said& said = one.*of;
      if (one.known->named && said.stated >= kLimits[bin] && said.stated < kLimits[bin + 1]) {
        cases += 1.0;
        right += one.known->isRight(said) ? 1.0 : 0.0;
        stated += said.stated;
      }
    }
    if (cases > 0.0) {
      std::cout << fmt::format("| {} to {:.2g} | {} | {:.2f} | {:.2f} |\n", kLimits[bin], kLimits[bin + 1], cases,
                               stated / cases, right / cases);
    }
  }
}

// Of what labels say, by the posterior; of cases with evidence.
double meanLogarithmOfTruth(const std::vector<TrialCase>& cases, const std::vector<JudgeNumbers>& numbers) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    for (const FittedCase& known : fittedCases({cases[i]})) {
      sum += std::log(probabilityOfTruth(known, numbers[i]) + kLeastProbability);
      count += 1.0;
    }
  }
  return sum / count;
}

// Numbers of each case: as fitted last, or fitted without the fold that the case is in.
std::vector<JudgeNumbers> numbersOf(const std::vector<TrialCase>& cases, int folds) {
  if (folds == 0) {
    return {cases.size(), diagnosis::fittedNumbers()};
  }
  std::vector<JudgeNumbers> numbers(cases.size());
  for (int fold = 0; fold < folds; ++fold) {
    const auto isIn = [&](std::size_t i) { return static_cast<int>(i) % folds == fold; };
    std::vector<TrialCase> others;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (!isIn(i)) {
        others.push_back(cases[i]);
      }
    }
    std::cerr << fmt::format("judge_again: fitting without part {} of {}\n", fold + 1, folds);
    const JudgeNumbers fitted = calibrate(fittedCases(others));
    for (std::size_t i = 0; i < cases.size(); ++i) {
      numbers[i] = isIn(i) ? fitted : numbers[i];
    }
  }
  return numbers;
}

void printComparison(const std::vector<TrialCase>& cases, int folds) {
  const std::vector<JudgeNumbers> numbers = numbersOf(cases, folds);
  std::vector<Judged> judged;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    judged.push_back({&cases[i], byCriteria(cases[i], {}), byPosterior(cases[i], numbers[i])});
  }
  const auto refused = std::count_if(cases.begin(), cases.end(), [](const TrialCase& one) { return !one.named; });
  std::cout << fmt::format("{} cases, {} of them without evidence, which count as wrong\n\n", cases.size(), refused);
  printDifferences(judged);
  printGroups(judged);
  printStated(judged, "criteria", &Judged::criteria);
  printStated(judged, "the posterior", &Judged::posterior);
  std::cout << fmt::format("\nMean logarithm of the probability of the truth by the posterior: {:.3f}\n",
                           meanLogarithmOfTruth(cases, numbers));
}

// ---- the fit
// ---------------------------------------------------------------------------------------------------------

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now));
  return text.data();
}

// "2026-11-26, on 60 cases (12 machine, 48 single)".
std::string fitInWords(const std::vector<TrialCase>& cases) {
  std::map<std::string, int> kinds;
  int number = 0;
  for (const TrialCase& known : cases) {
    kinds[known.truth.kind] += known.named ? 1 : 0;
    number += known.named ? 1 : 0;
  }
  std::vector<std::string> words;
  for (const auto& [kind, count] : kinds) {
    words.push_back(fmt::format("{} {}", count, kind));
  }
  return fmt::format("{}, on {} cases ({})", today(), number, fmt::join(words, ", "));
}

void writeNumbers(const std::vector<TrialCase>& cases, const std::string& path) {
  const JudgeNumbers numbers = calibrate(fittedCases(cases));
  std::ofstream file(path);
  file << fittedNumbersSource(numbers, fitInWords(cases));
  if (!file.flush()) {
    throw std::runtime_error(path + ": cannot be written");
  }
  std::cout << "| number | fitted | before | unit | meaning |\n|---|---|---|---|---|\n";
  for (const diagnosis::NumberInfo& info : diagnosis::numberTable()) {
    std::cout << fmt::format("| `{}` | {:.3g} | {:.3g} | {} | {} |\n", info.name, numbers.*info.value, info.mean,
                             info.unit, info.meaning);
  }
}

void printVerdicts(const std::vector<TrialCase>& cases) {
  for (const TrialCase& known : cases) {
    const Said criteria = byCriteria(known, {});
    const Said posterior = byPosterior(known, diagnosis::fittedNumbers());
    std::cout << fmt::format("{}: {} [{}] by criteria, {} [{}] by the posterior\n", known.name, criteria.verdict,
                             fmt::join(criteria.effects, ", "), posterior.verdict, fmt::join(posterior.effects, ", "));
  }
}

int run(int argc, char** argv) {
  CLI::App app("Judges the evidence of many diagnoses again");
  std::vector<std::string> folders;
  std::vector<std::string> labels;
  std::string campaign;
  std::string numbers;
  double change = 0.3;
  int folds = 0;
  app.add_option("folders", folders, "folders of cases, with FOLDER_labels and FOLDER_reports beside each")
      ->type_name("FOLDER");
  CLI::Option* in_campaign =
      app.add_option("--campaign", campaign, "campaign whose jobs are the cases")->type_name("FOLDER");
  app.add_option("--labels", labels, "folders of the labels of its cases (may be repeated)")
      ->type_name("FOLDER")
      ->needs(in_campaign)
      ->take_all();
  CLI::Option* fit = app.add_option("--calibrate", numbers, "fit the numbers of the posterior and write this source")
                         ->type_name("FILE");
  CLI::Option* compare = app.add_flag("--compare", "both judges side by side")->excludes(fit);
  app.add_option("--folds", folds, "with --compare: numbers fitted without each of so many parts, and judged on it")
      ->type_name("NUMBER")
      ->check(CLI::Range(2, 100))
      ->needs(compare);
  CLI::Option* verdicts = app.add_flag("--verdicts", "the verdicts of each case")->excludes(fit)->excludes(compare);
  app.add_option("--change", change, "share by which each criterion is moved; default 0.3")
      ->type_name("SHARE")
      ->check(CLI::Range(0.01, 0.99));
  CLI11_PARSE(app, argc, argv);

  std::vector<TrialCase> cases = campaign.empty() ? std::vector<TrialCase>{} : casesOfCampaign(campaign, labels);
  for (const std::string& folder : folders) {
    const std::vector<TrialCase> more = casesOfFolder(folder);
    cases.insert(cases.end(), more.begin(), more.end());
  }
  if (cases.empty()) {
    throw std::invalid_argument(
        "no cases; accepted: folders of cases with labels and reports, or --campaign and --labels");
  }
  if (*fit) {
    writeNumbers(cases, numbers);
  } else if (*compare) {
    printComparison(cases, folds);
  } else if (*verdicts) {
    printVerdicts(cases);
  } else {
    printCriteria(cases, change);
  }
  return 0;
}

}  // namespace
}  // namespace rubber_suspension::blind_trial

int main(int argc, char** argv) {
  try {
    return rubber_suspension::blind_trial::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "judge_again: " << error.what() << "\n";
    return 1;
  }
}
