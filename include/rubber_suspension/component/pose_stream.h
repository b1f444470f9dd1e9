// Acceptance of stamped poses, with the same rules in node and replay.
#pragma once

#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::component {

struct StreamWrench {
  Acceptance acceptance;
  BushForce force;            ///< valid only for an accepted sample
  SixNumbers coordinates;     ///< valid only for an accepted sample [m, rad]
  bool beyond_valid = false;  ///< true if the sample is accepted, and its rotation is beyond the stated validity
};

/// Feeds stamped poses to a component of six directions, as SampleStream does for a component of one direction.
class PoseStream : public StampedStream {
 public:
  /// Largest deviation of the length of a quaternion from 1.
  static constexpr double kQuaternionTolerance = 1e-3;

  /// The component has to outlive the stream. `max_gap` [s]: longest time gap that counts as an ordinary step.
  explicit PoseStream(const SixDirections& component, double max_gap = 0.5);

  /// Processes a pose of body B in body A: stamp [ns], position [m], rotation. The first pose after construction or
  /// reset() finds the component at rest. A dropped sample does not change the state. Allocates nothing.
  StreamWrench push(std::int64_t stamp, const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation);

  /// Sets the temperature [degC] like SampleStream::setTemperature().
  bool setTemperature(double temperature);

  /// Resets to a new test piece, which the next sample finds at rest. Temperature and counters are kept.
  void reset();

  const SixDirectionsState& state() const { return state_; }

  /// Returns the number of accepted samples beyond the stated validity.
  std::uint64_t beyondValid() const { return beyond_valid_; }

  /// Continues where another stream of the same component stopped, from numbers() of its state. Throws like
  /// SixDirections::restore().
  void deserialise(std::int64_t last_stamp, const std::vector<double>& numbers);

 private:
  BushForce advance(Acceptance acceptance, std::int64_t stamp, const Eigen::Isometry3d& pose);

  const SixDirections& component_;
  SixDirectionsState state_;
  SixDirectionsState saved_;  // restored if the wrench of a step is not finite
  std::uint64_t beyond_valid_ = 0;
};

/// Returns the pose for the numbers of topics and logs. The quaternion is normalised.
Eigen::Isometry3d poseOf(const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation);

}  // namespace rubber_suspension::component
