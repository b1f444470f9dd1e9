// Fits the numbers of the judgement to cases with known causes.
#include "calibration.h"

#include <ceres/gradient_problem.h>
#include <ceres/gradient_problem_solver.h>
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "diagnosis/judge/set_posterior.h"

namespace rubber_suspension::blind_trial {
namespace {

using diagnosis::judge::Evidence;
using diagnosis::judge::JudgeNumbers;
using diagnosis::judge::NumberInfo;
using diagnosis::judge::numberTable;
using diagnosis::judge::SetPosterior;
using diagnosis::judge::SetProbability;

constexpr double kPartOfTruth = 0.2;    // credit for the answer `unknown` if a listed and an unlisted effect act
constexpr double kMoreThanTruth = 0.5;  // credit for the right effects beside an unlisted one that does not act
constexpr double kValuesOfNone = 0.3;   // credit for "wrong values" if the configured model is nearly right
constexpr double kAccepted = 0.02;      // gap that an engineer accepts

// The parameters of the fit: the rows of the table, with logarithms of positive ones, and then the base rates.
class Unknowns {
 public:
  explicit Unknowns(const std::vector<FittedCase>& cases) {
    std::set<std::string> names;
    for (const FittedCase& known : cases) {
      names.insert(known.table.effects.begin(), known.table.effects.end());
    }
    rates_.assign(names.begin(), names.end());
  }

  int size() const { return static_cast<int>(numberTable().size() + rates_.size()); }

  std::vector<double> means() const {
    std::vector<double> means;
    for (const NumberInfo& info : numberTable()) {
      means.push_back(info.positive ? std::log(info.mean) : info.mean);
    }
    means.resize(static_cast<std::size_t>(size()), 0.0);
    return means;
  }

  std::vector<double> deviations() const {
    std::vector<double> deviations;
    for (const NumberInfo& info : numberTable()) {
      deviations.push_back(info.deviation);
    }
    deviations.resize(static_cast<std::size_t>(size()), diagnosis::judge::kRateDeviation);
    return deviations;
  }

  // Returns for each parameter whether it is fitted: all of them if `only` is empty.
  std::vector<bool> areFitted(const std::vector<std::string>& only) const {
    std::vector<bool> fitted(static_cast<std::size_t>(size()), only.empty());
    for (const std::string& number : only) {
      const std::vector<NumberInfo>& table = numberTable();
      const auto found =
          std::find_if(table.begin(), table.end(), [&](const NumberInfo& info) { return info.name == number; });
      if (found == table.end()) {
        throw std::invalid_argument("no number '" + number + "'; accepted: a name of the table in numbers.cpp");
      }
      fitted[static_cast<std::size_t>(found - table.begin())] = true;
    }
    return fitted;
  }

  std::vector<double> valuesOf(const JudgeNumbers& numbers) const {
    std::vector<double> values;
    for (const NumberInfo& info : numberTable()) {
      values.push_back(info.positive ? std::log(numbers.*info.value) : numbers.*info.value);
    }
    for (const std::string& effect : rates_) {
      values.push_back(numbers.rateOf(effect));
    }
    return values;
  }

  JudgeNumbers numbers(const double* values) const {
    JudgeNumbers numbers;
    for (const NumberInfo& info : numberTable()) {
      numbers.*info.value = info.positive ? std::exp(*values) : *values;
      ++values;
    }
    for (const std::string& effect : rates_) {
      numbers.rates[effect] = *values++;
    }
    return numbers;
  }

 private:
  std::vector<std::string> rates_;
};

// Negative logarithm of the joint probability of numbers and labels.
class Loss final : public ceres::FirstOrderFunction {
 public:
  Loss(const std::vector<FittedCase>& cases, const Unknowns& unknowns, std::vector<bool> fitted)
      : cases_(cases),
        unknowns_(unknowns),
        fitted_(std::move(fitted)),
        means_(unknowns.means()),
        deviations_(unknowns.deviations()) {}

  int NumParameters() const override { return unknowns_.size(); }

  bool Evaluate(const double* values, double* loss, double* gradient) const override {
    constexpr double kStep = 1e-5;
    *loss = at(values);
    if (gradient != nullptr) {
      std::vector<double> moved(values, values + NumParameters());
      for (std::size_t i = 0; i < moved.size(); ++i) {
        moved[i] = values[i] + kStep;
        gradient[i] = fitted_[i] ? (at(moved.data()) - *loss) / kStep : 0.0;
        moved[i] = values[i];
      }
    }
    return std::isfinite(*loss);
  }

 private:
  double at(const double* values) const {
    double loss = 0.0;
    for (std::size_t i = 0; i < means_.size(); ++i) {
      loss += 0.5 * std::pow((values[i] - means_[i]) / deviations_[i], 2);
    }
    const JudgeNumbers numbers = unknowns_.numbers(values);
    for (const FittedCase& known : cases_) {
      loss -= std::log(probabilityOfTruth(known, numbers) + kLeastProbability);
    }
    return loss;
  }

  const std::vector<FittedCase>& cases_;
  const Unknowns& unknowns_;
  std::vector<bool> fitted_;
  std::vector<double> means_;
  std::vector<double> deviations_;
};

std::vector<std::string> namesOf(const SetProbability& set, const FittedCase& known) {
  std::vector<std::string> names;
  for (const int member : set.members) {
    names.push_back(known.table.effects[static_cast<std::size_t>(member)]);
  }
  std::sort(names.begin(), names.end());
  return names;
}

bool isIn(const std::string& name, const std::vector<std::string>& names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

// Returns true if the names contain one of the known causes, and nothing else but accepted effects.
bool fitsMachine(const std::vector<std::string>& names, const Truth& truth) {
  const bool any =
      std::any_of(names.begin(), names.end(), [&](const std::string& name) { return isIn(name, truth.effects); });
  return any && std::all_of(names.begin(), names.end(), [&](const std::string& name) {
           return isIn(name, truth.effects) || isIn(name, truth.also);
         });
}

double ofListed(const SetPosterior& posterior, const FittedCase& known) {
  std::vector<std::string> truth = known.truth.effects;
  std::sort(truth.begin(), truth.end());
  double sum = known.truth.unlisted ? kPartOfTruth * posterior.unknown : 0.0;
  for (const SetProbability& set : posterior.sets) {
    const std::vector<std::string> names = namesOf(set, known);
    if (known.truth.kind == "machine") {
      sum += fitsMachine(names, known.truth) ? set.sum() : 0.0;
    } else if (names == truth) {
      sum += known.truth.unlisted ? set.beside : set.alone + kMoreThanTruth * set.beside;
    }
  }
  return sum;
}

double ofUnlisted(const SetPosterior& posterior, const FittedCase& known) {
  if (known.truth.unlisted) {
    return posterior.unknown;
  }
  if (known.truth.kind == "parameter_error") {
    return posterior.parameter_error;
  }
  return posterior.none + (known.far_off ? 1.0 : kValuesOfNone) * posterior.parameter_error;
}

}  // namespace

std::vector<FittedCase> fittedCases(const std::vector<TrialCase>& cases) {
  std::vector<FittedCase> fitted;
  for (const TrialCase& known : cases) {
    if (known.evidence) {
      const double configured = leftBeyondNoise(*known.evidence, Evidence::kAsConfigured);
      fitted.push_back({scoreTable(*known.evidence), known.truth, known.isHidden(), configured > kAccepted});
    }
  }
  return fitted;
}

double probabilityOfTruth(const FittedCase& known, const JudgeNumbers& numbers) {
  const SetPosterior posterior = setPosterior(known.table, numbers);
  const double sum = known.truth.effects.empty() ? ofUnlisted(posterior, known) : ofListed(posterior, known);
  return sum + (known.hidden ? posterior.parameter_error : 0.0);
}

JudgeNumbers calibrate(const std::vector<FittedCase>& cases, const std::vector<std::string>& only) {
  if (cases.empty()) {
    throw std::invalid_argument("no case with evidence; accepted: at least one");
  }
  const Unknowns unknowns(cases);
  const std::vector<bool> fitted = unknowns.areFitted(only);
  const std::vector<double> last = unknowns.valuesOf(diagnosis::judge::fittedNumbers());
  const ceres::GradientProblem problem(new Loss(cases, unknowns, fitted));
  ceres::GradientProblemSolver::Options options;
  options.line_search_direction_type = ceres::LBFGS;
  options.max_num_iterations = 80;
  options.function_tolerance = 1e-6;
  options.logging_type = ceres::SILENT;
  double least = HUGE_VAL;
  std::vector<double> best;
  for (std::vector<double> values : {unknowns.means(), last}) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = fitted[i] ? values[i] : last[i];
    }
    ceres::GradientProblemSolver::Summary summary;
    ceres::Solve(options, problem, values.data(), &summary);
    if (!summary.IsSolutionUsable()) {
      throw std::runtime_error("the numbers cannot be fitted: " + summary.message);
    }
    if (summary.final_cost < least) {
      least = summary.final_cost;
      best = values;
    }
  }
  return unknowns.numbers(best.data());
}

Certainty certaintyOf(const std::vector<FittedCase>& cases, const JudgeNumbers& numbers) {
  constexpr double kStep = 1e-2;  // of the prior standard deviation: far above the error of the gradient
  const Unknowns unknowns(cases);
  const Loss loss(cases, unknowns, unknowns.areFitted({}));
  const std::vector<double> prior = unknowns.deviations();
  const Eigen::Map<const Eigen::VectorXd> deviations(prior.data(), unknowns.size());
  const auto gradientAt = [&](const std::vector<double>& values) {
    Eigen::VectorXd gradient(unknowns.size());
    double value = 0.0;
    loss.Evaluate(values.data(), &value, gradient.data());
    return gradient;
  };
  const std::vector<double> best = unknowns.valuesOf(numbers);
  Eigen::MatrixXd hessian(unknowns.size(), unknowns.size());  // in units of the prior standard deviations
  for (int i = 0; i < unknowns.size(); ++i) {
    std::vector<double> above = best;
    std::vector<double> below = best;
    above[static_cast<std::size_t>(i)] += kStep * deviations[i];
    below[static_cast<std::size_t>(i)] -= kStep * deviations[i];
    hessian.col(i) = (gradientAt(above) - gradientAt(below)).cwiseProduct(deviations) / (2.0 * kStep);
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(0.5 * (hessian + hessian.transpose()));
  // At a minimum that the tolerance of the fit stopped early, an eigenvalue may lie below that of the prior, which
  // is 1.
  const Eigen::VectorXd eigenvalues = solver.eigenvalues().cwiseMax(1.0);
  const Eigen::MatrixXd& vectors = solver.eigenvectors();
  const Eigen::VectorXd errors =
      (vectors * eigenvalues.cwiseInverse().asDiagonal() * vectors.transpose()).diagonal().cwiseSqrt();
  Certainty certainty;
  for (std::size_t i = 0; i < numberTable().size(); ++i) {
    certainty.errors.push_back(errors[static_cast<Eigen::Index>(i)] * prior[i]);
  }
  certainty.known = static_cast<int>((eigenvalues.array() > 2.0).count());  // the cases add more than the prior's 1
  certainty.directions = unknowns.size();
  return certainty;
}

std::string fittedNumbersSource(const JudgeNumbers& numbers, const std::string& of) {
  std::string text = fmt::format(
      "// The numbers of the judgement as fitted last. Written by `judge_again --calibrate`:\n// {}.\n"
      "#include \"diagnosis/judge/numbers.h\"\n\nnamespace rubber_suspension::diagnosis::judge {{\n\n"
      "const JudgeNumbers& fittedNumbers() {{\n  static const JudgeNumbers numbers = [] {{\n    JudgeNumbers fitted;\n",
      of);
  for (const NumberInfo& info : numberTable()) {
    text += fmt::format("    fitted.{} = {:.4g};\n", info.name, numbers.*info.value);
  }
  for (const auto& [effect, rate] : numbers.rates) {
    text += fmt::format("    fitted.rates[\"{}\"] = {:.3g};\n", effect, rate);
  }
  return text +
         "    return fitted;\n  }();\n  return numbers;\n}\n\n}  // namespace rubber_suspension::diagnosis::judge\n";
}

}  // namespace rubber_suspension::blind_trial
