// Two ways to step a vehicle: with variable steps and trial steps, or in a loop with constant wrenches at fixed steps.
#pragma once

#include <cstdint>
#include <deque>
#include <utility>

#include "rubber_suspension/component/pose_stream.h"
#include "vehicle/history.h"
#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// Settings of a simulation.
struct Scene {
  Kind kind = Kind::struts;
  VehicleParameters parameters;
  Track track;
  double duration = 0.0;         ///< [s]
  std::int64_t step = 1000000;   ///< interval of records and of fixed steps [ns]
  std::array<double, 3> kick{};  ///< initial speeds of the three coordinates of half a bogie [m/s, rad/s, m/s]

  std::int64_t steps() const;
  double time(std::int64_t n) const { return 1e-9 * static_cast<double>(n * step); }  ///< [s]
};

/// Step control of an explicit integrator.
struct VariableStep {
  double accuracy = 1e-8;   ///< limit of Simbody's measure of the error of a step
  double longest = 0.5e-3;  ///< longest step [s]; limits the error of linear poses, which `accuracy` ignores
};

struct StepCount {
  int accepted = 0;
  int taken_back = 0;  ///< rejected trial steps
};

/// Simulates by the method of Runge-Kutta-Merson with variable steps. Accepted steps advance the memory of the
/// components; trial steps do not change it. There is no delay, so the result is the reference for runExchange().
/// Throws std::runtime_error if the integrator cannot continue or a rotation is beyond the range of a component's
/// measure.
History runVariableStep(const Scene& scene, const Bushes& components, const VariableStep& options,
                        StepCount* count = nullptr);

/// Exchanges a pose of each component for a wrench. Poses may be sent before the wrenches of earlier ones are received.
class Exchange {
 public:
  virtual ~Exchange() = default;

  /// Sends the poses of a stamp [ns].
  virtual void send(std::int64_t stamp, const Poses& poses) = 0;

  /// Waits for the wrenches that answer the poses of a stamp [ns]. Throws std::runtime_error if none arrive.
  virtual Wrenches receive(std::int64_t stamp) = 0;
};

/// Computes the wrenches in the same process, with the streams that the node uses, so the numbers are equal bit by bit.
class LibraryExchange final : public Exchange {
 public:
  /// The components must outlive this object.
  explicit LibraryExchange(const Bushes& components) : streams_(components.begin(), components.end()) {}

  void send(std::int64_t stamp, const Poses& poses) override;
  Wrenches receive(std::int64_t stamp) override;

 private:
  std::vector<component::PoseStream> streams_;
  std::deque<std::pair<std::int64_t, Wrenches>> answers_;
};

/// Simulates a loop with a partner that answers poses with wrenches at fixed steps. From step n to step n + 1 the
/// wrenches of step n - delay act and are constant, so the mean delay is (delay + 1/2) steps. With a delay of 0 each
/// step waits for its answer. With a delay of 1 partner and vehicle compute at the same time. The history contains the
/// wrenches that act.
History runExchange(const Scene& scene, Exchange& exchange, int delay);

/// Returns the mean delay of wrenches in such a loop [s].
inline double loopDelay(double step, int delay) { return (delay + 0.5) * step; }

}  // namespace rubber_suspension::vehicle
