// Components of six directions in a multibody simulation agree with the bushing of Simbody and with closed forms.
#include <Simbody.h>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/io/component_file.h"
#include "support/test.h"
#include "vehicle/simulation.h"
#include "vehicle/soft_track.h"

namespace rubber_suspension::vehicle {
namespace {

using component::SixDirections;
using component::SixNumbers;
using SimTK::Vec3;
using SimTK::Vec6;

const std::string kFolder = TEST_DIR "/../config/";
const std::array<double, 6> kStiffness = {4e6, 2e6, 1e6, 900.0, 700.0, 250.0};
const std::array<double, 6> kDamping = {3e3, 2e3, 1e3, 5.0, 4.0, 3.0};

component::SixDirectionsLaws lawsOf(component::RotationMeasure measure) {
  component::SixDirectionsLaws laws;
  for (std::size_t i = 0; i < 6; ++i) {
    laws.elements[i] = {{"spring", {{"stiffness", {kStiffness[i]}}}}, {"dashpot", {{"damping", {kDamping[i]}}}}};
  }
  laws.measure = measure;
  return laws;
}

Eigen::Vector3d toEigen(const Vec3& v) { return {v[0], v[1], v[2]}; }

Eigen::Matrix3d toEigen(const SimTK::Rotation& rotation) {
  Eigen::Matrix3d result;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      result(row, column) = rotation.asMat33()(row, column);
    }
  }
  return result;
}

Eigen::Isometry3d toEigen(const SimTK::Transform& transform) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = toEigen(transform.p());
  result.linear() = toEigen(transform.R());
  return result;
}

// Two moving bodies at random poses, with cardan angles between them of at most `angle`. The bushing of Simbody between
// them is away from the centres of both bodies.
class TwoBodies {
 public:
  TwoBodies()
      : matter_(system_),
        forces_(system_),
        on_a_(frame(1.0, 0.2)),
        on_b_(frame(1.0, 0.2)),
        a_(matter_.Ground(), SimTK::Transform(), solid(), SimTK::Transform()),
        b_(matter_.Ground(), SimTK::Transform(), solid(), SimTK::Transform()),
        bushing_(forces_, a_, on_a_, b_, on_b_, vec6(kStiffness), vec6(kDamping)) {
    state_ = system_.realizeTopology();
  }

  void move(double angle) {
    const SimTK::Transform of_a = frame(3.0, 1.0);
    // The frames of the bushing on the two bodies differ by this pose.
    const SimTK::Transform between(turn(angle), 0.02 * vec3());
    a_.setQToFitTransform(state_, of_a);
    b_.setQToFitTransform(state_, of_a * on_a_ * between * ~on_b_);
    a_.setUToFitVelocity(state_, {vec3(), vec3()});
    b_.setUToFitVelocity(state_, {vec3(), vec3()});
    system_.realize(state_, SimTK::Stage::Dynamics);
  }

  SixDirections bush(component::RotationMeasure measure) const {
    component::SixDirectionsLaws laws = lawsOf(measure);
    laws.on_a = toEigen(on_a_);
    laws.on_b = toEigen(on_b_);
    return SixDirections(laws);
  }

  Eigen::Isometry3d pose() const { return toEigen(~a_.getBodyTransform(state_) * b_.getBodyTransform(state_)); }

  component::Twist twist() const {
    const SimTK::SpatialVec velocity = b_.findBodyVelocityInAnotherBody(state_, a_);
    return {toEigen(velocity[1]), toEigen(velocity[0])};
  }

  // Returns the wrenches of Simbody's bushing on A and B about the origins of the bodies, in the axes of A.
  component::Reactions ofSimbody() const {
    SimTK::Vector_<SimTK::SpatialVec> bodies;
    SimTK::Vector_<Vec3> particles;
    SimTK::Vector mobilities;
    bushing_.calcForceContribution(state_, bodies, particles, mobilities);
    const Eigen::Matrix3d axes = toEigen(a_.getBodyRotation(state_)).transpose();
    const auto of = [&](const SimTK::MobilizedBody& body) {
      const SimTK::SpatialVec& load = bodies[body.getMobilizedBodyIndex()];
      return component::Wrench{axes * toEigen(load[1]), axes * toEigen(load[0])};
    };
    return {of(a_), of(b_)};
  }

 private:
  static SimTK::Body solid() { return SimTK::Body::Rigid({5.0, Vec3(0.0), SimTK::Inertia(0.02, 0.02, 0.02)}); }
  static Vec6 vec6(const std::array<double, 6>& by_direction) {  // Simbody has rotations first
    const auto& v = by_direction;
    return {v[3], v[4], v[5], v[0], v[1], v[2]};
  }
  double share() { return std::uniform_real_distribution<double>(-1.0, 1.0)(random_); }
  Vec3 vec3() {
    const double x = share();
    const double y = share();
    return {x, y, share()};
  }
  SimTK::Rotation turn(double angle) {
    const Vec3 angles = angle * vec3();
    return {SimTK::BodyRotationSequence, angles[0], SimTK::XAxis, angles[1], SimTK::YAxis, angles[2], SimTK::ZAxis};
  }
  SimTK::Transform frame(double angle, double length) {
    const SimTK::Rotation rotation = turn(angle);
    return {rotation, length * vec3()};
  }

  std::mt19937 random_{7};
  SimTK::MultibodySystem system_;
  SimTK::SimbodyMatterSubsystem matter_;
  SimTK::GeneralForceSubsystem forces_;
  SimTK::Transform on_a_;
  SimTK::Transform on_b_;
  SimTK::MobilizedBody::Free a_;
  SimTK::MobilizedBody::Free b_;
  SimTK::Force::LinearBushing bushing_;
  SimTK::State state_;
};

double distance(const component::Wrench& a, const component::Wrench& b) {
  return std::max((a.force - b.force).norm() / b.force.norm(), (a.moment - b.moment).norm() / b.moment.norm());
}

// Both bushings use Simbody's definition: body-fixed x-y-z angles, and forces that act at the frame on B along the axes
// of the frame on A.
TEST(SixDirectionsInSimbody, CardanAnglesEqualTheLinearBushing) {
  TwoBodies bodies;
  const SixDirections bush = bodies.bush(component::RotationMeasure::cardan);
  component::SixDirectionsState state = bush.makeState();
  for (int i = 0; i < 1000; ++i) {
    bodies.move(80.0 * element::kPi / 180.0);
    const component::BushForce force = bush.initialise(state, bodies.pose(), bodies.twist());
    const component::Reactions reactions = SixDirections::reactions(bodies.pose(), force.wrench);
    const component::Reactions expected = bodies.ofSimbody();
    ASSERT_LT(distance(reactions.on_a, expected.on_a), 1e-9) << i;
    ASSERT_LT(distance(reactions.on_b, expected.on_b), 1e-9) << i;
  }
}

// The rotation vector agrees to first order, so half the angle halves the relative difference.
TEST(SixDirectionsInSimbody, RotationVectorComesToItInProportionToTheAngle) {
  const auto difference = [](double angle) {
    TwoBodies bodies;  // the same random numbers for every angle
    const SixDirections vector = bodies.bush(component::RotationMeasure::vector);
    component::SixDirectionsState state = vector.makeState();
    double sum = 0.0;
    for (int i = 0; i < 100; ++i) {
      bodies.move(angle);
      const SixDirections cardan = bodies.bush(component::RotationMeasure::cardan);
      component::SixDirectionsState other = cardan.makeState();
      const Eigen::Vector3d expected = cardan.initialise(other, bodies.pose()).wrench.moment;
      sum += (vector.initialise(state, bodies.pose()).wrench.moment - expected).norm();
    }
    return sum / angle;
  };
  const double coarse = difference(0.08);
  const double fine = difference(0.04);
  EXPECT_GT(fine, 0.0);
  EXPECT_NEAR(coarse / fine, 2.0, 0.1);
}

Scene someTrack(Kind kind) {
  Scene scene = softTrack({{4e-3, 9.0, 0.0}, {2e-3, 31.0, 1.0}}, 1.0);
  scene.kind = kind;
  return scene;
}

// All four bushes follow the same track at once, so the body only moves up and down, as a mass on four springs.
TEST(Vehicle, BodyOnSpringsIsAnOscillator) {
  Scene scene = someTrack(Kind::body);
  scene.parameters.speed = 1e9;  // makes the delay of the rear bushes negligible
  Bushes bushes;
  for (const double x : {1.1, -1.1}) {
    for (const double y : {0.6, -0.6}) {
      component::SixDirectionsLaws laws;
      for (std::size_t i = 0; i < 6; ++i) {
        laws.elements[i] = {{"spring", {{"stiffness", {i < 3 ? 2e5 : 500.0}}}}};
      }
      laws.on_a.translation() = laws.on_b.translation() = Eigen::Vector3d(x, y, 0.0);
      bushes.emplace_back(laws);
    }
  }
  const History history = runVariableStep(scene, bushes, {});
  const double omega2 = 4.0 * 2e5 / scene.parameters.hung.mass;
  double height = 0.0;
  double speed = 0.0;
  constexpr double kStep = 1e-5;
  for (std::size_t n = 0; n < history.size(); ++n) {
    const double track = scene.track.height(history.time[n]);
    for (const Eigen::Isometry3d& pose : history.pose[n]) {
      ASSERT_NEAR(pose.translation().z(), height - track, 1e-6);
      ASSERT_LT(pose.translation().head<2>().norm() + (pose.linear() - Eigen::Matrix3d::Identity()).norm(), 1e-9);
    }
    for (int i = 0; i < 100; ++i) {  // leapfrog method, with a phase error of (w h)^2/24 of a cycle
      const double time = history.time[n] + kStep * i;
      height += 0.5 * kStep * speed;
      speed -= kStep * omega2 * (height - scene.track.height(time + 0.5 * kStep));
      height += 0.5 * kStep * speed;
    }
  }
}

// Held wrenches lag by half a step, so halving the step halves the difference to variable steps.
TEST(Vehicle, LoopsWithHeldWrenchesComeToVariableStepsWithTheStep) {
  for (const auto& [kind, file] :
       {std::pair(Kind::body, "hung_body.yaml"), std::pair(Kind::bushes, "half_bogie_six.yaml")}) {
    const auto bushes = loadBushes(kind, kFolder + file);
    const auto difference = [&, which = kind](std::int64_t step) {
      Scene scene = someTrack(which);
      scene.step = step;
      LibraryExchange exchange(bushes);
      return displacementDifference(bushes, runExchange(scene, exchange, 0), runVariableStep(scene, bushes, {}));
    };
    const PerBush<double> coarse = difference(500000);
    const PerBush<double> fine = difference(250000);
    for (std::size_t i = 0; i < bushes.size(); ++i) {
      EXPECT_LT(coarse[i], 0.5);
      EXPECT_NEAR(coarse[i] / fine[i], 2.0, 0.4) << bushNames(kind)[i];
    }
  }
}

// The track reaches the rear later, so the body pitches and moves along, which loads the bushes in these directions.
TEST(Vehicle, ATrackLoadsSeveralDirections) {
  const auto bushes = loadBushes(Kind::body, kFolder + "hung_body.yaml");
  const History history = runVariableStep(someTrack(Kind::body), bushes, {});
  SixNumbers largest = SixNumbers::Zero();
  for (const auto& poses : history.pose) {
    largest = largest.cwiseMax(bushes[0].coordinates(poses[0]).cwiseAbs());
  }
  EXPECT_GT(largest[component::kX], 1e-5);
  EXPECT_GT(largest[component::kZ], 1e-4);
  EXPECT_GT(largest[component::kRy], 1e-5);
  EXPECT_LT(largest[component::kRx], 1e-9);  // both sides have the same track
}

TEST(Vehicle, ComponentsOfOneDirectionAreRefused) {
  EXPECT_THROW(loadBushes(Kind::bushes, kFolder + "half_bogie.yaml"), io::ComponentFileError);
}

}  // namespace
}  // namespace rubber_suspension::vehicle
