// Two ways to step a vehicle: variable steps with trials, and a loop with held wrenches, from the library or elsewhere.
#pragma once

#include <cstdint>
#include <deque>
#include <utility>

#include "rubber_suspension/component/pose_stream.h"
#include "vehicle/history.h"
#include "vehicle/track.h"

namespace rubber_suspension::vehicle {

/// The settings of every run.
struct Scene {
  Kind kind = Kind::struts;
  VehicleParameters parameters;
  Track track;
  double duration = 0.0;         ///< [s]
  std::int64_t step = 1000000;   ///< between records, and of the fixed steps [ns]
  std::array<double, 3> kick{};  ///< speeds of half a bogie at the start [m/s, rad/s, m/s]

  std::int64_t steps() const;
  double time(std::int64_t n) const { return 1e-9 * static_cast<double>(n * step); }  ///< [s]
};

/// Step control of an explicit integrator.
struct VariableStep {
  double accuracy = 1e-8;   ///< Simbody's measure of the error of a step
  double longest = 0.5e-3;  ///< [s]; the pose is linear between accepted steps, which no error measure sees
};

/// The counts of an integrator.
struct StepCount {
  int accepted = 0;
  int taken_back = 0;  ///< rejected trial steps
};

/// Runge-Kutta-Merson with variable steps: wrenches of trial steps, the components' memory advances with accepted ones.
/// No delay: the reference for the loop. Throws std::runtime_error where the integrator gives up, and where a rotation
/// goes beyond the end of a component's measure.
History runVariableStep(const Scene& scene, const Bushes& components, const VariableStep& options,
                        StepCount* count = nullptr);

/// Exchanges poses for wrenches, one of each component; several may be in transit.
class Exchange {
 public:
  virtual ~Exchange() = default;

  /// Sends the poses at a stamp [ns].
  virtual void send(std::int64_t stamp, const Poses& poses) = 0;

  /// Waits for the wrenches that answer the poses sent at a stamp. Throws std::runtime_error where none come.
  virtual Wrenches receive(std::int64_t stamp) = 0;
};

/// The library in the same process, by the streams that the node feeds: the same numbers to the last bit.
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

/// A loop with a partner that answers poses with wrenches at fixed steps. The wrenches of step n - delay act, constant,
/// from step n to step n + 1: they are late by (delay + 1/2) steps in the mean. With delay 0 each step waits for its
/// answer; with 1 the partner computes while the vehicle does. The history holds the wrenches that act.
History runExchange(const Scene& scene, Exchange& exchange, int delay);

/// The mean delay of wrenches in such a loop [s].
inline double loopDelay(double step, int delay) { return (delay + 0.5) * step; }

}  // namespace rubber_suspension::vehicle
