// The contract of every law: the same tests for all laws of the catalogue, with typical parameters.
#include <Eigen/Core>

#include "element/driver.h"
#include "element/typical_elements.h"
#include "support/allocation_counter.h"
#include "support/test.h"

namespace rubber_suspension::test {
namespace {

using testing::Eq;

constexpr double kShortestStep = 1e-3;  // [s]
constexpr double kAmplitude = 1.5e-3;   // [m], larger than the gaps and yield displacements of the typical parameters

/// A reproducible walk with random displacements up to 2 amplitudes and random time steps.
class RandomMoves {
 public:
  explicit RandomMoves(unsigned seed) : generator_(seed) {}

  double displacement() { return 2.0 * kAmplitude * uniform_(generator_); }
  double dt() { return kShortestStep * std::exp(2.0 * uniform_(generator_)); }
  double share() { return 0.5 + 0.45 * uniform_(generator_); }

 private:
  std::mt19937 generator_;
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

std::vector<double> forcesOfWalk(const component::Component& component, component::ComponentState& state,
                                 unsigned seed) {
  RandomMoves moves(seed);
  std::vector<double> forces;
  for (int i = 0; i < 200; ++i) {
    const double dt = moves.dt();
    forces.push_back(component.step(state, dt, moves.displacement()).total);
  }
  return forces;
}

double largest(const std::vector<double>& values) {
  double result = 0.0;
  for (const double value : values) {
    result = std::max(result, std::abs(value));
  }
  return result;
}

/// Returns the displacement of a motion that starts smoothly from rest, so that the acceleration does not jump.
double smoothMotion(double t) {
  return kAmplitude * (std::pow(std::sin(2.0 * element::kPi * 1.3 * t), 3) +
                       0.4 * std::pow(std::sin(2.0 * element::kPi * 5.1 * t), 3));
}

/// Returns the forces under smoothMotion every 4 ms, simulated with steps of 4 ms / refinement.
std::vector<double> forcesOfSmoothMotion(const component::Component& component, int refinement) {
  constexpr double kCoarse = 4e-3;
  constexpr int kSamples = 300;
  component::ComponentState state = component.makeState();
  std::vector<double> forces;
  for (int i = 1; i <= kSamples * refinement; ++i) {
    const double force = component.step(state, kCoarse / refinement, smoothMotion(kCoarse * i / refinement)).total;
    if (i % refinement == 0) {
      forces.push_back(force);
    }
  }
  return forces;
}

double rmsDifference(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    sum += (a[i] - b[i]) * (a[i] - b[i]);
  }
  return std::sqrt(sum / static_cast<double>(a.size()));
}

/// Simulates until the slowest relaxation of the typical laws (tau of about 50 s) has decayed by exp(-30).
std::complex<double> simulatedStiffness(const component::Component& component, double frequency, int samples) {
  return settledStiffness(component, frequency, samples, static_cast<int>(1500.0 * frequency) + 1, kAmplitude);
}

/// Returns K* as a sampled sine shows it if steps are exact. The straight lines between samples contain the angular
/// frequencies w + k w_s, w_s = 2 pi/dt, with shares sinc^2((w + k w_s) dt/2), so the result is the sum of shares times
/// K*(w + k w_s). The shares add up to 1, so the high-frequency limit of K* is taken out of the sum. Pairs of other
/// terms fall as 1/k^4.
std::complex<double> sampledStiffness(const component::Component& component, double frequency, int samples_per_cycle) {
  constexpr int kAliases = 200000;
  constexpr double kInfinite = 1e14;  // [Hz]
  const double sampling = frequency * samples_per_cycle;
  const double limit = component.complexStiffness(kInfinite)->real();
  const auto term = [&](int k) {
    const double alias = frequency + k * sampling;
    const double argument = element::kPi * alias / sampling;
    const double share = std::pow(std::sin(argument) / argument, 2);
    const std::complex<double> stiffness = *component.complexStiffness(std::abs(alias));
    return share * ((alias < 0.0 ? std::conj(stiffness) : stiffness) - limit);
  };
  std::complex<double> sum = 0.0;  // the smallest terms first, against rounding
  for (int k = kAliases; k > 0; --k) {
    sum += term(k) + term(-k);
  }
  return sum + term(0) + limit;
}

bool isRole(element::Role role) {
  const std::string name = element::toString(role);
  return name == "scale" || name == "shape" || name == "choice" || name == "reference";
}

TEST(Catalogue, EveryLawIsPutToTheContract) {
  std::set<std::string> tested;
  for (const element::ElementDescription& description : typicalElements()) {
    tested.insert(description.type);
  }
  for (const element::ElementType& type : element::elementTypes()) {
    EXPECT_TRUE(tested.count(type.name)) << type.name << " has no typical parameters in typical_elements.h";
    EXPECT_FALSE(type.documentation.empty()) << type.name;
    for (const element::ParameterInfo& parameter : type.parameters) {
      EXPECT_FALSE(parameter.documentation.empty()) << type.name << '.' << parameter.name;
      EXPECT_FALSE(parameter.unit.empty()) << type.name << '.' << parameter.name;
      EXPECT_TRUE(isRole(parameter.role)) << type.name << '.' << parameter.name;
      EXPECT_TRUE(!parameter.default_value || parameter.range.contains(*parameter.default_value))
          << type.name << '.' << parameter.name;
    }
  }
}

std::string nameOf(const testing::TestParamInfo<element::ElementDescription>& test) {
  return test.param.type + "_" + std::to_string(test.index);
}

template <class Predicate>
auto typicalElementsThat(Predicate predicate) {
  std::vector<element::ElementDescription> chosen;
  for (const element::ElementDescription& description : typicalElements()) {
    if (predicate(description)) {
      chosen.push_back(description);
    }
  }
  return testing::ValuesIn(chosen);
}

class Contract : public testing::TestWithParam<element::ElementDescription> {
 protected:
  component::Component component_ = subject(GetParam());
  component::ComponentState state_ = component_.makeState();
};

INSTANTIATE_TEST_SUITE_P(AllLaws, Contract, testing::ValuesIn(typicalElements()), nameOf);

class ForcelessContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(LawsWithoutForceOfTheirOwn, ForcelessContract,
                         typicalElementsThat([](const element::ElementDescription& law) {
                           return !isOneOf(law, {"force_offset", "force_drift"});
                         }),
                         nameOf);

TEST_P(ForcelessContract, ZeroInGivesZeroOut) {
  RandomMoves moves(1);
  EXPECT_EQ(component_.initialise(state_, 0.0).total, 0.0);
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(component_.step(state_, moves.dt(), 0.0).total, 0.0) << "step " << i;
  }
}

TEST_P(Contract, RestIsAsNew) {
  const std::vector<double> as_new = forcesOfWalk(component_, state_, 2);
  component_.initialise(state_, 0.0);
  EXPECT_EQ(state_.memory(), component_.makeState().memory());
  EXPECT_EQ(forcesOfWalk(component_, state_, 2), as_new);
}

class StillContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(LawsThatRest, StillContract, typicalElementsThat([](const element::ElementDescription& law) {
                           return law.type != "force_drift";
                         }),
                         nameOf);

TEST_P(StillContract, StaysAtRestWhereItRests) {
  const double force = component_.initialise(state_, kAmplitude).total;
  for (const double dt : {1e-4, 1.0, 1e4}) {
    // The operations are the same, except for the order of sums and the tolerance of the solver for a mount.
    ASSERT_NEAR(component_.step(state_, dt, kAmplitude).total, force, 1e-12 * std::abs(force)) << dt;
  }
}

// A file or a simulator may restore any numbers. Numbers that are a position or a count are checked. No element
// accesses memory beyond its own.
TEST_P(Contract, RestoredNumbersAreRefusedOrServed) {
  forcesOfWalk(component_, state_, 6);
  const std::vector<double> own = state_.memory();
  for (const double number : {-1.0, 0.0, 0.5, 1.0, 255.0, 256.0, 2e9, -2e9, 1e300}) {
    for (std::size_t place = 0; place < std::min<std::size_t>(own.size(), 8); ++place) {
      std::vector<double> memory = own;
      memory[place] = number;
      component::ComponentState restored = component_.makeState();
      try {
        component_.restore(restored, state_.displacement(), memory);
      } catch (const std::invalid_argument&) {
        EXPECT_EQ(restored.memory(), component_.makeState().memory()) << "what is refused leaves no trace";
        continue;
      }
      forcesOfWalk(component_, restored, 7);
    }
  }
}

TEST_P(Contract, CopyContinuesAsTheOriginal) {
  forcesOfWalk(component_, state_, 3);
  component::ComponentState copy = state_;
  component::ComponentState restored = component_.makeState();
  component_.restore(restored, state_.displacement(), state_.memory());
  const std::vector<double> forces = forcesOfWalk(component_, state_, 4);
  EXPECT_EQ(forcesOfWalk(component_, copy, 4), forces);
  EXPECT_EQ(forcesOfWalk(component_, restored, 4), forces);
}

TEST_P(Contract, StepAllocatesNothing) {
  RandomMoves moves(5);
  const AllocationCounter counter;
  for (int i = 0; i < 200; ++i) {
    component_.step(state_, moves.dt(), moves.displacement());
  }
  component_.initialise(state_, kAmplitude);
  component_.relax(state_, 0.0);
  EXPECT_EQ(counter.count(), 0U);
}

class ParallelContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(LawsWithForces, ParallelContract, typicalElementsThat(addsForce), nameOf);

TEST_P(ParallelContract, RawLawAgreesWithComponent) {
  Driver law(GetParam(), 1e-4);
  EXPECT_EQ(law.output(), component_.initialise(state_, 1e-4).total);
  RandomMoves moves(7);
  for (int i = 0; i < 200; ++i) {
    const double dt = moves.dt();
    const double next = moves.displacement();
    const double force = law.step(dt, next);
    ASSERT_NEAR(component_.step(state_, dt, next).total, force, 1e-12 * std::abs(force));  // order of sums
  }
}

// An even characteristic releases energy in one direction of motion, but none over a closed cycle.
class PassiveContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(PassiveLaws, PassiveContract, typicalElementsThat([](const element::ElementDescription& law) {
                           return isPassive(law) || isElastic(law);
                         }),
                         nameOf);

TEST_P(PassiveContract, ClosedSettledCycleDissipates) {
  constexpr int kSamples = 400;
  constexpr int kCycles = 10;
  double work = 0.0;
  double peak = 0.0;
  element::ComponentForce before = component_.initialise(state_, 0.0);
  for (int i = 1; i <= kCycles * kSamples; ++i) {
    const double z = kAmplitude * std::sin(2.0 * element::kPi * (i % kSamples) / kSamples);
    const double increment = z - state_.displacement();
    const element::ComponentForce force = component_.step(state_, 0.5 / kSamples, z);
    peak = std::max(peak, std::abs(force.total));
    if (i > (kCycles - 1) * kSamples) {
      work += 0.5 * (before.total + force.total) * increment;
    }
    before = force;
  }
  // An elastic law retraces its path over the same samples, so its work is zero up to rounding.
  EXPECT_GE(work, -1e-12 * peak * kAmplitude);
  if (!isElastic(GetParam())) {
    EXPECT_GT(work, 1e-4 * peak * kAmplitude) << "a law with loss loses nothing";
  }
}

class BoundedContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(LawsPassiveByThemselves, BoundedContract, typicalElementsThat(isPassive), nameOf);

TEST_P(BoundedContract, NeverGivesMoreEnergyThanItGot) {
  constexpr int kParts = 256;
  RandomMoves moves(8);
  double work = 0.0;
  constexpr double kRounding = 1e-11;  // rounding of the root at an open contact [N]; forces are some kN
  double uncertainty = 0.0;            // error of the trapezoidal rule for a force that is monotone over a part
  double before = component_.initialise(state_, 0.0).total;
  for (int move = 0; move < 40; ++move) {
    const double start = state_.displacement();
    const double end = moves.displacement();
    const double dt = moves.dt() / kParts;
    for (int part = 1; part <= kParts; ++part) {
      const double z = start + (end - start) * part / kParts;
      const double increment = z - state_.displacement();
      const double force = component_.step(state_, dt, z).total;
      work += 0.5 * (before + force) * increment;
      uncertainty += (0.5 * std::abs(force - before) + kRounding) * std::abs(increment);
      before = force;
      ASSERT_GE(work, -uncertainty) << "move " << move;
    }
  }
}

/// Returns the forces of a weighted sum of two walks, with alternating temperatures.
Eigen::VectorXd walkOfBoth(const component::Component& component, double first, double second) {
  component::ComponentState state = component.makeState();
  RandomMoves moves(10);
  RandomMoves others(11);
  Eigen::VectorXd forces(200);
  int count = 0;
  for (double& force : forces) {
    const double dt = moves.dt();
    const double displacement = first * moves.displacement();
    component.setTemperature(state, ++count % 50 < 25 ? 5.0 : 50.0);
    force = component.step(state, dt, displacement + second * others.displacement()).total;
  }
  return forces;
}

// Linear laws superpose, all others do not. Rounding and the tolerance of the solver for a series compliance are below
// 1e-9 of the force. The weakest nonlinearity of the typical laws is far above 1e-4.
TEST_P(Contract, SuperposesWhereTheLawSaysSo) {
  const component::Component component = linearSubject(GetParam());
  const Eigen::VectorXd none = walkOfBoth(component, 0.0, 0.0);
  const Eigen::VectorXd first = walkOfBoth(component, 1.0, 0.0) - none;
  const Eigen::VectorXd second = walkOfBoth(component, 0.0, 1.0) - none;
  const Eigen::VectorXd both = walkOfBoth(component, 1.0, 1.0) - none;
  const double difference = (both - first - second).cwiseAbs().maxCoeff();
  const double largest = std::max(both.cwiseAbs().maxCoeff(), none.cwiseAbs().maxCoeff());
  if (element::lawOf(element::makeElement(GetParam())).linear()) {
    EXPECT_LE(difference, 1e-9 * largest);
  } else {
    EXPECT_GE(difference, 1e-4 * largest);
  }
}

/// Returns the law with the named parameters multiplied by a factor.
element::ElementDescription multiplied(element::ElementDescription law, const std::vector<std::string>& names,
                                       double factor) {
  for (const std::string& name : names) {
    for (double& value : law.values.at(name)) {
      value *= factor;
    }
  }
  return law;
}

Eigen::VectorXd walkOf(const element::ElementDescription& law) { return walkOfBoth(subject(law), 1.0, 0.0); }

/// Returns the parameters of a role that can be varied: their value is given and not at a limit of its range.
std::vector<std::string> parametersOf(const element::ElementDescription& law, element::Role role) {
  std::vector<std::string> names;
  const element::ElementDescription completed = element::complete(law);
  for (const element::ParameterInfo& parameter : element::findElementType(law.type)->parameters) {
    const double first = completed.value(parameter.name);
    const bool at_end = first == 0.0 || first == parameter.range.lower || first == parameter.range.upper;
    if (parameter.role == role && (parameter.is_list || !at_end)) {
      names.push_back(parameter.name);
    }
  }
  return names;
}

class RoleContract : public testing::TestWithParam<element::ElementDescription> {
 protected:
  element::ElementDescription law_ = element::complete(GetParam());
  Eigen::VectorXd force_ = walkOf(law_);
  double largest_ = force_.cwiseAbs().maxCoeff();
};

INSTANTIATE_TEST_SUITE_P(AllLaws, RoleContract, testing::ValuesIn(typicalElements()), nameOf);

// Rounding in sums of a few hundred products is below 1e-12 of the largest force.
TEST_P(RoleContract, TheForceIsLinearInScales) {
  const std::vector<std::string> scales = parametersOf(law_, element::Role::scale);
  if (scales.empty()) {
    return;  // parameters with other roles have their own tests
  }
  ASSERT_TRUE(addsForce(law_));
  EXPECT_LE((walkOf(multiplied(law_, scales, 2.0)) - 2.0 * force_).cwiseAbs().maxCoeff(), 1e-12 * largest_);
  for (const std::string& name : scales) {
    const Eigen::VectorXd twice = walkOf(multiplied(law_, {name}, 2.0)) - force_;
    const Eigen::VectorXd thrice = walkOf(multiplied(law_, {name}, 3.0)) - force_;
    EXPECT_LE((thrice - 2.0 * twice).cwiseAbs().maxCoeff(), 1e-12 * largest_) << name;
    EXPECT_GE(twice.cwiseAbs().maxCoeff(), 0.01 * largest_) << name << " does nothing";
  }
}

/// Returns true for the stiffness of Bouc-Wen with exponent 1, the only shape parameter in which a force is linear.
bool scalesByChance(const element::ElementDescription& law, const std::string& name) {
  return law.type == "bouc_wen" && law.value("exponent") == 1.0 && name == "stiffness";
}

// Reducing a shape parameter by a tenth changes the force by at least 1e-5 of it, but does not simply scale the force.
TEST_P(RoleContract, ShapesActOnTheForceButDoNotScaleIt) {
  for (const std::string& name : parametersOf(law_, element::Role::shape)) {
    const Eigen::VectorXd changed = walkOf(multiplied(law_, {name}, 0.9));
    EXPECT_GE((changed - force_).cwiseAbs().maxCoeff(), 1e-5 * largest_) << name;
    EXPECT_TRUE(scalesByChance(law_, name) || (changed - 0.9 * force_).cwiseAbs().maxCoeff() >= 1e-5 * largest_)
        << name;
  }
}

// Fits do not vary a reference, because changing its value only scales the force. Powers of ratios are accurate to
// 1e-11 of the force.
TEST_P(RoleContract, ReferencesOnlyScaleTheForce) {
  for (const std::string& name : parametersOf(law_, element::Role::reference)) {
    const Eigen::VectorXd changed = walkOf(multiplied(law_, {name}, 0.9));
    const double factor = changed.dot(force_) / force_.squaredNorm();
    EXPECT_LE((changed - factor * force_).cwiseAbs().maxCoeff(), 1e-11 * largest_) << name;
  }
}

TEST_P(Contract, RefiningTheStepConverges) {
  const std::vector<double> reference = forcesOfSmoothMotion(component_, 128);
  const double coarse = rmsDifference(forcesOfSmoothMotion(component_, 1), reference);
  const double fine = rmsDifference(forcesOfSmoothMotion(component_, 8), reference);
  const double negligible = 1e-11 * largest(reference);
  // With an eighth of the step, a first-order error falls to 1/8, plus 1/128 for the error of the reference. It
  // scatters a little, because samples miss the turning points.
  EXPECT_LE(fine, std::max(negligible, 0.2 * coarse)) << "coarse " << coarse;
}

class ExactContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(ExactLaws, ExactContract, typicalElementsThat(isExact), nameOf);

TEST_P(ExactContract, SplittingAStepChangesNothing) {
  component::ComponentState split = component_.makeState();
  RandomMoves moves(9);
  std::vector<double> whole_forces;
  std::vector<double> split_forces;
  for (int i = 0; i < 300; ++i) {
    const double start = state_.displacement();
    const double dt = moves.dt();
    const double end = moves.displacement();
    const double share = moves.share();
    whole_forces.push_back(component_.step(state_, dt, end).total);
    component_.step(split, share * dt, start + share * (end - start));
    split_forces.push_back(component_.step(split, dt - share * dt, end).total);
  }
  // Each step has a rounding error of some 1e-16. Differences over small parts of a step lose two more digits.
  EXPECT_LE(rmsDifference(whole_forces, split_forces), 1e-12 * largest(whole_forces));
}

// A drift is excluded because its loop never closes.
class LinearContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(LinearLaws, LinearContract, typicalElementsThat([](const element::ElementDescription& law) {
                           return linearSubject(law).linear() && law.type != "force_drift";
                         }),
                         nameOf);

TEST_P(LinearContract, SettledSineTendsToComplexStiffness) {
  const component::Component component = linearSubject(GetParam());
  constexpr double kFrequency = 4.0;
  const std::complex<double> expected = *component.complexStiffness(kFrequency);
  const double coarse = std::abs(simulatedStiffness(component, kFrequency, 40) - expected);
  const double fine = std::abs(simulatedStiffness(component, kFrequency, 80) - expected);
  const double negligible = 1e-9 * std::max(1e3, std::abs(expected));
  EXPECT_LE(fine, std::max(negligible, 0.55 * coarse)) << expected;  // first order or better
  EXPECT_LE(fine, std::max(negligible, 0.06 * std::abs(expected)));  // half a step is a phase of pi/80 = 0.04
}

// K* of a dashpot grows without limit. Its own test uses a closed form instead.
class SampledContract : public Contract {};
INSTANTIATE_TEST_SUITE_P(ExactLawsWithFiniteStiffness, SampledContract,
                         typicalElementsThat([](const element::ElementDescription& law) {
                           return isOneOf(law, {"spring", "maxwell", "springpot", "creep", "inertia_track"}) &&
                                  linearSubject(law).linear();
                         }),
                         nameOf);

TEST_P(SampledContract, SettledSineOfAnExactStepIsKnown) {
  for (const double frequency : {0.5, 4.0, 25.0}) {
    const std::complex<double> expected = sampledStiffness(component_, frequency, 24);
    const std::complex<double> simulated = simulatedStiffness(component_, frequency, 24);
    EXPECT_LE(std::abs(simulated - expected), 1e-10 * std::abs(expected)) << frequency << " Hz";
  }
}

TEST_P(Contract, ForcesStayFiniteUnderExtremeSteps) {
  for (const double dt : {1e-9, 1e-3, 1e6}) {
    for (const double z : {1e-15, -1.0, 0.0, 10.0, 1e-3}) {
      const element::ComponentForce force = component_.step(state_, dt, z);
      ASSERT_TRUE(std::isfinite(force.total)) << "dt " << dt << " z " << z;
    }
  }
  for (const double value : state_.memory()) {
    ASSERT_TRUE(std::isfinite(value));
  }
}

}  // namespace
}  // namespace rubber_suspension::test
