// Diagnosis of single directions of a component with six: directions that can be diagnosed alone, the cross map, units
// of rotations. Whole diagnoses are in test/usage/six_directions_test.py.
#include "rubber_suspension/diagnosis/six_directions.h"

#include "diagnosis/results/cross_map.h"
#include "diagnosis/words/text.h"
#include "gap/simulate.h"
#include "io/rotational_unit.h"
#include "support/kit.h"

namespace rubber_suspension::diagnosis {
namespace {

using component::kRx;
using component::kRz;
using component::kX;
using component::kY;
using component::kZ;
using results::crossShare;

constexpr double kNoiseLeft = 5.0;  // noise of the residuals [N]

// x, y and z move at different frequencies, rx moves in proportion to x, and ry and rz stand still. The residual of x
// is coupling(x, z) [N], with x and z in mm, plus noise and an offset per log. Other residuals are noise.
template <class Coupling>
std::vector<results::DirectionResiduals> residuals(Coupling coupling) {
  std::mt19937 generator(7);
  std::normal_distribution<double> noise(0.0, kNoiseLeft);
  std::vector<results::DirectionResiduals> logs(2);
  for (std::size_t k = 0; k < logs.size(); ++k) {
    for (int i = 0; i < 6000; ++i) {
      const double t = 0.004 * i;
      const double x = 1.5 * std::sin(9.0 * t + static_cast<double>(k));
      const double z = 1.0 * std::sin(13.7 * t);
      const std::array<double, 6> at = {1e-3 * x, 1e-3 * std::sin(5.3 * t), 1e-3 * z, 0.02 * x, 0.0, 0.0};
      for (std::size_t direction = 0; direction < at.size(); ++direction) {
        log::Log& log = logs[k][direction];
        log.stamp.push_back(4000000LL * i);
        log.displacement.push_back(at[direction]);
        log.force.push_back(noise(generator) +
                            (direction == kX ? coupling(x, z) + 100.0 * static_cast<double>(k) : 0.0));
      }
    }
  }
  return logs;
}

TEST(CrossMap, SaysWhichDisplacementPredictsTheRest) {
  const auto logs = residuals([](double x, double z) { return 40.0 * x * z; });
  const CrossShare by_z = crossShare(logs, kX, kZ);
  // The product of 40 N/mm^2 and the RMS displacements, 1.5/sqrt(2) mm and 1/sqrt(2) mm. All else is noise.
  const double rms = 40.0 * 1.5 / 2.0;
  EXPECT_NEAR(by_z.force, rms, 0.02 * rms);
  EXPECT_NEAR(by_z.share, rms * rms / (rms * rms + kNoiseLeft * kNoiseLeft), 0.01);
  EXPECT_LT(crossShare(logs, kX, kY).share, 0.01);
  EXPECT_LT(crossShare(logs, kZ, kX).share, 0.01);
}

// A residual is no coupling if it is noise or a function of the displacement in its own direction.
TEST(CrossMap, OwnMotionAndNoiseAreNoCoupling) {
  const auto logs = residuals([](double x, double) { return 30.0 * x * x * x; });
  for (const component::Direction by : {kY, kZ}) {
    EXPECT_LT(crossShare(logs, kX, by).share, 0.01);
    EXPECT_GE(crossShare(logs, kX, by).share, 0.0);
  }
}

TEST(CrossMap, IsEmptyWhereTheOtherTellsNothing) {
  const auto logs = residuals([](double x, double) { return 30.0 * x; });
  EXPECT_TRUE(std::isnan(crossShare(logs, kX, kRx).share));  // rx moves in proportion to x
  EXPECT_TRUE(std::isnan(crossShare(logs, kX, kRz).share));  // rz stands still
}

io::ComponentDescription radialBush() {
  return io::parseComponentFile(
             "components:\n  bush:\n    directions:\n      x: &e {model: elements, elements: [{type: spring, "
             "stiffness: "
             "4 kN/mm}, {type: maxwell, stiffness: 1 kN/mm, break_frequency: 2 Hz}], add: [{type: radial_stiffness, "
             "cubic: 2.0e+11, alone: 0.5}]}\n      y: *e\n",
             "bush.yaml")
      .front();
}

// Simulating x with the displacement of y as an input gives the force of the whole bush.
TEST(RadialStiffness, OfARecordIsThatOfTheBush) {
  const component::SixDirections bush = radialBush().six->makeComponent();
  component::SixDirectionsState state = bush.makeState();
  log::Log log;
  std::vector<double> expected;
  for (int i = 0; i < 500; ++i) {
    component::SixNumbers at = component::SixNumbers::Zero();
    at[0] = 1.5e-3 * std::sin(0.02 * i);
    at[1] = 1e-3 * (1.0 - std::cos(0.033 * i));
    log.stamp.push_back(4000000LL * i);
    log.displacement.push_back(at[0]);
    log.across.push_back(at[1]);
    const auto force = i == 0 ? bush.initialise(state, bush.pose(at)) : bush.step(state, 4e-3, bush.pose(at));
    expected.push_back(force.wrench.force.x());
  }
  log.force = expected;
  const log::Record record = log::evenRecord(log);
  const Eigen::VectorXd found = gap::simulate(radialBush().six->directions[kX]->allElements(), {record}).front();
  EXPECT_LT((found - record.force).cwiseAbs().maxCoeff(), 1e-9 * record.force.cwiseAbs().maxCoeff());
}

std::string refusal(const std::string& coupling, const std::vector<component::Direction>& directions) {
  const auto component = componentOf(
      "components:\n  bush:\n    directions: {x: &e {model: elements, elements: [{type: spring, stiffness: 1 kN/mm}]}, "
      "y: "
      "*e, z: *e}\n    coupling: " +
      coupling + "\n");
  return messageOf<std::invalid_argument>([&] { requireDirections(component, directions); });
}

TEST(RequiredDirections, ErrorsNameDirectionAndWhatIsAccepted) {
  EXPECT_EQ(refusal("rectangular", {kX, kZ}), "");
  EXPECT_EQ(refusal("cylindrical", {kZ}), "");
  EXPECT_EQ(refusal("rectangular", {kRx}), "direction rx: is free; accepted: one of x, y, z");
  EXPECT_EQ(refusal("cylindrical", {}), "has six directions; accepted: --direction with one or more of z");
  const std::string coupled = refusal("cylindrical", {kZ, kY});
  EXPECT_EQ(coupled.rfind("direction y: ", 0), 0U) << coupled;
  EXPECT_NE(coupled.find("accepted: one of z; rectangular coupling; "), std::string::npos) << coupled;
  EXPECT_NE(coupled.find("displacement=y force=Fy"), std::string::npos) << coupled;
  EXPECT_NE(refusal("spherical", {kZ}).find("accepted: rectangular coupling; "), std::string::npos);
}

TEST(RotationUnits, StandBehindNumbersAndInBracketsOnly) {
  EXPECT_EQ(words::inRotationUnits("2 N (1.9 to 2.1 N) at 5 mm or 300 µm"),
            "2 N m (1.9 to 2.1 N m) at 5 mrad or 300 µrad");
  EXPECT_EQ(words::inRotationUnits("4 kN/mm, 3 N/m, 2 kN s/m, 2 m, 3 m/s, [kN] over [mm]"),
            "4 kN m/mrad, 3 N m/rad, 2 kN m s/rad, 2 rad, 3 rad/s, [kN m] over [mrad]");
  const std::string other = "5 N m, 3 N m/rad, 2 mrad/s, 4 Nm, x_mm, 5 ms, K_n, 7 Hz";
  EXPECT_EQ(words::inRotationUnits(other), other);
}

TEST(RotationUnits, ScaleAsThoseOfADisplacement) {
  for (const char* unit : {"m", "N", "N/m", "N s/m", "m/s"}) {
    for (const double value : {3e-6, 2e-3, 2.0, 5e3, 7e6}) {
      EXPECT_EQ(words::quantity(value, io::rotationalUnit(unit)), words::inRotationUnits(words::quantity(value, unit)));
    }
  }
}

}  // namespace
}  // namespace rubber_suspension::diagnosis
