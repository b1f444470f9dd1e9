// The judgement of a component while its bench runs, from looks at windows and the errors on the blocks since: the
// rule, without data and without time. Evidence grows block by block and may be looked at after each one.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::diagnosis::live {

/// Bets on blocks that no fit has seen. Before a block comes it is settled which model is the claim; the claim wins the
/// block where its squared error is smaller than those of the model as configured and of the re-estimated one. Where
/// one of those two is right, the claim's force differs from the true one by some d, and the errors from each other by
/// sum(d^2) - 2 sum(d n) with the noise n of the block: whatever the claim is, with noise as likely to be n as -n it
/// wins with a probability of at most 1/2. The factor
///   E = 1 + b for a block won, 1 - b for one lost
/// then has an expectation of at most 1 given all that was before: a bet at fair odds or worse (Shafer, J. R. Stat.
/// Soc. A 184, 2021; Shafer and Vovk, Game-theoretic foundations for probability and finance, 2019). Of
///   R <- max(R, 1) E
/// the expectation is at most the number n of bets so far, and so is that of its maximum's chance to have reached c,
/// times c (Ville's inequality for R - n; Shin, Ramdas, Rinaldo, E-detectors, New England J. Stat. Data Sci. 2, 2024):
///   P(R reaches c within n bets) <= n/c,   mean number of bets until it does, without an effect >= c,
/// however often one looks, whatever was looked at and whenever the claim changed. No correction for repeated looks,
/// such as spending a level on them, is left to do. Max(R, 1) forgets bets that were lost before the effect set in.
class SequentialEvidence {
 public:
  /// Reached with R >= threshold.
  explicit SequentialEvidence(double threshold) : threshold_(threshold) {}

  void add(bool won) {
    constexpr double kMost = 1e30;  // says no more than the threshold does, and stays finite
    value_ = std::min(kMost, std::max(value_, 1.0) * (won ? 1.0 + kBet : 1.0 - kBet));
  }
  void forget() { value_ = 1.0; }

  double value() const { return value_; }
  double threshold() const { return threshold_; }
  bool isReached() const { return value_ >= threshold_; }

  /// b: with an effect that wins nine blocks in ten, 2 p - 1 is the bet whose gain grows fastest (Kelly, Bell Syst.
  /// Tech. J. 35, 1956).
  static constexpr double kBet = 0.8;

 private:
  double threshold_;
  double value_ = 1.0;
};

/// The diagnosis of one window.
struct Look {
  Verdict verdict = Verdict::none;
  std::vector<std::string> effects;  ///< named
};

/// Errors on a block that no look has seen, each the RMS of measured less simulated force without its mean [N]. Not a
/// number where there is no such model.
struct BlockErrors {
  std::int64_t begin = 0;  ///< stamp of its first sample [ns]
  double force = 0.0;      ///< standard deviation of the measured force [N]
  double configured = 0.0;
  double re_estimated = std::numeric_limits<double>::quiet_NaN();
  double augmented = std::numeric_limits<double>::quiet_NaN();
};

struct LiveCriteria {
  double block = 1.0;  ///< length of a block [s]
  /// Mean time from one wrong name to the next while the model is right [h], at least; within a tenth of it there is
  /// one with a probability of at most 10 %. With 1000 h: one in 100 h at most, nine times in ten none.
  double hours_between_false_names = 1000.0;

  double threshold() const { return 3600.0 * hours_between_false_names / block; }
};

/// The judgement at the moment.
struct LiveVerdict {
  std::optional<Verdict> verdict;  ///< none while nothing can be said
  std::vector<std::string> effects;
  std::optional<std::int64_t> since;  ///< onset [ns]; nothing: from the first block on, or no gap is claimed
  double evidence = 1.0;              ///< of SequentialEvidence
  double threshold = 0.0;

  /// True where a gap is claimed.
  bool isGap() const { return verdict && *verdict != Verdict::none; }
};

/// The verdict, or "watching" while there is none.
std::string toString(const LiveVerdict& verdict);

/// Looks come again and again, and any of them may be wrong. What is said follows these rules:
///  - An effect is named once the blocks since the look are evidence for what it adds: see SequentialEvidence, whose
///    guarantee holds whatever the looks do. Until then there is no verdict.
///  - It stays, as the newest look with an effect has it, until kAgreeing looks in a row have none.
///  - `none` is said at once; the other verdicts without an effect once kAgreeing looks in a row have the same.
///  - The onset is where the level of the logarithmic block errors of the configured model last changed, if it rose
///    there.
/// Blocks in which the component hardly moves say nothing and are left out. Memory is bounded.
class LiveJudgement {
 public:
  explicit LiveJudgement(const LiveCriteria& criteria = {});

  void addBlock(const BlockErrors& block);
  void addLook(const Look& look);

  LiveVerdict now() const;

  /// Stamp from which on the error of the configured model is what it is now [ns]; nothing: from the first block on.
  std::optional<std::int64_t> regimeBegin() const;

  static constexpr int kAgreeing = 2;

 private:
  struct Point {
    std::int64_t begin;
    double log_error;
  };

  bool moves(const BlockErrors& block);
  std::vector<double> logErrors() const;

  LiveCriteria criteria_;
  SequentialEvidence evidence_;
  std::deque<Point> points_;
  double usual_force_ = 0.0;   // of the blocks so far [N]
  std::optional<Look> claim_;  // the newest look with an effect
  bool named_ = false;
  std::optional<Verdict> last_verdict_;  // of the looks without an effect
  int agreeing_ = 0;
  std::optional<Verdict> said_;
};

/// A change between two stretches of a sequence.
struct ChangePoint {
  std::size_t first = 0;    ///< place of the first value behind it
  double likelihood = 0.0;  ///< logarithm of the ratio of likelihoods, with the change to without it
  double before = 0.0;      ///< mean of the stretch before
  double after = 0.0;       ///< and of that behind
};

/// The most likely change of mean and spread of normal values (Hinkley, Biometrika 57, 1970), if there is one: if the
/// ratio of likelihoods exceeds what the best of all places gives by chance. Both stretches have at least kShortest
/// values.
std::optional<ChangePoint> mostLikelyChange(const std::vector<double>& values);

/// The last change: the sequence is cut at the most likely one, and what is behind it again, until there is none
/// (binary segmentation: Scott and Knott, Biometrics 30, 1974).
std::optional<ChangePoint> lastChange(const std::vector<double>& values);

}  // namespace rubber_suspension::diagnosis::live
