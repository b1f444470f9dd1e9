// One side of a bogie as a Simbody model.
#include "vehicle/half_bogie.h"

namespace rubber_suspension::vehicle {
namespace {

using SimTK::MobilizedBody;
using SimTK::Vec3;

constexpr double kBodyHeight = 1.0;  // of the body above the frame [m], for its damper to have a direction

// A slider moves along x of its frames; ours is vertical, y. The body's own axes stay those of the ground.
SimTK::Transform upwards(double height) {
  return {SimTK::Rotation(SimTK::Pi / 2, SimTK::ZAxis), Vec3(0.0, height, 0.0)};
}
SimTK::Transform upwards() { return upwards(0.0); }

// Of the inertias only that about the lateral axis matters.
SimTK::MassProperties solid(double mass, double inertia) {
  return {mass, Vec3(0.0), SimTK::Inertia(inertia, inertia, inertia)};
}

}  // namespace

// The bridge to Simbody, which asks for forces at every stage of every step that it tries.
class HalfBogie::StrutForces final : public SimTK::Force::Custom::Implementation {
 public:
  StrutForces(const HalfBogie& bogie, StrutLaw& law) : bogie_(bogie), law_(law) {}

  void calcForce(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& body_forces,
                 SimTK::Vector_<Vec3>& /*particle_forces*/, SimTK::Vector& /*mobility_forces*/) const override {
    const PerStrut compression = bogie_.compressions(state);
    for (std::size_t i = 0; i < kStruts; ++i) {
      bogie_.apply(state, i, law_.load(i, state.getTime(), compression[i]), body_forces);
    }
  }

  // Rubber keeps no account of its energy.
  double calcPotentialEnergy(const SimTK::State& /*state*/) const override { return 0.0; }

 private:
  const HalfBogie& bogie_;
  StrutLaw& law_;
};

HalfBogie::HalfBogie(const VehicleParameters& parameters, const Track& track, StrutLaw& law)
    : parameters_(parameters), track_(track), matter_(system_), forces_(system_) {
  // Height and pitch of the frame are two joints with a massless body in between.
  MobilizedBody::Slider carrier(matter_.Ground(), upwards(), SimTK::Body::Massless(), upwards());
  const MobilizedBody::Pin frame(carrier, Vec3(0.0),
                                 SimTK::Body::Rigid(solid(parameters.frame_mass, parameters.frame_inertia)), Vec3(0.0));
  const MobilizedBody::Slider body(matter_.Ground(), upwards(kBodyHeight),
                                   SimTK::Body::Rigid(solid(parameters.body_mass, parameters.body_mass)), upwards());
  frame_ = frame.getMobilizedBodyIndex();
  body_ = body.getMobilizedBodyIndex();
  const SimTK::Force::TwoPointLinearDamper damper(forces_, frame, Vec3(0.0), body, Vec3(0.0),
                                                  parameters.secondary_damping);
  const SimTK::Force::Custom struts(forces_, new StrutForces(*this, law));  // the subsystem owns it
  system_.realizeTopology();
}

double HalfBogie::height(const SimTK::State& state, SimTK::MobilizedBodyIndex body, double station) const {
  return matter_.getMobilizedBody(body).findStationLocationInGround(state, Vec3(station, 0.0, 0.0))[1];
}

PerStrut HalfBogie::compressions(const SimTK::State& state) const {
  system_.realize(state, SimTK::Stage::Position);
  const double time = state.getTime();
  const double a = parameters_.semi_wheelbase;
  return {track_.height(time) - height(state, frame_, a),
          track_.height(time - 2.0 * a / parameters_.speed) - height(state, frame_, -a),
          height(state, frame_, 0.0) - (height(state, body_, 0.0) - kBodyHeight)};
}

void HalfBogie::apply(const SimTK::State& state, std::size_t strut, double force,
                      SimTK::Vector_<SimTK::SpatialVec>& body_forces) const {
  const Vec3 up(0.0, force, 0.0);
  const auto& frame = matter_.getMobilizedBody(frame_);
  if (strut == 2) {
    frame.applyForceToBodyPoint(state, Vec3(0.0), -up, body_forces);
    matter_.getMobilizedBody(body_).applyForceToBodyPoint(state, Vec3(0.0), up, body_forces);
    return;
  }
  const double station = strut == 0 ? parameters_.semi_wheelbase : -parameters_.semi_wheelbase;
  frame.applyForceToBodyPoint(state, Vec3(station, 0.0, 0.0), up, body_forces);
}

SimTK::Vector HalfBogie::direction(const SimTK::State& state, std::size_t strut) const {
  SimTK::Vector_<SimTK::SpatialVec> body_forces(matter_.getNumBodies(), SimTK::SpatialVec(Vec3(0.0), Vec3(0.0)));
  apply(state, strut, 1.0, body_forces);
  SimTK::Vector generalised;
  matter_.multiplyBySystemJacobianTranspose(state, body_forces, generalised);
  return generalised;
}

}  // namespace rubber_suspension::vehicle
