// The order of calls, parameters, saved states and the log of an FMU.
#include "fmi/importer.h"
#include "fmi/runtime/fmi.h"
#include "fmi/runtime/saved_state.h"
#include "support/test.h"

namespace rubber_suspension::fmi::test {
namespace {

io::ComponentDescription example() {
  const auto components = io::loadComponentFile(TEST_DIR "/../config/example.yaml");
  return io::selectComponent(components, "left_secondary");
}

io::ComponentDescription bush() {
  return {"bush",
          {{"spring", {{"stiffness", {3e6}}}},
           {"maxwell", {{"stiffness", {1e6}}, {"break_frequency", {2.0}}}},
           {"spring_table", {{"displacement", {-4e-3, 0.0, 3e-3}}, {"force", {-2e4, 0.0, 1e4}}}}}};
}

// Returns the serialised state of an instance.
std::vector<char> savedBytes(Importer& importer) {
  void* state = nullptr;
  std::size_t size = 0;
  EXPECT_EQ(importer.save(&state), kOk);
  EXPECT_EQ(importer.serialisedSize(state, &size), kOk);
  std::vector<char> bytes(size);
  EXPECT_EQ(importer.serialise(state, bytes.data(), size - 1), kError) << "too few";
  EXPECT_EQ(importer.serialise(state, bytes.data(), size), kOk);
  EXPECT_EQ(importer.free(&state), kOk);
  return bytes;
}

// Makes `count` steps from a time on, and returns the forces.
std::vector<double> someSteps(Importer& importer, double& time, int count) {
  std::vector<double> forces;
  for (int i = 0; i < count; ++i, time += 1e-3) {
    EXPECT_EQ(importer.set(reference::kDisplacement, 1e-3 * std::sin(100.0 * time)), kOk);
    EXPECT_EQ(importer.step(time, 1e-3), kOk);
    forces.push_back(importer.value(reference::kForce));
  }
  return forces;
}

class Phases : public testing::TestWithParam<Version> {};

TEST_P(Phases, CallsInAWrongOrderAreErrorsAndDoNothing) {
  const LoadedFmu fmu(bush(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  double force = 0.0;
  const Reference out = reference::kForce;
  const auto step = [&] { return importer->step(0.0, 1e-3); };
  const auto get = [&] { return importer->get(&out, 1, &force); };
  const auto enter = [&] { return importer->enterInitialisation(0.0); };
  const auto leave = [&] { return importer->exitInitialisation(); };
  const auto end = [&] { return importer->terminate(); };
  const auto refused = [](const std::vector<std::function<int()>>& calls) {
    for (std::size_t i = 0; i < calls.size(); ++i) {
      EXPECT_EQ(calls[i](), kError) << "call " << i;
    }
  };
  refused({step, get, leave, end});
  ASSERT_EQ(enter(), kOk);
  refused({step, enter, end});
  ASSERT_EQ(leave(), kOk);
  refused({enter, leave});
  ASSERT_EQ(importer->set(reference::kDisplacement, 1e-3), kOk);
  ASSERT_EQ(step(), kOk);
  ASSERT_EQ(end(), kOk);
  refused({step, enter, leave, end});
  EXPECT_EQ(importer->set(reference::kDisplacement, 1e-3), kError);
  EXPECT_EQ(get(), kOk);
  const component::Component component = bush().makeComponent();
  component::ComponentState state = component.makeState();
  EXPECT_EQ(force, component.step(state, 1e-3, 1e-3).total);
  EXPECT_EQ(importer->messages.size(), 14U) << "each refusal is told once";
}

TEST_P(Phases, AnotherGuidGivesNoInstance) {
  const LoadedFmu fmu(bush(), GetParam());
  const LoadedFmu other(example(), GetParam());
  EXPECT_NE(fmu.guid(), other.guid());
  for (const std::string& guid : {other.guid(), std::string()}) {
    const auto importer = Importer::make(fmu, guid);
    EXPECT_FALSE(importer->valid());
    ASSERT_EQ(importer->messages.size(), 1U);
    EXPECT_EQ(importer->messages[0].status, kError);
    EXPECT_THAT(importer->messages[0].text, HasSubstr("GUID"));
  }
}

TEST_P(Phases, NoInstanceIsAnErrorForEveryFunction) {
  const LoadedFmu fmu(bush(), GetParam());
  const auto none = Importer::make(fmu, "");
  double value = 0.0;
  void* state = nullptr;
  std::size_t size = 0;
  const Reference in = reference::kDisplacement;
  EXPECT_EQ(none->enterInitialisation(0.0), kError);
  EXPECT_EQ(none->exitInitialisation(), kError);
  EXPECT_EQ(none->terminate(), kError);
  EXPECT_EQ(none->reset(), kError);
  EXPECT_EQ(none->set(in, 0.0), kError);
  EXPECT_EQ(none->get(&in, 1, &value), kError);
  EXPECT_EQ(none->step(0.0, 1e-3), kError);
  EXPECT_EQ(none->save(&state), kError);
  EXPECT_EQ(none->restore(nullptr), kError);
  EXPECT_EQ(none->serialisedSize(nullptr, &size), kError);
  EXPECT_EQ(none->setLogging(true, {}), kError);
}

TEST_P(Phases, StartTimesThatCannotBeAreErrors) {
  const LoadedFmu fmu(bush(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  EXPECT_EQ(importer->enterInitialisation(std::numeric_limits<double>::quiet_NaN()), kError);
  EXPECT_EQ(importer->enterInitialisation(std::numeric_limits<double>::infinity()), kError);
  importer->start(1e-3, 12.5);
  EXPECT_EQ(importer->value(reference::kTime), 12.5);
  EXPECT_EQ(importer->step(0.0, 1e-3), kError);
  EXPECT_EQ(importer->step(12.5, 1e-3), kOk);
}

// By FMI 2.0.4, 2.1.6 and FMI 3.0, 2.3.3, a step beyond a defined stop time is an error.
TEST_P(Phases, AStepEndsAtTheStopTimeAtTheLatest) {
  const LoadedFmu fmu(bush(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  EXPECT_EQ(importer->enterInitialisation(2.0, 1.0), kError);
  ASSERT_EQ(importer->enterInitialisation(0.0, 0.1), kOk);
  ASSERT_EQ(importer->exitInitialisation(), kOk);
  double time = 0.0;
  someSteps(*importer, time, 99);
  EXPECT_EQ(importer->step(time, 2e-3), kError);
  EXPECT_THAT(importer->messages.back().text, HasSubstr("stop time, 0.1 s"));
  const std::vector<char> bytes = savedBytes(*importer);
  someSteps(*importer, time, 1);  // the sum of a hundred steps of 1 ms is rounded, which must not count as beyond 0.1 s
  EXPECT_EQ(importer->step(time, 1e-6), kError);

  // The stop time is part of the saved state. A reset removes the stop time.
  const auto other = Importer::make(fmu, fmu.guid());
  void* read = nullptr;
  ASSERT_EQ(other->deserialise(bytes.data(), bytes.size(), &read), kOk);
  ASSERT_EQ(other->restore(read), kOk);
  EXPECT_EQ(other->step(99e-3, 2e-3), kError);
  EXPECT_EQ(other->step(99e-3, 1e-3), kOk);
  other->free(&read);
  ASSERT_EQ(importer->reset(), kOk);
  importer->start(0.0);
  EXPECT_EQ(importer->step(0.0, 10.0), kOk);
}

TEST_P(Phases, ParametersOfTheSpecificationAreEstimatedAnew) {
  const LoadedFmu fmu(example(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  const Reference stiffness = fmu.reference("specification.static_stiffness");
  const Reference friction = fmu.reference("add[1].friction.maximum_force");
  const Reference estimated = fmu.reference("elements[1].spring.stiffness");
  ASSERT_EQ(importer->set(stiffness, 3.2e6), kOk);
  ASSERT_EQ(importer->enterInitialisation(0.0), kOk);
  EXPECT_EQ(importer->value(estimated), 3.2e6);
  ASSERT_EQ(importer->set(friction, 4e3), kOk);  // parameters may be set during initialisation
  EXPECT_EQ(importer->set(estimated, 3e6), kError);
  ASSERT_EQ(importer->set(reference::kDisplacement, 1e-3), kOk);

  io::ComponentDescription changed = example();
  estimation::Specification specification = changed.specification();
  specification.set("static_stiffness", 3.2e6);
  changed.specify(specification);
  changed.add[0].values["maximum_force"] = {4e3};
  const component::Component component = changed.makeComponent();
  component::ComponentState state = component.makeState();
  EXPECT_EQ(importer->value(reference::kForce), component.initialise(state, 1e-3).total);
  ASSERT_EQ(importer->exitInitialisation(), kOk);
  double time = 0.0;
  std::vector<double> expected;
  for (int i = 0; i < 50; ++i, time += 1e-3) {
    expected.push_back(component.step(state, 1e-3, 1e-3 * std::sin(100.0 * time)).total);
  }
  time = 0.0;
  EXPECT_EQ(someSteps(*importer, time, 50), expected);
  ASSERT_EQ(importer->reset(), kOk);
  ASSERT_EQ(importer->enterInitialisation(0.0), kOk);
  EXPECT_EQ(importer->value(stiffness), 3e6) << "a reset brings the start values back";
}

TEST_P(Phases, ParametersThatCannotBeAreRefused) {
  const LoadedFmu fmu(example(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  const Reference stiffness = fmu.reference("specification.static_stiffness");
  for (const double value : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN(), 1e31, 1e308}) {
    EXPECT_EQ(importer->set(stiffness, value), kDiscard) << value;
  }
  EXPECT_THAT(importer->messages.back().text, HasSubstr("at most 1e+30"));
  for (const double value : {1e31, -1e308}) {
    EXPECT_EQ(importer->set(reference::kDisplacement, value), kDiscard) << value;
  }
  EXPECT_EQ(importer->set(stiffness, 0.0), kDiscard);
  EXPECT_THAT(importer->messages.back().text, HasSubstr("specification.static_stiffness"));
  EXPECT_EQ(importer->set(fmu.reference("specification.maxwell_elements"), 4.0), kDiscard);
  // The value is in its range, but with the dynamic stiffness of 4.2e6 there is no solution.
  ASSERT_EQ(importer->set(stiffness, 5e6), kOk);
  ASSERT_EQ(importer->enterInitialisation(0.0), kOk);
  double force = 0.0;
  const Reference out = reference::kForce;
  EXPECT_EQ(importer->get(&out, 1, &force), kError);
  EXPECT_EQ(importer->exitInitialisation(), kError);
  EXPECT_THAT(importer->messages.back().text, HasSubstr("dynamic_stiffness"));
  ASSERT_EQ(importer->set(stiffness, 3e6), kOk);
  EXPECT_EQ(importer->exitInitialisation(), kOk);
}

TEST_P(Phases, ListsAreParametersNumberByNumber) {
  const LoadedFmu fmu(bush(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  ASSERT_EQ(importer->set(fmu.reference("elements[3].spring_table.force[3]"), 4e4), kOk);
  importer->start(3e-3);
  EXPECT_DOUBLE_EQ(importer->value(reference::kForce), 3e6 * 3e-3 + 4e4);
}

TEST_P(Phases, ASavedStateTakesStepsBack) {
  const LoadedFmu fmu(example(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  importer->start(0.0);
  double time = 0.0;
  someSteps(*importer, time, 30);
  void* state = nullptr;
  ASSERT_EQ(importer->save(&state), kOk);
  const double at = time;
  const std::vector<double> first = someSteps(*importer, time, 30);
  for (int i = 0; i < 3; ++i) {
    ASSERT_EQ(importer->restore(state), kOk);
    time = at;
    EXPECT_EQ(importer->value(reference::kTime), at);
    EXPECT_EQ(someSteps(*importer, time, 30), first);
  }
  ASSERT_EQ(importer->free(&state), kOk);
  EXPECT_EQ(state, nullptr);
  EXPECT_EQ(importer->free(&state), kOk);
  EXPECT_EQ(importer->restore(state), kError);
}

TEST_P(Phases, StatesBeforeTheFirstStepAreSavedToo) {
  const LoadedFmu fmu(example(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  const Reference friction = fmu.reference("add[1].friction.maximum_force");
  void* instantiated = nullptr;
  void* initialising = nullptr;
  ASSERT_EQ(importer->save(&instantiated), kOk);
  ASSERT_EQ(importer->set(friction, 3e3), kOk);
  ASSERT_EQ(importer->enterInitialisation(2.0), kOk);
  ASSERT_EQ(importer->save(&initialising), kOk);
  ASSERT_EQ(importer->exitInitialisation(), kOk);
  ASSERT_EQ(importer->restore(initialising), kOk);
  EXPECT_EQ(importer->value(friction), 3e3);
  EXPECT_EQ(importer->exitInitialisation(), kOk);
  ASSERT_EQ(importer->restore(instantiated), kOk);
  ASSERT_EQ(importer->enterInitialisation(0.0), kOk);
  EXPECT_EQ(importer->value(friction), 6e3);
  importer->free(&instantiated);
  importer->free(&initialising);
}

TEST_P(Phases, ASerialisedStateGoesOnInAnotherInstance) {
  const LoadedFmu fmu(example(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  ASSERT_EQ(importer->set(fmu.reference("add[1].friction.maximum_force"), 3e3), kOk);
  importer->start(0.0);
  double time = 0.0;
  someSteps(*importer, time, 40);
  const std::vector<char> bytes = savedBytes(*importer);
  const auto other = Importer::make(fmu, fmu.guid());
  void* read = nullptr;
  ASSERT_EQ(other->deserialise(bytes.data(), bytes.size(), &read), kOk);
  ASSERT_EQ(other->restore(read), kOk);
  double time_of_other = time;
  EXPECT_EQ(someSteps(*other, time_of_other, 40), someSteps(*importer, time, 40));
  other->free(&read);
}

TEST_P(Phases, BytesThatAreNoStateAreRefused) {
  const LoadedFmu fmu(example(), GetParam());
  const LoadedFmu fmu_of_other(bush(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  const auto other = Importer::make(fmu_of_other, fmu_of_other.guid());
  importer->start(0.0);
  std::vector<char> bytes = savedBytes(*importer);
  const std::size_t size = bytes.size();
  void* read = nullptr;
  ASSERT_EQ(other->deserialise(bytes.data(), size, &read), kOk);
  EXPECT_EQ(other->restore(read), kError) << "of another FMU";
  other->free(&read);
  for (std::size_t cut = 0; cut < size; ++cut) {
    EXPECT_EQ(importer->deserialise(bytes.data(), cut, &read), kError) << cut;
  }
  bytes.push_back(0);
  EXPECT_EQ(importer->deserialise(bytes.data(), bytes.size(), &read), kError);
  bytes.pop_back();
  for (std::size_t i = 0; i < size; ++i) {
    bytes[i] = static_cast<char>(bytes[i] ^ 0xff);
    EXPECT_EQ(importer->deserialise(bytes.data(), size, &read), kError) << "byte " << i;
    EXPECT_EQ(read, nullptr);
    bytes[i] = static_cast<char>(bytes[i] ^ 0xff);
  }
  EXPECT_EQ(importer->deserialise(nullptr, size, &read), kError);
  EXPECT_EQ(importer->deserialise(bytes.data(), size, nullptr), kError);
}

// A changed state may have a valid checksum, so indices into the lists of elements are checked as well.
TEST_P(Phases, AStateWithAPlaceBeyondAListIsRefused) {
  const LoadedFmu fmu({"late", {{"spring", {{"stiffness", {3e6}}}}, {"time_delay", {{"delay", {0.01}}}}}}, GetParam());
  const auto importer = Importer::make(fmu, fmu.guid());
  importer->start(0.0);
  double time = 0.0;
  someSteps(*importer, time, 40);
  const std::vector<char> bytes = savedBytes(*importer);
  SavedState changed = deserialise(bytes.data(), bytes.size());
  changed.memory.at(1) = 2e9;
  const std::string written = serialise(changed);
  void* state = nullptr;
  ASSERT_EQ(importer->deserialise(written.data(), written.size(), &state), kOk);
  EXPECT_EQ(importer->restore(state), kError);
  importer->free(&state);
  someSteps(*importer, time, 40);
}

TEST_P(Phases, LoggingOfEventsIsSwitched) {
  const LoadedFmu fmu(bush(), GetParam());
  const auto importer = Importer::make(fmu, fmu.guid(), true);
  importer->start(0.0);
  ASSERT_EQ(importer->messages.size(), 2U);
  EXPECT_EQ(importer->messages[0].category, "logEvents");
  EXPECT_EQ(importer->messages[0].status, kOk);
  ASSERT_EQ(importer->setLogging(false, {}), kOk);
  ASSERT_EQ(importer->reset(), kOk);
  EXPECT_EQ(importer->messages.size(), 2U);
  ASSERT_EQ(importer->setLogging(true, {"logStatusError"}), kOk);
  importer->start(0.0);
  EXPECT_EQ(importer->messages.size(), 2U);
  EXPECT_EQ(importer->setLogging(true, {"logWeather"}), kError);
  EXPECT_EQ(importer->setLogging(true, {nullptr}), kError);
  ASSERT_EQ(importer->setLogging(true, {"logEvents"}), kOk);
  ASSERT_EQ(importer->reset(), kOk);
  EXPECT_EQ(importer->messages.back().category, "logEvents");
}

INSTANTIATE_TEST_SUITE_P(BothVersions, Phases, testing::Values(Version::fmi2, Version::fmi3),
                         [](const auto& version) { return version.param == Version::fmi2 ? "fmi2" : "fmi3"; });

TEST(Fmi2, DerivativesOfTheDisplacementCountForOneStep) {
  const LoadedFmu fmu(bush(), Version::fmi2);
  const fmi2CallbackFunctions callbacks{};  // without a logger
  const auto instance = fmu.function<decltype(fmi2Instantiate)>("fmi2Instantiate")(
      "test", fmi2CoSimulation, fmu.guid().c_str(), nullptr, &callbacks, 0, 1);
  ASSERT_NE(instance, nullptr);
  const auto set = fmu.function<decltype(fmi2SetReal)>("fmi2SetReal");
  const auto get = fmu.function<decltype(fmi2GetReal)>("fmi2GetReal");
  const auto derive = fmu.function<decltype(fmi2SetRealInputDerivatives)>("fmi2SetRealInputDerivatives");
  const auto step = fmu.function<decltype(fmi2DoStep)>("fmi2DoStep");
  fmu.function<decltype(fmi2EnterInitializationMode)>("fmi2EnterInitializationMode")(instance);
  fmu.function<decltype(fmi2ExitInitializationMode)>("fmi2ExitInitializationMode")(instance);
  const component::Component component = bush().makeComponent();
  component::ComponentState state = component.makeState();
  const Reference in = reference::kDisplacement;
  const Reference out = reference::kForce;
  const std::vector<Reference> both = {in, in};
  const std::vector<int> orders = {1, 2};
  const std::vector<double> derivatives = {0.25, 8.0};
  double force = 0.0;
  const double start = 1e-3;
  ASSERT_EQ(set(instance, &in, 1, &start), fmi2OK);
  ASSERT_EQ(derive(instance, both.data(), 2, orders.data(), derivatives.data()), fmi2OK);
  ASSERT_EQ(step(instance, 0.0, 0.5e-3, 1), fmi2OK);
  ASSERT_EQ(get(instance, &out, 1, &force), fmi2OK);
  // The expected displacement is z + z' h + z'' h^2/2. Another order of summation changes its rounding by 1e-16.
  const double reached = 1e-3 + 0.25 * 0.5e-3 + 0.5 * 8.0 * 0.25e-6;
  EXPECT_NEAR(force, component.step(state, 0.5e-3, reached).total, 1e-9);
  ASSERT_EQ(step(instance, 0.5e-3, 0.5e-3, 1), fmi2OK);
  ASSERT_EQ(get(instance, &out, 1, &force), fmi2OK);
  EXPECT_NEAR(force, component.step(state, 0.5e-3, 1e-3).total, 1e-9);
  const int order = 4;
  EXPECT_EQ(derive(instance, &in, 1, &order, derivatives.data()), fmi2Error);
  EXPECT_EQ(derive(instance, &out, 1, orders.data(), derivatives.data()), fmi2Error);
  EXPECT_EQ(derive(instance, nullptr, 1, nullptr, nullptr), fmi2Error);
  double time = 0.0;
  const auto real_status = fmu.function<decltype(fmi2GetRealStatus)>("fmi2GetRealStatus");
  EXPECT_EQ(real_status(instance, fmi2LastSuccessfulTime, &time), fmi2OK);
  EXPECT_EQ(time, 1e-3);
  EXPECT_EQ(real_status(instance, fmi2DoStepStatus, &time), fmi2Discard);
  EXPECT_EQ(fmu.function<decltype(fmi2CancelStep)>("fmi2CancelStep")(instance), fmi2Error);
  fmu.function<decltype(fmi2FreeInstance)>("fmi2FreeInstance")(instance);
}

TEST(Fmi2, TellsItsVersionAndIsNoModelExchange) {
  const LoadedFmu fmu(bush(), Version::fmi2);
  EXPECT_STREQ(fmu.function<decltype(fmi2GetVersion)>("fmi2GetVersion")(), "2.0");
  EXPECT_STREQ(fmu.function<decltype(fmi2GetTypesPlatform)>("fmi2GetTypesPlatform")(), "default");
  const auto instantiate = fmu.function<decltype(fmi2Instantiate)>("fmi2Instantiate");
  EXPECT_EQ(instantiate("test", fmi2ModelExchange, fmu.guid().c_str(), nullptr, nullptr, 0, 0), nullptr);
  EXPECT_EQ(instantiate("test", fmi2CoSimulation, nullptr, nullptr, nullptr, 0, 0), nullptr);
  fmu.function<decltype(fmi2FreeInstance)>("fmi2FreeInstance")(nullptr);
}

// Messages are format strings of printf, so a percent sign in a text from outside must be escaped.
TEST(Fmi2, MessagesAreNoFormats) {
  const LoadedFmu fmu(bush(), Version::fmi2);
  const auto importer = Importer::make(fmu, fmu.guid());
  EXPECT_EQ(importer->setLogging(true, {"100%s#"}), kError);
  EXPECT_THAT(importer->messages.back().text, HasSubstr("100%%s##"));
}

TEST(Fmi3, TellsItsVersionAndIsOfOneKind) {
  const LoadedFmu fmu(bush(), Version::fmi3);
  EXPECT_STREQ(fmu.function<decltype(fmi3GetVersion)>("fmi3GetVersion")(), "3.0");
  EXPECT_EQ(fmu.function<decltype(fmi3InstantiateModelExchange)>("fmi3InstantiateModelExchange")(
                "test", fmu.guid().c_str(), nullptr, false, false, nullptr, nullptr),
            nullptr);
  EXPECT_EQ(fmu.function<decltype(fmi3InstantiateScheduledExecution)>("fmi3InstantiateScheduledExecution")(
                "test", fmu.guid().c_str(), nullptr, false, false, nullptr, nullptr, nullptr, nullptr, nullptr),
            nullptr);
  EXPECT_EQ(fmu.function<decltype(fmi3InstantiateCoSimulation)>("fmi3InstantiateCoSimulation")(
                "test", fmu.guid().c_str(), nullptr, false, false, true, false, nullptr, 0, nullptr, nullptr, nullptr),
            nullptr)
      << "with event mode";
}

TEST(Fmi3, ValuesAreAsManyAsVariables) {
  const LoadedFmu fmu(bush(), Version::fmi3);
  const auto instance = fmu.function<decltype(fmi3InstantiateCoSimulation)>("fmi3InstantiateCoSimulation")(
      "test", fmu.guid().c_str(), nullptr, false, false, false, false, nullptr, 0, nullptr, nullptr, nullptr);
  ASSERT_NE(instance, nullptr);
  const Reference in = reference::kDisplacement;
  std::vector<double> values = {1e-3, 2e-3};
  EXPECT_EQ(fmu.function<decltype(fmi3SetFloat64)>("fmi3SetFloat64")(instance, &in, 1, values.data(), 2), fmi3Error);
  EXPECT_EQ(fmu.function<decltype(fmi3GetFloat64)>("fmi3GetFloat64")(instance, &in, 1, values.data(), 2), fmi3Error);
  float single = 0.0F;
  EXPECT_EQ(fmu.function<decltype(fmi3GetFloat32)>("fmi3GetFloat32")(instance, &in, 1, &single, 1), fmi3Error);
  EXPECT_EQ(fmu.function<decltype(fmi3EnterEventMode)>("fmi3EnterEventMode")(instance), fmi3Error);
  fmu.function<decltype(fmi3FreeInstance)>("fmi3FreeInstance")(instance);
}

}  // namespace
}  // namespace rubber_suspension::fmi::test
