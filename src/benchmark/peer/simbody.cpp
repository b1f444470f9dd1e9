// Simbody on the library's work: the displacements of the dashpots are auxiliary states of a force.
#include <Simbody.h>

#include "benchmark/peer/peers.h"

namespace rubber_suspension::benchmark {
namespace {

using SimTK::State;

// The way to the next sample.
struct Segment {
  double start = 0.0;         // [s]
  double displacement = 0.0;  // there [m]
  double velocity = 0.0;      // [m/s]

  double at(double time) const { return displacement + velocity * (time - start); }
};

// Of displacements, some millimetres: 0.01 N of the stiffest element.
constexpr double kSimbodyAccuracy = 3e-8;

// It acts on no body; the system has none.
class Dashpots final : public SimTK::Force::Custom::Implementation {
 public:
  Dashpots(const SimTK::GeneralForceSubsystem& forces, const PeerWork& work, const Segment& segment)
      : forces_(forces), work_(work), segment_(segment) {}

  void calcForce(const State& /*state*/, SimTK::Vector_<SimTK::SpatialVec>& /*body_forces*/,
                 SimTK::Vector_<SimTK::Vec3>& /*particle_forces*/, SimTK::Vector& /*mobility_forces*/) const override {}
  SimTK::Real calcPotentialEnergy(const State& /*state*/) const override { return 0.0; }

  void realizeTopology(State& state) const override {
    const auto count = static_cast<int>(work_.rate.size());
    forces_.allocateZ(state, SimTK::Vector(count, work_.displacement[0]));
  }

  void realizeAcceleration(const State& state) const override {
    const SimTK::Vector& dashpot = forces_.getZ(state);
    SimTK::Vector& velocity = forces_.updZDot(state);
    const double displacement = segment_.at(state.getTime());
    for (int k = 0; k < dashpot.size(); ++k) {
      velocity[k] = work_.rate[static_cast<std::size_t>(k)] * (displacement - dashpot[k]);
    }
  }

 private:
  const SimTK::GeneralForceSubsystem& forces_;
  const PeerWork& work_;
  const Segment& segment_;
};

}  // namespace

void simbodyMerson(const PeerWork& work, std::vector<double>& force) {
  SimTK::MultibodySystem system;
  const SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  Segment segment;
  const SimTK::Force::Custom dashpots(forces, new Dashpots(forces, work, segment));  // the handle owns it
  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(kSimbodyAccuracy);
  integrator.setAllowInterpolation(false);
  integrator.initialize(system.realizeTopology());
  for (std::size_t i = 1; i < work.displacement.size(); ++i) {
    segment = {integrator.getTime(), work.displacement[i - 1], work.velocity(i)};
    const double end = static_cast<double>(i) * work.dt;
    while (integrator.getTime() < end) {
      integrator.stepTo(end, end);
    }
    const SimTK::Vector& dashpot = forces.getZ(integrator.getState());
    force[i] = 0.0;
    for (int k = 0; k < dashpot.size(); ++k) {
      force[i] += work.stiffness[static_cast<std::size_t>(k)] * (work.displacement[i] - dashpot[k]);
    }
  }
}

}  // namespace rubber_suspension::benchmark
