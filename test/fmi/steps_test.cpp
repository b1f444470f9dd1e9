// An FMU gives the same forces as the component to the last bit, whatever the importer does between steps.
#include "element/largest_number.h"
#include "element/typical_elements.h"
#include "fmi/importer.h"
#include "fmi/malloc_counter.h"
#include "rubber_suspension/gap/replay.h"
#include "support/kit.h"

namespace rubber_suspension::fmi::test {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Returns the sum of sines of 2 mm and 0.3 mm that never repeats, with rests.
double displacementAt(std::size_t sample) {
  const double time = 1e-3 * static_cast<double>(sample);
  return sample / 100 % 4 == 3 ? 1e-3 : 2e-3 * std::sin(20.0 * time) + 3e-4 * std::sin(311.0 * time);
}

log::Log makeLog(std::size_t samples) { return logOf("log", static_cast<int>(samples), 1000000, displacementAt); }

double stepOf(const log::Log& log, std::size_t i) { return static_cast<double>(log.stamp[i] - log.stamp[i - 1]) / 1e9; }

std::vector<double> drive(Importer& importer, const log::Log& log) {
  std::vector<double> force;
  importer.start(log.displacement[0], log.time(0));
  force.push_back(importer.value(reference::kForce));
  double time = log.time(0);
  for (std::size_t i = 1; i < log.size(); ++i) {
    EXPECT_EQ(importer.set(reference::kDisplacement, log.displacement[i]), kOk);
    EXPECT_EQ(importer.step(time, stepOf(log, i)), kOk);
    time += stepOf(log, i);
    force.push_back(importer.value(reference::kForce));
  }
  return force;
}

// Returns a component with relaxation, friction, play, compliance, softening, heating and a delayed sensor.
io::ComponentDescription everything() {
  return {"everything",
          {{"spring", {{"stiffness", {3e6}}}},
           {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0}}}},
           {"friction", {{"maximum_force", {5e3}}, {"displacement", {2.2e-3}}}},
           {"iwan_table", {{"yield_displacement", {2e-3, 1e-4, 5e-4}}, {"stiffness", {4e5, 2e6, 1e6}}}},
           {"free_play", {{"gap", {2e-4}}}},
           {"series_compliance", {{"stiffness", {3e7}}}},
           {"stress_softening", {{"reduction", {0.3}}}},
           {"self_heating", {{"energy_sensitivity", {1e-3}}, {"time_constant", {20.0}}}},
           {"time_delay", {{"delay", {3.3e-3}}}},
           {"inertia", {{"mass", {12.0}}}}}};
}

io::ComponentDescription stiffening() {
  return {"stiffening", {{"spring", {{"stiffness", {3e6}}}}, {"progressive_stiffness", {{"cubic", {1e11}}}}}};
}

io::ComponentDescription exampleOf(const std::string& name) {
  const auto components = io::loadComponentFile(TEST_DIR "/../config/example.yaml");
  return io::selectComponent(components, name);
}

class Steps : public testing::TestWithParam<Version> {};

TEST_P(Steps, ForcesAreThoseOfReplayForEveryModel) {
  const log::Log log = makeLog(1200);
  for (const io::ComponentDescription& description : io::loadComponentFile(TEST_DIR "/../config/example.yaml")) {
    const LoadedFmu fmu(description, GetParam());
    const auto importer = Importer::make(fmu, fmu.guid());
    ASSERT_TRUE(importer->valid());
    EXPECT_EQ(drive(*importer, log), gap::simulateLog(description.makeComponent(), log)) << description.name;
  }
}

TEST_P(Steps, ForcesAreThoseOfReplayForEveryLaw) {
  const log::Log log = makeLog(400);
  for (const element::ElementDescription& law : rubber_suspension::test::typicalElements()) {
    io::ComponentDescription description(
        "law", {{"spring", {{"stiffness", {3e6}}}}, {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0}}}}});
    description.add = {law};  // added to the component like an effect in a diagnosis
    const LoadedFmu fmu(description, GetParam());
    const auto importer = Importer::make(fmu, fmu.guid());
    ASSERT_TRUE(importer->valid());
    EXPECT_EQ(drive(*importer, log), gap::simulateLog(description.makeComponent(), log)) << law.type;
  }
}

TEST_P(Steps, StepsMayVaryAndPartsAddUp) {
  const io::ComponentDescription description = everything();
  log::Log log = makeLog(600);
  for (std::size_t i = 1; i < log.size(); ++i) {
    log.stamp[i] = log.stamp[i - 1] + 100000 + static_cast<std::int64_t>(i * i % 97) * 50000;
  }
  const LoadedFmu fmu(description, GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  EXPECT_EQ(drive(*importer, log), gap::simulateLog(description.makeComponent(), log));

  const component::Component component = description.makeComponent();
  component::ComponentState state = component.makeState();
  element::ComponentForce force = component.initialise(state, log.displacement[0]);
  for (std::size_t i = 1; i < log.size(); ++i) {
    force = component.step(state, stepOf(log, i), log.displacement[i]);
  }
  EXPECT_EQ(importer->value(reference::kElastic), force.elastic);
  EXPECT_EQ(importer->value(reference::kViscous), force.viscous);
  EXPECT_EQ(importer->value(reference::kFriction), force.friction);
}

// Returns a component that is stiffer in the cold.
io::ComponentDescription shifting() {
  io::ComponentDescription description("shifting", {{"spring", {{"stiffness", {3e6}}}},
                                                    {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0}}}}});
  description.temperature = {"wlf_shift",
                             {{"c1", {8.86}}, {"c2", {101.6}}, {"reference", {23.0}}, {"vertical", {1e-3}}}};
  return description;
}

TEST_P(Steps, FollowTheTemperatureAsReplayDoes) {
  const io::ComponentDescription description = shifting();
  log::Log log = makeLog(400);
  const LoadedFmu fmu(description, GetParam());
  const Reference temperature = fmu.reference("temperature");
  const auto importer = Importer::make(fmu, fmu.guid());
  EXPECT_EQ(drive(*importer, log), gap::simulateLog(description.makeComponent(), log)) << "none was set";
  ASSERT_EQ(importer->reset(), kOk);
  for (std::size_t i = 0; i < log.size(); ++i) {
    log.temperature.push_back(-20.0 + 0.1 * static_cast<double>(i / 7));
  }
  const std::vector<double> expected = gap::simulateLog(description.makeComponent(), log);
  ASSERT_EQ(importer->set(temperature, log.temperature[0]), kOk);
  importer->start(log.displacement[0], log.time(0));
  EXPECT_EQ(importer->value(reference::kForce), expected[0]);
  double time = log.time(0);
  void* state = nullptr;
  for (std::size_t i = 1; i < log.size(); ++i) {
    ASSERT_EQ(importer->save(&state), kOk);
    ASSERT_EQ(importer->set(temperature, 60.0), kOk);  // a trial step at another temperature, which is undone
    ASSERT_EQ(importer->step(time, stepOf(log, i)), kOk);
    ASSERT_EQ(importer->restore(state), kOk);
    ASSERT_EQ(importer->value(temperature), log.temperature[i - 1]);
    ASSERT_EQ(importer->set(temperature, log.temperature[i]), kOk);
    ASSERT_EQ(importer->set(reference::kDisplacement, log.displacement[i]), kOk);
    ASSERT_EQ(importer->step(time, stepOf(log, i)), kOk);
    ASSERT_EQ(importer->value(reference::kForce), expected[i]) << i;
    time += stepOf(log, i);
  }
  for (const double bad : {-300.0, -100.0, kNaN}) {  // below absolute zero, below the range of WLF, NaN
    EXPECT_EQ(importer->set(temperature, bad), kDiscard) << bad;
  }
  EXPECT_EQ(importer->value(temperature), log.temperature.back());
  importer->free(&state);
}

TEST_P(Steps, AComponentWithoutShiftHasNoTemperature) {
  const LoadedFmu fmu(everything(), GetParam());
  EXPECT_EQ(fmu.references().count("temperature"), 0U);
}

TEST_P(Steps, ResetIsANewInstance) {
  const io::ComponentDescription description = everything();
  const log::Log log = makeLog(300);
  const LoadedFmu fmu(description, GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  const std::vector<double> first = drive(*importer, log);
  ASSERT_EQ(importer->reset(), kOk);
  EXPECT_EQ(drive(*importer, log), first);
}

TEST_P(Steps, StepAllocatesNothing) {
  const LoadedFmu fmu(everything(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  importer->start(0.0);
  void* state = nullptr;
  ASSERT_EQ(importer->save(&state), kOk);
  std::size_t wrong = 0;
  double time = 0.0;
  double force = 0.0;
  const Reference out = reference::kForce;
  const std::size_t before = mallocCalls();
  for (std::size_t i = 1; i < 1000; ++i, time += 1e-3) {
    wrong += importer->save(&state) != kOk ? 1 : 0;
    wrong += importer->set(reference::kDisplacement, displacementAt(i)) != kOk ? 1 : 0;
    wrong += importer->step(time, 1e-3) != kOk ? 1 : 0;
    wrong += importer->restore(state) != kOk ? 1 : 0;  // undoes a trial step
    wrong += importer->set(reference::kDisplacement, displacementAt(i)) != kOk ? 1 : 0;
    wrong += importer->step(time, 1e-3) != kOk ? 1 : 0;
    wrong += importer->get(&out, 1, &force) != kOk ? 1 : 0;
  }
  const std::size_t calls = mallocCalls() - before;
  EXPECT_EQ(wrong, 0U);
  EXPECT_EQ(calls, 0U);
  EXPECT_NE(force, 0.0);
  importer->free(&state);
}

TEST_P(Steps, TheCounterCountsInsideTheBinary) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__) && !defined(__clang__)
  const LoadedFmu fmu(everything(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  importer->start(0.0);
  const std::size_t before = mallocCalls();
  void* state = nullptr;
  ASSERT_EQ(importer->save(&state), kOk);
  EXPECT_GT(mallocCalls(), before);
  importer->free(&state);
#endif
}

TEST_P(Steps, InstancesShareNothing) {
  const io::ComponentDescription one = everything();
  const io::ComponentDescription other = exampleOf("left_secondary");
  const log::Log log = makeLog(300);
  const LoadedFmu fmu_of_one(one, GetParam());
  const LoadedFmu fmu_of_other(other, GetParam());
  const std::vector<double> expected_of_one = gap::simulateLog(one.makeComponent(), log);
  const std::vector<double> expected_of_other = gap::simulateLog(other.makeComponent(), log);
  std::vector<std::vector<double>> forces(4);
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < forces.size(); ++i) {
    threads.emplace_back([&, i] {
      const LoadedFmu& fmu = i % 2 == 0 ? fmu_of_one : fmu_of_other;
      forces[i] = drive(*Importer::make(fmu, fmu.guid()), log);
    });
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (std::size_t i = 0; i < forces.size(); ++i) {
    EXPECT_EQ(forces[i], i % 2 == 0 ? expected_of_one : expected_of_other) << i;
  }
}

TEST_P(Steps, WhatIsRefusedChangesNothing) {
  const io::ComponentDescription description = everything();
  const log::Log log = makeLog(200);
  const std::vector<double> expected = gap::simulateLog(description.makeComponent(), log);
  const LoadedFmu fmu(description, GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  importer->start(log.displacement[0]);
  double time = 0.0;
  for (std::size_t i = 1; i < log.size(); ++i) {
    for (const double value : {kNaN, kInfinity, -kInfinity}) {
      EXPECT_EQ(importer->set(reference::kDisplacement, value), kDiscard);
      EXPECT_EQ(importer->step(time, value), kError);
      EXPECT_EQ(importer->step(value, 1e-3), kError);
    }
    for (const double size : {0.0, -0.0, -1e-3}) {
      EXPECT_EQ(importer->step(time, size), kError);
    }
    EXPECT_EQ(importer->step(time + 1e-3, 1e-3), kError);
    EXPECT_EQ(importer->step(time - 1e-3, 1e-3), kError);
    EXPECT_EQ(importer->set(reference::kForce, 1.0), kError);
    EXPECT_EQ(importer->set(reference::kTime, 1.0), kError);
    EXPECT_EQ(importer->set(100000, 1.0), kError);
    EXPECT_EQ(importer->set(fmu.reference("elements[1].spring.stiffness"), 1e6), kError);  // too late to set one
    double value = 0.0;
    const Reference unknown = 100000;
    EXPECT_EQ(importer->get(&unknown, 1, &value), kError);
    EXPECT_EQ(importer->set(nullptr, 1, nullptr), kError);
    EXPECT_EQ(importer->get(nullptr, 1, nullptr), kError);
    EXPECT_EQ(importer->set(nullptr, 0, nullptr), kOk);
    EXPECT_EQ(importer->get(nullptr, 0, nullptr), kOk);

    ASSERT_EQ(importer->set(reference::kDisplacement, log.displacement[i]), kOk);
    ASSERT_EQ(importer->step(time, stepOf(log, i)), kOk);
    ASSERT_EQ(importer->value(reference::kForce), expected[i]) << i;
    time += stepOf(log, i);
    ASSERT_EQ(importer->value(reference::kTime), time);
  }
}

TEST_P(Steps, AListIsSetAsAWholeOrNotAtAll) {
  const LoadedFmu fmu(everything(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  importer->start(1e-3);
  const std::vector<Reference> references = {reference::kDisplacement, reference::kForce};
  const std::vector<double> values = {2e-3, 1.0};
  EXPECT_EQ(importer->set(references.data(), 2, values.data()), kError);
  EXPECT_EQ(importer->value(reference::kDisplacement), 1e-3);
}

TEST_P(Steps, AForceThatIsNotFiniteTakesASavedStateToGoOn) {
  std::vector<element::ElementDescription> elements = stiffening().allElements();
  // The force of this element overflows at the largest displacement that is accepted.
  elements.push_back(
      {"bump_stop", {{"gap", {1.0}}, {"stiffness", {1e30}}, {"exponent", {3.0}}, {"reference_depth", {1e-99}}}});
  const io::ComponentDescription description("stiffening", elements);
  const LoadedFmu fmu(description, GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  importer->start(1e-3);
  void* state = nullptr;
  ASSERT_EQ(importer->save(&state), kOk);
  ASSERT_EQ(importer->set(reference::kDisplacement, element::kLargestNumber), kOk);
  EXPECT_EQ(importer->step(0.0, 1e-3), kError);
  EXPECT_EQ(importer->step(1e-3, 1e-3), kError);
  double no_force = 0.0;
  EXPECT_EQ(importer->get(&reference::kForce, 1, &no_force), kError);
  EXPECT_EQ(importer->set(reference::kDisplacement, 1e-3), kError);
  void* spoilt = nullptr;
  EXPECT_EQ(importer->save(&spoilt), kError);
  EXPECT_EQ(spoilt, nullptr);
  ASSERT_EQ(importer->restore(state), kOk);
  ASSERT_EQ(importer->set(reference::kDisplacement, 2e-3), kOk);
  ASSERT_EQ(importer->step(0.0, 1e-3), kOk);
  EXPECT_DOUBLE_EQ(importer->value(reference::kForce), 3e6 * 2e-3 + 1e11 * 8e-9);
  importer->free(&state);
}

INSTANTIATE_TEST_SUITE_P(BothVersions, Steps, testing::Values(Version::fmi2, Version::fmi3),
                         [](const auto& version) { return version.param == Version::fmi2 ? "fmi2" : "fmi3"; });

}  // namespace
}  // namespace rubber_suspension::fmi::test
