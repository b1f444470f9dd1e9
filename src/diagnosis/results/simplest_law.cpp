// Chooses among laws with few numbers.
#include "diagnosis/results/simplest_law.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "diagnosis/judge/numbers.h"
#include "diagnosis/judge/score.h"
#include "element/each.h"
#include "numerics/bounded_least_squares.h"
#include "rubber_suspension/gap/gap.h"

namespace rubber_suspension::diagnosis::results {
namespace {

constexpr std::size_t kMostTerms = 3;    // largest number of basis terms of a law
constexpr std::size_t kMostNumbers = 6;  // largest number of free numbers of a law
constexpr int kSteps = 12;               // iterations of a fit
// A law is not fitted if its expected gap exceeds the allowed gap by this factor.
constexpr double kHopeless = 2.0;
constexpr double kOfTypical = 1e-6;  // a scale below this share of its typical value counts as 0

using Indices = std::vector<Eigen::Index>;

bool has(const Indices& columns, Eigen::Index column) {
  return std::find(columns.begin(), columns.end(), column) != columns.end();
}

// Start of the fit of a law, and the squared gap that the normal equations at the full law predict for it.
struct Start {
  Entries entries;
  double square = std::numeric_limits<double>::infinity();
};

// Best start for each count of numbers and each kind of the first term. All kinds are kept, because the linear normal
// equations do not show which kind will fit best.
using Starts = std::map<std::size_t, std::map<std::string, Start>>;

// Solves least squares for subsets of the terms of one effect, while all other parameters are free.
class Subsets {
 public:
  // `from` are the columns of the terms in the normal equations, and `free` the columns of all other free parameters.
  // The residual without the effect has the products `moment` with the columns and `square` with itself. The first
  // `own` terms belong to the candidate, the others to its further laws.
  Subsets(const Eigen::MatrixXd& gram, std::vector<fit::BasisTerm> terms, std::size_t own, const Indices& from,
          const Indices& free, const Eigen::VectorXd& moment, double square)
      : terms_(std::move(terms)), square_(square) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Eigen::MatrixXd of_free = gram(free, free);
    const auto unbounded = Eigen::VectorXd::Constant(of_free.rows(), kInfinity).eval();
    const auto solve = [&](const Eigen::VectorXd& right) {
      return numerics::boundedLeastSquares(of_free, right, -unbounded, unbounded);
    };
    const Eigen::MatrixXd across = gram(free, from);
    const Eigen::VectorXd of_moment = solve(moment(free));
    gram_ = gram(from, from);
    for (Eigen::Index j = 0; j < gram_.cols(); ++j) {
      gram_.col(j) -= across.transpose() * solve(across.col(j));
    }
    moment_ = moment(from) - across.transpose() * of_moment;
    square_ -= of_moment.dot(moment(free));
    for (const fit::BasisTerm& term : terms_) {
      const Entries one = {term.at(term.typical)};
      numbers_.push_back(numbersOf(one).size());
      kinds_.push_back(one.front().type + (kinds_.size() < own ? "" : " of another form"));
    }
  }

  Starts best() {
    tryFrom(0, {}, 0);
    return std::move(best_);
  }

 private:
  void tryFrom(std::size_t first, const Indices& chosen, std::size_t numbers) {
    for (std::size_t t = first; t < terms_.size(); ++t) {
      const bool of_one_kind = chosen.empty() || kinds_[t] == kinds_[static_cast<std::size_t>(chosen.front())];
      if (numbers + numbers_[t] > kMostNumbers || (terms_[t].additive && !of_one_kind)) {
        continue;
      }
      Indices more = chosen;
      more.push_back(static_cast<Eigen::Index>(t));
      rate(more, best_[numbers + numbers_[t]][kinds_[static_cast<std::size_t>(more.front())]]);
      if (more.size() < kMostTerms) {
        tryFrom(t + 1, more, numbers + numbers_[t]);
      }
    }
  }

  void rate(const Indices& chosen, Start& best) const {
    const auto count = static_cast<Eigen::Index>(chosen.size());
    Eigen::VectorXd lower(count);
    Eigen::VectorXd upper(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      lower[i] = term(chosen, i).lower;
      upper[i] = term(chosen, i).upper;
    }
    const Eigen::VectorXd moment = moment_(chosen);
    const Eigen::MatrixXd gram = gram_(chosen, chosen);
    const Eigen::VectorXd scales = numerics::boundedLeastSquares(gram, moment, lower, upper);
    const double square = square_ - 2.0 * scales.dot(moment) + scales.dot(gram * scales);
    if (!(square < best.square)) {
      return;
    }
    MemberLaw law;
    for (Eigen::Index i = 0; i < count; ++i) {
      if (std::abs(scales[i]) < kOfTypical * term(chosen, i).typical) {
        return;  // equal to a law with fewer terms
      }
      law.terms.push_back(term(chosen, i));
    }
    best = {law.at(scales), square};
  }

  const fit::BasisTerm& term(const Indices& chosen, Eigen::Index i) const {
    return terms_[static_cast<std::size_t>(chosen[static_cast<std::size_t>(i)])];
  }

  std::vector<fit::BasisTerm> terms_;
  std::vector<std::size_t> numbers_;  // count of free numbers of each term
  std::vector<std::string> kinds_;    // kind of each term
  Eigen::MatrixXd gram_;
  Eigen::VectorXd moment_;
  double square_;
  Starts best_;
};

class Chooser {
 public:
  Chooser(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates,
          const hypotheses::FittedHypothesis& judged, const std::vector<gap::PreparedRecord>& held_out, double before,
          int threads)
      : fitter_(fitter),
        candidates_(candidates),
        judged_(judged),
        held_out_(held_out),
        before_(before),
        threads_(threads) {}

  SimplestLaw run() {
    result_.fitted = fullLaw(judged_);
    if (result_.fitted.law.members.empty()) {
      return std::move(result_);
    }
    linearise();
    const judge::JudgeNumbers& numbers = judge::fittedNumbers();
    gap_ = gapOf(result_.fitted);
    const double full = std::pow(gap_, 2);
    const double most = 0.5 * (full + std::pow(before_, 2));  // the law has to close half of what the full law closes
    double allowed = full + std::pow(numbers.accepted, 2);
    for (std::size_t m = 0; m < own_.size(); ++m) {
      result_.form_error.push_back((candidateOf(m).one_form ? numbers.form_error_of_one : numbers.form_error) *
                                   addedBy(m));
      allowed += std::pow(result_.form_error[m], 2);
      expected_ = allowed - full;
      simplify(m, std::min(allowed, most));
    }
    return std::move(result_);
  }

 private:
  const fit::Candidate& candidateOf(std::size_t m) const {
    return candidates_[static_cast<std::size_t>(judged_.hypothesis.members[m])];
  }

  // Linearises the fit at the full law, after adding the further laws of each effect with scales of 0.
  void linearise() {
    extended_ = judged_.hypothesis;
    const Eigen::Index of_model = fitter_.model().size();
    const auto columnOf = [&](std::size_t term) { return of_model + static_cast<Eigen::Index>(term); };
    std::size_t first = 0;
    for (std::size_t m = 0; m < judged_.hypothesis.members.size(); ++m) {
      Indices own;
      Indices beyond;
      for (std::size_t t = 0; t < judged_.hypothesis.counts[m]; ++t, ++first) {
        own.push_back(columnOf(first));
        if (judged_.hypothesis.places[first].candidate == judged_.hypothesis.members[m]) {
          beyond.push_back(columnOf(first));
        }
      }
      own_.push_back(own);
      of_candidate_.push_back(beyond.size());
      pool_.push_back(beyond);
      std::vector<fit::Candidate> laws = {fit::Candidate{}};
      laws.front().terms = candidateOf(m).laws;
      fit::findUnitEffects(laws, fitter_.records(), threads_);
      for (const fit::BasisTerm& term : laws.front().terms) {
        pool_.back().push_back(columnOf(extended_.terms.size()));
        extended_.terms.push_back(term);
      }
    }
    fit::ParameterVector about = judged_.fit.parameters;
    about.scales.conservativeResizeLike(Eigen::VectorXd::Zero(static_cast<Eigen::Index>(extended_.terms.size())));
    scales_ = about.scales;
    blocks_ = fitter_.linearise(extended_, about, {}, threads_);
  }

  const fit::BasisTerm& termAt(Eigen::Index column) const {
    return extended_.terms[static_cast<std::size_t>(column - fitter_.model().size())];
  }

  double scaleAt(Eigen::Index column) const { return scales_[column - fitter_.model().size()]; }

  // Returns the RMS of the force that an effect adds, divided by the standard deviation of the force.
  double addedBy(std::size_t m) const {
    const Indices& own = own_[m];
    Eigen::VectorXd scales(static_cast<Eigen::Index>(own.size()));
    for (std::size_t i = 0; i < own.size(); ++i) {
      scales[static_cast<Eigen::Index>(i)] = scaleAt(own[i]);
    }
    return std::sqrt(std::max(0.0, scales.dot(Eigen::MatrixXd(blocks_.sum(own, own)) * scales)));
  }

  // Returns starts of the best laws for an effect, found with the normal equations.
  Starts startsOf(std::size_t m) const {
    const Eigen::Index last = blocks_.sum.cols() - 1;
    Eigen::VectorXd moment = blocks_.sum.col(last);
    double square = blocks_.sum(last, last);
    for (const Eigen::Index t : own_[m]) {  // removes the effect from the residual
      square += scaleAt(t) * (2.0 * moment[t] + scaleAt(t) * blocks_.sum(t, t));
      moment += scaleAt(t) * blocks_.sum.col(t);
    }
    Indices free;
    for (Eigen::Index j = 0; j < last; ++j) {
      const bool is_term = j >= fitter_.model().size() && j < fitter_.model().size() + scales_.size();
      const bool is_own = has(pool_[m], j) || has(own_[m], j);
      if (!is_own && (!is_term || scaleAt(j) != 0.0)) {
        free.push_back(j);
      }
    }
    const auto terms = element::each(pool_[m], [&](Eigen::Index t) { return termAt(t); });
    return Subsets(blocks_.sum, terms, of_candidate_[m], pool_[m], free, moment, square).best();
  }

  struct Allowed {
    std::size_t numbers;
    double gap;
    FittedLaw law;
  };

  void simplify(std::size_t m, double allowed) {
    const std::vector<Entries> full = result_.fitted.law.at(result_.fitted.fit.parameters.scales);
    const std::size_t most = numbersOf(full[m]).size();
    std::vector<Allowed> laws;
    std::set<std::string> kinds;  // kinds of the allowed laws
    for (const auto& [most_numbers, starts] : startsOf(m)) {
      for (const auto& [kind, start] : starts) {
        const std::size_t numbers = numbersOf(start.entries).size();  // a number at a limit does not count
        const bool is_new = numbers <= most && kinds.count(kind) == 0;
        if (std::optional<Allowed> law = is_new ? allowedOf(m, start, numbers, allowed) : std::nullopt) {
          laws.push_back(std::move(*law));
          kinds.insert(kind);
        }
      }
    }
    if (laws.empty() || isExactEnough(m, laws.front().gap)) {
      return;
    }
    std::sort(laws.begin(), laws.end(), [](const Allowed& a, const Allowed& b) {
      return a.numbers != b.numbers ? a.numbers < b.numbers : a.gap < b.gap;
    });
    for (auto larger = std::next(laws.begin()); larger != laws.end(); ++larger) {
      if (tellsMore(m, *larger, laws.front())) {
        std::iter_swap(laws.begin(), larger);
      }
    }
    const Allowed chosen = std::exchange(laws.front(), {most, gap_, std::move(result_.fitted)});
    for (Allowed& law : laws) {
      // Only the element errs if the force is exact: its number is as likely as the refitted one.
      const bool is_exact = &law == &laws.front() && hasExactForce(m);
      const double odds = is_exact ? 1.0 : oddsOver(chosen, law);
      result_.others.push_back({std::move(law.law), odds});
    }
    result_.fitted = chosen.law;
    gap_ = chosen.gap;
  }

  // Returns true if the exact term is kept instead of a fitted element. The force of an exact term (BasisTerm::exact)
  // is computed from later samples as well. Its element, such as a mass, cannot use later samples, and its refitted
  // number compensates for that. The exact term is kept if it removes more than half of the squared error that the
  // element removes.
  bool isExactEnough(std::size_t m, double gap_of_fitted) const {
    return hasExactForce(m) && gap_ * gap_ < 0.5 * (gap_of_fitted * gap_of_fitted + before_ * before_);
  }

  bool hasExactForce(std::size_t m) const { return own_[m].size() == 1 && termAt(own_[m].front()).exact; }

  // Returns the odds of `other` relative to `chosen`. As in the judgement, only errors above that of the better law
  // count. The number of parameters does not count, because it is no evidence on the size of the effect.
  double oddsOver(const Allowed& chosen, const Allowed& other) const {
    const judge::JudgeNumbers& numbers = judge::fittedNumbers();
    const double least = std::pow(std::min(chosen.gap, other.gap), 2);
    const auto logWeight = [&](const Allowed& law) {
      return -0.5 * numbers.sharpness * judge::lossOf(law.gap * law.gap - least, expected_, numbers);
    };
    return std::exp(logWeight(other) - logWeight(chosen));
  }

  // Returns true if a law of the same element with more numbers reduces the squared gap by more than the squared
  // accepted error per additional number. The numbers of the smaller law are then wrong: they compensate for missing
  // ones.
  static bool tellsMore(std::size_t m, const Allowed& larger, const Allowed& smaller) {
    const Entries& of_larger = larger.law.law.members[m].start;
    const Entries& of_smaller = smaller.law.law.members[m].start;
    const double beyond = static_cast<double>(larger.numbers) - static_cast<double>(smaller.numbers);
    return of_larger.size() == 1 && of_smaller.size() == 1 && of_larger[0].type == of_smaller[0].type &&
           std::pow(larger.gap, 2) + beyond * std::pow(judge::fittedNumbers().accepted, 2) < std::pow(smaller.gap, 2);
  }

  std::optional<Allowed> allowedOf(std::size_t m, const Start& start, std::size_t numbers, double allowed) const {
    if (start.entries.empty() || start.square > kHopeless * kHopeless * allowed) {
      return std::nullopt;
    }
    try {
      Allowed law{numbers, 0.0, fitted(m, start.entries, std::sqrt(allowed))};
      law.gap = gapOf(law.law);
      return law.gap * law.gap <= allowed ? std::optional(std::move(law)) : std::nullopt;
    } catch (const std::invalid_argument&) {
      return std::nullopt;  // no component can have these numbers
    }
  }

  FittedLaw fitted(std::size_t m, const Entries& start, double needed) const {
    FittedLaw simple{result_.fitted.law, {}};
    MemberLaw& member = simple.law.members[m];
    member.terms.clear();
    member.start = start;
    member.longest_time = 0.0;
    for (const log::Record& record : fitter_.records()) {
      member.longest_time = std::max(member.longest_time, record.duration());
    }
    const fit::Hypothesis hypothesis = simple.law.hypothesis();
    fit::ParameterVector from{result_.fitted.fit.parameters.model,
                              Eigen::VectorXd::Zero(static_cast<Eigen::Index>(hypothesis.terms.size()))};
    Eigen::Index to = 0;
    Eigen::Index of = 0;
    for (std::size_t i = 0; i < simple.law.members.size(); ++i) {
      const auto size = static_cast<Eigen::Index>(simple.law.members[i].size());
      if (i != m) {
        from.scales.segment(to, size) = result_.fitted.fit.parameters.scales.segment(of, size);
      }
      to += size;
      of += static_cast<Eigen::Index>(result_.fitted.law.members[i].size());
    }
    simple.fit = fitter_.fit(hypothesis, from, {kSteps, kHopeless * needed, {}, needed, threads_});
    return simple;
  }

  double gapOf(const FittedLaw& fitted) const {
    return gap::gapOfParts(unseenErrors(fitter_, fitted, elementsOf(fitter_.model(), fitted), held_out_));
  }

  const fit::Fitter& fitter_;
  const std::vector<fit::Candidate>& candidates_;
  const hypotheses::FittedHypothesis& judged_;
  const std::vector<gap::PreparedRecord>& held_out_;
  const double before_;
  const int threads_;
  fit::Hypothesis extended_;
  Eigen::VectorXd scales_;    // scales of the terms in the full law
  std::vector<Indices> own_;  // columns of the terms of each effect
  // For each effect, columns of the terms of its candidate, then of the further laws of the candidate.
  std::vector<Indices> pool_;
  std::vector<std::size_t> of_candidate_;  // for each effect, number of columns of its candidate in pool_
  fit::BlockGrams blocks_;
  // Expected excess of the squared gap over that of the full law, for the effects simplified so far.
  double expected_ = 0.0;
  double gap_ = 0.0;  // gap of the law so far
  SimplestLaw result_;
};

}  // namespace

FittedLaw fullLaw(const hypotheses::FittedHypothesis& judged) {
  FittedLaw result{{}, judged.fit};
  result.law.about.free_in_log = judged.hypothesis.free_in_log;
  std::vector<double> scales;
  Eigen::Index next = 0;
  for (const int member : judged.hypothesis.members) {
    MemberLaw law;
    law.member = member;
    const std::size_t terms = judged.hypothesis.counts[result.law.members.size()];
    for (std::size_t t = 0; t < terms; ++t, ++next) {
      const bool last = t + 1 == terms && law.terms.empty();
      if (judged.fit.parameters.scales[next] != 0.0 || last) {
        law.terms.push_back(judged.hypothesis.terms[static_cast<std::size_t>(next)]);
        scales.push_back(judged.fit.parameters.scales[next]);
      }
    }
    result.law.members.push_back(std::move(law));
  }
  result.fit.parameters.scales =
      Eigen::Map<const Eigen::VectorXd>(scales.data(), static_cast<Eigen::Index>(scales.size()));
  return result;
}

SimplestLaw simplestLaw(const fit::Fitter& fitter, const std::vector<fit::Candidate>& candidates,
                        const hypotheses::FittedHypothesis& judged, const std::vector<gap::PreparedRecord>& held_out,
                        double before, int threads) {
  return Chooser(fitter, candidates, judged, held_out, before, threads).run();
}

}  // namespace rubber_suspension::diagnosis::results
