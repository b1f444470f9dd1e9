// Simulation of a log: forces equal those of a stream. Also tests the gap, the summary and the figure.
#include "rubber_suspension/gap/replay.h"

#include "io/progress.h"
#include "rubber_suspension/element/constants.h"
#include "support/kit.h"

namespace rubber_suspension {
namespace {

log::Log sineLog(int samples) {
  return logOf("sine", samples, 1234567, [](int i) { return 0.003 * std::sin(0.01 * i); });
}

const component::Component kComponent({spring(3e6), maxwell(1e6, 2.0), friction(1500.0, 0.0005)});

TEST(SimulateLog, GivesTheForcesOfAStreamToTheLastBit) {
  const log::Log log = sineLog(5000);
  const std::vector<double> force = gap::simulateLog(kComponent, log);
  component::SampleStream stream(kComponent);
  for (std::size_t i = 0; i < log.size(); ++i) {
    ASSERT_EQ(force[i], stream.push(log.stamp[i], log.displacement[i]).force.total) << i;
  }
}

TEST(SimulateLog, RefusesABadLogAndNamesTheSampleWhoseForceIsNotFinite) {
  log::Log log = sineLog(10);
  log.stamp[5] = log.stamp[4];
  EXPECT_THROW(gap::simulateLog(kComponent, log), log::LogError);
  log = sineLog(3);
  log.displacement[2] = 1e305;  // the force of 3e6 N/m overflows a double
  EXPECT_THAT(messageOf<log::LogError>([&] { gap::simulateLog(kComponent, log); }),
              HasSubstr("sine: sample 3: displacement 1e+305 m"));
}

TEST(Replay, CountsGapsInTime) {
  log::Log log = sineLog(10);
  for (std::size_t i = 6; i < log.size(); ++i) {
    log.stamp[i] += 2000000000LL;
  }
  EXPECT_EQ(gap::replay(kComponent, log).bridged, 1u);
  EXPECT_EQ(gap::replay(kComponent, sineLog(10)).bridged, 0u);
}

TEST(Summary, HasTheGapOnlyWithAMeasuredForce) {
  log::Log log = sineLog(100);
  gap::Replay result = gap::replay(kComponent, log);
  EXPECT_THAT(gap::summary("bush", log, result), HasSubstr("bush: 100 samples, 0.122222 s"));
  EXPECT_THAT(gap::summary("bush", log, result), Not(HasSubstr("gap")));
  log.force = result.force;
  EXPECT_THAT(gap::summary("bush", log, result), HasSubstr("gap to the measured force 0.0000"));
  for (double& force : log.force) {
    force += 12.5;
  }
  EXPECT_THAT(gap::summary("bush", log, result), Not(HasSubstr("gap to the measured force 0.0000")));
  EXPECT_THAT(gap::summary("bush", log, result, gap::Offset::removed),
              HasSubstr("gap to the measured force 0.0000 without an offset of 12.5 N"));
}

// Many cycles would fill the axes, so the figure shows the last cycles with their residual, and the smallest and
// largest residual over the whole log.
TEST(ReplayFigure, ShowsTheLastCyclesAndTheWholeLogsResidual) {
  log::Log log = sineLog(120001);
  log.force.assign(log.size(), 1.0);
  log.force[7] = 3001.0;
  const io::Figure figure = gap::replayFigure("bush", log, std::vector<double>(log.size(), 2000.0));
  ASSERT_EQ(figure.axes.size(), 4u);
  EXPECT_NE(figure.title.find(": the last "), std::string::npos) << figure.title;
  EXPECT_EQ(figure.axes[0].curves.size(), 2u);
  EXPECT_GT(figure.axes[0].curves[0].width, figure.axes[0].curves[1].width) << "both are to be seen";
  for (const io::Axes& axes : figure.axes) {
    for (const io::Curve& curve : axes.curves) {
      EXPECT_LE(curve.x.size(), 4001u);
      EXPECT_EQ(curve.x.size(), curve.y.size());
    }
  }
  EXPECT_GT(figure.axes[1].curves[0].x.front(), 0.9 * log.time(log.size() - 1)) << "the end of the log";
  EXPECT_EQ(figure.axes[1].curves[1].y[0], 2.0);  // [kN]
  EXPECT_EQ(figure.axes[3].curves[0].y[0], -1.999);
  EXPECT_EQ(figure.axes[2].curves[0].y[0], -1.999) << "smallest";
  EXPECT_NEAR(figure.axes[2].curves[1].y[0], 1.001, 1e-12) << "largest: what stands out is not thinned away";
  log.force.clear();
  EXPECT_EQ(gap::replayFigure("bush", log, std::vector<double>(log.size(), 2000.0)).axes.size(), 4u);
}

TEST(ReplayFigure, ShowsAllOfAShortLog) {
  const log::Log log = sineLog(10);
  const io::Figure figure = gap::replayFigure("bush", log, std::vector<double>(log.size(), 2000.0));
  EXPECT_EQ(figure.title, "bush, " + log.name);
  EXPECT_EQ(figure.axes[1].curves[0].x.size(), 10u);
}

// The figure has a row for each direction that moves or carries a load. Moments are in N m, rotations in degrees.
TEST(ReplayFigure, ShowsTheDirectionsOfABush) {
  log::PoseLog log;
  std::array<std::vector<double>, 6> wrench;
  for (int i = 0; i < 300; ++i) {
    log.stamp.push_back(4000000LL * i);
    for (std::size_t k = 0; k < 6; ++k) {
      log.coordinate[k].push_back(k == 0 || k == 5 ? 1e-3 * std::sin(0.2 * i) : 0.0);
      wrench[k].push_back(k == 2 ? 10.0 * std::sin(0.1 * i) : 2000.0);
    }
  }
  log.coordinate[5][299] = element::kPi / 180.0;
  const io::Figure figure = gap::replayFigure("bush", log, wrench);
  ASSERT_EQ(figure.axes.size(), 6u);
  EXPECT_EQ(figure.axes[0].x_label, "x [mm]");
  EXPECT_EQ(figure.axes[0].y_label, "Fx [kN]");
  EXPECT_EQ(figure.axes[0].curves[0].y[0], 2.0);
  EXPECT_EQ(figure.axes[2].y_label, "Fz [kN]");
  EXPECT_EQ(figure.axes[4].y_label, "Mz [N m]");
  EXPECT_EQ(figure.axes[4].curves[0].y[0], 2000.0);
  EXPECT_NEAR(figure.axes[4].curves[0].x.back(), 1.0, 1e-12);
  EXPECT_EQ(figure.axes[5].x_label, "time [s]");
}

TEST(ProgressBar, FillsWithThePercentageAndFitsTheTerminal) {
  EXPECT_EQ(io::Progress::bar("x", 0, 80), "x   0 % [" + std::string(40, ' ') + "]");
  EXPECT_EQ(io::Progress::bar("x", 50, 80), "x  50 % [" + std::string(20, '=') + std::string(20, ' ') + "]");
  EXPECT_EQ(io::Progress::bar("x", 100, 80), "x 100 % [" + std::string(40, '=') + "]");
  EXPECT_EQ(io::Progress::bar("x", 100, 10).size(), 10u);
}

}  // namespace
}  // namespace rubber_suspension
