// Bushes for tests of six directions, bodies on which they act, and their work over closed paths.
#pragma once

#include "rubber_suspension/component/six_directions.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension {

inline Eigen::Isometry3d poseAt(const Eigen::Vector3d& position, const Eigen::Vector3d& rotation) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position;
  pose.linear() = component::rotationOf(component::RotationMeasure::vector, rotation).toRotationMatrix();
  return pose;
}

// Returns springs, a curve with scaled branches, Maxwell elements and friction. `size` is 1 mm or some 0.1 rad.
inline std::vector<element::ElementDescription> fullElements(double stiffness, double size) {
  const double k = stiffness;
  std::vector<double> points;
  std::vector<double> forces;
  for (int i = -4; i <= 4; ++i) {
    points.push_back(i * size);
    forces.push_back(k * size * (i + 0.1 * i * std::abs(i)));
  }
  std::vector<double> steps;
  std::vector<double> branch;
  for (std::size_t i = 1; i < points.size(); ++i) {
    steps.insert(steps.end(), {points[i - 1], points[i]});
    branch.insert(branch.end(), 2, 0.3 * (forces[i] - forces[i - 1]) / (points[i] - points[i - 1]));
  }
  std::vector<double> damping = branch;
  std::for_each(damping.begin(), damping.end(), [](double& value) { value *= 2e-3; });
  return {spring(0.5 * k),
          {"maxwell", {{"stiffness", {0.4 * k}}, {"break_frequency", {3.0}}}},
          {"dashpot", {{"damping", {1e-3 * k}}}},
          {"spring_table", {{"displacement", points}, {"force", forces}, {"monotone", {0.0}}}},
          {"maxwell_along_curve", {{"displacement", steps}, {"stiffness", branch}, {"break_frequency", {8.0}}}},
          {"dashpot_along_curve", {{"displacement", steps}, {"damping", damping}}},
          {"bump_stop",
           {{"stiffness", {2.0 * k}}, {"gap", {2.5 * size}}, {"exponent", {1.5}}, {"reference_depth", {size}}}},
          {"iwan", {{"maximum_force", {0.2 * k * size}}, {"displacement", {0.3 * size}}}}};
}

inline component::SixDirectionsLaws fullLaws(component::RotationMeasure measure) {
  component::SixDirectionsLaws laws;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    const double share = 1.0 + 0.2 * static_cast<double>(i);
    laws.elements[i] = i < 3 ? fullElements(2e6 * share, 1e-3) : fullElements(800.0 * share, 0.2);
  }
  laws.measure = measure;
  return laws;
}

inline component::SixDirectionsLaws coupledLaws(component::Coupling coupling) {
  component::SixDirectionsLaws laws;
  for (std::size_t i = 0; i < component::kDirections; ++i) {
    laws.elements[i] = i < 3 ? fullElements(2e6, 1e-3) : fullElements(800.0, 0.2);
  }
  laws.translation = laws.rotation = coupling;
  return laws;
}

inline component::SixDirectionsLaws framed(component::SixDirectionsLaws laws) {
  laws.on_a = poseAt({0.1, -0.05, 0.02}, {0.3, -0.2, 0.5});
  laws.on_b = laws.on_a;  // at rest at the identity pose
  return laws;
}

// A body of 5 kg and 0.02 kg m^2. Only the given wrench changes its momentum.
struct Body {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
  Eigen::Vector3d angular_momentum = Eigen::Vector3d::Zero();  // about the centre of mass

  void push(const component::Wrench& wrench, double dt) {
    momentum += dt * wrench.force;
    angular_momentum += dt * wrench.moment;
    pose.translation() += dt / 5.0 * momentum;
    const Eigen::Vector3d turn = dt / 0.02 * angular_momentum;
    pose.linear() = poseAt(Eigen::Vector3d::Zero(), turn).linear() * pose.linear();
  }
  Eigen::Vector3d angularMomentumAboutOrigin() const { return pose.translation().cross(momentum) + angular_momentum; }
};

inline component::Wrench turned(const Eigen::Matrix3d& rotation, const component::Wrench& wrench) {
  return {rotation * wrench.force, rotation * wrench.moment};
}

// Returns the coordinates on a smooth closed path with rotations of up to 60 deg. The time is between 0 and 1.
inline component::SixNumbers loopAt(double time, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1.0, 1.0);
  component::SixNumbers numbers;
  for (Eigen::Index i = 0; i < 6; ++i) {
    numbers[i] = share(random) * (std::sin(2.0 * element::kPi * time)) +
                 share(random) * std::sin(4.0 * element::kPi * time) +
                 share(random) * (std::cos(6.0 * element::kPi * time) - 1.0);
  }
  numbers.head<3>() *= 1.5e-3;
  numbers.tail<3>() *= 0.2;
  return numbers;
}

struct LoopWork {
  double work = 0.0;                // work of the wrench on B relative to A [J]
  double work_of_directions = 0.0;  // work of the generalised forces on the coordinates [J]
  double turnover = 0.0;            // sum of the magnitudes of the work of all steps [J]
};

// Integrates the work over a closed path of 2 s with the trapezoidal rule.
inline LoopWork closedLoop(const component::SixDirections& bush, int steps, unsigned seed = 1) {
  component::SixDirectionsState state = bush.makeState();
  Eigen::Isometry3d last = bush.pose(loopAt(0.0, seed));
  component::BushForce before = bush.initialise(state, last);
  LoopWork sum;
  for (int i = 1; i <= steps; ++i) {
    const component::SixNumbers begin = loopAt((i - 1.0) / steps, seed);
    const component::SixNumbers end = loopAt(static_cast<double>(i) / steps, seed);
    const Eigen::Isometry3d pose = bush.pose(end);
    const component::BushForce force = bush.step(state, 2.0 / steps, pose);
    const Eigen::AngleAxisd turn(pose.linear() * last.linear().transpose());
    const Eigen::Vector3d way = pose.translation() - last.translation();
    const double work = 0.5 * (force.wrench.force + before.wrench.force).dot(way) +
                        0.5 * (force.wrench.moment + before.wrench.moment).dot(turn.angle() * turn.axis());
    sum.work += work;
    sum.turnover += std::abs(work);
    for (std::size_t k = 0; k < component::kDirections; ++k) {
      const auto at = static_cast<Eigen::Index>(k);
      sum.work_of_directions += 0.5 * (force.direction[k].total + before.direction[k].total) * (end[at] - begin[at]);
    }
    before = force;
    last = pose;
  }
  return sum;
}

// Compares the tangent with the derivative of the wrench with respect to the pose, from central differences.
inline void expectTangent(const component::SixDirections& bush) {
  component::SixDirectionsState state = bush.makeState();
  component::SixDirectionsState trial = bush.makeState();
  for (int i = 0; i < 50; ++i) {
    bush.step(state, 1e-3, bush.pose(loopAt(1e-3 * i)));
  }
  const Eigen::Isometry3d pose = bush.pose(loopAt(5e-2));
  const component::SixTangent tangent = bush.tangent(state, 1e-3, pose, trial);
  const Eigen::Matrix<double, 6, 6> expected = tangent.stiffness + tangent.damping / 1e-3;
  const auto wrenchAt = [&](Eigen::Index i, double by) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(i % 3);
    Eigen::Isometry3d moved = pose;
    if (i < 3) {
      moved.translation() += by * axis;
    } else {
      moved.linear() = poseAt(Eigen::Vector3d::Zero(), by * axis).linear() * pose.linear();
    }
    trial.copyFrom(state);
    const component::Wrench wrench = bush.step(trial, 1e-3, moved).wrench;
    component::SixNumbers numbers;
    numbers << wrench.force, wrench.moment;
    return numbers;
  };
  constexpr double kStep = 3e-8;
  for (Eigen::Index i = 0; i < 6; ++i) {
    const component::SixNumbers difference = (wrenchAt(i, kStep) - wrenchAt(i, -kStep)) / (2.0 * kStep);
    const auto block = i < 3 ? 0 : 3;
    for (const Eigen::Index first : {0, 3}) {
      const double scale = expected.block<3, 3>(first, block).norm();
      EXPECT_LT((difference.segment<3>(first) - expected.block<3, 1>(first, i)).norm(), 1e-6 * scale) << i << first;
    }
  }
}

}  // namespace rubber_suspension
