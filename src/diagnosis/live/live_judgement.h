// Judgement of a component while its bench runs, from looks at windows and the errors on the blocks since. Evidence
// grows block by block and may be examined after each one.
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

/// Bets on blocks that no fit has used. The claimed model is fixed before a block is measured; it wins the block if its
/// squared error is smaller than those of the configured and of the re-estimated model. If one of those two is right,
/// the force of the claimed model differs from the true one by some d, and the squared errors differ by sum(d^2) - 2
/// sum(d n) with the noise n of the block. If noise is as likely to be n as -n, any claimed model wins with a
/// probability of at most 1/2. The factor
///   E = 1 + b for a block won, 1 - b for one lost
/// then has an expectation of at most 1 given all earlier blocks: a bet at fair odds or worse (Shafer, J. R. Stat. Soc.
/// A 184, 2021; Shafer and Vovk, Game-theoretic foundations for probability and finance, 2019). The expectation of
///   R <- max(R, 1) E
/// after n bets is at most n, and Ville's inequality for R - n gives (Shin, Ramdas, Rinaldo, E-detectors, New England
/// J. Stat. Data Sci. 2, 2024)
///   P(R reaches c within n bets) <= n/c,   mean number of bets until it does, without an effect >= c,
/// however often one looks and whenever the claim changes. So repeated looks need no correction, such as a significance
/// level shared among them. max(R, 1) discards bets that were lost before the effect began.
class SequentialEvidence {
 public:
  /// Creates evidence that is reached if R >= threshold.
  explicit SequentialEvidence(double threshold) : threshold_(threshold) {}

  void add(bool won) {
    constexpr double kMost = 1e30;  // beyond any threshold, and finite
    value_ = std::min(kMost, std::max(value_, 1.0) * (won ? 1.0 + kBet : 1.0 - kBet));
  }
  void forget() { value_ = 1.0; }

  double value() const { return value_; }
  double threshold() const { return threshold_; }
  bool isReached() const { return value_ >= threshold_; }

  /// b = 2 p - 1, the bet whose capital grows fastest if an effect wins a share p = 0.9 of the blocks (Kelly, Bell
  /// Syst. Tech. J. 35, 1956).
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

/// Errors on a block that no look has used: RMS of measured minus simulated force without its mean [N]; NaN if there is
/// no such model.
struct BlockErrors {
  std::int64_t begin = 0;  ///< stamp of its first sample [ns]
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

/// The judgement at the moment.
struct LiveVerdict {
  std::optional<Verdict> verdict;  ///< empty until there is one
  std::vector<std::string> effects;
  std::optional<std::int64_t> since;  ///< onset [ns]; empty if there is no gap, or one from the first block on
  double evidence = 1.0;              ///< of SequentialEvidence
  double threshold = 0.0;

  /// True if a gap is reported.
  bool isGap() const { return verdict && *verdict != Verdict::none; }
};

/// Returns the verdict, or "watching" while there is none.
std::string toString(const LiveVerdict& verdict);

/// Judges from repeated looks, each of which may be wrong, by these rules:
///  - An effect is named once the blocks since the look are evidence for its model (SequentialEvidence, whose guarantee
///    holds for any sequence of looks). Until then there is no verdict.
///  - The name remains, updated by each look with an effect, until kAgreeing looks in a row agree on another verdict.
///  - `none` is reported at once unless an effect is named; other verdicts without an effect need kAgreeing looks.
///  - The onset is the last change of level in the logarithmic block errors of the configured model, if it is a rise.
/// Blocks in which the component hardly moves are ignored. Memory is bounded.
class LiveJudgement {
 public:
  explicit LiveJudgement(const LiveCriteria& criteria = {});

  void addBlock(const BlockErrors& block);
  void addLook(const Look& look);

  LiveVerdict now() const;

  /// Returns the stamp of the last change in the level of the configured model's error [ns]; empty if there is none.
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
  double usual_force_ = 0.0;   // running mean over the blocks [N]
  std::optional<Look> claim_;  // the newest look with an effect
  bool named_ = false;
  std::optional<Verdict> last_verdict_;  // of the looks without an effect
  int agreeing_ = 0;
  std::optional<Verdict> said_;
};

/// A change between two stretches of a sequence.
struct ChangePoint {
  std::size_t first = 0;    ///< index of the first value after it
  double likelihood = 0.0;  ///< logarithm of the likelihood ratio, with the change to without it
  double before = 0.0;      ///< mean of the stretch before
  double after = 0.0;       ///< mean of the stretch after
};

/// Returns the most likely change of mean and spread of normal values (Hinkley, Biometrika 57, 1970), if its likelihood
/// ratio exceeds what the best of all places reaches by chance. Both stretches have at least four values.
std::optional<ChangePoint> mostLikelyChange(const std::vector<double>& values);

/// Returns the last change by binary segmentation (Scott and Knott, Biometrics 30, 1974): splits the sequence at the
/// most likely change, and then the part after it, until there is none.
std::optional<ChangePoint> lastChange(const std::vector<double>& values);

}  // namespace rubber_suspension::diagnosis::live
