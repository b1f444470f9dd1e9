// The figures of the latency benchmark show the numbers of its tables.
#include <gmock/gmock.h>

#include "benchmark/latency/latency_benchmark.h"

namespace rubber_suspension {
namespace {

using ::testing::ElementsAre;

std::vector<benchmark::LatencyRow> exampleRows() {
  benchmark::LatencyRow one;
  one.components = 1;
  one.rate = 1000.0;
  one.median.echo = 1e-4;
  one.late.echo = 2e-4;
  one.median.node = {1.1, 1.0, 1.3};
  one.median.again = {0.9, 0.8, 1.2};
  one.late.node = {2.0, 1.5, 2.5};
  one.node_highest = 50000.0;
  one.echo_highest = 60000.0;
  benchmark::LatencyRow bundled = one;
  bundled.components = 50;
  bundled.bundled = true;
  bundled.median.node = {1.4, 1.2, 1.5};
  return {one, bundled};
}

const io::Curve& curveNamed(const io::Axes& axes, const std::string& label) {
  for (const io::Curve& curve : axes.curves) {
    if (curve.label == label) {
      return curve;
    }
  }
  throw std::runtime_error("no curve " + label);
}

TEST(LatencyFigure, HasTheRatiosAndTheRates) {
  const io::Figure figure = benchmark::latencyFigure(exampleRows());
  ASSERT_EQ(figure.axes.size(), 4U);
  EXPECT_THAT(figure.axes[0].rows, ElementsAre("1 component\n1000 Hz", "50 components\n1000 Hz, one message"));
  EXPECT_THAT(curveNamed(figure.axes[0], "node / echo").x, ElementsAre(1.1, 1.4));
  EXPECT_THAT(curveNamed(figure.axes[0], "echo / itself").x, ElementsAre(0.9, 0.9));
  EXPECT_THAT(curveNamed(figure.axes[1], "node / echo").x, ElementsAre(2.0, 2.0));
  EXPECT_THAT(curveNamed(figure.axes[2], "99 %").x, ElementsAre(0.2, 0.2));    // [ms]
  EXPECT_THAT(curveNamed(figure.axes[3], "node").x, ElementsAre(50.0, 50.0));  // thousands
}

TEST(SoakFigure, MemoryOverSamples) {
  benchmark::SoakResult result;
  result.components = 10;
  result.sent = 4000000;
  result.memory = {1048576, 2 * 1048576, 2 * 1048576, 2 * 1048576};
  const io::Figure figure = benchmark::soakFigure(result);
  EXPECT_THAT(figure.axes.at(0).curves.at(0).x, ElementsAre(1.0, 2.0, 3.0, 4.0));
  EXPECT_THAT(figure.axes.at(0).curves.at(0).y, ElementsAre(1.0, 2.0, 2.0, 2.0));
}

}  // namespace
}  // namespace rubber_suspension
