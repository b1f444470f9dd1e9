// One component of the node: its samples, counters and state. Thread-safe and independent of ROS.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "node/gap_monitor.h"
#include "node/latency_histogram.h"
#include "node/promotion.h"
#include "node/temperature_feed.h"
#include "rubber_suspension/component/pose_stream.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::node {

/// State of a model's stream.
struct SavedStream {
  bool started = false;       ///< false: no sample yet, and the other members have no meaning
  std::int64_t stamp = 0;     ///< stamp of the last accepted sample [ns]
  double displacement = 0.0;  ///< at that sample [m]; not used for six directions
  std::vector<double> memory;
};

/// State of a second model beside the configured one.
struct SavedPromotion : SavedStream {
  std::string description;  ///< of the model, as a component file
  RunStage stage = RunStage::configured;
  double weight = 0.0;  ///< of its force in the published force
};

/// Identity of a model: its elements, or for six directions the SHA-256 of its description in YAML.
struct ModelIdentity {
  std::vector<element::ElementDescription> elements;
  std::string sha256;

  bool operator!=(const ModelIdentity& other) const { return elements != other.elements || sha256 != other.sha256; }
};

/// Saved state of a component, with the name and the model for which alone it may be loaded.
struct SavedState : SavedStream {
  std::string component;
  ModelIdentity model;                      ///< the model that has this state
  std::optional<SavedPromotion> promotion;  ///< state of the second model, if there is one
};

/// The model or models from which the published force is computed.
struct RunningModel {
  RunStage stage = RunStage::configured;
  double weight = 0.0;             ///< of the other model's force in the published force
  std::int64_t since = 0;          ///< stamp of the stage's first sample [ns]
  std::string configured_sha256;   ///< of the configured model's description in YAML
  std::string other_sha256;        ///< of the other model's description; empty: there is none
  std::vector<std::string> added;  ///< types of the elements that the other model adds
  std::string note;                ///< why a stage ended, if not as requested

  friend bool operator!=(const RunningModel& a, const RunningModel& b) {
    return std::tie(a.stage, a.since, a.configured_sha256, a.other_sha256, a.note) !=
           std::tie(b.stage, b.since, b.configured_sha256, b.other_sha256, b.note);
  }
};

/// Counts of a channel since its construction, including those before resets and reloads.
struct ChannelReport : component::StreamCounters {
  std::uint64_t beyond_valid = 0;       ///< samples that were answered beyond `valid`
  std::optional<element::Range> valid;  ///< stated validity [m]
  std::uint64_t beyond_rotation = 0;    ///< poses that were answered beyond `valid_rotation`
  double valid_rotation = 0.0;          ///< of six directions [rad]
  std::uint64_t disabled = 0;           ///< samples that came while the component was disabled
  std::uint64_t lost = 0;               ///< samples that never arrived, by the sequence numbers of their senders
  std::uint64_t undecodable = 0;        ///< messages that are not samples
  std::uint64_t undelivered = 0;        ///< forces that a subscriber lost because it reads too slowly
  bool enabled = true;
  bool started = false;
  double last_time = 0.0;                            ///< stamp of the last accepted sample [s]
  double displacement = 0.0;                         ///< of the last accepted sample [m]
  std::optional<component::SixNumbers> coordinates;  ///< likewise, of six directions [m, rad]
  bool shifts_with_temperature = false;              ///< true if the component depends on the temperature
  std::optional<double> temperature;                 ///< of the last sample [degC], if any was received
  std::uint64_t refused_temperatures = 0;            ///< not finite, or outside the range of the component's shift
  LatencyHistogram latency;                          ///< of the samples since the last report
};

/// Feeds one component with samples. Calls lock only for arithmetic, never while a file is read, a model is estimated
/// or a message is published.
class ComponentChannel {
  class Promotion;

 public:
  /// Throws std::invalid_argument if there is no solution. `max_gap` [s]; `samples_kept` is the capacity of GapMonitor.
  ComponentChannel(const io::ComponentDescription& description, double max_gap,
                   const PromotionSettings& promotion_settings = {}, std::size_t samples_kept = GapMonitor::kCapacity);

  const std::string& name() const { return name_; }

  /// Returns true if the samples are poses, not displacements.
  bool hasSixDirections() const { return has_six_; }

  /// Processes a sample: stamp [ns], displacement [m]. Returns false, and counts the reason, if no force is to be sent.
  bool push(std::int64_t stamp, double displacement, element::ComponentForce& force);

  /// Processes a pose likewise: position [m] and rotation of B in A; `wrench` [N, N m] acts on B, in A's axes.
  bool push(std::int64_t stamp, const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation,
            component::Wrench& wrench);

  /// Adds a measured wrench on B at B's origin, in A's axes, to be compared with that of the pose of the same stamp.
  void addMeasured(std::int64_t stamp, const component::Wrench& wrench);

  /// Returns the matched samples of the last `seconds` for each direction; those of six have generalised forces.
  std::vector<std::vector<MatchedSample>> windows(double seconds) const;

  /// Sets the temperature [degC] of the samples from a stamp [ns] on. Returns false, and counts it, if the component's
  /// shift is not valid there.
  bool setTemperature(std::int64_t stamp, double temperature);

  /// Counts the time of a sample from arrival to publication [ns].
  void countLatency(std::int64_t nanoseconds) { latency_.add(nanoseconds); }

  /// Counts samples that were sent but never arrived.
  void countLost(std::uint64_t samples);

  /// Resets to a new component at rest.
  void reset();

  /// Enables or disables the component. While it is disabled, it answers no sample and keeps its state.
  void setEnabled(bool enabled);

  SavedState save() const;

  /// Throws std::invalid_argument if the state is not one of this component. Returns its second model, if it has one.
  std::shared_ptr<Promotion> checkState(const SavedState& state) const;

  /// Continues from a state. Throws as checkState(), without any change.
  void load(const SavedState& state);

  /// A model for exchange(), which is made without a lock.
  class Model;
  static std::shared_ptr<Model> makeModel(const io::ComponentDescription& description, double max_gap);

  /// Replaces the configured model. The new one continues from the state if it has the same elements, else it is new.
  void exchange(const std::shared_ptr<Model>& model);

  /// Computes a second model in parallel to the configured one (shadow), which it then replaces by a cross-fade, unless
  /// its error was larger or its force not finite. Throws std::invalid_argument if there is a second model already, or
  /// if this one cannot be built.
  void promote(const io::ComponentDescription& description);

  /// Returns to the configured model by a cross-fade, or ends the shadow. Throws std::invalid_argument if there is no
  /// second model, or if it is being rolled back.
  void rollBack();

  RunningModel running() const;

  /// Returns the configured component; another object after exchange().
  std::shared_ptr<const io::ComponentDescription> configured() const;

  /// Returns the monitor of a direction, which push() fills; measured forces of one direction are added by the caller.
  GapMonitor& gap(std::size_t direction = 0) { return gaps_[direction]; }

  /// Returns the counts so far, and the latency since the last report.
  ChannelReport report();

 private:
  void dropFinished(std::shared_ptr<Promotion>& finished);
  bool isBeside() const;
  void keepTemperature();
  bool begins(std::int64_t stamp, bool finite);
  void clearGaps();

  std::string name_;
  double max_gap_;
  PromotionSettings promotion_settings_;
  bool has_six_;
  mutable std::mutex mutex_;
  std::shared_ptr<Model> model_;
  std::shared_ptr<Promotion> promotion_;  // the second model, if any
  std::string note_;                      // how the last promotion ended
  std::int64_t since_ = 0;                // and the stamp of that sample [ns]
  ChannelReport counts_;                  // counted here, and by models before a reload
  LatencyCounter latency_;                // needs no lock
  TemperatureFeed temperatures_;
  std::deque<GapMonitor> gaps_;  // each has a lock of its own
};

}  // namespace rubber_suspension::node
