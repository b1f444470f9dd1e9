// Blocks of samples give the same bits as single samples, for any laws and any block length.
#include "element/typical_elements.h"
#include "kernel/laws_one_by_one.h"
#include "rubber_suspension/component/sample_stream.h"
#include "support/allocation_counter.h"
#include "support/on_any_processor.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

constexpr double kStep = 1e-3;                  // [s]
constexpr std::int64_t kNanoseconds = 1000000;  // [ns]

/// Returns a sine with noise and pauses. Noise makes friction reverse often.
std::vector<double> randomPath(std::mt19937& random, std::size_t samples) {
  std::normal_distribution<double> noise(0.0, 1.0);
  std::vector<double> path(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    const bool pause = i > 0 && noise(random) < -1.5;
    path[i] = pause ? path[i - 1] : 2e-3 * std::sin(0.02 * static_cast<double>(i)) + 2e-5 * noise(random);
  }
  return path;
}

void expectSameBits(const component::Component& component, const std::vector<double>& path) {
  component::ComponentState one_by_one = component.makeState();
  component::ComponentState at_once = component.makeState();
  std::vector<double> force(path.size());
  component.simulate(at_once, kStep, path.data(), path.size(), force.data());
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(force[i], component.step(one_by_one, kStep, path[i]).total) << "sample " << i;
  }
  EXPECT_EQ(at_once.memory(), one_by_one.memory());
  EXPECT_EQ(at_once.displacement(), one_by_one.displacement());
}

class Simulate : public OnAnyProcessor {};
INSTANTIATE_TEST_SUITE_P(With, Simulate, anyInstructions());

TEST_P(Simulate, HasTheBitsOfStepsForRandomLaws) {
  std::mt19937 random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const std::size_t samples = 1 + random() % 3000;
    expectSameBits(component::Component(LawsOneByOne(random, 2).entries()), randomPath(random, samples));
  }
}

TEST_P(Simulate, HasTheBitsOfStepsForAllLawsAtOnce) {
  std::mt19937 random(2);
  expectSameBits(component::Component(typicalElements()), randomPath(random, 600));
}

TEST_P(Simulate, AllocatesNothing) {
  std::mt19937 random(3);
  const component::Component component({maxwell(1e6, 1.0), friction(5e3, 1e-3, 0.0)});
  const std::vector<double> path = randomPath(random, 1000);
  std::vector<double> force(path.size());
  component::ComponentState state = component.makeState();
  const AllocationCounter counter;
  component.simulate(state, kStep, path.data(), path.size(), force.data());
  EXPECT_EQ(counter.count(), 0U);
}

/// Returns stamps with everything that a stream handles: even steps, other steps, gaps, repeated stamps, restarts.
std::vector<std::int64_t> randomStamps(std::mt19937& random, std::size_t samples) {
  const std::vector<std::int64_t> steps = {2 * kNanoseconds, 700 * kNanoseconds, 0, -kNanoseconds,
                                           -3000 * kNanoseconds};
  std::vector<std::int64_t> stamps(samples);
  for (std::size_t i = 1; i < samples; ++i) {
    const bool even = random() % 40 != 0;
    stamps[i] = stamps[i - 1] + (even ? kNanoseconds : steps[random() % steps.size()]);
  }
  return stamps;
}

/// Calls pushAll() until all samples are processed, skipping dropped samples.
std::vector<double> forcesOfAll(component::SampleStream& stream, const std::vector<std::int64_t>& stamps,
                                const std::vector<double>& path) {
  std::vector<double> force(path.size(), 0.0);
  for (std::size_t i = 0; i < path.size();) {
    i += stream.pushAll(stamps.data() + i, path.data() + i, path.size() - i, force.data() + i);
    if (i < path.size()) {
      force[i++] = 0.0;
    }
  }
  return force;
}

void expectSameStream(const component::Component& component, const std::vector<std::int64_t>& stamps,
                      const std::vector<double>& path) {
  component::SampleStream one_by_one(component);
  component::SampleStream at_once(component);
  const std::vector<double> force = forcesOfAll(at_once, stamps, path);
  for (std::size_t i = 0; i < path.size(); ++i) {
    ASSERT_EQ(force[i], one_by_one.push(stamps[i], path[i]).force.total) << "sample " << i;
  }
  EXPECT_EQ(at_once.state().memory(), one_by_one.state().memory());
  EXPECT_EQ(at_once.lastStamp(), one_by_one.lastStamp());
  EXPECT_EQ(at_once.counters().accepted, one_by_one.counters().accepted);
  EXPECT_EQ(at_once.counters().bridged, one_by_one.counters().bridged);
  EXPECT_EQ(at_once.counters().restarted, one_by_one.counters().restarted);
}

TEST(PushAll, DoesAsPushWouldWithAnyStamps) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const std::size_t samples = 1 + random() % 1000;
    expectSameStream(component::Component(LawsOneByOne(random, 2).entries()), randomStamps(random, samples),
                     randomPath(random, samples));
  }
}

TEST(PushAll, DropsWhatPushWouldDrop) {
  std::mt19937 random(5);
  const std::vector<double> other = {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                                     1e305};
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> path = randomPath(random, 300);
    for (int i = 0; i < 3; ++i) {
      path[random() % path.size()] = other[random() % other.size()];
    }
    expectSameStream(component::Component({spring(3e6), maxwell(1e6, 1.0)}), randomStamps(random, 300), path);
  }
}

TEST(PushAll, TakesARunThatIsLongerThanItsPortions) {
  std::mt19937 random(6);
  std::vector<std::int64_t> stamps(10000);
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    stamps[i] = static_cast<std::int64_t>(i) * kNanoseconds;
  }
  expectSameStream(component::Component({maxwell(1e6, 1.0), friction(5e3, 1e-3, 0.0)}), stamps,
                   randomPath(random, 10000));
}

}  // namespace
}  // namespace rubber_suspension::test
