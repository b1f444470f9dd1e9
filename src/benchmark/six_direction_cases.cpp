// Components of six directions against six components of one with the same elements, moved by the same coordinates.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/component/six_directions.h"

namespace rubber_suspension::benchmark {
namespace {

using component::kDirections;

// Five Maxwell elements and friction; of rotations 0.1 rad are what 2 mm are.
std::vector<element::ElementDescription> directionElements(bool bank, bool turns) {
  constexpr double kLength = 0.02;  // [m/rad]
  BareParameters parameters = bareParameters(5);
  if (turns) {
    parameters.spring *= kLength * kLength;
    for (double& stiffness : parameters.stiffness) {
      stiffness *= kLength * kLength;
    }
    parameters.maximum_force *= kLength;
    parameters.friction_displacement /= kLength;
  }
  std::vector<element::ElementDescription> elements = elementsOf(parameters);
  for (element::ElementDescription& element : elements) {
    element.type = bank && element.type == "friction" ? "iwan" : element.type;
  }
  return elements;
}

// Components of six directions, and six times as many of one, on one path.
class SixDirectionBench {
 public:
  SixDirectionBench(std::size_t samples, std::size_t bushes, component::Coupling coupling)
      : bushes_(bushes, component::SixDirections(lawsOf(coupling))),
        coordinates_(samples),
        poses_(samples),
        states_(bushes, bushes_[0].makeState()),
        expected_(samples),
        found_(samples) {
    const std::vector<double> displacement = benchmarkDisplacement(samples + 100 * kDirections);
    for (std::size_t i = 0; i < samples; ++i) {
      for (std::size_t k = 0; k < kDirections; ++k) {
        coordinates_[i][static_cast<Eigen::Index>(k)] = displacement[i + 70 * k] * (k < 3 ? 1.0 : 50.0);
      }
      poses_[i] = bushes_[0].pose(coordinates_[i]);
    }
    for (std::size_t k = 0; k < kDirections * bushes; ++k) {
      singles_.emplace_back(bushes_[0].laws().elements[k % kDirections]);
      single_states_.push_back(singles_.back().makeState());
    }
  }

  void stepSix() {
    for (std::size_t b = 0; b < bushes_.size(); ++b) {
      found_[0] = bushes_[b].initialise(states_[b], poses_[0]).direction;
    }
    for (std::size_t i = 1; i < poses_.size(); ++i) {
      for (std::size_t b = 0; b < bushes_.size(); ++b) {
        found_[i] = bushes_[b].step(states_[b], kStep, poses_[i]).direction;
      }
    }
  }

  void stepSingles() {
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      for (std::size_t k = 0; k < singles_.size(); ++k) {
        const double displacement = coordinates_[i][static_cast<Eigen::Index>(k % kDirections)];
        expected_[i][k % kDirections] = i == 0 ? singles_[k].initialise(single_states_[k], displacement)
                                               : singles_[k].step(single_states_[k], kStep, displacement);
      }
    }
  }

  // About each pose, from rest; of the translations, whose axes stay, what both sides have to agree on is added up.
  void tangentOfSix() {
    component::SixDirectionsState trial = states_[0];
    tangents_ = 0.0;
    for (const Eigen::Isometry3d& pose : poses_) {
      const component::SixTangent tangent = bushes_[0].tangent(states_[0], kStep, pose, trial);
      tangents_ += (tangent.stiffness + tangent.damping / kStep).topLeftCorner<3, 3>().trace();
    }
  }

  void tangentOfSingles() {
    std::vector<component::ComponentState> trial = single_states_;
    expected_tangents_ = 0.0;
    for (const component::SixNumbers& at : coordinates_) {
      for (std::size_t k = 0; k < kDirections; ++k) {
        const component::Tangent tangent =
            singles_[k].tangent(single_states_[k], kStep, at[static_cast<Eigen::Index>(k)], trial[k]);
        expected_tangents_ += k < 3 ? tangent.stiffness + tangent.damping / kStep : 0.0;
      }
    }
  }

  double errorOfTangents() const { return std::abs(tangents_ / expected_tangents_ - 1.0); }

  // Of the forces by direction, each of its own largest. Poses are rounded, and so are coordinates found in them.
  double error() {
    double worst = 0.0;
    for (std::size_t k = 0; k < kDirections; ++k) {
      std::vector<double> expected;
      std::vector<double> found;
      for (std::size_t i = 1; i < poses_.size(); ++i) {
        expected.push_back(expected_[i][k].total);
        found.push_back(found_[i][k].total);
      }
      worst = std::max(worst, relativeDifference(expected, found));
    }
    return worst;
  }

  // What a sliding friction of two directions at once takes from each is another force: that of a radius alone.
  double finite() {
    const auto state = static_cast<double>(std::isfinite(found_.back()[0].total));
    return 1.0 - state;
  }

  double count() const { return static_cast<double>(poses_.size() * bushes_.size()); }

 private:
  static component::SixDirectionsLaws lawsOf(component::Coupling coupling) {
    component::SixDirectionsLaws laws;
    laws.translation = laws.rotation = coupling;
    for (std::size_t k = 0; k < kDirections; ++k) {
      laws.elements[k] = directionElements(coupling != component::Coupling::rectangular, k >= 3);
    }
    return laws;
  }

  std::vector<component::SixDirections> bushes_;
  std::vector<component::Component> singles_;
  std::vector<component::SixNumbers> coordinates_;
  std::vector<Eigen::Isometry3d> poses_;
  std::vector<component::SixDirectionsState> states_;
  std::vector<component::ComponentState> single_states_;
  std::vector<std::array<element::ComponentForce, kDirections>> expected_;
  std::vector<std::array<element::ComponentForce, kDirections>> found_;
  double tangents_ = 0.0;
  double expected_tangents_ = 0.0;
};

Case sixCase(const std::string& name, std::size_t samples, std::size_t bushes, component::Coupling coupling,
             double most) {
  const auto bench = std::make_shared<SixDirectionBench>(samples, bushes, coupling);
  Case result;
  result.name = name;
  result.baseline = fmt::format("{} components of one direction", bushes * kDirections);
  result.unit = "step of six";
  result.count = result.baseline_count = bench->count();
  result.library = [bench] { bench->stepSix(); };
  result.bare = [bench] { bench->stepSingles(); };
  const bool same = coupling == component::Coupling::rectangular;
  result.error = [bench, same] { return same ? bench->error() : bench->finite(); };
  result.error_meaning = same ? "of the largest force of a direction" : "forces that are not finite";
  result.tolerance = same ? 1e-9 : 0.0;
  result.most = most;
  return result;
}

Case tangentCase(std::size_t samples) {
  const auto bench = std::make_shared<SixDirectionBench>(samples, 1, component::Coupling::rectangular);
  Case result;
  result.name = "`SixDirections::tangent`, rectangular";
  result.baseline = "`Component::tangent` of six";
  result.unit = "tangent";
  result.count = result.baseline_count = bench->count();
  result.library = [bench] { bench->tangentOfSix(); };
  result.bare = [bench] { bench->tangentOfSingles(); };
  result.error = [bench] { return bench->errorOfTangents(); };
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
      sixCase("`SixDirections::step`, rectangular", size.samples, 1, component::Coupling::rectangular, kMostOfPoses),
      sixCase(fmt::format("{} bushes at each tick, `SixDirections::step`", bushes), std::min(kMostTicks, size.samples),
              bushes, component::Coupling::rectangular, kMostOfPoses),
      sixCase("`SixDirections::step`, cylindrical, `iwan`", size.samples, 1, component::Coupling::cylindrical,
              kMostOfRadius),
      tangentCase(size.samples / 10)};
}

}  // namespace rubber_suspension::benchmark
