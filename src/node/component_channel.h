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

struct SavedStream {
  bool started = false;       ///< false before the first sample; then the other values have no meaning
  std::int64_t stamp = 0;     ///< stamp of the last accepted sample [ns]
  double displacement = 0.0;  ///< displacement at that sample [m]; not used for six directions
  std::vector<double> memory;
};

/// State of a second model in addition to the configured model.
struct SavedPromotion : SavedStream {
  std::string description;  ///< description of the model, as the text of a component file
  RunStage stage = RunStage::configured;
  double weight = 0.0;  ///< weight of its force in the published force
};

/// Identity of a model: its elements or, for six directions, the SHA-256 of its description in YAML.
struct ModelIdentity {
  std::vector<element::ElementDescription> elements;
  std::string sha256;

  bool operator!=(const ModelIdentity& other) const { return elements != other.elements || sha256 != other.sha256; }
};

/// Saved state of a component. It may be loaded only for the component of this name with this model.
struct SavedState : SavedStream {
  std::string component;
  ModelIdentity model;                      ///< the configured model, to which this state belongs
  std::optional<SavedPromotion> promotion;  ///< state of the second model, if there is one
};

/// The model or models from which the published force is computed.
struct RunningModel {
  RunStage stage = RunStage::configured;
  double weight = 0.0;             ///< weight of the other model's force in the published force
  std::int64_t since = 0;          ///< stamp of the stage's first sample [ns]
  std::string configured_sha256;   ///< hash of the configured model's description in YAML
  std::string other_sha256;        ///< hash of the other model's description; empty if there is no other model
  std::vector<std::string> added;  ///< types of the elements that the other model adds
  std::string note;                ///< why the last stage ended, unless the end was requested

  friend bool operator!=(const RunningModel& a, const RunningModel& b) {
    return std::tie(a.stage, a.since, a.configured_sha256, a.other_sha256, a.note) !=
           std::tie(b.stage, b.since, b.configured_sha256, b.other_sha256, b.note);
  }
};

/// Counts of a channel since its construction. Resets and reloads do not set them to 0.
struct ChannelReport : component::StreamCounters {
  std::uint64_t beyond_valid = 0;       ///< number of samples that were answered beyond `valid`
  std::optional<element::Range> valid;  ///< range of validity in the component file [m]
  std::uint64_t beyond_rotation = 0;    ///< number of poses that were answered beyond `valid_rotation`
  double valid_rotation = 0.0;          ///< limit for six directions [rad]
  std::uint64_t disabled = 0;           ///< number of samples that came while the component was disabled
  std::uint64_t lost = 0;               ///< number of samples that never arrived, according to sequence numbers
  std::uint64_t undecodable = 0;        ///< number of messages that are not samples
  std::uint64_t undelivered = 0;        ///< number of forces that a subscriber lost because it reads too slowly
  bool enabled = true;
  bool started = false;
  double last_time = 0.0;                            ///< stamp of the last accepted sample [s]
  double displacement = 0.0;                         ///< displacement at the last accepted sample [m]
  std::optional<component::SixNumbers> coordinates;  ///< coordinates at that sample, for six directions [m, rad]
  bool shifts_with_temperature = false;              ///< true if the component depends on the temperature
  std::optional<double> temperature;                 ///< temperature at the last sample [degC], if received
  std::uint64_t refused_temperatures = 0;            ///< number of temperatures that were not accepted
  LatencyHistogram latency;                          ///< latency of the samples since the last report
};

/// Feeds one component with samples. The lock is held for arithmetic only, never while a file is read, a model is
/// estimated or a message is published.
class ComponentChannel {
  class Promotion;

 public:
  /// `max_gap` is the longest time between samples that is not counted [s], `samples_kept` the capacity of each
  /// GapMonitor. Throws std::invalid_argument if no elements fulfil the specification.
  ComponentChannel(const io::ComponentDescription& description, double max_gap,
                   const PromotionSettings& promotion_settings = {}, std::size_t samples_kept = GapMonitor::kCapacity);

  const std::string& name() const { return name_; }

  bool hasSixDirections() const { return has_six_; }

  /// Processes a displacement [m] with a stamp [ns]. Returns false and counts the reason if no force is to be sent.
  bool push(std::int64_t stamp, double displacement, element::ComponentForce& force);

  /// Processes the pose of body B in body A: position [m] and rotation. `wrench` [N, N m] acts on B, in A's axes.
  bool push(std::int64_t stamp, const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation,
            component::Wrench& wrench);

  /// Adds a measured wrench on B at B's origin, in A's axes, to be compared with the simulated wrench of the same
  /// stamp.
  void addMeasured(std::int64_t stamp, const component::Wrench& wrench);

  /// Returns the matched samples of the last `seconds` for each direction. Forces of six directions are generalised
  /// ones.
  std::vector<std::vector<MatchedSample>> windows(double seconds) const;

  /// Sets the temperature [degC] of the samples from a stamp [ns] on. If the temperature shift of the component
  /// does not cover this temperature, counts a refused temperature and returns false.
  bool setTemperature(std::int64_t stamp, double temperature);

  /// Counts the time from the arrival of a sample to the publication of its answer [ns].
  void countLatency(std::int64_t nanoseconds) { latency_.add(nanoseconds); }

  void countLost(std::uint64_t samples);

  void reset();

  /// Enables or disables the component. While it is disabled, it answers no sample and keeps its state.
  void setEnabled(bool enabled);

  SavedState save() const;

  /// Returns the second model in the state, or null. Throws std::invalid_argument for a state of another component.
  std::shared_ptr<Promotion> checkState(const SavedState& state) const;

  /// Continues from a state. If the state is refused, throws as checkState() and changes nothing.
  void load(const SavedState& state);

  /// A model for exchange(). No lock is held while makeModel() makes it.
  class Model;
  static std::shared_ptr<Model> makeModel(const io::ComponentDescription& description, double max_gap);

  /// Replaces the configured model. Only a model with the same elements continues from the present state.
  void exchange(const std::shared_ptr<Model>& model);

  /// Computes a second model in parallel to the configured model (shadow) and then replaces the configured model by a
  /// cross-fade, unless the second model had a larger error or a force that is not finite. Throws std::invalid_argument
  /// if there already is a second model, or if this model cannot be built.
  void promote(const io::ComponentDescription& description);

  /// Returns to the configured model by a cross-fade, or ends the shadow stage. Throws std::invalid_argument if there
  /// is no second model or it is already being rolled back.
  void rollBack();

  RunningModel running() const;

  /// Returns the description of the configured component, which is another object after exchange().
  std::shared_ptr<const io::ComponentDescription> configured() const;

  /// Returns the monitor of a direction. push() adds the simulated forces; for components of one direction the caller
  /// adds the measured forces.
  GapMonitor& gap(std::size_t direction = 0) { return gaps_[direction]; }

  /// Returns the counts since construction, and the latency since the last report.
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
  std::shared_ptr<Promotion> promotion_;  // the second model, or null
  std::string note_;                      // how the last promotion ended
  std::int64_t since_ = 0;                // stamp of the sample at which it ended [ns]
  ChannelReport counts_;                  // counts of the channel, and of models before a reload
  LatencyCounter latency_;                // used without the lock
  TemperatureFeed temperatures_;
  std::deque<GapMonitor> gaps_;  // each has a lock of its own
};

}  // namespace rubber_suspension::node
