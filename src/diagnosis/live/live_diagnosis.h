// The diagnosis of one component while its bench runs: samples in, looks at windows, what may be said now. Knows
// neither threads nor ROS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/live/live_judgement.h"
#include "rubber_suspension/diagnosis/diagnosis.h"

namespace rubber_suspension::diagnosis::live {

/// A displacement with the force measured at the same stamp.
struct LiveSample {
  std::int64_t stamp = 0;     ///< [ns]
  double displacement = 0.0;  ///< [m]
  double force = 0.0;         ///< measured [N]
};

struct LiveSettings {
  std::size_t memory = 300000;       ///< samples that are kept, at most
  double shortest_window = 20.0;     ///< of a look [s]
  double longest_window = 120.0;     ///< [s]
  double longest_pause = 60.0;       ///< between two looks [s of the stamps]
  std::size_t most_samples = 24000;  ///< that a look takes; a denser log is thinned as far as its motion allows
  LiveCriteria criteria;
};

/// The findings of the newest look and their judgement.
struct LiveFindings {
  LiveVerdict now;
  std::vector<double> probabilities;    ///< of the effects said, in their order
  std::vector<std::string> confounded;  ///< sets that cannot be told apart, as "friction + creep"
  Gap gap;                              ///< over the window; augmented: with what the look would add
  std::vector<std::string> rig_findings;
  std::string where;        ///< place of the gap in words; empty: there is none
  std::string sentence;     ///< for an engineer
  std::int64_t stamp = 0;   ///< of the newest sample of the window [ns]
  std::size_t samples = 0;  ///< that the look took
  double window = 0.0;      ///< [s]
  std::size_t looks = 0;    ///< so far
};

/// The configured model is simulated along with the samples, and its error kept block by block. A look is a diagnosis
/// (see diagnose()) of the last minutes, but of nothing before the error changed its level; where they are long they
/// are cut into logs. What the look would add is then simulated along as well, and judged on the blocks that follow:
/// see LiveJudgement. The state at a window's begin is unknown: the rig layer of the diagnosis leaves what is left from
/// before out of every fit, and each model runs through the window before its errors count.
///
/// An offset or a drift of the force is not told from the load cell's: block errors are taken without their means.
class LiveDiagnosis {
 public:
  /// Throws std::invalid_argument where the component has no solution.
  explicit LiveDiagnosis(io::ComponentDescription configured, const LiveSettings& settings = {});
  ~LiveDiagnosis();

  /// The next sample. One whose stamp steps back is dropped; a jump back of more than a second is a new recording, and
  /// all before is forgotten.
  void add(const LiveSample& sample);

  bool lookIsDue() const;

  /// Diagnose the window. Takes seconds; `stop` is asked many times a second. Throws io::Cancelled; a window that
  /// cannot be diagnosed is no failure, and findings() say why.
  void look(const std::function<bool()>& stop = {});

  /// As of the newest sample.
  LiveFindings findings() const;

  /// Number of looks since the recording began.
  std::size_t looks() const { return findings_.looks; }

  /// The component that closes the gap which findings() speak of, if they speak of one that can be closed.
  std::optional<io::ComponentDescription> found() const;

 private:
  class Model;
  struct Block;

  void restart();
  void keep(const LiveSample& sample);
  void simulate(const LiveSample& sample);
  void finishBlock();
  std::int64_t windowBegin() const;
  std::vector<log::Log> windowLogs(std::int64_t begin) const;
  void takeUp(const Diagnosis& diagnosis);
  std::unique_ptr<Model> warmedUp(const io::ComponentDescription& component) const;

  io::ComponentDescription configured_;
  LiveSettings settings_;
  LiveJudgement judgement_;
  std::deque<LiveSample> samples_;
  std::int64_t first_ = 0;         // stamp of the first sample [ns]
  std::int64_t regime_begin_ = 0;  // stamp from which on the error of the configured model is what it is [ns]
  std::int64_t last_look_ = 0;     // newest stamp at the last look [ns]
  double last_window_ = 0.0;       // of that look [s]
  std::unique_ptr<Model> configured_model_;
  std::unique_ptr<Model> re_estimated_model_;  // both of the last look, if it has an effect
  std::unique_ptr<Model> augmented_model_;
  std::unique_ptr<Block> block_;
  LiveFindings findings_;
  std::optional<io::ComponentDescription> candidate_;  // what the look that findings_ tell of would put in place
};

}  // namespace rubber_suspension::diagnosis::live
