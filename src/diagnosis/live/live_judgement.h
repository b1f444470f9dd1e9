// The judgement of a component while its bench runs, from looks at windows and the errors on the blocks since: the
// rule, without data and without time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/live/sequential_evidence.h"
#include "rubber_suspension/diagnosis/verdict.h"

namespace rubber_suspension::diagnosis::live {

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

}  // namespace rubber_suspension::diagnosis::live
