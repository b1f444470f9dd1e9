// Geometry and motion of the half bogie agree with closed forms: heights, free flight, a pitch oscillation.
#include "support/test.h"
#include "vehicle/simulation.h"
#include "vehicle/vehicle.h"

namespace rubber_suspension::vehicle {
namespace {

class NoForce final : public WrenchLaw {
 public:
  component::Wrench wrench(std::size_t, double, const Eigen::Isometry3d&) override { return {}; }
};

// Given forces on both primaries, independent of the displacements. Their sign may alternate from step to step.
class GivenForces final : public Exchange {
 public:
  GivenForces(double force, bool alternates) : force_(force), alternates_(alternates) {}

  void send(std::int64_t stamp, const Poses& /*poses*/) override { odd_ = (stamp / 1000000) % 2 != 0; }

  Wrenches receive(std::int64_t /*stamp*/) override {
    component::Wrench up;  // force of the bush; the wrench points against it
    up.force.z() = alternates_ && odd_ ? force_ : -force_;
    return {up, up, {}};
  }

 private:
  double force_;
  bool alternates_;
  bool odd_ = false;
};

Bushes springs(double primary, double secondary) {
  const double front = VehicleParameters().semi_wheelbase;
  const auto spring = [](double stiffness, double station) {
    return makeStrut({{"spring", {{"stiffness", {stiffness}}}}}, station);
  };
  return {spring(primary, front), spring(primary, -front), spring(secondary, 0.0)};
}

TEST(HalfBogie, CompressionsFollowFromHeightsAndPitch) {
  const Track track;
  NoForce law;
  const VehicleParameters parameters;
  const Vehicle bogie(Kind::struts, parameters, track, law);
  SimTK::State state = bogie.restState();
  const double frame = 2e-3;
  const double pitch = 3e-3;
  const double body = 5e-3;
  state.updQ() = SimTK::Vector(SimTK::Vec3(frame, pitch, body));
  const Poses poses = bogie.poses(state);
  const Bushes struts = springs(1.0, 1.0);
  const auto compression = [&](std::size_t i) { return struts[i].coordinates(poses[i])[component::kZ]; };
  EXPECT_NEAR(compression(0), -frame - parameters.semi_wheelbase * std::sin(pitch), 1e-15);
  EXPECT_NEAR(compression(1), -frame + parameters.semi_wheelbase * std::sin(pitch), 1e-15);
  EXPECT_NEAR(compression(2), (frame - body) * std::cos(pitch), 1e-15);  // along the vertical axis of the frame
}

// Constant forces F on both primaries accelerate the frame of mass m upwards by z = F t^2/m.
TEST(HalfBogie, FliesFreelyUnderHeldForces) {
  Scene scene;
  scene.parameters.secondary_damping = 0.0;
  scene.duration = 0.1;
  GivenForces exchange(100.0, false);
  const History history = runExchange(scene, exchange, 0);
  const double time = history.time.back();
  EXPECT_NEAR(time, 0.1, 1e-12);
  EXPECT_NEAR(history.position.back()[0], 100.0 * time * time / scene.parameters.frame_mass, 1e-12);
  EXPECT_NEAR(history.position.back()[1], 0.0, 1e-15);
}

// The held forces alternate. If a force acted beyond its step, the effect would be of first order.
TEST(HalfBogie, TakesEachHeldForceFromTheStartOfItsStep) {
  Scene scene;
  scene.parameters.secondary_damping = 0.0;
  scene.duration = 0.1;
  GivenForces exchange(1e3, true);
  const History history = runExchange(scene, exchange, 0);
  // After each pair of steps, the frame is at rest and displaced by h^2 times the acceleration.
  const double expected = 50.0 * 1e-6 * 2e3 / scene.parameters.frame_mass;
  EXPECT_NEAR(history.position.back()[0], expected, 1e-9 * expected);
}

// On linear springs alone, the pitch obeys I theta'' = -2 k a^2 theta. The sine of the pitch and the linear path
// between accepted steps change the result by 1e-6 of the amplitude.
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
