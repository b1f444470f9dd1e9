// Acceptance of the samples of a stream by their stamps, with the same rules in node and replay.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::component {

enum class Acceptance {
  accepted,
  restarted,         ///< accepted after a jump back by more than a second (a new replay); the component was reset
  bridged,           ///< accepted after a time gap longer than max_gap, over which the displacement is assumed linear
  not_finite,        ///< dropped: the displacement is not finite
  repeated,          ///< dropped: the stamp equals the preceding stamp
  stepped_back,      ///< dropped: the stamp is before the preceding stamp, by a second at most
  force_not_finite,  ///< dropped: the displacement is so large that the force is not finite
  not_a_rotation,    ///< dropped: the length of the quaternion is not 1
  beyond_measure,    ///< dropped: the rotation is beyond the limits of its measure
};

inline bool isAccepted(Acceptance acceptance) { return acceptance <= Acceptance::bridged; }

struct StreamCounters {
  std::uint64_t accepted = 0;  ///< number that includes restarts and bridged time gaps
  std::uint64_t restarted = 0;
  std::uint64_t bridged = 0;
  std::uint64_t not_finite = 0;
  std::uint64_t repeated = 0;
  std::uint64_t stepped_back = 0;
  std::uint64_t force_not_finite = 0;
  std::uint64_t not_a_rotation = 0;
  std::uint64_t beyond_measure = 0;

  std::uint64_t dropped() const {
    return not_finite + repeated + stepped_back + force_not_finite + not_a_rotation + beyond_measure;
  }
};

struct StreamForce {
  Acceptance acceptance;
  element::ComponentForce force;  ///< valid only for an accepted sample
};

/// Base class of all streams: accepts or drops samples by their stamps, and counts them.
class StampedStream {
 public:
  static constexpr std::int64_t kNanosecondsPerSecond = 1000000000;
  static constexpr std::uint64_t kRestartJump = kNanosecondsPerSecond;

  const StreamCounters& counters() const { return counters_; }
  bool started() const { return started_; }
  std::int64_t lastStamp() const { return last_stamp_; }  ///< stamp of the last accepted sample [ns]

 protected:
  explicit StampedStream(double max_gap /* [s] */);

  Acceptance judge(std::int64_t stamp, bool finite) const;
  void count(Acceptance acceptance);

  /// Returns later - earlier [ns], which may exceed the range of a signed integer.
  static std::uint64_t between(std::int64_t earlier, std::int64_t later) {
    return static_cast<std::uint64_t>(later) - static_cast<std::uint64_t>(earlier);
  }

  /// Returns the time [s] from one stamp [ns] to a later one.
  static double secondsBetween(std::int64_t earlier, std::int64_t later);

  std::uint64_t max_gap_;  // [ns]
  StreamCounters counters_;
  std::int64_t last_stamp_ = 0;
  bool started_ = false;
};

/// Feeds stamped samples to a component. Time is computed only from the integer nanoseconds of the stamps, so that a
/// log gives the same force, bit by bit, from a topic, a bag or a file.
class SampleStream : public StampedStream {
 public:
  /// The component has to outlive the stream. `max_gap` [s]: longest time gap that counts as an ordinary step.
  explicit SampleStream(const Component& component, double max_gap = 0.5);

  /// Processes a sample: stamp [ns], displacement [m]. The first sample after construction or reset() finds the
  /// component at rest. A dropped sample does not change the state. Allocates nothing.
  __attribute__((always_inline)) StreamForce push(std::int64_t stamp, double displacement) {
    // If the time step equals one that was accepted before, only the numbers have to be checked.
    if (stamp <= last_stamp_ || between(last_stamp_, stamp) != usual_.nanoseconds ||
        !(std::abs(displacement) <= kLargest) || step_count_ == kMostSteps) {
      return pushAny(stamp, displacement);
    }
    steps_[step_count_++] = {usual_.seconds, displacement};
    const element::ComponentForce force = component_.step(state_, usual_.seconds, displacement);
    if (!std::isfinite(force.total)) {
      return refuseForce();
    }
    last_stamp_ = stamp;
    ++counters_.accepted;
    return {Acceptance::accepted, force};
  }

  /// Pushes samples up to the first that is dropped, and returns the number of accepted samples. Writes their forces
  /// [N] to `force`, equal to those of push() bit by bit. This is several times as fast if samples are evenly spaced.
  std::size_t pushAll(const std::int64_t* stamp, const double* displacement, std::size_t count, double* force);

  /// Sets the temperature [degC] of the following samples. Returns false, without effect, if a shift of the component
  /// is not valid at this temperature. Does nothing for a component without shifts. Allocates nothing.
  bool setTemperature(double temperature);

  /// Pushes samples, each with a temperature [degC] (null: none), up to one at which the shifts are not valid.
  std::size_t pushAll(const std::int64_t* stamp, const double* displacement, const double* temperature,
                      std::size_t count, double* force);

  /// Resets to a new test piece, which the next sample finds at rest. Temperature and counters are kept.
  void reset();

  const ComponentState& state() const { return state_; }

  /// Continues where another stream of the same component stopped. Throws like Component::restore().
  void deserialise(std::int64_t last_stamp, double displacement, const std::vector<double>& memory);

 private:
  // A step after the state was saved.
  struct Step {
    double dt;            // [s]
    double displacement;  // [m]
  };
  static constexpr std::size_t kMostSteps = 64;  // steps that are repeated if a force is not finite
  static constexpr double kLargest = 1e30;       // [m]; larger than any component, but with finite results in a delay

  // The time between samples that was accepted last; 0 if there is none.
  struct Interval {
    std::uint64_t nanoseconds = 0;
    double seconds = 0.0;
  };

  StreamForce pushAny(std::int64_t stamp, double displacement);
  StreamForce refuseForce();
  void save();
  void rollBack();
  element::ComponentForce initialise(double displacement);
  element::ComponentForce advance(Acceptance acceptance, std::int64_t stamp, double displacement);
  std::size_t evenRun(const std::int64_t* stamp, const double* displacement, std::size_t count) const;
  bool pushRun(const std::int64_t* stamp, const double* displacement, std::size_t count, double* force);

  const Component& component_;
  ComponentState state_;
  // An earlier state and the steps after it. The state before a sample can be restored from them.
  ComponentState saved_;
  std::array<Step, kMostSteps> steps_;
  std::size_t step_count_ = 0;
  Interval usual_;
};

}  // namespace rubber_suspension::component
