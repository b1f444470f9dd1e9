// Components of six directions, compared with six components of one direction with the same elements and coordinates.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "benchmark/cases.h"
#include "benchmark/example.h"
#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::benchmark {
namespace {

using component::kDirections;

// Components of six directions, and six times as many components of one direction, on the same path.
struct SixDirectionBench {
  using Forces = std::vector<std::array<element::ComponentForce, kDirections>>;

  std::vector<component::SixDirections> bushes;
  std::vector<component::Component> singles;
  std::vector<component::SixNumbers> coordinates;
  std::vector<Eigen::Isometry3d> poses;
  std::vector<component::SixDirectionsState> states;
  std::vector<component::ComponentState> single_states;
  Forces expected;
  Forces found;
  double tangents = 0.0;  // sum of the stiffnesses over the poses
  double expected_tangents = 0.0;

  SixDirectionBench(std::size_t samples, std::size_t count, component::Coupling coupling)
      : bushes(count, component::SixDirections(exampleBush(coupling))),
        coordinates(samples),
        poses(samples),
        states(count, bushes[0].makeState()),
        expected(samples),
        found(samples) {
    const std::vector<double> displacement = benchmarkDisplacement(samples + 100 * kDirections);
    for (std::size_t i = 0; i < samples; ++i) {
      for (std::size_t k = 0; k < kDirections; ++k) {
        coordinates[i][static_cast<Eigen::Index>(k)] = displacement[i + 70 * k] * (k < 3 ? 1.0 : 50.0);
      }
      poses[i] = bushes[0].pose(coordinates[i]);
    }
    for (std::size_t k = 0; k < kDirections * count; ++k) {
      singles.emplace_back(bushes[0].laws().elements[k % kDirections]);
      single_states.push_back(singles.back().makeState());
    }
  }

  void stepSix() {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (std::size_t b = 0; b < bushes.size(); ++b) {
        found[i] = i == 0 ? bushes[b].initialise(states[b], poses[i]).direction
                          : bushes[b].step(states[b], kStep, poses[i]).direction;
      }
    }
  }

  void stepSingles() {
    for (std::size_t i = 0; i < poses.size(); ++i) {
      for (std::size_t k = 0; k < singles.size(); ++k) {
        const double displacement = coordinates[i][static_cast<Eigen::Index>(k % kDirections)];
        expected[i][k % kDirections] = i == 0 ? singles[k].initialise(single_states[k], displacement)
                                              : singles[k].step(single_states[k], kStep, displacement);
      }
    }
  }

  // Computes tangents about each pose, from rest. Both sides sum translational stiffnesses, whose axes do not rotate.
  void tangentOfSix() {
    component::SixDirectionsState trial = states[0];
    tangents = 0.0;
    for (const Eigen::Isometry3d& pose : poses) {
      const component::SixTangent tangent = bushes[0].tangent(states[0], kStep, pose, trial);
      tangents += (tangent.stiffness + tangent.damping / kStep).topLeftCorner<3, 3>().trace();
    }
  }

  void tangentOfSingles() {
    std::vector<component::ComponentState> trial = single_states;
    expected_tangents = 0.0;
    for (const component::SixNumbers& at : coordinates) {
      for (std::size_t k = 0; k < kDirections; ++k) {
        const component::Tangent tangent =
            singles[k].tangent(single_states[k], kStep, at[static_cast<Eigen::Index>(k)], trial[k]);
        expected_tangents += k < 3 ? tangent.stiffness + tangent.damping / kStep : 0.0;
      }
    }
  }

  // Returns the largest error of a direction, relative to its largest force. The error is due to the rounding of poses.
  double error() const {
    double worst = 0.0;
    for (std::size_t k = 0; k < kDirections; ++k) {
      std::vector<double> right;
      std::vector<double> actual;
      for (std::size_t i = 0; i < found.size(); ++i) {
        right.push_back(expected[i][k].total);
        actual.push_back(found[i][k].total);
      }
      worst = std::max(worst, relativeDifference(right, actual));
    }
    return worst;
  }

  // Friction that couples two directions differs from friction of single ones, so the force must only be finite.
  double finite() const { return std::isfinite(found.back()[0].total) ? 0.0 : 1.0; }

  double count() const { return static_cast<double>(poses.size() * bushes.size()); }
};

Case stepCase(const std::string& name, std::size_t samples, std::size_t bushes, component::Coupling coupling,
              double most) {
  const auto bench = std::make_shared<SixDirectionBench>(samples, bushes, coupling);
  Case result = caseOf(bench, name, &SixDirectionBench::stepSix,
                       fmt::format("{} components of one direction", bushes * kDirections),
                       &SixDirectionBench::stepSingles, "step of six", bench->count());
  const bool same = coupling == component::Coupling::rectangular;
  result.error = [bench, same] { return same ? bench->error() : bench->finite(); };
  result.error_meaning = same ? "of the largest force of a direction" : "(number of forces that are not finite)";
  result.tolerance = same ? 1e-9 : 0.0;
  result.most = most;
  return result;
}

Case tangentCase(std::size_t samples) {
  const auto bench = std::make_shared<SixDirectionBench>(samples, 1, component::Coupling::rectangular);
  Case result = caseOf(bench, "`SixDirections::tangent`, rectangular", &SixDirectionBench::tangentOfSix,
                       "`Component::tangent` of six", &SixDirectionBench::tangentOfSingles, "tangent", bench->count());
  result.error = [bench] { return std::abs(bench->tangents / bench->expected_tangents - 1.0); };
  result.error_meaning = "of the stiffnesses along the axes";
  result.tolerance = 1e-6;
  return result;
}

}  // namespace

std::vector<Case> sixDirectionCases(const BenchmarkSize& size) {
  constexpr double kMostOfPoses = 1.5;
  constexpr double kMostOfRadius = 2.5;
  constexpr std::size_t kMostTicks = 100;
  const auto bushes = static_cast<std::size_t>(size.components);
  return {
      stepCase("`SixDirections::step`, rectangular", size.samples, 1, component::Coupling::rectangular, kMostOfPoses),
      stepCase(fmt::format("{} bushes at each tick, `SixDirections::step`", bushes), std::min(kMostTicks, size.samples),
               bushes, component::Coupling::rectangular, kMostOfPoses),
      stepCase("`SixDirections::step`, cylindrical, `iwan`", size.samples, 1, component::Coupling::cylindrical,
               kMostOfRadius),
      tangentCase(size.samples / 10)};
}

}  // namespace rubber_suspension::benchmark
