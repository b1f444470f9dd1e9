// Evidence that grows block by block and may be looked at after each one: an e-detector of bets on unseen blocks.
#pragma once

#include <algorithm>

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

}  // namespace rubber_suspension::diagnosis::live
