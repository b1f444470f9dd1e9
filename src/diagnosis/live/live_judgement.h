// Judges a component while its bench runs, from looks at windows and from the errors on the blocks after a look.
// Evidence accumulates block by block and may be examined after each block.
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

/// Evidence from bets on blocks that no fit has used. The claimed model is fixed before a block is measured. The model
/// wins the block if its squared error is smaller than that of the configured model and that of the re-estimated model.
/// Suppose that one of these two models is right. The force of the claimed model then differs from the true force by
/// some d, and its squared error by sum(d^2) - 2 sum(d n), with the noise n of the block. If noise is as likely to be n
/// as -n, a claimed model wins with a probability of at most 1/2. The factor
///   E = 1 + b for a block won, 1 - b for a block lost
/// therefore has an expectation of at most 1 given all earlier blocks: it is a bet at fair odds or worse (Shafer, J. R.
/// Stat. Soc. A 184, 2021; Shafer and Vovk, Game-theoretic foundations for probability and finance, 2019). The
/// expectation of
///   R <- max(R, 1) E
/// after n bets is at most n. Ville's inequality for R - n then gives (Shin, Ramdas, Rinaldo, E-detectors, New England
/// J. Stat. Data Sci. 2, 2024)
///   P(R reaches c within n bets) <= n/c,   and a mean of at least c bets until R reaches c,
/// however often the evidence is examined and whenever the claim changes. Repeated looks therefore need no correction,
/// such as a significance level that they share. max(R, 1) discards bets that were lost before the effect began.
class SequentialEvidence {
 public:
  /// Creates evidence that suffices if R >= threshold.
  explicit SequentialEvidence(double threshold) : threshold_(threshold) {}

  void add(bool won) {
    constexpr double kMost = 1e30;  // above any threshold, and finite
    value_ = std::min(kMost, std::max(value_, 1.0) * (won ? 1.0 + kBet : 1.0 - kBet));
  }
  void forget() { value_ = 1.0; }

  double value() const { return value_; }
  double threshold() const { return threshold_; }
  bool isReached() const { return value_ >= threshold_; }

  /// b = 2 p - 1, the stake with which the capital grows fastest if an effect wins a share p = 0.9 of the blocks
  /// (Kelly, Bell Syst. Tech. J. 35, 1956).
  static constexpr double kBet = 0.8;

 private:
  double threshold_;
  double value_ = 1.0;
};

struct Look {
  Verdict verdict = Verdict::none;
  std::vector<std::string> effects;  ///< named effects
};

/// Standard deviations of measured minus simulated force on a block that no look has used [N]; NaN if there is no
/// model.
struct BlockErrors {
  std::int64_t begin = 0;  ///< stamp of the first sample in the block [ns]
  double force = 0.0;      ///< standard deviation of the measured force [N]
  double configured = 0.0;
  double re_estimated = std::numeric_limits<double>::quiet_NaN();
  double augmented = std::numeric_limits<double>::quiet_NaN();
};

struct LiveCriteria {
  double block = 1.0;  ///< length of a block [s]
  /// Lower bound of the mean time between two wrong names while the model is right [h]. The probability of a wrong name
  /// within a tenth of this time is at most 10 %.
  double hours_between_false_names = 1000.0;

  double threshold() const { return 3600.0 * hours_between_false_names / block; }
};

struct LiveVerdict {
  std::optional<Verdict> verdict;  ///< empty as long as there is no verdict
  std::vector<std::string> effects;
  std::optional<std::int64_t> since;  ///< onset [ns]; empty without a gap, or if the first block has the gap
  double evidence = 1.0;              ///< value of SequentialEvidence
  double threshold = 0.0;

  bool isGap() const { return verdict && *verdict != Verdict::none; }
};

/// Returns the verdict, or "watching" as long as there is none.
std::string toString(const LiveVerdict& verdict);

/// Judges from repeated looks, each of which may be wrong, according to these rules:
///   - An effect is named as soon as the blocks since the look are sufficient evidence for its model
///     (SequentialEvidence, whose guarantee holds for any sequence of looks). Until then there is no verdict.
///   - The name remains until kAgreeing successive looks without an effect agree on a verdict. Looks with an effect
///     update it.
///   - `none` is reported at once unless an effect is named. Other verdicts without an effect need kAgreeing looks.
///   - The onset is the last change of level in the logarithmic block errors of the configured model, if it is a rise.
/// Blocks in which the component hardly moves are ignored. Memory is bounded.
class LiveJudgement {
 public:
  explicit LiveJudgement(const LiveCriteria& criteria = {});

  void addBlock(const BlockErrors& block);
  void addLook(const Look& look);

  LiveVerdict now() const;

  /// Returns the stamp [ns] at which the error of the configured model last changed its level; nullopt if it never did.
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
  double usual_force_ = 0.0;   // running mean of the force over the blocks [N]
  std::optional<Look> claim_;  // newest look with an effect
  bool named_ = false;
  std::optional<Verdict> last_verdict_;  // verdict of the newest looks without an effect
  int agreeing_ = 0;
  std::optional<Verdict> said_;
};

struct ChangePoint {
  std::size_t first = 0;    ///< index of the first value after the change
  double likelihood = 0.0;  ///< logarithm of the ratio of the likelihoods with and without the change
  double before = 0.0;      ///< mean of the stretch before
  double after = 0.0;       ///< mean of the stretch after
};

/// Returns the most likely change in mean and spread of normal values (Hinkley, Biometrika 57, 1970), if its likelihood
/// ratio exceeds what the best of all positions reaches by chance. Each of the two stretches has at least four values.
std::optional<ChangePoint> mostLikelyChange(const std::vector<double>& values);

/// Returns the last change, found by binary segmentation (Scott and Knott, Biometrics 30, 1974): the sequence is split
/// at the most likely change, and the part behind it is split in the same way until no change is found.
std::optional<ChangePoint> lastChange(const std::vector<double>& values);

}  // namespace rubber_suspension::diagnosis::live
