// The vehicle's geometry and motion against closed forms: heights, directions, free flight, a pitch oscillation.
#include "vehicle/half_bogie.h"

#include <gtest/gtest.h>

#include <cmath>

#include "vehicle/simulation.h"

namespace rubber_suspension::vehicle {
namespace {

class NoForce final : public StrutLaw {
 public:
  double load(std::size_t, double, const double&) override { return 0.0; }
};

// The same forces whatever the displacements.
class ConstantForces final : public ForceExchange {
 public:
  explicit ConstantForces(const PerStrut& force) : force_(force) {}
  void send(std::int64_t, const PerStrut&) override {}
  PerStrut receive(std::int64_t) override { return force_; }

 private:
  PerStrut force_;
};

std::vector<component::Component> springs(double primary, double secondary) {
  const component::Component front({{"spring", {{"stiffness", {primary}}}}});
  return {front, front, component::Component({{"spring", {{"stiffness", {secondary}}}}})};
}

TEST(HalfBogie, CompressionsFollowFromHeightsAndPitch) {
  const Track track;
  NoForce law;
  const VehicleParameters parameters;
  const HalfBogie bogie(parameters, track, law);
  SimTK::State state = bogie.restState();
  const double frame = 2e-3;
  const double pitch = 3e-3;
  const double body = 5e-3;
  state.updQ() = SimTK::Vector(SimTK::Vec3(frame, pitch, body));
  const PerStrut compression = bogie.compressions(state);
  EXPECT_NEAR(compression[0], -frame - parameters.semi_wheelbase * std::sin(pitch), 1e-15);
  EXPECT_NEAR(compression[1], -frame + parameters.semi_wheelbase * std::sin(pitch), 1e-15);
  EXPECT_NEAR(compression[2], frame - body, 1e-15);
}

// Virtual work: a force in a component does the work -F dz in a motion, so its generalised force is -dz/dq.
TEST(HalfBogie, DirectionsAreThoseOfVirtualWork) {
  const Track track;
  NoForce law;
  const HalfBogie bogie(VehicleParameters(), track, law);
  SimTK::State state = bogie.restState();
  state.updQ() = SimTK::Vector(SimTK::Vec3(1e-3, 0.2, -1e-3));
  bogie.compressions(state);
  constexpr double kDistance = 1e-6;
  for (std::size_t i = 0; i < kStruts; ++i) {
    const SimTK::Vector direction = bogie.direction(state, i);
    for (int j = 0; j < direction.size(); ++j) {
      SimTK::State above = state;
      SimTK::State below = state;
      above.updQ()[j] += kDistance;
      below.updQ()[j] -= kDistance;
      const double slope = (bogie.compressions(above)[i] - bogie.compressions(below)[i]) / (2.0 * kDistance);
      EXPECT_NEAR(direction[j], -slope, 1e-9) << strutNames()[i] << ", coordinate " << j;
    }
  }
}

// With constant forces on both primaries the frame falls upwards: z = F t^2/m.
TEST(HalfBogie, FliesFreelyUnderHeldForces) {
  Scene scene;
  scene.parameters.secondary_damping = 0.0;
  scene.duration = 0.1;
  ConstantForces exchange({100.0, 100.0, 0.0});
  const History history = runExchange(scene, exchange, 0);
  const double time = history.time.back();
  EXPECT_NEAR(time, 0.1, 1e-12);
  EXPECT_NEAR(history.position.back()[0], 100.0 * time * time / scene.parameters.frame_mass, 1e-12);
  EXPECT_NEAR(history.position.back()[1], 0.0, 1e-15);
}

// Held forces that alternate: a force that lingered over the end of its step would leave a trace of the first order.
TEST(HalfBogie, TakesEachHeldForceFromTheStartOfItsStep) {
  class Alternating final : public ForceExchange {
   public:
    void send(std::int64_t stamp, const PerStrut&) override { even_ = (stamp / 1000000) % 2 == 0; }
    PerStrut receive(std::int64_t) override { return even_ ? PerStrut{1e3, 1e3, 0.0} : PerStrut{-1e3, -1e3, 0.0}; }

   private:
    bool even_ = true;
  };
  Scene scene;
  scene.parameters.secondary_damping = 0.0;
  scene.duration = 0.1;
  Alternating exchange;
  const History history = runExchange(scene, exchange, 0);
  // Two steps end at rest, h^2 a further.
  const double expected = 50.0 * 1e-6 * 2e3 / scene.parameters.frame_mass;
  EXPECT_NEAR(history.position.back()[0], expected, 1e-9 * expected);
}

// Pitch on linear springs alone: I theta'' = -2 k a^2 theta. The sine of the pitch and the path between accepted steps
// leave 1e-6 of the amplitude.
TEST(HalfBogie, PitchesAsASingleOscillator) {
  Scene scene;
  scene.duration = 0.5;
  scene.kick = {0.0, 1e-3, 0.0};
  const double k = 1.5e6;
  const double a = scene.parameters.semi_wheelbase;
  const double omega = std::sqrt(2.0 * k * a * a / scene.parameters.frame_inertia);
  const History history = runVariableStep(scene, springs(k, 0.5e6), {});
  const double amplitude = scene.kick[1] / omega;
  for (std::size_t n = 0; n < history.size(); ++n) {
    ASSERT_NEAR(history.position[n][1], amplitude * std::sin(omega * history.time[n]), 1e-5 * amplitude);
  }
}

}  // namespace
}  // namespace rubber_suspension::vehicle
