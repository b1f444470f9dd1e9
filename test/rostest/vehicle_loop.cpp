// A vehicle on a generated track, stepped against the running node over the bundled topics: the forces of the library
// in one process to the last bit, and those of a run without delay but for what the delay explains.
#include <cstdlib>
#include <map>

#include "apps/topic_exchange.h"
#include "bench.h"

namespace rubber_suspension::vehicle {
namespace {

constexpr std::int64_t kStep = 500000;  // [ns]

Bushes loadedComponents(const std::vector<element::ElementDescription>& further = {}) {
  return loadBushes(Kind::struts, ros::NodeHandle("~").param<std::string>("config_file", ""), further);
}

class VehicleLoop : public testing::TestWithParam<int> {
 protected:
  // Three seconds of the track that scripts/generate_track draws from its spectrum.
  static Scene generated() {
    const std::string path = testing::TempDir() + "vehicle_loop_track.csv";
    const std::string command = TEST_DIR "/../scripts/generate_track --track --duration 3 --output " + path;
    EXPECT_EQ(std::system(command.c_str()), 0);
    Scene scene;
    scene.track = Track(log::readLog(path));
    scene.duration = scene.track.duration();
    scene.step = kStep;
    return scene;
  }

  static const Scene& scene() {
    static const Scene once = generated();
    return once;
  }

  static const History& overTopics(int delay) {
    static std::map<int, History> runs;
    if (runs.count(delay) == 0) {
      const Bushes struts = loadedComponents();
      StrutExchange exchange(struts, "/simulate/reset");
      runs[delay] = runExchange(scene(), exchange, delay);
    }
    return runs[delay];
  }
};

TEST_P(VehicleLoop, GivesTheForcesOfTheLibraryToTheLastBit) {
  const auto components = loadedComponents();
  LibraryExchange library(components);
  const History expected = runExchange(scene(), library, GetParam());
  const History& loop = overTopics(GetParam());
  ASSERT_EQ(loop.size(), expected.size());
  ASSERT_GT(loop.size(), 5000U);
  for (std::size_t n = 0; n < loop.size(); ++n) {
    ASSERT_EQ(loop.position[n], expected.position[n]) << "step " << n;
    for (std::size_t i = 0; i < components.size(); ++i) {
      ASSERT_EQ(loop.pose[n][i].matrix(), expected.pose[n][i].matrix()) << "step " << n;
      ASSERT_EQ(loop.wrench[n][i].force, expected.wrench[n][i].force) << "step " << n;
      ASSERT_EQ(loop.wrench[n][i].moment, expected.wrench[n][i].moment) << "step " << n;
    }
  }
}

// A force that is held over the step, from an answer `delay` steps old, is late by delay + 1/2 steps in the mean. The
// same lateness given to the components of a run that knows no loop leaves less than a fiftieth of the difference; that
// the forces are held, and not only late, is of the next order in the step.
TEST_P(VehicleLoop, DiffersFromARunWithoutDelayByWhatTheDelayExplains) {
  const double delay = loopDelay(1e-9 * kStep, GetParam());
  const Bushes components = loadedComponents();
  const History undelayed = runVariableStep(scene(), components, {});
  const History delayed = runVariableStep(scene(), loadedComponents({{"time_delay", {{"delay", {delay}}}}}), {});
  const PerBush<double> whole = displacementDifference(components, overTopics(GetParam()), undelayed);
  const PerBush<double> rest = displacementDifference(components, overTopics(GetParam()), delayed);
  for (std::size_t i = 0; i < components.size(); ++i) {
    const std::string& name = bushNames(Kind::struts)[i];
    EXPECT_LT(rest[i], 0.02 * whole[i]) << name << ": " << whole[i] << " of the displacement";
    RecordProperty(name + "_difference", std::to_string(whole[i]));
    RecordProperty(name + "_not_explained", std::to_string(rest[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(StepsOfDelay, VehicleLoop, testing::Values(0, 1));

}  // namespace
}  // namespace rubber_suspension::vehicle

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "vehicle_loop"); }
