// An FMU with six directions gives the same wrenches as the component for any poses, to the last bit.
#include "rubber_suspension/component/six_directions.h"

#include "fmi/description_check.h"
#include "fmi/importer.h"
#include "support/kit.h"

namespace rubber_suspension::fmi::test {
namespace {

const char* const kBush = R"(
components:
  bush:
    rotation: cardan
    coupling: {translation: cylindrical, axis: x}
    frame: {a: {position: [0.1, 0, 0], rotation: [0, 0, 0.2]}, b: {position: [0.1, 0, 0]}}
    directions:
      x:
        model: multi_maxwell
        specification:
          {static_stiffness: 1 kN/mm, dynamic_stiffness: 1.4 kN/mm, nominal_frequency: 4.0, maximum_stiffness: 1.7 kN/mm, high_frequency: 25.0}
        add: [{type: friction, maximum_force: 100 N, displacement: 0.2 mm}]
      y: {model: elements, elements: [{type: spring, stiffness: 3 kN/mm}, {type: maxwell, stiffness: 1 kN/mm, break_frequency: 3.0}]}
      rz: {model: elements, elements: [{type: spring, stiffness: 900 N m/rad}, {type: dashpot, damping: 4 N m s/rad}]}
)";

io::ComponentDescription sixDirectionsBush() { return componentOf(kBush); }

component::SixNumbers inputsAt(int sample) {
  component::SixNumbers inputs;
  for (Eigen::Index i = 0; i < 6; ++i) {
    inputs[i] = (i < 3 ? 2e-3 : 0.3) * std::sin(0.02 * sample * (1.0 + 0.3 * static_cast<double>(i)));
  }
  return inputs;
}

Eigen::Isometry3d poseOf(const component::SixNumbers& inputs) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = inputs.head<3>();
  pose.linear() = component::rotationOf(component::RotationMeasure::cardan, inputs.tail<3>()).toRotationMatrix();
  return pose;
}

class SixDirections : public testing::TestWithParam<Version> {
 protected:
  SixDirections() : fmu_(sixDirectionsBush(), GetParam()), importer_(Importer::make(fmu_, fmu_.guid())) {
    for (const char* name : {"x", "y", "z", "rx", "ry", "rz"}) {
      inputs_.push_back(fmu_.reference(name));
    }
    for (const char* name : {"Fx", "Fy", "Fz", "Mx", "My", "Mz"}) {
      outputs_.push_back(fmu_.reference(name));
    }
  }

  int set(const component::SixNumbers& inputs) { return importer_->set(inputs_.data(), 6, inputs.data()); }

  component::SixNumbers wrench() {
    component::SixNumbers wrench;
    EXPECT_EQ(importer_->get(outputs_.data(), 6, wrench.data()), kOk);
    return wrench;
  }

  void start(int sample) {
    ASSERT_EQ(importer_->enterInitialisation(0.0), kOk);
    ASSERT_EQ(set(inputsAt(sample)), kOk);
    ASSERT_EQ(importer_->exitInitialisation(), kOk);
  }

  // Returns the wrench of each sample after `first` up to `last`. The pose of `first` is already set.
  std::vector<component::SixNumbers> drive(int first, int last) {
    std::vector<component::SixNumbers> wrenches;
    for (int i = first + 1; i <= last; ++i) {
      EXPECT_EQ(set(inputsAt(i)), kOk);
      EXPECT_EQ(importer_->step(1e-3 * (i - 1), 1e-3), kOk);
      wrenches.push_back(wrench());
    }
    return wrenches;
  }

  LoadedFmu fmu_;
  std::unique_ptr<Importer> importer_;
  std::vector<Reference> inputs_;
  std::vector<Reference> outputs_;
};

TEST_P(SixDirections, WrenchesAreThoseOfTheComponent) {
  ASSERT_TRUE(importer_->valid());
  const component::SixDirections component = sixDirectionsBush().six->makeComponent();
  component::SixDirectionsState state = component.makeState();
  const auto expect = [](const component::SixNumbers& numbers, const component::Wrench& expected) {
    EXPECT_EQ(numbers.head<3>(), expected.force);
    EXPECT_EQ(numbers.tail<3>(), expected.moment);
  };
  start(3);
  expect(wrench(), component.initialise(state, poseOf(inputsAt(3))).wrench);
  double largest = 0.0;
  for (int i = 4; i < 600; ++i) {
    ASSERT_EQ(set(inputsAt(i)), kOk);
    ASSERT_EQ(importer_->step(1e-3 * (i - 4), 1e-3), kOk);
    const component::Wrench expected = component.step(state, 1e-3, poseOf(inputsAt(i))).wrench;
    expect(wrench(), expected);
    largest = std::max(largest, expected.force.norm());
  }
  EXPECT_GT(largest, 1e3);
}

TEST_P(SixDirections, TheDescriptionBreaksNoRule) {
  EXPECT_EQ(brokenRules(modelDescription(dataOf(sixDirectionsBush()), GetParam(), "test 1.0"), GetParam()),
            std::vector<std::string>());
}

TEST_P(SixDirections, ASavedStateGoesOnWithTheSameBits) {
  start(0);
  drive(0, 100);
  void* state = nullptr;
  ASSERT_EQ(importer_->save(&state), kOk);
  std::size_t size = 0;
  ASSERT_EQ(importer_->serialisedSize(state, &size), kOk);
  std::vector<char> bytes(size);
  ASSERT_EQ(importer_->serialise(state, bytes.data(), size), kOk);
  const auto first = drive(100, 200);
  ASSERT_EQ(importer_->restore(state), kOk);
  EXPECT_EQ(drive(100, 200), first);
  // The state is restored from its bytes in another instance.
  importer_->free(&state);
  importer_ = Importer::make(fmu_, fmu_.guid());
  ASSERT_EQ(importer_->deserialise(bytes.data(), size, &state), kOk);
  ASSERT_EQ(importer_->restore(state), kOk);
  EXPECT_EQ(drive(100, 200), first);
  importer_->free(&state);
}

TEST_P(SixDirections, ARotationBeyondTheMeasureIsAnErrorThatLeavesAllAsItWas) {
  start(0);
  drive(0, 50);
  component::SixNumbers of_bush = component::SixNumbers::Zero();
  of_bush[component::kRy] = 1.55;  // 88.8 deg; cardan angles of the bush are valid up to 85 deg
  const Eigen::Isometry3d pose = sixDirectionsBush().six->makeComponent().pose(of_bush);
  component::SixNumbers beyond;
  beyond << pose.translation(),
      component::coordinatesOf(component::RotationMeasure::cardan, Eigen::Quaterniond(pose.linear())).value;
  ASSERT_EQ(set(beyond), kOk);
  EXPECT_EQ(importer_->step(0.05, 1e-3), kError);
  EXPECT_EQ(drive(50, 60).size(), 10U);
}

TEST_P(SixDirections, ResetIsAsNew) {
  start(0);
  const auto first = drive(0, 100);
  ASSERT_EQ(importer_->reset(), kOk);
  start(0);
  EXPECT_EQ(drive(0, 100), first);
}

INSTANTIATE_TEST_SUITE_P(Versions, SixDirections, testing::Values(Version::fmi2, Version::fmi3));

}  // namespace
}  // namespace rubber_suspension::fmi::test
