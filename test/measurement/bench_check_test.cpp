// Errors of a bench are reported with their correction. Differences that effects explain are not reported.
#include "rubber_suspension/measurement/bench_check.h"

#include "measurement/examine.h"
#include "rubber_suspension/element/constants.h"
#include "support/test.h"

namespace rubber_suspension::measurement {
namespace {

std::vector<RigFinding> check(const VirtualRig& rig, const Perturbation& p, const Elements& elements) {
  const log::Log log = runRig(rig, p).log;
  return checkBench(elements, {log::makeRecord(repaired(log, findFaults(log)))});
}

void expectAll(const Perturbation& p, const std::string& name, const std::string& word) {
  for (const VirtualRig& rig : allRigs(2)) {
    const std::vector<RigFinding> findings = check(rig, p, elementsOf(rig));
    ASSERT_EQ(findings.size(), 1u) << static_cast<int>(rig.law) << static_cast<int>(rig.motion);
    EXPECT_EQ(findings[0].finding, name) << static_cast<int>(rig.law) << static_cast<int>(rig.motion)
                                         << findings[0].text;
    EXPECT_TRUE(findings[0].fatal);
    EXPECT_THAT(findings[0].text, HasSubstr(word));
  }
}

TEST(BenchCheck, LeavesLogsAsBenchesWriteThemAlone) {
  Perturbation messy;
  messy.running_start = true;
  messy.force_zero = 0.03;
  messy.displacement_zero = 0.03;
  messy.spikes = 0.2;
  messy.pink = true;
  messy.gain = 0.003;
  messy.delay = 0.5;
  for (const VirtualRig& rig : allRigs(3)) {
    EXPECT_TRUE(check(rig, {}, elementsOf(rig)).empty());
    EXPECT_TRUE(check(rig, messy, elementsOf(rig)).empty());
  }
}

TEST(BenchCheck, NamesSign) {
  Perturbation p;
  p.sign = true;
  expectAll(p, finding::kSign, "--columns force=-NAME");
}

TEST(BenchCheck, NamesSwappedColumns) {
  Perturbation p;
  p.swapped = true;
  expectAll(p, finding::kSwappedColumns, "swap");
}

// Expects that a log has no finding after its correction.
void expectCorrected(const Perturbation& p, const std::string& name) {
  for (const VirtualRig& rig : allRigs(2)) {
    const log::Log log = runRig(rig, p).log;
    const log::Record record = log::makeRecord(repaired(log, findFaults(log)));
    const std::vector<RigFinding> findings = checkBench(elementsOf(rig), {record});
    ASSERT_EQ(findings.size(), 1u);
    const auto correction = correctionOf(findings[0], elementsOf(rig), record);
    ASSERT_TRUE(correction) << name;
    EXPECT_TRUE(checkBench(elementsOf(rig), {correction->record}).empty())
        << name << ", " << correction->text << ": " << static_cast<int>(rig.law) << static_cast<int>(rig.motion);
  }
}

TEST(BenchCheck, CorrectsWhatItNames) {
  Perturbation sign;
  sign.sign = true;
  expectCorrected(sign, finding::kSign);
  Perturbation swapped;
  swapped.swapped = true;
  expectCorrected(swapped, finding::kSwappedColumns);
}

// Like swapped columns, a late displacement makes loops generate energy. The stiffness distinguishes the two.
TEST(BenchCheck, LeavesALateDisplacementToTheEffects) {
  Perturbation late;
  late.delay = -3.0;  // delay of the force relative to the displacement
  for (const VirtualRig& rig : allRigs(2)) {
    for (const RigFinding& finding : check(rig, late, elementsOf(rig))) {
      EXPECT_NE(finding.finding, finding::kSwappedColumns) << finding.text;
      EXPECT_NE(finding.finding, finding::kSign) << finding.text;
    }
  }
}

// If a spring has no loss, any delay of its force makes it generate energy. Short delays are an effect, not a fault.
TEST(BenchCheck, LeavesShortDelaysInSlowMotionToTheEffects) {
  const Elements lossless = {spring(2.3e5)};
  const auto late = [](double delay) {
    constexpr double kFrequency = 3.2;  // [Hz]
    const auto at = [](double time) { return std::sin(2.0 * element::kPi * kFrequency * time); };
    return log::makeRecord(logOf(
        "", 8000, 500000, [&](int i) { return 1e-3 * at(0.0005 * i); },
        [&](int i, double /*z*/) { return 230.0 * at(0.0005 * i - delay); }));
  };
  for (const double delay : {0.0025, 0.012, 0.02}) {
    EXPECT_TRUE(checkBench(lossless, {late(delay), late(delay)}).empty()) << delay;
  }
  const std::vector<RigFinding> findings = checkBench(lossless, {late(0.06), late(0.06)});
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].finding, finding::kDelay);
  EXPECT_NEAR(findings[0].value, 0.06, 0.025 / 3.2);  // the search has steps of 1/40 cycle
}

// A reversed sign or swapped columns affect all logs of a bench. If only one log of three generates energy, the cause
// is an effect.
TEST(BenchCheck, LeavesThePhaseOfFewLogsToTheEffects) {
  Perturbation late;
  late.delay = 20.0;  // samples by which the force is late; the effect of a delay permits less
  const auto record = [](const VirtualRig& rig, const Perturbation& p) {
    const log::Log log = runRig(rig, p).log;
    return log::makeRecord(repaired(log, findFaults(log)));
  };
  int by_phase = 0;
  for (const VirtualRig& rig : allRigs(2)) {
    const log::Record right = record(rig, {});
    const log::Record wrong = record(rig, late);
    if (checkBench(elementsOf(rig), {wrong}).size() == 1) {
      ++by_phase;
      EXPECT_EQ(checkBench(elementsOf(rig), {wrong, wrong, right}).size(), 2U);
      EXPECT_TRUE(checkBench(elementsOf(rig), {wrong, right, right}).empty());
    }
  }
  EXPECT_GT(by_phase, 0);
}

// Returns a record of a sine with the force of a linear law of this stiffness and phase.
log::Record sine(double frequency, double stiffness, double phase = 0.0, log::UnitsAre units = log::UnitsAre::named) {
  const auto turn = [&](int i) { return 2.0 * element::kPi * frequency * 0.002 * i; };
  log::Log log = logOf(
      "sine", 4000, 2000000, [&](int i) { return 1e-3 * std::sin(turn(i)); },
      [&](int i, double /*z*/) { return stiffness * 1e-3 * std::sin(turn(i) + phase); });
  log.units = units;
  return log::makeRecord(log);
}

const Elements kSpring = {spring(1e6)};

std::vector<std::string> namesOf(const std::vector<RigFinding>& findings) {
  std::vector<std::string> names;
  std::transform(findings.begin(), findings.end(), std::back_inserter(names),
                 [](const RigFinding& finding) { return finding.finding; });
  return names;
}

// A mass may reduce the stiffness of the fastest log. The check reports a factor of an assumed unit in a slow log, and
// a factor of a thousand in any log.
TEST(BenchCheck, LeavesWhatAMassMakesOfTheFastestLogToTheEffects) {
  const auto record = [](double frequency, double factor, log::UnitsAre units) {
    return sine(frequency, factor * 1e6, 0.0, units);
  };
  for (const log::UnitsAre units : {log::UnitsAre::named, log::UnitsAre::assumed}) {
    for (const double factor : {0.22, 1.0 / 9.81}) {
      EXPECT_TRUE(
          checkBench(kSpring, {record(1.0, 1.0, units), record(2.0, 1.0, units), record(8.0, factor, units)}).empty())
          << factor;
      const bool told = units == log::UnitsAre::assumed;
      EXPECT_EQ(
          checkBench(kSpring, {record(1.0, factor, units), record(2.0, 1.0, units), record(8.0, 1.0, units)}).size(),
          told ? 1U : 0U)
          << factor;
    }
    EXPECT_THAT(
        namesOf(checkBench(kSpring, {record(1.0, 1.0, units), record(2.0, 1.0, units), record(8.0, 0.001, units)})),
        ElementsAre(finding::kUnitFactor));
  }
}

// Returns the force of a mass, a damper and a spring with a resonance at 4 Hz. Above the resonance, the force has the
// opposite sign of the spring's force. Every loop dissipates energy.
log::Record massOnSpring(double frequency, double sign = 1.0) {
  const double omega = 2.0 * element::kPi * frequency;
  const double resonance = 2.0 * element::kPi * 4.0;
  const double real = 1e6 * (1.0 - std::pow(omega / resonance, 2));
  const double imaginary = 5e3 * omega;
  return sine(frequency, sign * std::hypot(real, imaginary), std::atan2(imaginary, real));
}

TEST(BenchCheck, TakesNoMassForAReversedSign) {
  EXPECT_TRUE(checkBench(kSpring, {massOnSpring(2.0), massOnSpring(8.0)}).empty());
  EXPECT_TRUE(checkBench(kSpring, {massOnSpring(7.0), massOnSpring(8.0)}).empty());
  EXPECT_TRUE(checkBench(kSpring, {massOnSpring(8.0)}).empty());
  EXPECT_THAT(namesOf(checkBench(kSpring, {massOnSpring(1.0, -1.0), massOnSpring(2.0, -1.0)})),
              ElementsAre(finding::kSign, finding::kSign));
}

// Without loss, the work does not show the sign. The slowest log does, because a mass affects it least.
TEST(BenchCheck, NamesTheReversedSignOfASpringWithoutLoss) {
  EXPECT_THAT(namesOf(checkBench(kSpring, {sine(1.0, -1e6), sine(4.0, -1e6)})),
              ElementsAre(finding::kSign, finding::kSign));
  EXPECT_THAT(namesOf(checkBench(kSpring, {sine(1.0, -1e6), sine(4.0, 1e6)})), ElementsAre(finding::kSign));
  EXPECT_TRUE(checkBench(kSpring, {sine(1.0, 1e6), sine(4.0, -0.5e6), sine(5.0, -1e6)}).empty());
}

// The fastest of three logs also contains slow motion, in which a mass is too weak to reverse the force.
TEST(BenchCheck, NamesTheReversedSignOfAFastLogWithSlowMotion) {
  log::Record wide = sine(8.0, -1e6);
  const Eigen::ArrayXd cycles = Eigen::ArrayXd::LinSpaced(wide.size(), 0.0, wide.duration());
  wide.raw_displacement.array() += 3e-3 * (2.0 * element::kPi * cycles).sin();
  wide.mean_frequency = std::sqrt((9.0 * 1.0 + 1.0 * 64.0) / (9.0 + 1.0));
  wide.displacement = wide.raw_displacement;
  wide.force = -1e6 * wide.displacement;
  EXPECT_THAT(namesOf(checkBench(kSpring, {sine(1.0, 1e6), sine(2.0, 1e6), wide})), ElementsAre(finding::kSign));
  EXPECT_TRUE(checkBench(kSpring, {sine(1.0, 1e6), sine(2.0, 1e6), sine(8.0, -1e6)}).empty()) << "as by a mass";
}

// A reversed sign is found although the stiffness in the file is a guess, or the unit is wrong as well.
TEST(BenchCheck, NamesTheReversedSignAtAnySizeOfTheSlope) {
  for (const double factor : {0.1, 0.5, 2.0, 10.0, 1000.0}) {
    const auto findings = checkBench(kSpring, {sine(1.0, -factor * 1e6)});
    ASSERT_THAT(namesOf(findings), ElementsAre(finding::kSign)) << factor;
    EXPECT_EQ(findings[0].text.find("besides") != std::string::npos, factor < 0.3 || factor > 3.5) << findings[0].text;
  }
}

// A guessed stiffness may be wrong by any factor. So a unit that the log names is doubted only if all logs are off by
// the factor between two units.
TEST(BenchCheck, DoubtsNamedUnitsByTheirOwnFactorInAllLogsAlone) {
  const auto logs = [](double factor, log::UnitsAre units) {
    return std::vector<log::Record>{sine(1.0, factor * 1e6, 0.1, units), sine(3.0, 1.1 * factor * 1e6, 0.1, units)};
  };
  using Names = std::vector<std::string>;
  const Names unit(2, finding::kUnitFactor);
  const Names other(2, finding::kOtherComponent);
  for (const log::UnitsAre units : {log::UnitsAre::named, log::UnitsAre::assumed}) {
    const bool named = units == log::UnitsAre::named;
    EXPECT_EQ(namesOf(checkBench(kSpring, logs(1050.0, units))), unit);
    EXPECT_EQ(namesOf(checkBench(kSpring, logs(1900.0, units))), named ? other : unit);
    EXPECT_EQ(namesOf(checkBench(kSpring, logs(15.0, units))), other);
  }
  EXPECT_TRUE(checkBench(kSpring, {sine(1.0, 5e6), sine(3.0, 1e6)}).empty()) << "not one factor";
  for (const double factor : {1000.0, 15.0, 2.0}) {
    EXPECT_TRUE(checkBench(kSpring, logs(factor, log::UnitsAre::accepted)).empty());
  }
  // Deviations within the tolerance of the data sheet (a factor of 10 for a guess) are no faults of the bench.
  const double guess = estimation::SheetTolerance::kGuess;
  for (const double factor : {15.0, 4.448, 2.0, 0.5}) {
    EXPECT_TRUE(checkBench(kSpring, logs(factor, log::UnitsAre::named), guess).empty()) << factor;
  }
  EXPECT_EQ(namesOf(checkBench(kSpring, logs(1050.0, log::UnitsAre::named), guess)), unit);
}

TEST(BenchCheck, NamesWhatWasTakenFromPeakToPeak) {
  for (const VirtualRig& rig : allRigs(1)) {
    for (const double factor : {0.5, 2.0}) {
      Perturbation p;
      p.factor = factor;
      const std::vector<RigFinding> findings = check(rig, p, elementsOf(rig));
      ASSERT_THAT(namesOf(findings), ElementsAre(finding::kPeakToPeak));
      EXPECT_THAT(findings[0].text,
                  HasSubstr(factor > 1.0 ? "--columns force=0.5*NAME" : "--columns displacement=0.5*NAME"));
    }
  }
  EXPECT_TRUE(checkBench(kSpring, {sine(1.0, 2e6), sine(3.0, 1.5e6)}).empty()) << "2.0 in one log alone";
}

// The stiffness and phase of the record differ slightly from those of the component.
TEST(BenchCheck, NamesARectifiedChannel) {
  for (const bool force : {true, false}) {
    log::Record record = sine(2.0, 1.3e6, 0.15);
    (force ? record.force : record.displacement) = (force ? record.force : record.displacement).cwiseAbs().eval();
    record.raw_displacement = record.displacement;
    const std::vector<RigFinding> findings = checkBench(kSpring, {record});
    ASSERT_THAT(namesOf(findings), ElementsAre(finding::kRectified)) << force;
    EXPECT_THAT(findings[0].text, HasSubstr(force ? "the force has lost" : "the displacement has lost"));
  }
}

// A contact that acts on one side only is a law of the component, not a rectified channel.
TEST(BenchCheck, LeavesASpringThatLiftsOffToTheEffects) {
  log::Record record = sine(2.0, 1.3e6, 0.15);
  record.force = record.force.cwiseMax(0.0).eval();
  EXPECT_TRUE(checkBench(kSpring, {record}).empty());
}

// The log moves on both sides of the contact, or only on the side where the contact in the file is open.
TEST(BenchCheck, NamesAContactOfTheOtherSide) {
  for (const double side : {1.0, -1.0}) {
    for (const double mean : {0.0, 1.2e-3}) {
      log::Record record = sine(2.0, 1e6);
      record.displacement = record.raw_displacement.array() + side * mean;
      record.raw_displacement = record.displacement;
      record.force = 1e6 * side * (side * record.displacement).cwiseMax(0.0);
      std::vector<element::ElementDescription> elements = kSpring;
      elements.push_back({"lift_off", {{"side", {-side}}}});
      const std::vector<RigFinding> findings = checkBench(elements, {record});
      ASSERT_THAT(namesOf(findings), ElementsAre(finding::kContactSide)) << side << mean;
      EXPECT_THAT(findings[0].text, HasSubstr("reverse `side`"));
      elements.back().values["side"] = {side};
      EXPECT_TRUE(checkBench(elements, {record}).empty()) << side << mean;
    }
  }
}

// A very soft compliance on one side acts as an open contact, and is reported as a contact.
TEST(BenchCheck, NamesAComplianceOfTheOtherSideAsAContact) {
  for (const double side : {1.0, -1.0}) {
    log::Record record = sine(2.0, 1e6);
    record.force = 1e6 * side * (side * record.displacement).cwiseMax(0.0);
    std::vector<element::ElementDescription> elements = kSpring;
    elements.push_back({"series_compliance", {{"stiffness", {1e3}}, {"side", {side}}}});
    const std::vector<RigFinding> findings = checkBench(elements, {record});
    ASSERT_THAT(namesOf(findings), ElementsAre(finding::kContactSide)) << side;
    EXPECT_THAT(findings[0].text, HasSubstr("the contact `series_compliance`"));
    elements.back().values["side"] = {-side};
    EXPECT_TRUE(checkBench(elements, {record}).empty()) << side;
  }
}

// The displacement is held, or moves, on the side where the contact is open, so a force of zero is plausible.
TEST(BenchCheck, TakesNoLongSlackForADeadChannel) {
  for (const double side : {1.0, -1.0}) {
    for (const double swing : {0.0, 1.0}) {
      log::Record record = sine(2.0, 1e6);
      const Eigen::Index slack = record.size() / 2;
      auto held = record.raw_displacement.tail(slack);
      held = ((swing * held).array() - 1.1e-3 * side).eval();
      record.displacement = record.raw_displacement;
      record.force = 1e6 * side * (side * record.displacement).cwiseMax(0.0);
      EXPECT_TRUE(checkBench(kSpring, {record}).empty()) << side << swing;
      // Other samples at the same displacement have a force, so the contact cannot be open there.
      record.displacement.tail(slack) = record.raw_displacement.tail(slack) = record.raw_displacement.head(slack);
      EXPECT_THAT(namesOf(checkBench(kSpring, {record})), ElementsAre(finding::kConstant)) << side << swing;
    }
  }
}

TEST(BenchCheck, NamesAChannelThatMeasuredNothing) {
  const log::Record whole = sine(2.0, 1e6, 0.1);
  for (const bool force : {true, false}) {
    for (const Eigen::Index dead : {whole.size(), whole.size() / 2, whole.size() / 5}) {
      log::Record record = whole;
      Eigen::VectorXd& channel = force ? record.force : record.raw_displacement;
      channel.tail(dead).setConstant(channel[whole.size() - dead]);
      record.displacement = record.raw_displacement;
      const std::vector<RigFinding> findings = checkBench(kSpring, {record});
      ASSERT_THAT(namesOf(findings), ElementsAre(finding::kConstant)) << force << dead;
      EXPECT_THAT(findings[0].text, HasSubstr(force ? "the force " : "the displacement "));
      EXPECT_EQ(findings[0].unit, dead < whole.size() ? "s" : force ? "N" : "m");
    }
  }
  log::Record noise = whole;
  for (Eigen::Index i = 0; i < noise.size(); ++i) {
    noise.force[i] = 5.0 * std::sin(37.0 * static_cast<double>(i * i % 1013));
  }
  EXPECT_THAT(namesOf(checkBench(kSpring, {noise})), ElementsAre(finding::kConstant));
}

// The force of a seal is weak compared with the spring in the file, but changes its sign with the velocity.
TEST(BenchCheck, TakesNoWeakFrictionForADeadChannel) {
  log::Record seal = sine(2.0, 1e6, 0.5 * element::kPi);
  seal.force = 8.0 * seal.force.cwiseSign();
  EXPECT_TRUE(checkBench(kSpring, {seal}).empty());
}

// During a hold, mains hum is nearly as large as the force of the motion.
TEST(BenchCheck, TakesNoHoldWithAHumForADeadChannel) {
  log::Record record = sine(2.0, 1e6, 0.1);
  const Eigen::Index held = record.raw_displacement.size() / 2;
  record.raw_displacement.tail(held).setConstant(record.raw_displacement[record.raw_displacement.size() - held]);
  record.displacement = record.raw_displacement;
  record.force = 1e6 * record.displacement;
  const double hum = 0.8 * record.force.maxCoeff();
  for (Eigen::Index i = 0; i < record.force.size(); ++i) {
    record.force[i] += hum * std::sin(0.3 * static_cast<double>(i));
  }
  EXPECT_TRUE(checkBench(kSpring, {record}).empty());
}

// In the first case rubber relaxes during a hold, in the second a small motion stays within a free play.
TEST(BenchCheck, TakesNoHoldForADeadChannel) {
  log::Record record = sine(2.0, 1e6, 0.1);
  const Eigen::Index half = record.size() / 2;
  for (Eigen::Index i = half; i < record.size(); ++i) {
    record.raw_displacement[i] = record.raw_displacement[half - 1];
    record.force[i] = record.force[half - 1] + 300.0 * std::exp(-static_cast<double>(i - half) / 500.0);
  }
  record.displacement = record.raw_displacement;
  EXPECT_TRUE(checkBench(kSpring, {record}).empty());
  log::Record play = sine(2.0, 1e6, 0.1);
  for (Eigen::Index i = half; i < play.size(); ++i) {
    play.raw_displacement[i] *= 0.4;
    play.force[i] = 0.0;
  }
  play.displacement = play.raw_displacement;
  EXPECT_TRUE(checkBench(kSpring, {play}).empty());
}

TEST(BenchCheck, NamesUnitFactors) {
  for (const double factor :
       {1e3, 1e-3, 1e6, 1e-6, 9.81, 1.0 / 9.81, 10.0, 0.1, 25.4, 1.0 / 25.4, 4.448, 1.0 / 4.448}) {
    Perturbation p;
    p.factor = factor;
    expectAll(p, finding::kUnitFactor, "--unit");
  }
}

TEST(BenchCheck, NamesAnotherComponent) {
  for (const double factor : {6.5, 0.15}) {
    Perturbation p;
    p.factor = factor;
    expectAll(p, finding::kOtherComponent, "same component");
  }
}

// Differences in stiffness are not reported if effects or a wrong specification may cause them.
TEST(BenchCheck, LeavesEffectsToTheDiagnosis) {
  for (const VirtualRig& rig : allRigs(1)) {
    for (const double factor : {0.6, 1.8}) {
      Perturbation p;
      p.factor = factor;
      EXPECT_TRUE(check(rig, p, elementsOf(rig)).empty()) << factor;
    }
  }
}

// The component is a damper whose friction is far stronger than its spring.
TEST(BenchCheck, LeavesDampersWithWeakSpringAlone) {
  VirtualRig rig;
  rig.law = Law::friction;
  for (const Motion motion : {Motion::sines, Motion::sweep, Motion::track}) {
    rig.motion = motion;
    const log::Log log = runRig(rig).log;
    log::Record record = log::makeRecord(log);
    record.force = simulateAll({friction(400.0, 1e-5)}, {record.dt}, {record.displacement}).front();
    const Elements weak = {spring(1e3)};
    EXPECT_TRUE(checkBench(weak, {record}).empty());
    record.force *= -1.0;
    const std::vector<RigFinding> reversed = checkBench(weak, {record});
    ASSERT_EQ(reversed.size(), 1u);
    EXPECT_EQ(reversed[0].finding, finding::kSign);
  }
}

TEST(BenchCheck, NamesLogsThatHardlyMove) {
  log::Record record = log::makeRecord(runRig({}).log);
  record.displacement.setZero();
  record.displacement.segment(100, 8).setLinSpaced(0.0, 1e-3);
  record.displacement.tail(record.size() - 108).setConstant(1e-3);
  const std::vector<RigFinding> findings = checkBench(elementsOf({}), {record});
  ASSERT_EQ(findings.size(), 1u);
  EXPECT_EQ(findings[0].finding, finding::kTooShort);
  EXPECT_THAT(findings[0].text, AllOf(HasSubstr("add a log with more motion"), Not(HasSubstr("record longer"))));
}

TEST(BenchCheck, IsTheSameOnABenchOfAnySize) {
  for (const double scale : {0.01, 100.0}) {
    VirtualRig rig;
    rig.length = scale;
    rig.force = 1.0 / scale;
    rig.time = scale;
    Perturbation p;
    EXPECT_TRUE(check(rig, p, elementsOf(rig)).empty());
    p.sign = true;
    ASSERT_EQ(check(rig, p, elementsOf(rig)).size(), 1u);
    EXPECT_EQ(check(rig, p, elementsOf(rig))[0].finding, finding::kSign);
  }
}

}  // namespace
}  // namespace rubber_suspension::measurement
