// The rules for time of poses, in node and replay alike.
#pragma once

#include "rubber_suspension/component/sample_stream.h"
#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::component {

struct StreamWrench {
  Acceptance acceptance;
  BushForce force;            ///< of an accepted sample only
  SixNumbers coordinates;     ///< likewise [m, rad]
  bool beyond_valid = false;  ///< accepted, and the rotation is beyond the stated validity
};

/// Feeds a component of six directions with stamped poses, as SampleStream does a component of one direction.
class PoseStream : public StampedStream {
 public:
  /// Largest deviation of the length of a quaternion from 1.
  static constexpr double kQuaternionTolerance = 1e-3;

  /// The component must outlive the stream. max_gap in [s].
  explicit PoseStream(const SixDirections& component, double max_gap = 0.5);

  /// Processes a pose of B in A: stamp [ns], position [m], rotation. At the first one after construction or reset() the
  /// component is at rest. A dropped sample does not change the state. Allocates nothing.
  StreamWrench push(std::int64_t stamp, const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation);

  /// Sets the temperature [degC] as SampleStream::setTemperature() does.
  bool setTemperature(double temperature);

  /// Resets to a new test piece at rest, with the same temperature and counters; the next sample starts again.
  void reset();

  const SixDirectionsState& state() const { return state_; }

  /// Returns the number of accepted samples beyond the stated validity.
  std::uint64_t beyondValid() const { return beyond_valid_; }

  /// Continues where another stream of the same component stopped, with numbers() of its state. Throws as
  /// SixDirections::restore() does.
  void deserialise(std::int64_t last_stamp, const std::vector<double>& numbers);

 private:
  BushForce advance(Acceptance acceptance, std::int64_t stamp, const Eigen::Isometry3d& pose);

  const SixDirections& component_;
  SixDirectionsState state_;
  SixDirectionsState saved_;  // to undo a step whose wrench is not finite
  std::uint64_t beyond_valid_ = 0;
};

/// Returns a pose from the numbers of topics and logs, with the quaternion normalised.
Eigen::Isometry3d poseOf(const Eigen::Vector3d& position, const Eigen::Quaterniond& rotation);

}  // namespace rubber_suspension::component
