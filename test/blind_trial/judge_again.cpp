// Judges the evidence of many diagnoses again: the rate of right answers, the calibration of stated probabilities, and
// the fit of the numbers of the judgement.
// Cases are in folders FOLDER, FOLDER_labels and FOLDER_reports, as `generate.py` and `run.py --evidence` write them.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "calibration.h"
#include "command_line/command.h"
#include "diagnosis/judge/answer.h"
#include "judged_case.h"

namespace rubber_suspension::blind_trial {
namespace {

using diagnosis::judge::Evidence;
using diagnosis::judge::JudgeNumbers;

std::vector<std::string> namesOf(const std::vector<int>& effects, const Evidence& evidence) {
  std::vector<std::string> names;
  std::transform(effects.begin(), effects.end(), std::back_inserter(names),
                 [&](int effect) { return evidence.effects.at(static_cast<std::size_t>(effect)); });
  return names;
}

// Returns the answer of the judgement, or check_bench for a case without evidence, whose diagnosis refused the logs.
Said saidOf(const TrialCase& known, const JudgeNumbers& numbers) {
  if (!known.evidence) {
    return {diagnosis::Verdict::check_bench, {}, 0.0};
  }
  const diagnosis::judge::Answer answer = diagnosis::judge::answer(*known.evidence, numbers);
  return {answer.verdict, namesOf(answer.effects, *known.evidence), answer.probability};
}

struct Judged {
  const TrialCase* known;
  Said said;

  bool isRight() const { return known->isRight(said); }
};

struct Counts {
  long cases = 0;
  long right = 0;
  long too_many = 0;

  void add(const Judged& one) {
    ++cases;
    right += one.isRight() ? 1 : 0;
    too_many += one.known->namesTooMuch(one.said) ? 1 : 0;
  }
};

// Formats a share with its 95 % interval (Clopper and Pearson, Biometrika 26, 1934): "86.0 % (72 to 95 %)".
std::string share(long part, long all) {
  using Binomial = boost::math::binomial;
  constexpr double kTail = 0.025;
  const auto n = static_cast<double>(all);
  const auto k = static_cast<double>(part);
  return fmt::format("{:.1f} % ({:.0f} to {:.0f} %)", 100.0 * k / n,
                     100.0 * Binomial::find_lower_bound_on_p(n, k, kTail),
                     100.0 * Binomial::find_upper_bound_on_p(n, k, kTail));
}

// Prints a table of the cases by the text that `keyOf` returns for each.
template <class Key>
void printCounts(const char* title, const std::vector<Judged>& judged, const Key& keyOf) {
  std::map<std::string, Counts> rows;
  Counts all;
  for (const Judged& one : judged) {
    rows[keyOf(*one.known)].add(one);
    all.add(one);
  }
  std::cout << fmt::format("\n| {} | number | right (95 %) | an effect too many (95 %) |\n|---|---|---|---|\n", title);
  const auto row = [](const std::string& name, const Counts& counts) {
    std::cout << fmt::format("| {} | {} | {} | {} |\n", name, counts.cases, share(counts.right, counts.cases),
                             share(counts.too_many, counts.cases));
  };
  for (const auto& [key, counts] : rows) {
    row(key, counts);
  }
  row("all", all);
}

std::string inWords(const Truth& truth) {
  const std::string effects = fmt::format("{}", fmt::join(truth.effects, ", "));
  return truth.unlisted ? effects + (effects.empty() ? "unlisted" : " beside an unlisted one")
                        : (effects.empty() ? truth.kind : effects);
}

void printWrong(const std::vector<Judged>& judged) {
  for (const Judged& one : judged) {
    if (!one.isRight()) {
      std::cout << fmt::format("{} ({}): {} [{}] ({:.2f})\n", one.known->name, inWords(one.known->truth),
                               toString(one.said.verdict), fmt::join(one.said.effects, ", "), one.said.stated);
    }
  }
}

void printStated(const std::vector<Judged>& judged) {
  constexpr std::array kLimits = {0.0, 0.5, 0.8, 0.95, 1.0 + 1e-9};
  std::cout << "\n| stated | cases | mean | right |\n|---|---|---|---|\n";
  for (std::size_t bin = 0; bin + 1 < kLimits.size(); ++bin) {
    double cases = 0.0;
    double right = 0.0;
    double stated = 0.0;
    for (const Judged& one : judged) {
      if (one.known->evidence && one.said.stated >= kLimits[bin] && one.said.stated < kLimits[bin + 1]) {
        cases += 1.0;
        right += one.isRight() ? 1.0 : 0.0;
        stated += one.said.stated;
      }
    }
    if (cases > 0.0) {
      std::cout << fmt::format("| {} to {:.2g} | {} | {:.2f} | {:.2f} |\n", kLimits[bin], kLimits[bin + 1], cases,
                               stated / cases, right / cases);
    }
  }
}

// Returns the mean logarithm of the probability of the labelled truth over all cases with evidence.
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

// Returns the numbers for each case: those fitted to the cases of all other parts.
std::vector<JudgeNumbers> numbersOfOthers(const std::vector<TrialCase>& cases, const std::vector<std::string>& parts,
                                          const std::vector<std::string>& only) {
  std::vector<JudgeNumbers> numbers(cases.size());
  for (const std::string& part : std::set<std::string>(parts.begin(), parts.end())) {
    std::vector<TrialCase> others;
    for (std::size_t i = 0; i < cases.size(); ++i) {
      if (parts[i] != part) {
        others.push_back(cases[i]);
      }
    }
    std::cerr << fmt::format("judge_again: fitting without {}\n", part);
    const JudgeNumbers fitted = calibrate(fittedCases(others), only);
    for (std::size_t i = 0; i < cases.size(); ++i) {
      numbers[i] = parts[i] == part ? fitted : numbers[i];
    }
  }
  return numbers;
}

// Prints the slope of a logistic regression of right verdicts on the log odds of stated probabilities: 1 if these are
// true, and less if they are too certain. Cases without evidence have none. A prior of Jeffreys keeps it finite if all
// verdicts are right.
void printSlope(const std::vector<Judged>& all) {
  constexpr double kNearCertain = 1e-3;  // closer to 0 or 1, a stated probability counts as this
  std::vector<Judged> judged;
  std::copy_if(all.begin(), all.end(), std::back_inserter(judged),
               [](const Judged& one) { return one.known->evidence.has_value(); });
  Eigen::MatrixX2d regressors(static_cast<Eigen::Index>(judged.size()), 2);
  Eigen::VectorXd right(regressors.rows());
  for (Eigen::Index i = 0; i < regressors.rows(); ++i) {
    const Judged& one = judged[static_cast<std::size_t>(i)];
    const double stated = std::clamp(one.said.stated, kNearCertain, 1.0 - kNearCertain);
    regressors.row(i) << 1.0, std::log(stated / (1.0 - stated));
    right[i] = one.isRight() ? 1.0 : 0.0;
  }
  Eigen::Vector2d line(0.0, 1.0);
  Eigen::Matrix2d information;
  for (int step = 0; step < 100; ++step) {
    const Eigen::VectorXd expected = (1.0 + (-(regressors * line).array()).exp()).inverse();
    const Eigen::VectorXd variance = expected.array() * (1.0 - expected.array());
    information = regressors.transpose() * variance.asDiagonal() * regressors;
    const Eigen::VectorXd leverage =
        variance.array() * (regressors * information.inverse()).cwiseProduct(regressors).rowwise().sum().array();
    const Eigen::VectorXd score = (right - expected).array() + leverage.array() * (0.5 - expected.array());
    const Eigen::Vector2d move = information.ldlt().solve(regressors.transpose() * score);
    line += move / std::max(1.0, move.norm());
  }
  std::cout << fmt::format("\nCalibration slope: {:.2f} +- {:.2f}\n", line[1], std::sqrt(information.inverse()(1, 1)));
}

void printFigures(const std::vector<TrialCase>& cases, const std::vector<JudgeNumbers>& numbers) {
  std::vector<Judged> judged;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    judged.push_back({&cases[i], saidOf(cases[i], numbers[i])});
  }
  const auto refused = std::count_if(cases.begin(), cases.end(), [](const TrialCase& one) { return !one.evidence; });
  std::cout << fmt::format("{} cases, {} of them without evidence, which count as wrong. Wrong are:\n\n", cases.size(),
                           refused);
  printWrong(judged);
  printCounts("cases", judged, [](const TrialCase& known) { return known.group(); });
  printCounts("hand", judged, [](const TrialCase& known) { return known.hand; });
  printStated(judged);
  printSlope(judged);
  std::cout << fmt::format("\nMean logarithm of the probability of the truth: {:.3f}\n",
                           meanLogarithmOfTruth(cases, numbers));
}

std::string today() {
  const std::time_t now = std::time(nullptr);
  std::array<char, 16> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%d", std::gmtime(&now));
  return text.data();
}

// Returns two lines of a comment, such as "2026-11-26, on 60 cases" and "12 machine, 48 single".
std::string fitInWords(const std::vector<TrialCase>& cases, const std::vector<std::string>& only) {
  std::map<std::string, int> kinds;
  int number = 0;
  for (const TrialCase& known : cases) {
    kinds[known.truth.kind] += known.evidence ? 1 : 0;
    number += known.evidence ? 1 : 0;
  }
  std::vector<std::string> words;
  for (const auto& [kind, count] : kinds) {
    words.push_back(fmt::format("{} {}", count, kind));
  }
  const std::string alone = only.empty() ? "" : fmt::format("{} alone, ", fmt::join(only, ", "));
  return fmt::format("{}, {}on {} cases:\n// {}", today(), alone, number, fmt::join(words, ", "));
}

void writeNumbers(const std::vector<TrialCase>& cases, const std::string& path, const std::vector<std::string>& only) {
  const std::vector<FittedCase> fitted = fittedCases(cases);
  const JudgeNumbers numbers = calibrate(fitted, only);
  std::ofstream file(path);
  file << fittedNumbersSource(numbers, fitInWords(cases, only));
  if (!file.flush()) {
    throw std::runtime_error(path + ": cannot be written");
  }
  const Certainty certainty = certaintyOf(fitted, numbers);
  const JudgeNumbers& before = diagnosis::judge::fittedNumbers();
  std::cout << "| number | fitted | standard error | fitted before | mean of the prior | its standard "
               "deviation | unit | meaning |\n|---|---|---|---|---|---|---|---|\n";
  std::size_t row = 0;
  for (const diagnosis::judge::NumberInfo& info : diagnosis::judge::numberTable()) {
    std::cout << fmt::format("| `{}` | {:.3g} | {:.2g}{} | {:.3g} | {:.3g} | {:.2g} | {} | {} |\n", info.name,
                             numbers.*info.value, certainty.errors[row++], info.positive ? " (ln)" : "",
                             before.*info.value, info.mean, info.deviation, info.unit, info.meaning);
  }
  std::cout << fmt::format("\nThe cases determine {} of {} directions better than the prior does.\n", certainty.known,
                           certainty.directions);
}

void printVerdicts(const std::vector<TrialCase>& cases) {
  for (const TrialCase& known : cases) {
    const Said said = saidOf(known, diagnosis::judge::fittedNumbers());
    std::cout << fmt::format("{}: {} [{}]\n", known.name, toString(said.verdict), fmt::join(said.effects, ", "));
  }
}

struct Options {
  std::vector<std::string> folders;
  std::string numbers;
  std::vector<std::string> only;
  int folds = 0;  // 0: use the last fitted numbers
  bool hands = false;
  bool verdicts = false;

  command_line::OptionTable table() {
    using command_line::Option;
    command_line::OptionTable options = {
        Option("folders", folders, "FOLDER", "folders of cases, with FOLDER_labels and FOLDER_reports beside each"),
        Option("--calibrate", numbers, "FILE", "fit the numbers of the judgement and write this source"),
        Option("--only", only, "NUMBER", "fit these numbers alone, and keep the others; give them after the folders"),
        Option("--folds", folds, "NUMBER", "judge each of so many parts by numbers fitted to the others")
            .within(2, 100),
        Option("--hands", hands,
               "judge the cases of each hand by numbers fitted to the others; the cases of a hand are in "
               "folders of one folder"),
        Option("--verdicts", verdicts, "print the verdict of each case alone")};
    options.excludes({"--folds", "--hands", "--verdicts"}, {"--calibrate"});
    options.excludes({"--folds", "--hands"}, {"--verdicts"});
    options.excludes({"--folds"}, {"--hands"});
    options.needs({"--only"}, {"--calibrate", "--folds", "--hands"});
    return options;
  }
};

std::vector<TrialCase> casesOf(const Options& options) {
  std::vector<TrialCase> cases;
  for (const std::string& folder : options.folders) {
    const std::vector<TrialCase> more = casesOfFolder(folder);
    cases.insert(cases.end(), more.begin(), more.end());
  }
  if (cases.empty()) {
    throw std::invalid_argument("no cases; accepted: folders of cases with labels and reports");
  }
  return cases;
}

// Returns the numbers that judge each case.
std::vector<JudgeNumbers> numbersOf(const std::vector<TrialCase>& cases, const Options& options) {
  if (!options.hands && options.folds == 0) {
    return {cases.size(), diagnosis::judge::fittedNumbers()};
  }
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    parts.push_back(options.hands ? cases[i].hand
                                  : fmt::format("part {}", i % static_cast<std::size_t>(options.folds) + 1));
  }
  return numbersOfOthers(cases, parts, options.only);
}

int run(const Options& options) {
  const std::vector<TrialCase> cases = casesOf(options);
  if (!options.numbers.empty()) {
    writeNumbers(cases, options.numbers, options.only);
  } else if (options.verdicts) {
    printVerdicts(cases);
  } else {
    printFigures(cases, numbersOf(cases, options));
  }
  return 0;
}

}  // namespace
}  // namespace rubber_suspension::blind_trial

int main(int argc, char** argv) {
  using namespace rubber_suspension;
  blind_trial::Options options;
  return command_line::runCommand(argc, argv, {"judge_again", "Judges the evidence of many diagnoses again."},
                                  options.table(), [&] { return blind_trial::run(options); });
}
