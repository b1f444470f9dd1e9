// One component of the node: its samples, its counters, its state, safe to use from several threads. Independent of
// ROS.
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
  bool started = false;       ///< false: no sample yet, the rest means nothing
  std::int64_t stamp = 0;     ///< [ns] of the last accepted sample
  double displacement = 0.0;  ///< [m] at that sample; of six directions the memory has the coordinates
  std::vector<double> memory;
};

/// The state of a model beside the configured one.
struct SavedPromotion : SavedStream {
  std::string description;  ///< of the model, as a component file
  RunStage stage = RunStage::configured;
  double weight = 0.0;  ///< of its force in the published one
};

/// Identity of a model: its elements, or of six directions the SHA-256 of the description in YAML.
struct ModelIdentity {
  std::vector<element::ElementDescription> elements;
  std::string sha256;

  bool operator!=(const ModelIdentity& other) const { return elements != other.elements || sha256 != other.sha256; }
};

/// The state of a component as it is saved, with what is needed to refuse it where it does not belong.
struct SavedState : SavedStream {
  std::string component;
  ModelIdentity model;                      ///< whose state it is
  std::optional<SavedPromotion> promotion;  ///< of the model beside, where there is one
};

/// The source of a component's force.
struct RunningModel {
  RunStage stage = RunStage::configured;
  double weight = 0.0;             ///< of the other model's force in the published one
  std::int64_t since = 0;          ///< stamp of the stage's first sample [ns]
  std::string configured_sha256;   ///< of the description in YAML
  std::string other_sha256;        ///< likewise; empty: there is no other model
  std::vector<std::string> added;  ///< types of the elements that the other model adds
  std::string note;                ///< why a stage ended, if not as requested

  friend bool operator!=(const RunningModel& a, const RunningModel& b) {
    return std::tie(a.stage, a.since, a.configured_sha256, a.other_sha256, a.note) !=
           std::tie(b.stage, b.since, b.configured_sha256, b.other_sha256, b.note);
  }
};

/// Counts of a channel since it was made, over resets and reloads, and since the last report.
struct ChannelReport : component::StreamCounters {
  std::uint64_t beyond_valid = 0;       ///< samples that were answered beyond `valid`
  std::optional<element::Range> valid;  ///< stated validity [m]
  std::uint64_t beyond_rotation = 0;    ///< poses that were answered beyond `valid_rotation`
  double valid_rotation = 0.0;          ///< of six directions [rad]
  std::uint64_t disabled = 0;           ///< samples that came while the component was disabled
  std::uint64_t lost = 0;  ///< samples that were sent but never arrived, by the sequence numbers of their senders
  std::uint64_t undecodable = 0;  ///< messages that are no samples
  std::uint64_t undelivered = 0;  ///< forces that a subscriber did not get because it reads too slowly
  bool enabled = true;
  bool started = false;
  double last_time = 0.0;                            ///< stamp of the last accepted sample [s]
  double displacement = 0.0;                         ///< of the last accepted sample [m]
  std::optional<component::SixNumbers> coordinates;  ///< likewise, of six directions [m, rad]
  bool shifts_with_temperature = false;              ///< whether the component does
  std::optional<double> temperature;                 ///< of the last sample [degC], where one has come
  std::uint64_t refused_temperatures = 0;            ///< not finite, or one at which the component's shift is not valid
  LatencyHistogram latency;                          ///< of the samples since the last report
};

/// Feeds one component with samples. Calls lock only for arithmetic, never while a file is read, a model is estimated
/// or a message is published.
class ComponentChannel {
  class Promotion;

 public:
  /// Throws std::invalid_argument where the description has no solution. max_gap in [s]; samples_kept as in GapMonitor.
  ComponentChannel(const io::ComponentDescription& description, double max_gap,
                   const PromotionSettings& promotion_settings = {}, std::size_t samples_kept = GapMonitor::kCapacity);

  const std::string& name() const { return name_; }

  /// True if the samples are poses, not displacements.
  bool hasSixDirections() const { return has_six_; }

  /// Processes a sample: stamp [ns], displacement [m]. Returns false, and counts the reason, if no force is to be sent.
  bool push(std::int64_t stamp, double displacement, element::ComponentForce& force);

  /// Processes a pose: position [m] and rotation of B in A; the wrench on B, in A's axes.
  bool push(std::int64_t stamp, const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation,
            component::Wrench& wrench);

  /// A measured wrench on B at B's origin, in A's axes; one of a stamp that a pose has is compared with its wrench.
  void addMeasured(std::int64_t stamp, const component::Wrench& wrench);

  /// The matched samples of the last seconds: of one direction, or of six in their order, with generalised forces.
  std::vector<std::vector<MatchedSample>> windows(double seconds) const;

  /// Sets the temperature [degC] of the samples from a stamp [ns] on. Returns false, and counts it, if the component's
  /// shift is not valid there.
  bool setTemperature(std::int64_t stamp, double temperature);

  /// Counts a served sample: from arrival to publication [ns].
  void countLatency(std::int64_t nanoseconds) { latency_.add(nanoseconds); }

  /// Counts samples that a sender sent and that never arrived.
  void countLost(std::uint64_t samples);

  /// Back to a new component at rest.
  void reset();

  /// While disabled no sample is answered; the state stays as it is.
  void setEnabled(bool enabled);

  SavedState save() const;

  /// Throws std::invalid_argument if the state is not one of this component. Returns the model beside, if it has one.
  std::shared_ptr<Promotion> checkState(const SavedState& state) const;

  /// Continues from a state; throws as checkState(), and nothing has changed.
  void load(const SavedState& state);

  /// A model made ready for exchange(), outside of any lock.
  class Model;
  static std::shared_ptr<Model> makeModel(const io::ComponentDescription& description, double max_gap);

  /// Continues with another model, which takes over the state if it has the same elements, else starts as new.
  void exchange(const std::shared_ptr<Model>& model);

  /// Computes another model in the shadow of the configured one, which it then replaces by a cross-fade, unless its
  /// error was larger or its force not finite. Throws std::invalid_argument if there is another model already, or this
  /// one cannot be built.
  void promote(const io::ComponentDescription& description);

  /// Back to the configured model by a cross-fade, or out of the shadow. Throws std::invalid_argument where no other
  /// model is there.
  void rollBack();

  RunningModel running() const;

  /// The configured component; another object after exchange().
  std::shared_ptr<const io::ComponentDescription> configured() const;

  /// Measured forces go here; what is accepted and answered is already there. For six directions there is one each.
  GapMonitor& gap(std::size_t direction = 0) { return gaps_[direction]; }

  /// The counts so far; starts a new interval of the latency.
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
  std::shared_ptr<Promotion> promotion_;  // the model beside, if any
  std::string note_;                      // how the last promotion ended
  std::int64_t since_ = 0;                // and with which sample
  ChannelReport counts_;                  // what is counted here, and by models before a reload
  LatencyCounter latency_;                // needs no lock
  TemperatureFeed temperatures_;
  std::deque<GapMonitor> gaps_;  // each has a lock of its own
};

}  // namespace rubber_suspension::node
