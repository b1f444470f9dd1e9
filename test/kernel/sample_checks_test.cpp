// Checking many samples at once finds a sample that violates the rule at any position.
#include "kernel/sample_checks.h"

#include "support/on_any_processor.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

constexpr std::size_t kMost = 40;  // several of the widest vectors
constexpr std::int64_t kLargest = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t kSmallest = std::numeric_limits<std::int64_t>::min();

class SampleChecks : public OnAnyProcessor {};
INSTANTIATE_TEST_SUITE_P(With, SampleChecks, anyInstructions());

std::vector<std::int64_t> evenStamps(std::size_t count, std::int64_t first, std::int64_t step) {
  std::vector<std::int64_t> stamps{first};
  while (stamps.size() < count) {
    stamps.push_back(stamps.back() + step);
  }
  return stamps;
}

TEST_P(SampleChecks, FindWhatIsNotFinite) {
  using Limits = std::numeric_limits<double>;
  for (std::size_t count = 0; count <= kMost; ++count) {
    std::vector<double> values(count, Limits::max());
    values.resize(count + 1, Limits::denorm_min());
    EXPECT_TRUE(kernel::allFinite(values.data(), count));
    for (std::size_t at = 0; at < count; ++at) {
      for (const double other : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN(), -Limits::quiet_NaN()}) {
        values[at] = other;
        EXPECT_FALSE(kernel::allFinite(values.data(), count)) << other << " at " << at << " of " << count;
      }
      values[at] = -Limits::max();
    }
  }
}

TEST_P(SampleChecks, FindWhatIsTooLarge) {
  using Limits = std::numeric_limits<double>;
  for (std::size_t count = 0; count <= kMost; ++count) {
    std::vector<double> values(count + 1, -std::nextafter(0x1p99, 0.0));
    EXPECT_TRUE(kernel::allBelowTwoTo(99, values.data(), count));
    for (std::size_t at = 0; at < count; ++at) {
      for (const double other : {0x1p99, -0x1p99, Limits::max(), -Limits::infinity(), Limits::quiet_NaN()}) {
        values[at] = other;
        EXPECT_FALSE(kernel::allBelowTwoTo(99, values.data(), count)) << other << " at " << at << " of " << count;
      }
      values[at] = 0.0;
    }
  }
}

TEST_P(SampleChecks, FindWhatDoesNotIncrease) {
  EXPECT_TRUE(kernel::allIncreasing(nullptr, 0));
  for (std::size_t count = 1; count <= kMost; ++count) {
    const std::vector<std::int64_t> stamps = evenStamps(count, -20, 1);
    EXPECT_TRUE(kernel::allIncreasing(stamps.data(), count));
    for (std::size_t at = 1; at < count; ++at) {
      std::vector<std::int64_t> wrong = stamps;
      wrong[at] = wrong[at - 1];
      EXPECT_FALSE(kernel::allIncreasing(wrong.data(), count)) << at << " of " << count;
    }
  }
  const std::vector<std::int64_t> far = {kSmallest, 0, kLargest};
  EXPECT_TRUE(kernel::allIncreasing(far.data(), 3));
  const std::vector<std::int64_t> back = {kLargest, kSmallest};
  EXPECT_FALSE(kernel::allIncreasing(back.data(), 2));
}

TEST_P(SampleChecks, FindStepsOfOtherLength) {
  for (std::size_t count = 1; count <= kMost; ++count) {
    std::vector<std::int64_t> stamps = evenStamps(count + 1, -3000, 1000);
    EXPECT_TRUE(kernel::allEven(stamps.data(), count, 1000));
    EXPECT_FALSE(kernel::allEven(stamps.data(), count, 999));
    for (std::int64_t& stamp : stamps) {
      stamp += 1;
      EXPECT_EQ(kernel::allEven(stamps.data(), count, 1000), &stamp == &stamps.back()) << &stamp - stamps.data();
    }
  }
}

TEST_P(SampleChecks, TakeNoStepsThatWrapAround) {
  const std::vector<std::int64_t> wrapping = {kLargest - 1, kSmallest, kSmallest + 2};
  EXPECT_FALSE(kernel::allEven(wrapping.data(), 2, 2));
  const std::vector<std::int64_t> still = {5, 5, 5};
  EXPECT_FALSE(kernel::allEven(still.data(), 2, 0));
}

}  // namespace
}  // namespace rubber_suspension::test
