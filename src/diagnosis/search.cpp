// The search over candidate effects.
#include "rubber_suspension/diagnosis/search.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "rubber_suspension/diagnosis/parallel.h"

namespace rubber_suspension {
namespace {

constexpr int kBaseIterations = 10;
constexpr int kSingleIterations = 6;
constexpr int kPairIterations = 5;
constexpr std::size_t kPairsFitted = 8;
constexpr std::size_t kAdditionsFitted = 3;
constexpr double kSignificantRest = 1.5;  // held-out error over the noise floor that makes triples worth their time

Trial makeTrial(const std::vector<Candidate>& candidates, const std::vector<int>& members) {
  Trial trial;
  trial.members = members;
  for (const int member : members) {
    const auto& atoms = candidates[static_cast<std::size_t>(member)].atoms;
    trial.atoms.insert(trial.atoms.end(), atoms.begin(), atoms.end());
  }
  return trial;
}

// Fit from several starts of the own parameters, nothing added; the best counts.
void fitTrial(const Fitter& fitter, const std::vector<Candidate>& candidates,
              const std::vector<Eigen::VectorXd>& starts, int iterations, Trial& trial) {
  const Eigen::VectorXd nothing = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(trial.atoms.size()));
  const bool additive =
      std::all_of(trial.atoms.begin(), trial.atoms.end(), [](const Atom& atom) { return atom.additive; });
  for (std::size_t i = 0; i < (additive ? 1 : starts.size()); ++i) {  // additive effects have one optimum only
    Fit fit = fitter.fit(trial.atoms, {starts[i], nothing}, iterations, hasTrends(candidates, trial.members));
    if (i == 0 || fit.held_out < trial.fit.held_out) {
      trial.fit = std::move(fit);
    }
  }
}

// Own parameters that the fits of the members alone arrived at, the best first.
std::vector<Eigen::VectorXd> startsOf(const Search& result, const std::vector<int>& members) {
  const Trial* best = &result.singles[static_cast<std::size_t>(members.front())];
  for (const int member : members) {
    const Trial& single = result.singles[static_cast<std::size_t>(member)];
    best = single.fit.held_out < best->fit.held_out ? &single : best;
  }
  return {best->fit.point.own};
}

// A dashpot takes the displacement as linear between samples: its force lags by half a step, which looks like a delay.
// RMS of what the lag makes of the model's force, weighted as a gap is.
double discretisationError(const Fitter& fitter, const Point& point) {
  std::vector<ElementDescription> elements = *fitter.elements(point, {});
  bool any = false;
  for (ElementDescription& element : elements) {
    if (element.type == "dashpot") {
      element.values["order"] = {2.0};
      any = true;
    }
  }
  if (!any) {
    return 0.0;
  }
  const auto smooth = simulate(elements, fitter.records());
  const auto lagging = *fitter.forces(point, {});
  double sum = 0.0;
  for (std::size_t r = 0; r < smooth.size(); ++r) {
    const Record& record = fitter.records()[r];
    sum += (smooth[r] - lagging[r]).squaredNorm() / static_cast<double>(record.size()) /
           std::pow(record.force_deviation, 2);
  }
  return std::sqrt(sum / static_cast<double>(smooth.size()));
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

// Held-out errors of many hypotheses from one set of normal equations with the atoms of all candidates.
class Screen {
 public:
  // About a fitted trial: its own parameters and scales, all other candidates at nothing.
  Screen(const Fitter& fitter, const std::vector<Candidate>& candidates, const Trial& about)
      : candidates_(candidates), own_(fitter.own().size()) {
    Point point{about.fit.point.own, {}};
    std::vector<double> scales;
    for (int c = 0; c < static_cast<int>(candidates.size()); ++c) {
      columns_of_.emplace_back();
      for (const Atom& atom : candidates[static_cast<std::size_t>(c)].atoms) {
        columns_of_.back().push_back(own_ + static_cast<Eigen::Index>(all_.size()));
        all_.push_back(atom);
        scales.push_back(0.0);
      }
    }
    Eigen::Index fitted = 0;
    for (const int member : about.members) {
      for (const Eigen::Index column : columns_of_[static_cast<std::size_t>(member)]) {
        scales[static_cast<std::size_t>(column - own_)] = about.fit.point.scales[fitted++];
      }
    }
    point.scales = Eigen::Map<const Eigen::VectorXd>(scales.data(), static_cast<Eigen::Index>(scales.size()));
    blocks_ = fitter.linearise(point, all_, true);
    fitter.stepBounds(point, all_, unknowns(), lower_, upper_);
  }

  Screened operator()(std::vector<int> members) const {
    std::sort(members.begin(), members.end());
    std::vector<Eigen::Index> columns(static_cast<std::size_t>(own_));
    std::iota(columns.begin(), columns.end(), 0);
    for (const int member : members) {
      const auto& more = columns_of_[static_cast<std::size_t>(member)];
      columns.insert(columns.end(), more.begin(), more.end());
    }
    if (hasTrends(candidates_, members)) {
      for (Eigen::Index j = own_ + static_cast<Eigen::Index>(all_.size()); j < unknowns(); ++j) {
        columns.push_back(j);
      }
    }
    Eigen::VectorXd lower(static_cast<Eigen::Index>(columns.size()));
    Eigen::VectorXd upper(lower.size());
    for (Eigen::Index i = 0; i < lower.size(); ++i) {
      lower[i] = lower_[columns[static_cast<std::size_t>(i)]];
      upper[i] = upper_[columns[static_cast<std::size_t>(i)]];
    }
    const std::vector<double> errors = crossValidate(blocks_, columns, lower, upper);
    return {members, std::sqrt(std::inner_product(errors.begin(), errors.end(), blocks_.weight.begin(), 0.0))};
  }

  // Each other candidate added to these, best first.
  std::vector<Screened> additions(const std::vector<int>& members) const {
    std::vector<Screened> result;
    for (int c = 0; c < static_cast<int>(candidates_.size()); ++c) {
      if (std::find(members.begin(), members.end(), c) == members.end()) {
        std::vector<int> more = members;
        more.push_back(c);
        result.push_back((*this)(more));
      }
    }
    return sorted(std::move(result));
  }

  std::vector<Screened> pairs() const {
    std::vector<Screened> result;
    const int count = static_cast<int>(candidates_.size());
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        result.push_back((*this)({a, b}));
      }
    }
    return sorted(std::move(result));
  }

  // Part of each candidate's force that the model's own parameters cannot take over, and whether a typical size of it
  // stands out of the noise.
  void measureVisibility(double noise, Search& result) const {
    constexpr double kVisible = 0.05;
    constexpr double kOverNoise = 0.2;
    const Eigen::MatrixXd total = blocks_.sum();
    const auto base = total.topLeftCorner(own_, own_).completeOrthogonalDecomposition();
    for (const auto& columns : columns_of_) {
      double share = 0.0;
      bool testable = false;
      for (const Eigen::Index j : columns) {
        const Eigen::VectorXd cross = total.col(j).head(own_);
        const double whole = total(j, j);
        const double rest = std::max(0.0, whole - cross.dot(base.solve(cross)));
        const double visible = whole > 0.0 ? std::sqrt(rest / whole) : 0.0;
        share = std::max(share, visible);
        const double size = all_[static_cast<std::size_t>(j - own_)].typical * std::sqrt(rest);
        testable = testable || (visible >= kVisible && size >= kOverNoise * noise);
      }
      result.visible_share.push_back(share);
      result.testable.push_back(testable);
    }
  }

 private:
  Eigen::Index unknowns() const { return blocks_.gram[0].rows() - 1; }

  static std::vector<Screened> sorted(std::vector<Screened> screened) {
    std::sort(screened.begin(), screened.end(), [](const Screened& x, const Screened& y) { return x.error < y.error; });
    return screened;
  }

  const std::vector<Candidate>& candidates_;
  Eigen::Index own_;
  std::vector<Atom> all_;
  std::vector<std::vector<Eigen::Index>> columns_of_;
  BlockGrams blocks_;
  Eigen::VectorXd lower_;
  Eigen::VectorXd upper_;
};

// Take the best of a screening that are not yet in the list.
void choose(const std::vector<Candidate>& candidates, const std::vector<Screened>& screened, std::size_t most,
            std::vector<Trial>& trials) {
  for (std::size_t i = 0; i < std::min(most, screened.size()); ++i) {
    const auto same = [&](const Trial& trial) { return trial.members == screened[i].members; };
    if (std::none_of(trials.begin(), trials.end(), same)) {
      trials.push_back(makeTrial(candidates, screened[i].members));
    }
  }
}

void sortByError(std::vector<Trial>& trials) {
  std::sort(trials.begin(), trials.end(),
            [](const Trial& x, const Trial& y) { return x.fit.held_out < y.fit.held_out; });
}

}  // namespace

bool hasTrends(const std::vector<Candidate>& candidates, const std::vector<int>& members) {
  return std::any_of(members.begin(), members.end(),
                     [&](int member) { return candidates[static_cast<std::size_t>(member)].free_trend; });
}

Search search(const Fitter& fitter, const Fitter& element_level, int threads, const ProgressCallback& progress) {
  const auto say = [&](const std::string& stage, double fraction) {
    if (progress) {
      progress(stage, fraction);
    }
  };
  Search result;
  result.candidates = candidates(summarise(fitter.records()));
  fitter.precompute(result.candidates, threads);

  say("re-estimating the model's own parameters", 0.0);
  result.configured_gap = fitter.gapAt(fitter.configured(0), {});
  result.re_estimated.fit = fitter.fit({}, fitter.configured(0), kBaseIterations);
  result.discretisation = discretisationError(fitter, result.re_estimated.fit.point);
  const std::vector<Eigen::VectorXd> starts = {result.re_estimated.fit.point.own, fitter.configured(0).own};

  say("fitting single effects", 0.1);
  for (int c = 0; c < static_cast<int>(result.candidates.size()); ++c) {
    result.singles.push_back(makeTrial(result.candidates, {c}));
  }
  parallelFor(result.singles.size() + 1, threads, [&](std::size_t i) {
    if (i == result.singles.size()) {
      result.element_level = element_level.fit({}, element_level.configured(0), kBaseIterations);
    } else {
      fitTrial(fitter, result.candidates, starts, kSingleIterations, result.singles[i]);
    }
  });

  std::vector<Trial> ranked = result.singles;
  sortByError(ranked);
  estimateNoise(fitter, ranked.front().fit, ranked.front().atoms, result);

  say("screening all pairs", 0.4);
  std::vector<Screened> screened[3];
  parallelFor(3, threads, [&](std::size_t i) {
    const Screen screen(fitter, result.candidates, i == 0 ? result.re_estimated : ranked[i - 1]);
    if (i == 0) {
      screened[i] = screen.pairs();
      screen.measureVisibility(result.noise, result);
      std::vector<int> all(result.candidates.size());
      std::iota(all.begin(), all.end(), 0);
      result.surrogate_gap = screen(all).error;
    } else {
      screened[i] = screen.additions(ranked[i - 1].members);
    }
  });
  choose(result.candidates, screened[0], kPairsFitted, result.pairs);
  choose(result.candidates, screened[1], kAdditionsFitted, result.pairs);
  choose(result.candidates, screened[2], kAdditionsFitted, result.pairs);
  say("fitting the best pairs", 0.5);
  const auto fitSeveral = [&](std::vector<Trial>& trials) {
    parallelFor(trials.size(), threads, [&](std::size_t i) {
      fitTrial(fitter, result.candidates, startsOf(result, trials[i].members), kPairIterations, trials[i]);
    });
  };
  fitSeveral(result.pairs);
  sortByError(result.pairs);

  const Trial& pair = result.pairs.front();
  if (pair.fit.held_out > kSignificantRest * result.noise) {
    say("fitting triples", 0.75);
    const Screen screen(fitter, result.candidates, pair);
    choose(result.candidates, screen.additions(pair.members), kAdditionsFitted, result.triples);
    fitSeveral(result.triples);
    sortByError(result.triples);
  }
  return result;
}

}  // namespace rubber_suspension
