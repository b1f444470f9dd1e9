// Simbody on the library's work: the displacements of the dashpots are auxiliary states of a force.
#include <Simbody.h>

#include "benchmark/bare_loop.h"
#include "benchmark/test_signal.h"

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
  Dashpots(const SimTK::GeneralForceSubsystem& forces, const BareMaxwells<5>& maxwells, const Segment& segment)
      : forces_(forces), maxwells_(maxwells), segment_(segment) {}

  void calcForce(const State& /*state*/, SimTK::Vector_<SimTK::SpatialVec>& /*body_forces*/,
                 SimTK::Vector_<SimTK::Vec3>& /*particle_forces*/, SimTK::Vector& /*mobility_forces*/) const override {}
  SimTK::Real calcPotentialEnergy(const State& /*state*/) const override { return 0.0; }

  void realizeTopology(State& state) const override {
    forces_.allocateZ(state, SimTK::Vector(5, segment_.displacement));
  }

  void realizeAcceleration(const State& state) const override {
    const SimTK::Vector& dashpot = forces_.getZ(state);
    SimTK::Vector& velocity = forces_.updZDot(state);
    const double displacement = segment_.at(state.getTime());
    for (int k = 0; k < dashpot.size(); ++k) {
      velocity[k] = (displacement - dashpot[k]) / maxwells_.relaxation_time[static_cast<std::size_t>(k)];
    }
  }

 private:
  const SimTK::GeneralForceSubsystem& forces_;
  const BareMaxwells<5>& maxwells_;
  const Segment& segment_;
};

}  // namespace

void simbodyMerson(const BareMaxwells<5>& maxwells, const std::vector<double>& displacement,
                   std::vector<double>& force) {
  SimTK::MultibodySystem system;
  const SimTK::SimbodyMatterSubsystem matter(system);
  SimTK::GeneralForceSubsystem forces(system);
  Segment segment{0.0, displacement[0], 0.0};
  const SimTK::Force::Custom dashpots(forces, new Dashpots(forces, maxwells, segment));  // the handle owns it
  SimTK::RungeKuttaMersonIntegrator integrator(system);
  integrator.setAccuracy(kSimbodyAccuracy);
  integrator.setAllowInterpolation(false);
  integrator.initialize(system.realizeTopology());
  for (std::size_t i = 1; i < displacement.size(); ++i) {
    segment = {integrator.getTime(), displacement[i - 1], (displacement[i] - displacement[i - 1]) / kStep};
    const double end = static_cast<double>(i) * kStep;
    while (integrator.getTime() < end) {
      integrator.stepTo(end, end);
    }
    const SimTK::Vector& dashpot = forces.getZ(integrator.getState());
    force[i] = 0.0;
    for (int k = 0; k < dashpot.size(); ++k) {
      force[i] += maxwells.stiffness[static_cast<std::size_t>(k)] * (displacement[i] - dashpot[k]);
    }
  }
}

}  // namespace rubber_suspension::benchmark
