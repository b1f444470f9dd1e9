// A component of six directions: reference values, power, momentum, tangents.
#include "rubber_suspension/component/six_directions.h"

#include "component/bushes.h"
#include "support/allocation_counter.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

using component::RotationMeasure;
using component::SixDirections;
using component::SixDirectionsLaws;
using component::SixNumbers;
using Eigen::Isometry3d;
using Eigen::Vector3d;

const std::vector<RotationMeasure> kMeasures = {RotationMeasure::vector, RotationMeasure::cardan};

// The reference values are of an independent implementation in numpy, which was verified by gradients of potentials.
SixDirectionsLaws referenceLaws(RotationMeasure measure) {
  SixDirectionsLaws laws;
  laws.elements[component::kX] = {spring(4e6), entry("progressive_stiffness cubic=2e12")};
  laws.elements[component::kY] = {spring(2e6)};
  laws.elements[component::kZ] = {spring(1e6)};
  laws.elements[component::kRx] = laws.elements[component::kRy] = {spring(900.0)};
  laws.elements[component::kRz] = {spring(250.0)};
  laws.measure = measure;
  return laws;
}

Isometry3d referencePose() { return poseAt({0.6e-3, -0.8e-3, 0.5e-3}, {0.05, -0.03, 0.12}); }

TEST(SixDirections, GivesTheWrenchOfTheReference) {
  for (const auto& [measure, moment] :
       {std::pair(RotationMeasure::vector, Vector3d(46.130988425, -25.026593055, 30.022106559)),
        {RotationMeasure::cardan, Vector3d(46.521778495, -25.819289042, 30.152275086)}}) {
    const SixDirections bush(referenceLaws(measure));
    auto state = bush.makeState();
    const component::Wrench wrench = bush.initialise(state, referencePose()).wrench;
    EXPECT_LT((wrench.force - Vector3d(2832.0, -1600.0, 500.0)).norm(), 1e-9);
    EXPECT_LT((wrench.moment - moment).norm(), 1e-9);
    EXPECT_EQ(bush.step(state, 1e-3, referencePose()).wrench.force, wrench.force);
  }
  const Vector3d angles(0.051690865, -0.026918777, 0.120729911);
  const SixDirections bush(referenceLaws(RotationMeasure::cardan));
  EXPECT_LT((bush.coordinates(referencePose()).tail<3>() - angles).norm(), 1e-9);
}

// This is the wrench of a cylindrical bush at the reference pose. The moment on A is M + d x F.
TEST(SixDirections, GivesBothBodiesTheirReactions) {
  const component::Wrench on_b{{3600.0, -4800.0, 500.0}, {46.130988425, -25.026593055, 30.022106559}};
  const component::Reactions reactions = SixDirections::reactions(referencePose(), on_b);
  EXPECT_EQ(reactions.on_a.force, on_b.force);
  EXPECT_LT((reactions.on_a.moment - Vector3d(48.130988425, -23.526593055, 30.022106559)).norm(), 1e-9);
  EXPECT_EQ(reactions.on_b.force, -on_b.force);
  EXPECT_EQ(reactions.on_b.moment, -on_b.moment);
}

TEST(SixDirections, GivesForcesByDirectionBack) {
  for (const RotationMeasure measure : kMeasures) {
    const SixDirections bush(framed(fullLaws(measure)));
    auto state = bush.makeState();
    const Isometry3d pose = poseAt({1e-3, 2e-3, -1e-3}, {0.3, -0.5, 0.2});
    const component::BushForce force = bush.initialise(state, pose);
    const SixNumbers back = bush.directionForces(pose, force.wrench);
    for (std::size_t i = 0; i < component::kDirections; ++i) {
      const double expected = force.direction[i].total;
      EXPECT_NEAR(back[static_cast<Eigen::Index>(i)], expected, 1e-11 * (1.0 + std::abs(expected))) << i;
    }
    EXPECT_TRUE(bush.pose(bush.coordinates(pose)).isApprox(pose, 1e-14));
  }
}

TEST(SixDirections, RotationMeasuresTurnBackToTheirRotations) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> angle(-1.4, 1.4);
  for (const RotationMeasure measure : kMeasures) {
    for (int i = 0; i < 200; ++i) {
      const double size = std::pow(10.0, -i / 20);  // down to 1e-9 rad
      const Vector3d value = size * Vector3d(angle(random), angle(random), angle(random));
      Eigen::Quaterniond rotation = component::rotationOf(measure, value);
      rotation.coeffs() *= i % 2 == 0 ? 1.0 : -1.0;  // the same rotation
      const component::RotationCoordinates found = component::coordinatesOf(measure, rotation);
      EXPECT_LT((found.value - value).norm(), 1e-15 + 1e-14 * size);
      const component::RotationCoordinates same = component::coordinatesOf(measure, rotation.toRotationMatrix());
      EXPECT_LT((same.value - value).norm(), 1e-15 + 1e-14 * size);
      const Vector3d moments(1.0, -2.0, 0.5);
      EXPECT_LT((same.momentOf(moments) - found.rates().transpose() * moments).norm(), 1e-13);
      EXPECT_LT((found.rates() - component::ratesAt(measure, value)).norm(), 1e-13);
      // The rates are the derivative of the coordinates with respect to a rotation about the axes of A.
      constexpr double kStep = 1e-6;
      for (Eigen::Index axis = 0; axis < 3; ++axis) {
        const auto turned = [&](double by) {
          const Eigen::AngleAxisd turn(by, Vector3d::Unit(axis));
          return component::coordinatesOf(measure, turn * rotation).value;
        };
        EXPECT_LT(((turned(kStep) - turned(-kStep)) / (2.0 * kStep) - found.rates().col(axis)).norm(), 1e-8);
      }
    }
  }
}

// At a given twist, springs and dashpots exert K q + C q' on the coordinates q, independent of the last step.
TEST(SixDirections, DashpotsAnswerToATwist) {
  SixDirectionsLaws laws = referenceLaws(RotationMeasure::cardan);
  for (auto& elements : laws.elements) {
    elements.push_back(dashpot(70.0));
  }
  const SixDirections bush(laws);
  const SixDirections springs(referenceLaws(RotationMeasure::cardan));
  auto state = bush.makeState();
  auto spring_state = springs.makeState();
  const component::Twist twist{{0.1, -0.2, 0.3}, {1.0, 2.0, -0.5}};
  const Isometry3d pose = poseAt({1e-3, 0.0, 2e-3}, {0.4, 0.9, -0.3});
  const component::Wrench elastic = springs.initialise(spring_state, pose).wrench;
  const component::RotationCoordinates rotation =
      component::coordinatesOf(RotationMeasure::cardan, Eigen::Quaterniond(pose.linear()));
  const Vector3d force = elastic.force + 70.0 * twist.linear;
  const Vector3d moment = elastic.moment + 70.0 * rotation.rates().transpose() * rotation.rates() * twist.angular;
  const component::Wrench at_once = bush.initialise(state, pose, twist).wrench;
  EXPECT_LT((at_once.force - force).norm() + (at_once.moment - moment).norm(), 1e-9 * force.norm());
  bush.step(state, 3e-3, poseAt({0.0, 1e-3, 0.0}, {0.3, 0.8, -0.2}));
  const component::Wrench after = bush.step(state, 2e-3, pose, twist).wrench;
  EXPECT_LT((after.force - force).norm() + (after.moment - moment).norm(), 1e-9 * force.norm());
}

TEST(SixDirections, ADisplacedBodyComesBack) {
  SixDirectionsLaws laws = framed(fullLaws(RotationMeasure::vector));
  for (auto& elements : laws.elements) {
    elements.pop_back();  // remove friction, which could balance the springs
  }
  const SixDirections bush(laws);
  auto state = bush.makeState();
  Body body;
  body.pose = poseAt({2e-3, -1e-3, 1e-3}, {0.1, 0.05, -0.1});
  bush.initialise(state, Isometry3d::Identity());
  for (int i = 0; i < 40000; ++i) {
    const component::Wrench wrench = bush.step(state, 1e-4, body.pose).wrench;
    body.push(SixDirections::reactions(body.pose, wrench).on_b, 1e-4);
  }
  // The slowest branch (3 Hz) has decayed by exp(-2 pi 3 4) after 4 s.
  EXPECT_LT(body.pose.translation().norm(), 1e-9);
  EXPECT_LT(Eigen::AngleAxisd(body.pose.linear()).angle(), 1e-9);
  EXPECT_LT(body.momentum.norm(), 1e-6);
}

TEST(SixDirections, TwoFreeBodiesKeepTheirMomentum) {
  for (const RotationMeasure measure : kMeasures) {
    const SixDirections bush(framed(fullLaws(measure)));
    auto state = bush.makeState();
    Body a;
    Body b;
    a.pose = poseAt({0.3, 0.2, -0.1}, {0.4, -0.2, 0.7});
    b.pose = a.pose * poseAt({3e-3, -2e-3, 1e-3}, {0.2, -0.1, 0.15});
    b.momentum = {0.2, 0.1, -0.1};
    b.angular_momentum = {0.05, 0.02, 0.03};
    const Vector3d linear = a.momentum + b.momentum;
    const Vector3d angular = a.angularMomentumAboutOrigin() + b.angularMomentumAboutOrigin();
    bush.initialise(state, a.pose.inverse() * b.pose);
    double moved = 0.0;
    for (int i = 0; i < 20000; ++i) {
      const Isometry3d pose = a.pose.inverse() * b.pose;
      const component::Wrench wrench = bush.step(state, 1e-4, pose).wrench;
      const component::Reactions reactions = SixDirections::reactions(pose, wrench);
      const Eigen::Matrix3d axes = a.pose.linear();
      a.push(turned(axes, reactions.on_a), 1e-4);
      b.push(turned(axes, reactions.on_b), 1e-4);
      moved = std::max(moved, a.momentum.norm());
    }
    EXPECT_GT(moved, 0.1);
    EXPECT_LT((a.momentum + b.momentum - linear).norm(), 1e-9 * moved);
    EXPECT_LT((a.angularMomentumAboutOrigin() + b.angularMomentumAboutOrigin() - angular).norm(), 1e-9 * moved);
  }
}

// On a fine path, the wrench does the same work on the bodies as the forces on the coordinates do. Elastic directions
// do none.
TEST(SixDirections, TheWrenchDoesTheWorkOfItsDirections) {
  for (const RotationMeasure measure : kMeasures) {
    const LoopWork loop = closedLoop(SixDirections(framed(fullLaws(measure))), 10000);
    EXPECT_GT(loop.work, 0.0);
    EXPECT_NEAR(loop.work, loop.work_of_directions, 1e-6 * loop.turnover);
    const LoopWork elastic = closedLoop(SixDirections(framed(referenceLaws(measure))), 10000);
    EXPECT_LT(std::abs(elastic.work), 1e-6 * elastic.turnover);
  }
}

TEST(SixDirections, TangentEqualsCentralDifferences) {
  for (const RotationMeasure measure : kMeasures) {
    for (const bool coupled : {false, true}) {
      SixDirectionsLaws laws = framed(coupled ? coupledLaws(component::Coupling::cylindrical) : fullLaws(measure));
      laws.measure = measure;
      expectTangent(SixDirections(laws));
    }
  }
}

TEST(SixDirections, StepsAllocateNothing) {
  const SixDirections bush(framed(coupledLaws(component::Coupling::spherical)));
  auto state = bush.makeState();
  auto trial = bush.makeState();
  test::AllocationCounter counter;
  for (int i = 1; i < 50; ++i) {
    const Isometry3d pose = poseAt(1e-4 * i * Vector3d(1.0, -0.5, 0.2), 0.01 * i * Vector3d(0.3, 0.1, -1.0));
    bush.step(state, 1e-3 * (1 + i % 2), pose);
    bush.step(state, 1e-3, pose, component::Twist());
    bush.tangent(state, 1e-3, pose, trial);
    trial.copyFrom(state);
  }
  EXPECT_EQ(counter.count(), 0U);
}

TEST(SixDirections, ContinuesFromItsNumbers) {
  const SixDirections bush(framed(coupledLaws(component::Coupling::cylindrical)));
  auto state = bush.makeState();
  for (int i = 1; i < 20; ++i) {
    bush.step(state, 1e-3, poseAt(2e-4 * i * Vector3d(1.0, -0.5, 0.2), {0.01 * i, 0.0, -0.02 * i}));
  }
  auto other = bush.makeState();
  bush.restore(other, state.numbers());
  const Isometry3d next = poseAt({1e-3, 0.0, 0.0}, {0.1, 0.1, 0.0});
  EXPECT_EQ(bush.step(other, 1e-3, next).wrench.force, bush.step(state, 1e-3, next).wrench.force);
  std::vector<double> numbers = state.numbers();
  numbers.back() = std::nan("");
  EXPECT_THROW(bush.restore(other, numbers), std::invalid_argument);
  numbers.pop_back();
  EXPECT_THROW(bush.restore(other, numbers), std::invalid_argument);
}

TEST(SixDirections, SaysWhichDirectionIsRefused) {
  SixDirectionsLaws laws = referenceLaws(RotationMeasure::vector);
  laws.elements[component::kRy] = {spring(-1.0)};
  EXPECT_EQ(messageOf<std::invalid_argument>([&] { SixDirections bush(laws); }).rfind("ry: spring.stiffness", 0), 0U);
}

}  // namespace
}  // namespace rubber_suspension
