// The search over candidate effects.
#include "rubber_suspension/diagnosis/search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>

#include "fit/linear_least_squares.h"
#include "rubber_suspension/diagnosis/excess.h"
#include "rubber_suspension/diagnosis/friction_noise.h"
#include "rubber_suspension/fit/parallel.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr int kBaseIterations = 14;
constexpr int kSingleIterations = 6;
constexpr int kFurtherIterations = 3;
constexpr int kAloneIterations = 4;
constexpr std::size_t kPairsFitted = 6;
constexpr std::size_t kAdditionsFitted = 2;
constexpr double kSignificantRest = 1.5;  // held-out error over the noise floor that makes triples worth their time

Trial makeTrial(const std::vector<fit::Candidate>& candidates, const std::vector<int>& members) {
  Trial trial;
  trial.members = members;
  for (const int member : members) {
    const auto& atoms = candidates[static_cast<std::size_t>(member)].atoms;
    trial.atoms.insert(trial.atoms.end(), atoms.begin(), atoms.end());
  }
  return trial;
}

bool allAdditive(const Trial& trial) {
  return std::all_of(trial.atoms.begin(), trial.atoms.end(), [](const fit::Atom& atom) { return atom.additive; });
}

constexpr double kFar = 0.2;  // a logarithm of an own parameter: far enough for a second start from the configured ones

void keepBetter(fit::Fit fit, Trial& trial) {
  if (trial.fit.block_errors.empty() || fit.score() < trial.fit.score()) {
    trial.fit = std::move(fit);
  }
}

// A single effect, from where the own parameters alone arrived, and from where it gets with the configured ones kept if
// these are far from there or if it changes what the others do; in the latter case from no effect, too.
void fitSingle(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates, const Trial& re_estimated,
               Trial& trial) {
  const bool trends = hasTrends(candidates, trial.members);
  const fit::Point configured = fitter.configured(trial.atoms.size());
  fit::Point start = configured;
  start.own = re_estimated.fit.point.own;
  keepBetter(fitter.fit(trial.atoms, start, kSingleIterations, trends), trial);
  const bool far = start.furthestMove() > kFar;
  const bool additive = allAdditive(trial);
  if (far && !additive) {
    keepBetter(fitter.fit(trial.atoms, configured, kSingleIterations, trends), trial);
  }
  if (far || !additive) {
    start = fitter.scalesAlone(trial.atoms, configured, additive ? 1 : kAloneIterations);
    keepBetter(fitter.fit(trial.atoms, start, kSingleIterations, trends), trial);
  }
}

// Several effects, from where some of them arrived.
void fitFurther(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates, const Trial& from,
                Trial& trial) {
  const bool trends = hasTrends(candidates, trial.members);
  fit::Point start = fitter.configured(trial.atoms.size());
  std::vector<bool> active(trial.atoms.size(), true);
  start.own = from.fit.point.own;
  std::size_t place = 0;
  std::size_t place_from = 0;
  for (const int member : trial.members) {
    const bool known = std::find(from.members.begin(), from.members.end(), member) != from.members.end();
    for (const fit::Atom& atom : candidates[static_cast<std::size_t>(member)].atoms) {
      if (known) {
        const double scale = from.fit.point.scales[static_cast<Eigen::Index>(place_from++)];
        start.scales[static_cast<Eigen::Index>(place)] = scale;
        active[place] = atom.additive || scale != 0.0;
      }
      ++place;
    }
  }
  keepBetter(fitter.fit(trial.atoms, start, kFurtherIterations, trends, active), trial);
  if (start.furthestMove() > kFar && allAdditive(trial)) {
    start = fitter.scalesAlone(trial.atoms, fitter.configured(trial.atoms.size()), 1);
    keepBetter(fitter.fit(trial.atoms, start, kSingleIterations, trends), trial);
  }
}

// The best fit among those of the members alone.
const Trial& bestMember(const Search& result, const std::vector<int>& members) {
  const Trial* best = &result.singles[static_cast<std::size_t>(members.front())];
  for (const int member : members) {
    const Trial& single = result.singles[static_cast<std::size_t>(member)];
    best = single.fit.score() < best->fit.score() ? &single : best;
  }
  return *best;
}

// A dashpot takes the displacement as linear between samples: its force lags by half a step, which looks like a delay.
// RMS of what the lag makes of the model's force, weighted as a gap is.
double discretisationError(const fit::Fitter& fitter, const fit::Point& point) {
  std::vector<element::ElementDescription> elements = *fitter.elements(point, {});
  bool any = false;
  for (element::ElementDescription& element : elements) {
    if (element.type == "dashpot") {
      element.values["order"] = {2.0};
      any = true;
    }
  }
  if (!any) {
    return 0.0;
  }
  const auto smooth = fit::simulate(elements, fitter.records());
  const auto lagging = *fitter.forces(point, {});
  double sum = 0.0;
  for (std::size_t r = 0; r < smooth.size(); ++r) {
    const log::Record& record = fitter.records()[r];
    sum += (smooth[r] - lagging[r]).squaredNorm() / static_cast<double>(record.size()) /
           std::pow(record.force_deviation, 2);
  }
  return std::sqrt(sum / static_cast<double>(smooth.size()));
}

// For each log, the larger one of the white noise of what the best model leaves above the band of the excitation, and
// of what the noise of the displacement causes.
void estimateNoise(const fit::Fitter& fitter, const fit::Fit& best, const std::vector<fit::Atom>& atoms,
                   Search& result) {
  const auto forces = *fitter.forces(best.point, atoms);
  const std::vector<double> caused =
      frictionNoise(*fitter.elements(result.re_estimated.fit.point, {}), fitter.records());
  double sum = 0.0;
  bool by_displacement = false;
  for (std::size_t r = 0; r < fitter.records().size(); ++r) {
    const log::Record& record = fitter.records()[r];
    const double white = log::whiteNoiseFloor(record, record.force - forces[r]);
    by_displacement = by_displacement || caused[r] > white;
    result.record_noise.push_back(std::max(white, caused[r]));
    sum += std::pow(result.record_noise.back(), 2) / static_cast<double>(fitter.records().size());
  }
  result.noise = std::sqrt(sum);
  result.noise_source = by_displacement ? "spectrum of the residual above the band of the excitation, and noise of the "
                                          "displacement through the model"
                                        : "spectrum of the residual above the band of the excitation";
}

struct Screened {
  std::vector<int> members;
  double error;
};

// Held-out errors of many hypotheses from one set of normal equations with the atoms of all candidates.
class Screen {
 public:
  // About a fitted trial: its own parameters and scales, all other candidates at nothing.
  Screen(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates, const Trial& about, int threads)
      : candidates_(candidates), own_(fitter.own().size()), threads_(threads) {
    fit::Point point{about.fit.point.own, {}};
    std::vector<double> scales;
    for (int c = 0; c < static_cast<int>(candidates.size()); ++c) {
      columns_of_.emplace_back();
      for (const fit::Atom& atom : candidates[static_cast<std::size_t>(c)].atoms) {
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
    blocks_ = fitter.linearise(point, all_, true, {}, threads);
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
    const std::vector<double> errors = fit::crossValidate(blocks_, columns, lower, upper);
    return {members, std::sqrt(std::inner_product(errors.begin(), errors.end(), blocks_.weight.begin(), 0.0))};
  }

  // Each other candidate added to these, best first.
  std::vector<Screened> additions(const std::vector<int>& members) const {
    std::vector<std::vector<int>> sets;
    for (int c = 0; c < static_cast<int>(candidates_.size()); ++c) {
      if (std::find(members.begin(), members.end(), c) == members.end() && !hasLastResort(candidates_, {c})) {
        sets.push_back(members);
        sets.back().push_back(c);
      }
    }
    return screened(sets);
  }

  std::vector<Screened> pairs() const {
    std::vector<std::vector<int>> sets;
    const int count = static_cast<int>(candidates_.size());
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        if (!hasLastResort(candidates_, {a, b})) {
          sets.push_back({a, b});
        }
      }
    }
    return screened(sets);
  }

  // Part of each candidate's force that the model's own parameters cannot take over, and whether a typical size of it
  // stands out of the noise.
  void measureVisibility(double noise, Search& result) const {
    constexpr double kVisible = 0.05;
    constexpr double kOverNoise = 0.2;
    const Eigen::MatrixXd total = blocks_.sum - blocks_.prior;
    const fit::LeastNorm base(total.topLeftCorner(own_, own_));
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

  // Best first.
  std::vector<Screened> screened(const std::vector<std::vector<int>>& sets) const {
    std::vector<Screened> result(sets.size());
    fit::parallelFor(sets.size(), threads_, [&](std::size_t i) { result[i] = (*this)(sets[i]); });
    std::stable_sort(result.begin(), result.end(),
                     [](const Screened& x, const Screened& y) { return x.error < y.error; });
    return result;
  }

  const std::vector<fit::Candidate>& candidates_;
  Eigen::Index own_;
  int threads_;
  std::vector<fit::Atom> all_;
  std::vector<std::vector<Eigen::Index>> columns_of_;
  fit::BlockGrams blocks_;
  Eigen::VectorXd lower_;
  Eigen::VectorXd upper_;
};

// Take the best of a screening that are not yet in the list.
void choose(const std::vector<fit::Candidate>& candidates, const std::vector<Screened>& screened, std::size_t most,
            std::vector<Trial>& trials) {
  for (std::size_t i = 0; i < std::min(most, screened.size()); ++i) {
    const auto same = [&](const Trial& trial) { return trial.members == screened[i].members; };
    if (std::none_of(trials.begin(), trials.end(), same)) {
      trials.push_back(makeTrial(candidates, screened[i].members));
    }
  }
}

void sortByScore(std::vector<Trial>& trials) {
  std::sort(trials.begin(), trials.end(), [](const Trial& x, const Trial& y) { return x.fit.score() < y.fit.score(); });
}

class Searcher {
 public:
  Searcher(const fit::Fitter& fitter, const fit::Fitter& element_level, int threads, const ProgressCallback& progress)
      : fitter_(fitter), element_level_(element_level), threads_(threads), progress_(progress) {}

  Search run() {
    say("re-estimating the model parameters", 0.0);
    reEstimate();
    say("fitting single effects", 0.1);
    result_.candidates = fit::candidates(result_.excitation);
    fitter_.precompute(result_.candidates, threads_);
    fitSingles();
    say("screening all pairs", 0.4);
    const std::vector<Screened> pairs = screenPairs();
    if (restIsLeft()) {
      say("fitting the best pairs", 0.5);
      fitPairs(pairs);
      if (result_.pairs.front().fit.held_out > kSignificantRest * result_.noise) {
        say("fitting triples", 0.75);
        fitTriples();
      }
    }
    return std::move(result_);
  }

 private:
  void say(const std::string& stage, double fraction) const {
    if (progress_) {
      progress_(stage, fraction);
    }
  }

  // Own parameters as specified and as elements, and what the logs excite: three tasks that need nothing of each other.
  void reEstimate() {
    const std::array<std::function<void()>, 3> tasks = {
        [this] {
          result_.configured_gap = fitter_.gapAt(fitter_.configured(0), {});
          result_.re_estimated.fit = fitter_.fit({}, fitter_.configured(0), kBaseIterations);
          result_.discretisation = discretisationError(fitter_, result_.re_estimated.fit.point);
        },
        [this] { result_.element_level = element_level_.fit({}, element_level_.configured(0), kBaseIterations); },
        [this] { result_.excitation = fit::summarise(fitter_.records()); }};
    fit::parallelFor(tasks.size(), threads_, [&](std::size_t i) { tasks[i](); });
  }

  void fitSingles() {
    for (int c = 0; c < static_cast<int>(result_.candidates.size()); ++c) {
      result_.singles.push_back(makeTrial(result_.candidates, {c}));
    }
    // What has to be simulated takes longest and comes first, so that no thread waits for it at the end.
    std::vector<Trial*> order;
    for (Trial& single : result_.singles) {
      order.push_back(&single);
    }
    std::stable_partition(order.begin(), order.end(), [](const Trial* single) { return !allAdditive(*single); });
    fit::parallelFor(order.size(), threads_,
                     [&](std::size_t i) { fitSingle(fitter_, result_.candidates, result_.re_estimated, *order[i]); });
    std::copy_if(result_.singles.begin(), result_.singles.end(), std::back_inserter(ranked_),
                 [&](const Trial& trial) { return !hasLastResort(result_.candidates, trial.members); });
    sortByScore(ranked_);
    estimateNoise(fitter_, ranked_.front().fit, ranked_.front().atoms, result_);
  }

  // All pairs about the re-estimated model; on the way, what is visible and what a flexible fit could close.
  std::vector<Screened> screenPairs() {
    const Screen screen(fitter_, result_.candidates, result_.re_estimated, threads_);
    screen.measureVisibility(result_.noise, result_);
    std::vector<int> all(result_.candidates.size());
    std::iota(all.begin(), all.end(), 0);
    result_.surrogate_gap = screen(all).error;
    return screen.pairs();
  }

  bool restIsLeft() const {
    if (closedByOwnParameters(result_)) {
      return false;
    }
    const Trial* single = bestSingle(result_);
    // A trend follows whatever is slow: it may stand for two effects that are.
    return single == nullptr || excess(result_, *single) > enough(result_) ||
           hasTrends(result_.candidates, single->members);
  }

  void fitPairs(const std::vector<Screened>& screened) {
    choose(result_.candidates, screened, kPairsFitted, result_.pairs);
    for (const Trial* single : {&ranked_[0], &ranked_[1]}) {
      const Screen screen(fitter_, result_.candidates, *single, threads_);
      choose(result_.candidates, screen.additions(single->members), kAdditionsFitted, result_.pairs);
    }
    fit::parallelFor(result_.pairs.size(), threads_, [&](std::size_t i) {
      Trial& pair = result_.pairs[i];
      fitFurther(fitter_, result_.candidates, bestMember(result_, pair.members), pair);
    });
    sortByScore(result_.pairs);
  }

  void fitTriples() {
    const Trial& pair = result_.pairs.front();
    const Screen screen(fitter_, result_.candidates, pair, threads_);
    choose(result_.candidates, screen.additions(pair.members), kAdditionsFitted, result_.triples);
    fit::parallelFor(result_.triples.size(), threads_,
                     [&](std::size_t i) { fitFurther(fitter_, result_.candidates, pair, result_.triples[i]); });
    sortByScore(result_.triples);
  }

  const fit::Fitter& fitter_;
  const fit::Fitter& element_level_;
  int threads_;
  const ProgressCallback& progress_;
  Search result_;
  std::vector<Trial> ranked_;  // singles but for last resorts, best first
};

}  // namespace

bool hasTrends(const std::vector<fit::Candidate>& candidates, const std::vector<int>& members) {
  return std::any_of(members.begin(), members.end(),
                     [&](int member) { return candidates[static_cast<std::size_t>(member)].free_trend; });
}

bool hasLastResort(const std::vector<fit::Candidate>& candidates, const std::vector<int>& members) {
  return std::any_of(members.begin(), members.end(),
                     [&](int member) { return candidates[static_cast<std::size_t>(member)].last_resort; });
}

Search search(const fit::Fitter& fitter, const fit::Fitter& element_level, int threads,
              const ProgressCallback& progress) {
  return Searcher(fitter, element_level, threads, progress).run();
}

}  // namespace rubber_suspension::diagnosis
