// A vehicle on a generated track, stepped against the running node over the bundled topics: the forces of the library
// in one process to the last bit, and those of a run without delay but for what the delay explains.
#include <cstdlib>
#include <map>

#include "apps/topic_exchange.h"
#include "bench.h"
#include "vehicle/components.h"
#include "vehicle/simulation.h"

namespace rubber_suspension::vehicle {
namespace {

constexpr std::int64_t kStep = 500000;  // [ns]

std::vector<component::Component> loadedComponents(const std::vector<element::ElementDescription>& further = {}) {
  return loadStruts(ros::NodeHandle("~").param<std::string>("config_file", ""), further);
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
      TopicExchange exchange(ros::NodeHandle(), {strutNames().begin(), strutNames().end()}, "/simulate/reset");
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
    ASSERT_EQ(loop.force[n], expected.force[n]) << "step " << n;
    ASSERT_EQ(loop.compression[n], expected.compression[n]) << "step " << n;
  }
}

// A force that is held over the step, from an answer `delay` steps old, is late by delay + 1/2 steps in the mean. The
// same lateness given to the components of a run that knows no loop leaves less than a fiftieth of the difference; that
// the forces are held, and not only late, is of the next order in the step.
TEST_P(VehicleLoop, DiffersFromARunWithoutDelayByWhatTheDelayExplains) {
  const double delay = loopDelay(1e-9 * kStep, GetParam());
  const History undelayed = runVariableStep(scene(), loadedComponents(), {});
  const History delayed = runVariableStep(scene(), loadedComponents({{"time_delay", {{"delay", {delay}}}}}), {});
  const PerStrut whole = displacementDifference(overTopics(GetParam()), undelayed);
  const PerStrut rest = displacementDifference(overTopics(GetParam()), delayed);
  for (std::size_t i = 0; i < kStruts; ++i) {
    EXPECT_LT(rest[i], 0.02 * whole[i]) << strutNames()[i] << ": " << whole[i] << " of the displacement";
    RecordProperty(strutNames()[i] + "_difference", std::to_string(whole[i]));
    RecordProperty(strutNames()[i] + "_not_explained", std::to_string(rest[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(StepsOfDelay, VehicleLoop, testing::Values(0, 1));

}  // namespace
}  // namespace rubber_suspension::vehicle

int main(int argc, char** argv) { return rubber_suspension::runAsNode(argc, argv, "vehicle_loop"); }
