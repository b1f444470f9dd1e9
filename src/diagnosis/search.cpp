// The search over candidate effects.
#include "rubber_suspension/diagnosis/search.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace rubber_suspension {
namespace {

constexpr int kBaseIterations = 10;
constexpr int kSingleIterations = 6;
constexpr int kPairIterations = 5;
constexpr std::size_t kPairsFitted = 14;

bool wantsTrends(const Candidate& candidate) { return candidate.effect == "force_drift"; }

Trial makeTrial(const std::vector<Candidate>& candidates, const std::vector<int>& members) {
  Trial trial;
  trial.members = members;
  for (const int member : members) {
    const auto& atoms = candidates[static_cast<std::size_t>(member)].atoms;
    trial.atoms.insert(trial.atoms.end(), atoms.begin(), atoms.end());
  }
  return trial;
}

bool hasTrends(const std::vector<Candidate>& candidates, const std::vector<int>& members) {
  return std::any_of(members.begin(), members.end(),
                     [&](int member) { return wantsTrends(candidates[static_cast<std::size_t>(member)]); });
}

void fitTrial(const Fitter& fitter, const std::vector<Candidate>& candidates, const Eigen::VectorXd& own,
              int iterations, Trial& trial) {
  const Point start{own, Eigen::VectorXd::Zero(static_cast<Eigen::Index>(trial.atoms.size()))};
  trial.fit = fitter.fit(trial.atoms, start, iterations, hasTrends(candidates, trial.members));
}

// White noise of what the best model leaves, above the band of the excitation, for each log.
void estimateNoise(const Fitter& fitter, const Fit& best, const std::vector<Atom>& atoms, Search& result) {
  const auto forces = simulate(*fitter.elements(best.point, atoms), fitter.records());
  double sum = 0.0;
  for (std::size_t r = 0; r < fitter.records().size(); ++r) {
    const Record& record = fitter.records()[r];
    const double edge = std::min(3.0 * record.highest_frequency, 0.3 / record.dt);
    const double noise = whiteNoiseAbove(record.force - forces[r], record.dt, edge) / record.force_deviation;
    result.record_noise.push_back(noise);
    sum += noise * noise / static_cast<double>(fitter.records().size());
  }
  result.noise = std::sqrt(sum);
  result.noise_source = "spectrum of the residual above the band of the excitation";
}

struct Screened {
  std::vector<int> members;
  double error;
};

// Part of each candidate's force that the model's own parameters cannot take over, and whether a typical size of it
// stands out of the noise.
void measureVisibility(const BlockGrams& blocks, Eigen::Index own,
                       const std::vector<std::vector<Eigen::Index>>& columns_of, const std::vector<Atom>& all,
                       double noise, Search& result) {
  constexpr double kVisible = 0.05;
  const Eigen::MatrixXd total = blocks.sum();
  const auto base = total.topLeftCorner(own, own).completeOrthogonalDecomposition();
  for (const auto& columns : columns_of) {
    double share = 0.0;
    bool testable = false;
    for (const Eigen::Index j : columns) {
      const Eigen::VectorXd cross = total.col(j).head(own);
      const double whole = total(j, j);
      const double rest = std::max(0.0, whole - cross.dot(base.solve(cross)));
      const double visible = whole > 0.0 ? std::sqrt(rest / whole) : 0.0;
      share = std::max(share, visible);
      const double size = all[static_cast<std::size_t>(j - own)].typical * std::sqrt(rest);
      testable = testable || (visible >= kVisible && size >= 0.2 * noise);
    }
    result.visible_share.push_back(share);
    result.testable.push_back(testable);
  }
}

// Held-out error of every pair from one set of normal equations about the re-estimated model.
std::vector<Screened> screenPairs(const Fitter& fitter, Search& result) {
  std::vector<Atom> all;
  std::vector<std::vector<Eigen::Index>> columns_of;
  const Eigen::Index own = fitter.own().size();
  for (const Candidate& candidate : result.candidates) {
    columns_of.emplace_back();
    for (const Atom& atom : candidate.atoms) {
      columns_of.back().push_back(own + static_cast<Eigen::Index>(all.size()));
      all.push_back(atom);
    }
  }
  Point point = fitter.configured(all.size());
  point.own = result.re_estimated.fit.point.own;
  const BlockGrams blocks = fitter.linearise(point, all, true);
  const Eigen::Index unknowns = blocks.gram[0].rows() - 1;
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  fitter.stepBounds(point, all, unknowns, lower, upper);
  measureVisibility(blocks, own, columns_of, all, result.noise, result);

  std::vector<Screened> screened;
  const int count = static_cast<int>(result.candidates.size());
  for (int a = 0; a < count; ++a) {
    for (int b = a + 1; b < count; ++b) {
      std::vector<Eigen::Index> columns(static_cast<std::size_t>(own));
      std::iota(columns.begin(), columns.end(), 0);
      for (const int member : {a, b}) {
        const auto& more = columns_of[static_cast<std::size_t>(member)];
        columns.insert(columns.end(), more.begin(), more.end());
      }
      if (hasTrends(result.candidates, {a, b})) {
        for (Eigen::Index j = own + static_cast<Eigen::Index>(all.size()); j < unknowns; ++j) {
          columns.push_back(j);
        }
      }
      Eigen::VectorXd low(static_cast<Eigen::Index>(columns.size()));
      Eigen::VectorXd high(low.size());
      for (Eigen::Index i = 0; i < low.size(); ++i) {
        low[i] = lower[columns[static_cast<std::size_t>(i)]];
        high[i] = upper[columns[static_cast<std::size_t>(i)]];
      }
      const std::vector<double> errors = crossValidate(blocks, columns, low, high);
      const double error = std::inner_product(errors.begin(), errors.end(), blocks.weight.begin(), 0.0);
      screened.push_back({{a, b}, std::sqrt(error)});
    }
  }
  std::sort(screened.begin(), screened.end(), [](const Screened& x, const Screened& y) { return x.error < y.error; });
  return screened;
}

void sortByError(std::vector<Trial>& trials) {
  std::sort(trials.begin(), trials.end(),
            [](const Trial& x, const Trial& y) { return x.fit.held_out < y.fit.held_out; });
}

}  // namespace

Search search(const Fitter& fitter, const Fitter& element_level, int threads, const ProgressCallback& progress) {
  const auto say = [&](const std::string& stage, double fraction) {
    if (progress) {
      progress(stage, fraction);
    }
  };
  Search result;
  result.candidates = candidates(summarise(fitter.records()));

  say("re-estimating the model's own parameters", 0.0);
  result.configured_gap = fitter.gapAt(fitter.configured(0), {});
  result.re_estimated.fit = fitter.fit({}, fitter.configured(0), kBaseIterations);
  const Eigen::VectorXd own = result.re_estimated.fit.point.own;

  say("fitting single effects", 0.1);
  for (int c = 0; c < static_cast<int>(result.candidates.size()); ++c) {
    result.singles.push_back(makeTrial(result.candidates, {c}));
  }
  parallelFor(result.singles.size() + 1, threads, [&](std::size_t i) {
    if (i == result.singles.size()) {
      result.element_level = element_level.fit({}, element_level.configured(0), kBaseIterations);
    } else {
      fitTrial(fitter, result.candidates, own, kSingleIterations, result.singles[i]);
    }
  });

  const auto best = std::min_element(result.singles.begin(), result.singles.end(), [](const Trial& a, const Trial& b) {
    return a.fit.held_out < b.fit.held_out;
  });
  estimateNoise(fitter, best->fit, best->atoms, result);

  say("screening all pairs", 0.4);
  const std::vector<Screened> screened = screenPairs(fitter, result);
  for (std::size_t i = 0; i < std::min(kPairsFitted, screened.size()); ++i) {
    result.pairs.push_back(makeTrial(result.candidates, screened[i].members));
  }
  say("fitting the best pairs", 0.5);
  parallelFor(result.pairs.size(), threads,
              [&](std::size_t i) { fitTrial(fitter, result.candidates, own, kPairIterations, result.pairs[i]); });
  sortByError(result.pairs);
  return result;
}

}  // namespace rubber_suspension
