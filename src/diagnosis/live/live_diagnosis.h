// Diagnoses one component while its bench runs, from samples to the findings so far. Uses neither threads nor ROS.
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

/// A displacement and the force that was measured at the same time.
struct LiveSample {
  std::int64_t stamp = 0;     ///< [ns]
  double displacement = 0.0;  ///< [m]
  double force = 0.0;         ///< measured [N]
};

struct LiveSettings {
  std::size_t memory = 300000;       ///< largest number of samples that are kept
  double shortest_window = 20.0;     ///< shortest window of a look [s]
  double longest_window = 120.0;     ///< longest window of a look [s]
  double longest_pause = 60.0;       ///< longest pause between two looks, according to the stamps [s]
  std::size_t most_samples = 24000;  ///< largest number of samples in a look; a denser log is thinned
  LiveCriteria criteria;
};

/// The judgement, and the findings of the newest look, or of the newest look with an effect while an effect is named.
struct LiveFindings {
  LiveVerdict now;
  std::vector<double> probabilities;    ///< probabilities of the effects of the look, in their order
  std::vector<std::string> confounded;  ///< sets of effects that cannot be distinguished, such as "friction + creep"
  Gap gap;                              ///< gap over the window; its augmented value includes the effects of the look
  std::vector<std::string> rig_findings;
  std::string where;        ///< where the gap lies, in words; empty if there is no gap
  std::string sentence;     ///< verdict in words for an engineer
  std::int64_t stamp = 0;   ///< stamp of the newest sample in the window [ns]
  std::size_t samples = 0;  ///< number of samples in the look
  double window = 0.0;      ///< length of the window [s]
  std::size_t looks = 0;    ///< number of looks since the recording began
};

/// Simulates the configured model along with the samples and records its error block by block. A look is a diagnosis of
/// the last minutes (diagnose()), but not of samples before the last change in the level of the error. A long window is
/// split into several logs. The component that a look proposes is then simulated as well, and judged on the following
/// blocks (LiveJudgement). The state at the beginning of a window is unknown. In the diagnosis, the priors of the rig
/// account for it; each proposed model is simulated through the whole window before its errors count.
/// An offset or a drift of the force may come from the load cell, so that errors of blocks are computed without their
/// mean.
class LiveDiagnosis {
 public:
  /// Throws std::invalid_argument if the component has no solution.
  explicit LiveDiagnosis(io::ComponentDescription configured, const LiveSettings& settings = {});
  ~LiveDiagnosis();

  /// Adds the next sample. Drops a sample whose stamp is not later than the previous one. If the stamp is more than a
  /// second earlier, a new recording starts and all earlier samples are discarded.
  void add(const LiveSample& sample);

  bool lookIsDue() const;

  /// Diagnoses the window, which takes some seconds, and calls `stop` many times per second. Throws io::Cancelled. If
  /// the window cannot be diagnosed, findings() state the reason.
  void look(const std::function<bool()>& stop = {});

  LiveFindings findings() const;

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
  std::int64_t regime_begin_ = 0;  // stamp of the last change in the level of the error [ns]
  std::int64_t last_look_ = 0;     // newest stamp at the last look [ns]
  double last_window_ = 0.0;       // length of the window of the last look [s]
  std::unique_ptr<Model> configured_model_;
  std::unique_ptr<Model> re_estimated_model_;  // null unless the last look has an effect, as for augmented_model_
  std::unique_ptr<Model> augmented_model_;
  std::unique_ptr<Block> block_;
  LiveFindings findings_;
  std::optional<io::ComponentDescription> candidate_;  // component that the look in findings_ proposes
};

}  // namespace rubber_suspension::diagnosis::live
