// Evaluation of the runs of the benchmark: quantiles of round-trip times, medians of ratios, the table.
#include "benchmark/latency/latency_benchmark.h"

#include <unistd.h>

#include "benchmark/latency/benchmark_node.h"
#include "benchmark/timing.h"
#include "rubber_suspension/io/component_file.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

TEST(LatencyBenchmark, QuantilesOfRoundTrips) {
  benchmark::RoundTrips trips;
  EXPECT_EQ(trips.quantile(0.5), 0.0);
  for (int i = 0; i < 100; ++i) {
    trips.durations.push_back(i);
  }
  EXPECT_EQ(trips.quantile(0.5), 49.5);
  EXPECT_DOUBLE_EQ(trips.quantile(0.99), 98.01);
  EXPECT_EQ(trips.quantile(1.0), 99.0);
  trips.sent = 103;
  EXPECT_EQ(trips.lost(), 3U);
}

TEST(LatencyBenchmark, RatiosAreSummarisedByMedianAndQuartiles) {
  const io::Spread odd = benchmark::spreadOf({5.0, 1.0, 3.0, 2.0, 4.0});
  EXPECT_EQ(odd.median, 3.0);
  EXPECT_EQ(odd.lower, 2.0);
  EXPECT_EQ(odd.upper, 4.0);
  const io::Spread even = benchmark::spreadOf({2.0, 1.0});
  EXPECT_EQ(even.median, 1.5);
  const io::Spread one = benchmark::spreadOf({7.0});
  EXPECT_EQ(one.median, 7.0);
  EXPECT_EQ(one.lower, 7.0);
  EXPECT_EQ(one.upper, 7.0);
}

TEST(LatencyBenchmark, ComponentsAreAComponentFile) {
  const auto components = io::parseComponentFile(benchmark::benchmarkComponents(50), "benchmark");
  ASSERT_EQ(components.size(), 50U);
  const std::vector<std::string> names = benchmark::benchmarkNames(50);
  for (std::size_t i = 0; i < components.size(); ++i) {
    EXPECT_EQ(components[i].name, names[i]);
    components[i].makeComponent();
  }
}

TEST(LatencyBenchmark, EveryRowHasAsManyColumnsAsTheHead) {
  benchmark::LatencyRow row;
  row.components = 10;
  benchmark::SoakResult result;
  result.memory = {1024 * 1024, 3 * 1024 * 1024, 2 * 1024 * 1024};
  result.elapsed = 1.0;
  std::ostringstream latency;
  benchmark::printMarkdown({row, row}, latency);
  std::ostringstream soaked;
  benchmark::printMarkdown(result, soaked);
  EXPECT_NE(soaked.str().find("1.00, 2.00, 3.00"), std::string::npos) << soaked.str();
  for (const std::string& table : {latency.str(), soaked.str()}) {
    std::istringstream lines(table);
    std::string line;
    std::getline(lines, line);
    const auto columns = std::count(line.begin(), line.end(), '|');
    while (std::getline(lines, line)) {
      EXPECT_EQ(std::count(line.begin(), line.end(), '|'), columns) << line;
    }
  }
}

TEST(Soak, ExactIsOneForceEach) {
  benchmark::SoakResult result;
  result.sent = result.answered = 10;
  EXPECT_TRUE(result.exact());
  result.surplus = 1;
  EXPECT_FALSE(result.exact());
  result.surplus = 0;
  result.answered = 9;
  EXPECT_FALSE(result.exact());
}

TEST(Soak, SeesTheMemoryOfAProcess) {
  EXPECT_GT(benchmark::residentMemory(getpid()), 1024L * 1024L);
  EXPECT_EQ(benchmark::residentMemory(-1), 0);
}

}  // namespace
}  // namespace rubber_suspension
