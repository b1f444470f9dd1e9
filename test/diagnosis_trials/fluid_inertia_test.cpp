// Hydraulic mounts whose law differs from the candidate's law, and benches without fluid that resemble them.
#include <deque>
#include <iostream>

#include "diagnosis/rig.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "support/test.h"

namespace rubber_suspension {
namespace {

constexpr double kAmplitude = 2e-3;  // largest displacement [m]
constexpr double kStep = 0.004;      // time step of the logs [s]
constexpr int kParts = 16;           // substeps per sample, with linear displacement

/// A fluid column with linear and quadratic damping in a chamber that stiffens.
struct Column {
  double stiffness = 0.0;   ///< of the chamber, at small pressure [N/m]
  double resonance = 0.0;   ///< [rad/s]
  double laminar = 0.0;     ///< damping ratio of the linear part
  double turbulent = 0.0;   ///< damping ratio of the quadratic part, at a resonance of 1 mm
  double stiffening = 0.0;  ///< stiffness added to the chamber at the largest displacement, relative
};

RigEffect fluidOf(const Column& column) {
  return [column, q = 0.0, rate = 0.0, last = 0.0](double time, double z, double /*rate*/) mutable {
    const auto chamber = [&](double x) { return x * (1.0 + column.stiffening * std::pow(x / kAmplitude, 2)); };
    const double w = column.resonance;
    if (time == 0.0) {
      last = q = z;
      rate = 0.0;
    }
    constexpr double kPart = kStep / kParts;
    for (int part = 1; part <= kParts; ++part) {
      const double moved = last + (z - last) * part / kParts;
      const double damping = 2.0 * w * (column.laminar + column.turbulent * std::abs(rate) / (w * 1e-3));
      rate = (rate + kPart * w * w * chamber(moved - q)) / (1.0 + kPart * damping);
      q += kPart * rate;
    }
    last = z;
    return column.stiffness * chamber(z - q);
  };
}

/// Draws a mount with a turbulent track, a stiffening chamber, both, or two tracks of different length.
RigEffect drawMount(int number) {
  std::mt19937 generator(static_cast<unsigned>(number));
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(generator);
  };
  const int kind = number % 4;
  Column column{between(3e5, 7e5), 2.0 * element::kPi * between(2.5, 5.0), between(0.15, 0.35), 0.0, 0.0};
  if (kind == 0 || kind == 2) {
    column.laminar *= 0.5;
    column.turbulent = between(0.05, 0.2);
  }
  if (kind == 1 || kind == 2) {  // stiffening by a third at the resonance, so that the chamber does not jump
    column.laminar = between(0.25, 0.4);
    column.stiffening = between(0.02, 0.06);
  }
  Column second = column;
  second.resonance *= between(1.3, 1.8);
  if (kind != 3) {
    return fluidOf(column);
  }
  return [one = fluidOf(column), two = fluidOf(second)](double time, double z, double rate) {
    return 0.6 * one(time, z, rate) + 0.4 * two(time, z, rate);
  };
}

RigEffect mass(double of) {
  return [of, last = 0.0](double time, double /*z*/, double rate) mutable {
    const double acceleration = time == 0.0 ? 0.0 : (rate - last) / kStep;
    last = rate;
    return of * acceleration;
  };
}

RigEffect dahl(double limit) {  // Dahl friction with exponent 1.5
  return ofSteps([limit, force = 0.0](double step) mutable {
    const double left = std::max(0.0, 1.0 - std::copysign(1.0, step) * force / limit);
    return force = std::clamp(force + 1e6 * step * std::pow(left, 1.5), -limit, limit);
  });
}

/// Returns relaxation from 0.05 to 50 Hz. Its stiffness is a power of the frequency.
RigEffect relaxation(double stiffness) {
  return ofSteps([stiffness, forces = std::array<double, 10>{}](double step) mutable {
    double sum = 0.0;
    for (std::size_t i = 0; i < forces.size(); ++i) {
      const double frequency = 0.05 * std::pow(10.0, static_cast<double>(i) / 3.0);
      forces[i] = (forces[i] + step) * std::exp(-2.0 * element::kPi * frequency * kStep);
      sum += stiffness * std::pow(frequency, 0.3) * forces[i];
    }
    return sum;
  });
}

/// Returns a viscous flow that large forces accelerate.
RigEffect eyring(double stiffness) {
  return ofSteps([stiffness, x = 0.0](double step) mutable {
    x += step - kStep * 6.0 * 3e-4 * std::sinh(x / 3e-4);
    return stiffness * x;
  });
}

/// Returns the force of the rig's component, recorded some samples late.
RigEffect late(int samples) {
  return [=, past = std::deque<double>()](double time, double z, double /*rate*/) mutable {
    if (time == 0.0) {
      past.assign(static_cast<std::size_t>(samples), 0.0);
    }
    past.push_back(z);
    const double before = past.front();
    past.pop_front();
    return 1.2e6 * (before - z);
  };
}

/// Returns an effect of a bench without fluid, in one of three sizes.
RigEffect without(int number) {
  const double size = std::array{0.4, 1.0, 2.0}[static_cast<std::size_t>(number / 10)];
  const std::vector<RigEffect> kinds = {
      nothing,
      dahl(200.0 * size),
      [=](double, double, double rate) { return 4.7e4 * size * rate * std::abs(rate); },
      mass(150.0 * size),
      relaxation(2e5 * size),
      [=](double, double z, double) { return 300.0 * size * std::sinh(z / 1e-3); },
      [=](double, double z, double) { return 1.5e6 * size * std::pow(std::max(0.0, z - 1.2e-3) / 1e-3, 1.5); },
      late(1 + static_cast<int>(size)),
      [=](double, double z, double rate) { return size * (1.5e5 * z + 2e3 * rate); },
      eyring(4e5 * size)};
  return kinds[static_cast<std::size_t>(number % 10)];
}

/// Diagnoses two logs. More logs would narrow the intervals, but give the same names.
diagnosis::Diagnosis diagnosisOf(unsigned number, const RigEffect& effect) {
  return diagnosis::diagnose(rigComponent(), runRigs({2 * number, 2 * number + 1}, effect), {});
}

TEST(FluidInertia, IsNamedFirstWhereTheLawOfTheMountIsAnother) {
  constexpr int kBenches = 10;
  int named = 0;
  for (int i = 0; i < kBenches; ++i) {
    const diagnosis::Diagnosis result = diagnosisOf(static_cast<unsigned>(i), drawMount(i));
    const bool first = !result.answer.effects.empty() && result.answer.effects.front() == "fluid_inertia";
    named += first ? 1 : 0;
    EXPECT_GT(result.gaps.unseen.as_configured, 0.03) << i << ": there is something to be found";
    if (!first) {
      std::cout << i << ": " << result.sentence << std::endl;
    }
  }
  EXPECT_GE(named, 9);
}

// An orifice with quadratic loss is one track. Intervals and the semi-implicit steps of the bench allow errors of 5 %,
// and of a third in the small linear damping. The sentence states both interpretations of the file.
TEST(FluidInertia, OfQuadraticLossIsOneTrack) {
  const Column orifice{5e5, 2.0 * element::kPi * 4.0, 0.05, 0.15, 0.0};
  const double mass = orifice.stiffness / std::pow(orifice.resonance, 2);
  const std::vector<log::Log> logs = runRigs({1, 2}, fluidOf(orifice));
  io::ComponentDescription component = rigComponent();
  const diagnosis::Diagnosis result = diagnosis::diagnose(component, logs, {});
  ASSERT_EQ(result.answer.effects, std::vector<std::string>{"fluid_inertia"}) << result.sentence;
  EXPECT_EQ(result.answer.verdict, diagnosis::Verdict::named) << result.sentence;
  EXPECT_NE(result.sentence.find("fluid_inertia (a fluid track, or a mass on a spring such as the fixture: "),
            std::string::npos)
      << result.sentence;
  ASSERT_EQ(result.law.augmented.add.size(), 1U);
  const element::ElementDescription& track = result.law.augmented.add.front();
  ASSERT_EQ(track.type, "inertia_track");
  EXPECT_NEAR(track.value("mass") / mass, 1.0, 0.05);
  EXPECT_NEAR(track.value("stiffness") / orifice.stiffness, 1.0, 0.05);
  EXPECT_NEAR(track.value("quadratic_damping") / (2.0 * mass * orifice.turbulent / 1e-3), 1.0, 0.05);
  EXPECT_NEAR(track.value("damping") / (2.0 * mass * orifice.laminar * orifice.resonance), 1.0, 0.33);
  component.holds_fluid = true;
  EXPECT_EQ(diagnosis::diagnose(component, logs, {}).sentence.find("fixture"), std::string::npos);
}

// The test draws one bench of each kind. One bench in thirty may be named by chance.
TEST(FluidInertia, IsNamedOnHardlyABenchWithoutIt) {
  constexpr int kBenches = 10;
  int named = 0;
  for (int i = 0; i < kBenches; ++i) {
    const diagnosis::Diagnosis result = diagnosisOf(static_cast<unsigned>(100 + i), without(i));
    if (std::count(result.answer.effects.begin(), result.answer.effects.end(), "fluid_inertia") > 0) {
      ++named;
      std::cout << i << ": " << result.sentence << std::endl;
    }
  }
  EXPECT_EQ(named, 0);
}

}  // namespace
}  // namespace rubber_suspension
