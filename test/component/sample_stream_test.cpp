// The rules for time: which samples are accepted, and that dropped samples do not change the state.
#include "rubber_suspension/component/sample_stream.h"

#include "support/allocation_counter.h"
#include "support/kit.h"

namespace rubber_suspension::test {
namespace {

constexpr std::int64_t kMs = 1000000;  // [ns]

class Stream : public testing::Test {
 protected:
  component::Component component_{{spring(3e6), maxwell(1e6, 1.5), friction(5e3, 1e-3)}};
  component::SampleStream stream_{component_};

  double force(std::int64_t stamp, double displacement) {
    const component::StreamForce result = stream_.push(stamp, displacement);
    EXPECT_TRUE(component::isAccepted(result.acceptance));
    return result.force.total;
  }

  void expectDropped(std::int64_t stamp, double displacement, component::Acceptance acceptance) {
    const std::vector<double> memory = stream_.state().memory();
    const std::int64_t last = stream_.lastStamp();
    const component::StreamForce result = stream_.push(stamp, displacement);
    EXPECT_EQ(result.acceptance, acceptance);
    EXPECT_FALSE(component::isAccepted(result.acceptance));
    EXPECT_EQ(result.force.total, 0.0);
    EXPECT_EQ(stream_.state().memory(), memory);
    EXPECT_EQ(stream_.lastStamp(), last);
  }
};

TEST_F(Stream, FirstSampleFindsTheComponentAtRest) {
  EXPECT_FALSE(stream_.started());
  EXPECT_DOUBLE_EQ(force(12345 * kMs, 2e-3), 6e3) << "the spring alone: all else has relaxed";
  EXPECT_TRUE(stream_.started());
  EXPECT_EQ(stream_.lastStamp(), 12345 * kMs);
}

TEST_F(Stream, StepsAsTheComponentDoes) {
  component::ComponentState state = component_.makeState();
  component_.initialise(state, 1e-3);
  stream_.push(0, 1e-3);
  for (int i = 1; i < 50; ++i) {
    const double z = 1e-3 * std::cos(0.3 * i);
    EXPECT_EQ(force(i * 7 * kMs, z), component_.step(state, 0.007, z).total) << i;
  }
  EXPECT_EQ(stream_.counters().accepted, 50U);
  EXPECT_EQ(stream_.counters().dropped(), 0U);
}

TEST_F(Stream, DropsWhatIsNotFinite) {
  expectDropped(0, NAN, component::Acceptance::not_finite);
  EXPECT_FALSE(stream_.started()) << "not a start either";
  stream_.push(0, 1e-3);
  expectDropped(kMs, NAN, component::Acceptance::not_finite);
  expectDropped(kMs, INFINITY, component::Acceptance::not_finite);
  expectDropped(kMs, -INFINITY, component::Acceptance::not_finite);
  EXPECT_EQ(stream_.counters().not_finite, 4U);
  EXPECT_EQ(stream_.counters().dropped(), 4U);
  EXPECT_EQ(stream_.counters().accepted, 1U);
}

TEST_F(Stream, DropsRepeatedStampsAndStepsBackUpToASecond) {
  const std::int64_t second = component::SampleStream::kNanosecondsPerSecond;
  stream_.push(10 * second, 1e-3);
  expectDropped(10 * second, 1e-3, component::Acceptance::repeated);
  expectDropped(10 * second, 2e-3, component::Acceptance::repeated);
  expectDropped(10 * second - 1, 1e-3, component::Acceptance::stepped_back);
  expectDropped(9 * second, 1e-3, component::Acceptance::stepped_back);
  EXPECT_EQ(stream_.counters().repeated, 2U);
  EXPECT_EQ(stream_.counters().stepped_back, 2U);
  EXPECT_EQ(stream_.counters().restarted, 0U);
}

TEST_F(Stream, RestartsAfterALongerJumpBack) {
  const std::int64_t second = component::SampleStream::kNanosecondsPerSecond;
  const double first = force(10 * second, 1e-3);
  stream_.push(10 * second + kMs, 3e-3);
  const component::StreamForce result = stream_.push(9 * second - 1, 1e-3);
  EXPECT_EQ(result.acceptance, component::Acceptance::restarted);
  EXPECT_EQ(result.force.total, first) << "as new";
  EXPECT_EQ(stream_.counters().restarted, 1U);
  EXPECT_EQ(stream_.counters().accepted, 3U);
  EXPECT_EQ(stream_.counters().dropped(), 0U);
}

TEST_F(Stream, DroppedSamplesLeaveNoTrace) {
  component::SampleStream clean(component_);
  for (int i = 0; i < 100; ++i) {
    const double z = 1e-3 * std::sin(0.2 * i);
    const component::StreamForce expected = clean.push(i * kMs, z);
    EXPECT_EQ(force(i * kMs, z), expected.force.total);
    stream_.push(i * kMs, 5e-3);
    stream_.push((i - 3) * kMs, 5e-3);
    stream_.push((i + 1) * kMs, NAN);
  }
  EXPECT_EQ(stream_.counters().dropped(), 300U);
}

// A gap is one long step with linear displacement. It equals the sum of the missing steps.
TEST_F(Stream, BridgesAGapExactly) {
  stream_.push(0, 0.0);
  const component::StreamForce bridged = stream_.push(501 * kMs, 1e-3);
  EXPECT_EQ(bridged.acceptance, component::Acceptance::bridged);
  EXPECT_EQ(stream_.counters().bridged, 1U);
  component::SampleStream complete(component_);
  complete.push(0, 0.0);
  double expected = 0.0;
  for (int i = 1; i <= 501; ++i) {
    expected = complete.push(i * kMs, 1e-3 * i / 501.0).force.total;
  }
  EXPECT_NEAR(bridged.force.total, expected, 1e-11 * expected);  // 501 times the rounding
  EXPECT_EQ(complete.counters().bridged, 0U);
}

TEST_F(Stream, GapLimitIsAsGiven) {
  component::SampleStream strict(component_, 0.01);
  strict.push(0, 0.0);
  EXPECT_EQ(strict.push(10 * kMs, 0.0).acceptance, component::Acceptance::accepted);
  EXPECT_EQ(strict.push(20 * kMs + 1, 0.0).acceptance, component::Acceptance::bridged);
  stream_.push(0, 0.0);
  EXPECT_EQ(stream_.push(500 * kMs, 0.0).acceptance, component::Acceptance::accepted) << "half a second by default";
  component::SampleStream patient(component_, 1e300);
  patient.push(0, 0.0);
  EXPECT_EQ(patient.push(1000000000LL * 1000 * kMs, 0.0).acceptance, component::Acceptance::accepted);
}

TEST_F(Stream, TimeIsExactToTheNanosecondFarFromZero) {
  const std::int64_t epoch = 1700000000 * component::SampleStream::kNanosecondsPerSecond;
  component::SampleStream late(component_);
  stream_.push(0, 0.0);
  late.push(epoch, 0.0);
  for (int i = 1; i < 20; ++i) {
    EXPECT_EQ(late.push(epoch + i * 1234567, 1e-4 * i).force.total, force(i * 1234567, 1e-4 * i));
  }
}

TEST_F(Stream, ExtremeStampsDoNotOverflow) {
  const std::int64_t least = std::numeric_limits<std::int64_t>::min();
  const std::int64_t greatest = std::numeric_limits<std::int64_t>::max();
  stream_.push(least, 0.0);
  EXPECT_TRUE(std::isfinite(stream_.push(greatest, 1e-3).force.total));
  EXPECT_EQ(stream_.push(least, 0.0).acceptance, component::Acceptance::restarted);
}

TEST_F(Stream, ResetIsAsNewAndKeepsTheCounters) {
  const double first = force(0, 1e-3);
  stream_.push(kMs, 3e-3);
  stream_.reset();
  EXPECT_FALSE(stream_.started());
  EXPECT_EQ(force(0, 1e-3), first) << "also with a stamp from before";
  EXPECT_EQ(stream_.counters().accepted, 3U);
  EXPECT_EQ(stream_.counters().restarted, 0U);
}

TEST_F(Stream, RestoredStreamContinuesBitByBit) {
  for (int i = 0; i < 30; ++i) {
    stream_.push(i * kMs, 1e-3 * std::sin(0.4 * i));
  }
  component::SampleStream other(component_);
  other.deserialise(stream_.lastStamp(), stream_.state().displacement(), stream_.state().memory());
  for (int i = 30; i < 60; ++i) {
    EXPECT_EQ(other.push(i * kMs, 1e-3 * std::sin(0.4 * i)).force.total, force(i * kMs, 1e-3 * std::sin(0.4 * i)));
  }
  EXPECT_THROW(other.deserialise(0, 0.0, {}), std::invalid_argument);
}

// Samples whose force overflows must not change the state of a stream, whatever the displacement.
void expectNoTraceOfOverflows(const component::Component& component, double too_far) {
  component::SampleStream stream(component);
  component::SampleStream untouched(component);
  std::mt19937 random(1);
  std::int64_t stamp = 0;
  for (int i = 0; i < 3000; ++i) {
    stamp += random() % 500 == 0 ? -2000 * kMs : static_cast<std::int64_t>(1 + random() % 3) * kMs;  // restarts
    if (random() % 50 == 0) {
      EXPECT_EQ(stream.push(stamp, too_far).acceptance, component::Acceptance::force_not_finite);
    }
    std::array<double, 1> force{};
    const double displacement = 1e-3 * std::sin(0.1 * i);
    if (random() % 50 == 0) {
      ASSERT_EQ(stream.pushAll(&stamp, &displacement, 1, force.data()), 1U);
      ASSERT_EQ(force[0], untouched.push(stamp, displacement).force.total) << i;
    } else {
      ASSERT_EQ(stream.push(stamp, displacement).force.total, untouched.push(stamp, displacement).force.total) << i;
    }
    ASSERT_EQ(stream.state().memory(), untouched.state().memory()) << i;
    ASSERT_EQ(stream.state().displacement(), untouched.state().displacement()) << i;
  }
  EXPECT_GT(stream.counters().restarted, 2U);
}

TEST_F(Stream, ForcesThatOverflowLeaveNoTrace) {
  constexpr double kNoDisplacement = 1e31;  // [m], refused before the step
  constexpr double kTooFar = 1e30;          // [m], a displacement at which the force overflows
  const Entries stop = {entry("bump_stop gap=1 stiffness=1e30 exponent=3 reference_depth=1e-99")};
  const Entries softening = {entry("stress_softening reduction=0.3")};
  expectNoTraceOfOverflows(component_, kNoDisplacement);
  expectNoTraceOfOverflows(component::Component(component_.elements() + stop), kTooFar);
  expectNoTraceOfOverflows(component::Component(component_.elements() + stop + softening), kTooFar);
}

// A delay would store the displacement, and the force would be infinite several samples later.
TEST_F(Stream, RefusesADisplacementBeyondAnyComponentWhenItComes) {
  const component::Component delayed(component_.elements() + Entries{entry("time_delay delay=5e-3")});
  component::SampleStream stream(delayed);
  for (int i = 0; i < 20; ++i) {
    EXPECT_TRUE(component::isAccepted(stream.push(2 * i * kMs, 1e-3).acceptance)) << i;
    EXPECT_EQ(stream.push((2 * i + 1) * kMs, 1e306).acceptance, component::Acceptance::force_not_finite);
  }
}

TEST_F(Stream, PushAllocatesNothing) {
  stream_.push(0, 0.0);
  const AllocationCounter counter;
  for (int i = 1; i < 100; ++i) {
    stream_.push(i * kMs, 1e-3);
    stream_.push(i * kMs, NAN);
  }
  stream_.push(-5000 * kMs, 0.0);
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace rubber_suspension::test
