// Vehicles on rubber components as Simbody models.
#include "vehicle/vehicle.h"

namespace rubber_suspension::vehicle {
namespace {

using SimTK::MobilizedBody;
using SimTK::Vec3;

// Frames of joints. Simbody's sliders move along x and its pins turn about z; with these frames, along z and about -y.
SimTK::Transform alongZ() { return {SimTK::Rotation(-SimTK::Pi / 2, SimTK::YAxis)}; }
SimTK::Transform aboutMinusY() { return {SimTK::Rotation(SimTK::Pi / 2, SimTK::XAxis)}; }

SimTK::Body solid(double mass, const Vec3& inertia) {
  return SimTK::Body::Rigid({mass, Vec3(0.0), SimTK::Inertia(inertia)});
}

Vec3 toSimbody(const Eigen::Vector3d& vector) { return {vector[0], vector[1], vector[2]}; }

}  // namespace

// Computes forces for Simbody, which requests them at every stage of every trial step.
class Vehicle::BushForces final : public SimTK::Force::Custom::Implementation {
 public:
  BushForces(const Vehicle& vehicle, WrenchLaw& law) : vehicle_(vehicle), law_(law) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<Vec3>& /*particle_forces*/, SimTK::Vector& /*mobility_forces*/) const override {
    for (std::size_t i = 0; i < vehicle_.mounts_.size(); ++i) {
      const Eigen::Isometry3d pose = vehicle_.pose(state, vehicle_.mounts_[i]);
      const component::Wrench wrench = law_.wrench(i, state.getTime(), pose);
      vehicle_.apply(state, vehicle_.mounts_[i], component::SixDirections::reactions(pose, wrench), body_forces);
    }
  }

  // Returns 0, since the energy of the rubber is not computed.
  double calcPotentialEnergy(const SimTK::State& /*state*/) const override { return 0.0; }

 private:
  const Vehicle& vehicle_;
  WrenchLaw& law_;
};

Vehicle::Vehicle(Kind kind, const VehicleParameters& parameters, const Track& track, WrenchLaw& law)
    : track_(track), matter_(system_), forces_(system_) {
  kind == Kind::body ? makeBody(parameters) : makeHalfBogie(parameters);
  const SimTK::Force::Custom bushes(forces_, new BushForces(*this, law));  // the subsystem owns BushForces
  system_.realizeTopology();
}

void Vehicle::makeBody(const VehicleParameters& parameters) {
  const HungBody& hung = parameters.hung;
  const MobilizedBody::Free body(matter_.Ground(), SimTK::Transform(),
                                 solid(hung.mass, Vec3(hung.inertia[0], hung.inertia[1], hung.inertia[2])),
                                 SimTK::Transform());
  const double delay = hung.wheelbase / parameters.speed;
  for (const double late : {0.0, 0.0, delay, delay}) {
    mounts_.push_back({SimTK::GroundIndex, body.getMobilizedBodyIndex(), late});
  }
}

void Vehicle::makeHalfBogie(const VehicleParameters& parameters) {
  // Height and pitch of the frame are two joints with a massless body in between.
  MobilizedBody::Slider carrier(matter_.Ground(), alongZ(), SimTK::Body::Massless(), alongZ());
  const MobilizedBody::Pin frame(carrier, aboutMinusY(), solid(parameters.frame_mass, Vec3(parameters.frame_inertia)),
                                 aboutMinusY());
  const MobilizedBody::Slider body(matter_.Ground(), alongZ(), solid(parameters.body_mass, Vec3(parameters.body_mass)),
                                   alongZ());
  const Vec3 above(0.0, 0.0, 1.0);  // point of the body above the frame, which gives the damper a direction [m]
  const SimTK::Force::TwoPointLinearDamper damper(forces_, frame, Vec3(0.0), body, above, parameters.secondary_damping);
  const SimTK::MobilizedBodyIndex frame_index = frame.getMobilizedBodyIndex();
  mounts_ = {{SimTK::GroundIndex, frame_index, 0.0},
             {SimTK::GroundIndex, frame_index, 2.0 * parameters.semi_wheelbase / parameters.speed},
             {frame_index, body.getMobilizedBodyIndex(), 0.0}};
}

Eigen::Isometry3d Vehicle::pose(const SimTK::State& state, const Mount& mount) const {
  SimTK::Transform a = matter_.getMobilizedBody(mount.a).getBodyTransform(state);
  if (mount.a == SimTK::GroundIndex) {
    a.updP()[2] += track_.height(state.getTime() - mount.delay);
  }
  const SimTK::Transform pose = ~a * matter_.getMobilizedBody(mount.b).getBodyTransform(state);
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    result.translation()[row] = pose.p()[row];
    for (int column = 0; column < 3; ++column) {
      result.linear()(row, column) = pose.R().asMat33()(row, column);
    }
  }
  return result;
}

Poses Vehicle::poses(const SimTK::State& state) const {
  system_.realize(state, SimTK::Stage::Position);
  Poses poses;
  for (const Mount& mount : mounts_) {
    poses.push_back(pose(state, mount));
  }
  return poses;
}

// Adds the reactions of a component to the forces on its two bodies. A force on the ground has no effect.
void Vehicle::apply(const SimTK::State& state, const Mount& mount, const component::Reactions& reactions,
                    SimTK::Vector_<SimTK::SpatialVec>& body_forces) const {
  const auto& a = matter_.getMobilizedBody(mount.a);
  const SimTK::Rotation& axes = a.getBodyRotation(state);
  const auto add = [&](const SimTK::MobilizedBody& body, const component::Wrench& wrench) {
    body.applyForceToBodyPoint(state, Vec3(0.0), axes * toSimbody(wrench.force), body_forces);
    body.applyBodyTorque(state, axes * toSimbody(wrench.moment), body_forces);
  };
  add(a, reactions.on_a);
  add(matter_.getMobilizedBody(mount.b), reactions.on_b);
}

}  // namespace rubber_suspension::vehicle
