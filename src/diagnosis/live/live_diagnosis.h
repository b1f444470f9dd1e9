// Diagnosis of one component while its bench runs, from samples to the findings so far. Uses neither threads nor ROS.
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
  std::size_t memory = 300000;       ///< largest number of samples that are kept
  double shortest_window = 20.0;     ///< of a look [s]
  double longest_window = 120.0;     ///< [s]
  double longest_pause = 60.0;       ///< between two looks [s of the stamps]
  std::size_t most_samples = 24000;  ///< in a look; a denser log is thinned as far as its motion allows
  LiveCriteria criteria;
};

/// Findings of the newest look and the judgement; while an effect is named, of the newest look with an effect.
struct LiveFindings {
  LiveVerdict now;
  std::vector<double> probabilities;    ///< of the effects of the look, in their order
  std::vector<std::string> confounded;  ///< sets that cannot be told apart, as "friction + creep"
  Gap gap;                              ///< over the window; augmented: with the effects of the look
  std::vector<std::string> rig_findings;
  std::string where;        ///< place of the gap in words; empty if there is none
  std::string sentence;     ///< for an engineer
  std::int64_t stamp = 0;   ///< of the newest sample of the window [ns]
  std::size_t samples = 0;  ///< in the look
  double window = 0.0;      ///< [s]
  std::size_t looks = 0;    ///< number since the recording began
};

/// Simulates the configured model along with the samples and records its error block by block. A look is a diagnosis
/// (diagnose()) of the last minutes since the error changed its level; a long window is split into several logs. The
/// component that a look proposes is then simulated, too, and judged on the blocks that follow (LiveJudgement). The
/// state at the beginning of a window is unknown: in the diagnosis, the priors of the rig account for it, and each
/// model runs through the window before its errors count.
///
/// An offset or a drift of the force may be one of the load cell: block errors are taken without their means.
class LiveDiagnosis {
 public:
  /// Throws std::invalid_argument if the component has no solution.
  explicit LiveDiagnosis(io::ComponentDescription configured, const LiveSettings& settings = {});
  ~LiveDiagnosis();

  /// Adds the next sample. Drops one whose stamp does not advance; a step back of more than a second starts a new
  /// recording and discards all earlier samples.
  void add(const LiveSample& sample);

  bool lookIsDue() const;

  /// Diagnoses the window, which takes seconds; calls `stop` many times a second. Throws io::Cancelled. If the window
  /// cannot be diagnosed, findings() give the reason.
  void look(const std::function<bool()>& stop = {});

  /// Returns the findings as of the newest sample.
  LiveFindings findings() const;

  /// Returns the number of looks since the recording began.
  std::size_t looks() const { return findings_.looks; }

  /// Returns the component that closes the reported gap, if an effect or wrong values are reported.
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
  std::int64_t regime_begin_ = 0;  // stamp of the last change in the level of the configured model's error [ns]
  std::int64_t last_look_ = 0;     // newest stamp at the last look [ns]
  double last_window_ = 0.0;       // of that look [s]
  std::unique_ptr<Model> configured_model_;
  std::unique_ptr<Model> re_estimated_model_;  // this and the next: of the last look, if it has an effect
  std::unique_ptr<Model> augmented_model_;
  std::unique_ptr<Block> block_;
  LiveFindings findings_;
  std::optional<io::ComponentDescription> candidate_;  // proposed by the look of findings_
};

}  // namespace rubber_suspension::diagnosis::live
