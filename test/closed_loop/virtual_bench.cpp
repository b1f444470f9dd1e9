// Draws a virtual bench from a seed, and plays programmes on it.
#include "virtual_bench.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "rubber_suspension/element/constants.h"
#include "rubber_suspension/gap/gap.h"
#include "support/kit.h"

namespace rubber_suspension::closed_loop {
namespace {

constexpr double kStep = 0.004;      // [s]
constexpr double kDuration = 20.0;   // duration of each log before the experiment [s]
constexpr double kStroke = 0.002;    // stroke of the testing machine [m]
constexpr double kFrequency = 12.0;  // highest frequency in any log [Hz]
constexpr double kTwoPi = 2.0 * element::kPi;

using element::ElementDescription;

double eased(double t, double duration) {
  return t <= 0.0 ? 0.0 : t >= duration ? 1.0 : 0.5 - 0.5 * std::cos(element::kPi * t / duration);
}

Programme programmeOf(const std::string& name, double duration, const std::function<double(double)>& law) {
  Programme programme{name, kStep, {}};
  for (int i = 0; i * kStep <= duration; ++i) {
    const double t = i * kStep;
    programme.displacement.push_back(std::min(eased(t, 1.0), eased(duration - t, 1.0)) * law(t));
  }
  return programme;
}

io::ComponentDescription zener(double static_stiffness, double dynamic_stiffness, double break_frequency) {
  return componentOf(fmt::format(
      "components: {{bush: {{model: maxwell, specification: {{static_stiffness: {:f}, dynamic_stiffness: {:f}, "
      "nominal_frequency: 4.0, break_frequency: {:f}}}}}}}",
      static_stiffness, dynamic_stiffness, break_frequency));
}

double standardDeviation(const std::vector<double>& values) {
  return gap::standardDeviation(
      Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size())));
}

constexpr std::size_t kFiner = 8;  // steps of the component per sample of a log

// Interpolates between samples with Catmull-Rom cubics.
std::vector<double> finer(const std::vector<double>& z) {
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < z.size(); ++i) {
    const double before = z[i == 0 ? 0 : i - 1];
    const double after = z[std::min(i + 2, z.size() - 1)];
    for (std::size_t k = 0; k < kFiner; ++k) {
      const double u = static_cast<double>(k) / kFiner;
      result.push_back(z[i] + 0.5 * u *
                                  (z[i + 1] - before +
                                   u * (2.0 * before - 5.0 * z[i] + 4.0 * z[i + 1] - after +
                                        u * (3.0 * (z[i] - z[i + 1]) + after - before))));
    }
  }
  result.push_back(z.back());
  return result;
}

// Returns the force at the samples of a programme. `state` is the state at the first sample.
std::vector<double> forceAtSamples(const component::Component& component, component::ComponentState& state,
                                   const Programme& programme) {
  const std::vector<double> z = finer(programme.displacement);
  std::vector<double> force(z.size() - 1);
  component.simulate(state, programme.dt / kFiner, z.data() + 1, force.size(), force.data());
  std::vector<double> sampled;
  for (std::size_t i = kFiner - 1; i < force.size(); i += kFiner) {
    sampled.push_back(force[i]);
  }
  return sampled;
}

// An effect as an element of a given strength. Where possible, its law differs from the candidate's law.
struct Effect {
  const char* name;
  double strength;  // initial value for the search of the wanted gap
  std::function<ElementDescription(double strength)> at;
};

// Returns a function from a strength to an element, in which a parameter has that value, but at most `most`.
std::function<ElementDescription(double)> one(const char* type, const char* parameter,
                                              const element::ParameterValues& others = {}, double most = HUGE_VAL) {
  return [=](double strength) {
    ElementDescription element{type, others};
    element.values[parameter] = {std::min(strength, most)};
    return element;
  };
}

}  // namespace

VirtualBench::VirtualBench(unsigned seed) : draw_(seed) {
  const double stiffness = 1e6 * uniform(0.7, 1.5);
  const double ratio = uniform(1.15, 1.5);
  const double frequency = uniform(1.5, 6.0);
  const auto wrong = [&] { return uniform(0.97, 1.03); };
  component_ = zener(stiffness * wrong(), ratio * stiffness * wrong(), frequency * wrong());
  limits_.stroke = kStroke;
  limits_.speed = 0.08;
  limits_.frequency = kFrequency;
  limits_.force = 1e3 * stiffness;
  limits_.duration = 60.0;
  addEffect(zener(stiffness, ratio * stiffness, frequency).allElements());
}

void VirtualBench::addEffect(std::vector<ElementDescription> elements) {
  const double k = elements.front().value("stiffness");
  const double shape = uniform(0.0, 1.0);
  const double z = kStroke;
  const std::vector<Effect> effects = {
      {"friction", 0.1 * k * z, [=](double s) { return friction(s, (0.02 + 0.2 * shape) * z); }},
      {"relaxation", 0.2 * k, [=](double s) { return maxwell(s, 0.3 + 8.0 * shape); }},
      {"viscous_damping", 1e-3 * k, dashpot},
      {"progressive_stiffness", 0.2 * k / (z * z), one("progressive_stiffness", "cubic")},
      {"asymmetric_stiffness", 0.2 * k / z, one("asymmetric_stiffness", "quadratic")},
      {"bump_stop", k, one("bump_stop", "stiffness", {{"gap", {(0.45 + 0.4 * shape) * z}}})},
      {"free_play", 0.05 * z, one("free_play", "gap")},
      {"stress_softening", 0.2,
       one("stress_softening", "reduction", {{"width", {0.3 + shape}}, {"path", {4.0 * z}}}, 0.7)},
      {"inertia", 20.0, one("inertia", "mass", {{"bandwidth", {60.0}}})},
      {"time_delay", 0.004, one("time_delay", "delay", {}, 0.03)},
      {"creep", 0.2 * k, [=](double s) { return maxwell(s, 0.006 + 0.01 * shape); }}};
  const Effect& effect = effects[std::uniform_int_distribution<std::size_t>(0, effects.size() - 1)(draw_)];
  effect_ = effect.name;
  // The strength is adjusted to the wanted gap on a sweep of amplitude and frequency within the limits of the machine.
  const Programme probe = programmeOf("probe", kDuration, [&](double t) {
    return z * (0.6 + 0.4 * std::sin(0.5 * t)) * std::sin(kTwoPi * (1.5 * t + 0.06 * t * t));
  });
  const component::Component base(elements);
  const std::vector<double> without = forceOf(base, probe);
  const double wanted = uniform(0.05, 0.15);
  double strength = effect.strength;
  for (int i = 0; i < 6; ++i) {
    std::vector<ElementDescription> all = elements;
    all.push_back(effect.at(strength));
    std::vector<double> difference = forceOf(component::Component(all), probe);
    for (std::size_t j = 0; j < difference.size(); ++j) {
      difference[j] -= without[j];
    }
    strength *= std::clamp(wanted * standardDeviation(without) / standardDeviation(difference), 0.2, 5.0);
  }
  elements.push_back(effect.at(strength));
  true_component_.emplace_back(elements);
  memory_.state = true_component_.front().makeState();
  memory_.noise.seed(std::uniform_int_distribution<unsigned>()(draw_));
  noise_ = uniform(0.003, 0.01) * standardDeviation(without);
}

std::vector<double> VirtualBench::forceOf(const component::Component& component, const Programme& programme) const {
  component::ComponentState state = component.makeState();
  component.initialise(state, programme.displacement.front());
  return forceAtSamples(component, state, programme);
}

Programme VirtualBench::poorProgramme() {
  const double amplitude = kStroke * uniform(0.4, 1.0);
  const double frequency = std::exp(uniform(std::log(0.3), std::log(0.5 * kFrequency)));
  if (uniform(0.0, 1.0) < 0.75) {
    return programmeOf("log", kDuration, [=](double t) { return amplitude * std::sin(kTwoPi * frequency * t); });
  }
  const double slow = uniform(0.1, 0.4);
  return programmeOf("log", kDuration,
                     [=](double t) { return amplitude * 2.0 / element::kPi * std::asin(std::sin(kTwoPi * slow * t)); });
}

Programme VirtualBench::randomProgramme(double duration) {
  constexpr int kLines = 40;
  std::vector<std::array<double, 3>> lines;
  const double highest = std::exp(uniform(std::log(1.0), std::log(kFrequency)));
  for (int i = 0; i < kLines; ++i) {
    const double frequency = uniform(0.1, highest);
    lines.push_back({1.0 / frequency, frequency, uniform(0.0, kTwoPi)});
  }
  Programme programme = programmeOf("random", duration, [&](double t) {
    double sum = 0.0;
    for (const auto& [amplitude, frequency, phase] : lines) {
      sum += amplitude * std::sin(kTwoPi * frequency * t + phase);
    }
    return sum;
  });
  double peak = 0.0;
  double rate = 0.0;
  for (std::size_t i = 1; i < programme.displacement.size(); ++i) {
    peak = std::max(peak, std::abs(programme.displacement[i]));
    rate = std::max(rate, std::abs(programme.displacement[i] - programme.displacement[i - 1]) / kStep);
  }
  const double scale = std::min(uniform(0.3, 1.0) * kStroke / peak, *limits_.speed / rate);
  for (double& displacement : programme.displacement) {
    displacement *= scale;
  }
  return programme;
}

log::Log VirtualBench::play(const Programme& programme) {
  const component::Component& component = true_component_.front();
  log::Log log;
  log.name = programme.name;
  log.displacement = programme.displacement;
  const auto first = memory_.used ? component.relax(memory_.state, programme.displacement[0])
                                  : component.initialise(memory_.state, programme.displacement[0]);
  log.force = forceAtSamples(component, memory_.state, programme);
  log.force.insert(log.force.begin(), first.total);
  memory_.used = true;
  std::normal_distribution<double> normal(0.0, noise_);
  for (std::size_t i = 0; i < log.force.size(); ++i) {
    log.stamp.push_back(static_cast<std::int64_t>(std::llround(1e9 * programme.dt * static_cast<double>(i))));
    log.force[i] += normal(memory_.noise);
  }
  return log;
}

}  // namespace rubber_suspension::closed_loop
