// Computes settled loops: in closed form where there is one, otherwise by simulation until the cycle repeats.
#include "rubber_suspension/response/settled_loop.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>

#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::response {
namespace {

// Returns the largest minus the smallest value.
double extent(const std::vector<double>& values) {
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *high - *low;
}

using ParallelPointer = std::shared_ptr<const element::ParallelElement>;

void checkArguments(double frequency, double amplitude, const LoopOptions& options) {
  if (!(frequency > 0.0) || !std::isfinite(frequency)) {
    throw std::invalid_argument(fmt::format("frequency: {:g} Hz is out of range; accepted: greater than 0", frequency));
  }
  if (!(amplitude > 0.0) || !std::isfinite(amplitude)) {
    throw std::invalid_argument(fmt::format("amplitude: {:g} m is out of range; accepted: greater than 0", amplitude));
  }
  if (!std::isfinite(options.mean)) {
    throw std::invalid_argument(
        fmt::format("mean displacement: {:g} m is not finite; accepted: a finite number", options.mean));
  }
  if (options.samples < 8 || options.samples % 4 != 0) {
    throw std::invalid_argument(fmt::format(
        "samples: {} samples per cycle are not possible; accepted: a multiple of 4, at least 8", options.samples));
  }
}

// Returns the displacement at each sample of a cycle, exact at turning points and zero crossings.
std::vector<double> sineDisplacement(double amplitude, double mean, int samples) {
  std::vector<double> displacement(samples);
  for (int i = 0; i < samples; ++i) {
    displacement[i] = mean - amplitude * std::cos(2.0 * element::kPi * i / samples);
  }
  displacement[0] = mean - amplitude;
  displacement[samples / 2] = mean + amplitude;
  displacement[samples / 4] = displacement[3 * samples / 4] = mean;
  return displacement;
}

double largestChange(const std::vector<double>& before, const std::vector<double>& after) {
  double change = 0.0;
  for (std::size_t i = 0; i < after.size(); ++i) {
    change = std::max(change, std::abs(after[i] - before[i]));
  }
  return change;
}

// Calls `run_cycle`, which writes the forces of the next cycle, until the cycle repeats.
void settle(SettledLoop& loop, const LoopOptions& options, const std::function<void(std::vector<double>&)>& run_cycle) {
  std::vector<double> before(loop.force.size());
  double change_before = 0.0;
  run_cycle(before);
  for (loop.cycles = 1; loop.cycles < options.maximum_cycles;) {
    run_cycle(loop.force);
    ++loop.cycles;
    const double change = largestChange(before, loop.force);
    // Sum of all further changes if they continue the geometric series of the last two; infinite if these did not fall.
    const double rate = change_before > 0.0 ? change / change_before : 1.0;
    const double to_come = change == 0.0 ? 0.0 : rate < 1.0 ? change / (1.0 - rate) : HUGE_VAL;
    // Changes of the size of rounding errors do not follow a geometric series.
    const double range = extent(loop.force);
    const bool rounding = change <= 1e-14 * range;
    loop.remaining = range > 0.0 ? (rounding ? change : to_come) / range : change;
    loop.settled = loop.remaining <= options.tolerance;
    if (loop.settled) {
      return;
    }
    change_before = change;
    before.swap(loop.force);
  }
  loop.force.swap(before);
}

// Returns the laws of a component if all of them act in parallel; otherwise an empty vector.
std::vector<ParallelPointer> parallelLaws(const component::Component& component) {
  std::vector<ParallelPointer> laws;
  for (const element::ElementDescription& description : component.elements()) {
    const element::ElementPointer element = element::makeElement(description);
    if (!std::holds_alternative<ParallelPointer>(element)) {
      return {};
    }
    laws.push_back(std::get<ParallelPointer>(element));
  }
  return laws;
}

// A nonlinear law and its internal state, which starts at the lower turning point.
struct RunningLaw {
  ParallelPointer law;
  std::vector<double> memory;

  RunningLaw(ParallelPointer element, double amplitude, double mean)
      : law(std::move(element)), memory(law->memorySize()) {
    if (const auto* berg = dynamic_cast<const element::BergFriction*>(law.get())) {
      berg->startSettled(amplitude, mean, memory.data());
    } else {
      law->initialise(mean - amplitude, memory.data());
    }
  }
};

// Adds the force of the linear laws, whose loop is an ellipse.
void addEllipse(SettledLoop& loop, std::complex<double> stiffness, double mean) {
  const int samples = static_cast<int>(loop.force.size());
  for (int i = 0; i < samples; ++i) {
    const double phase = 2.0 * element::kPi * i / samples;
    loop.force[i] +=
        stiffness.real() * (loop.displacement[i] - mean) + stiffness.imag() * loop.amplitude * std::sin(phase);
  }
}

void simulateParallel(SettledLoop& loop, const std::vector<ParallelPointer>& laws, const LoopOptions& options) {
  const double omega = 2.0 * element::kPi * loop.frequency;
  std::complex<double> linear = 0.0;
  std::vector<RunningLaw> running;
  for (const ParallelPointer& law : laws) {
    if (const auto stiffness = law->complexStiffness(omega)) {
      linear += *stiffness;
    } else {
      running.emplace_back(law, loop.amplitude, options.mean);
    }
  }
  const double dt = 1.0 / (loop.frequency * options.samples);
  double last = loop.displacement[0];
  const auto runCycle = [&](std::vector<double>& force) {
    for (int i = 1; i <= options.samples; ++i) {
      const double displacement = loop.displacement[i % options.samples];
      const element::Motion motion{dt, displacement, displacement - last};
      double sum = 0.0;
      for (RunningLaw& law : running) {
        sum += law.law->step(motion, law.memory.data());
      }
      force[i % options.samples] = sum;
      last = displacement;
    }
  };
  if (running.empty()) {
    loop.settled = true;
  } else {
    settle(loop, options, runCycle);
  }
  addEllipse(loop, linear, options.mean);
}

void simulateWhole(SettledLoop& loop, const component::Component& component, const LoopOptions& options) {
  const double dt = 1.0 / (loop.frequency * options.samples);
  component::ComponentState state = component.makeState();
  component.initialise(state, loop.displacement[0]);
  settle(loop, options, [&](std::vector<double>& force) {
    for (int i = 1; i <= options.samples; ++i) {
      const int sample = i % options.samples;
      force[sample] = component.step(state, dt, loop.displacement[sample]).total;
    }
  });
}

// Returns the extreme of the parabola through values at the steps 0, 1 and 2, if it lies from step `from` to step `to`.
std::optional<double> vertex(double first, double second, double third, double from, double to) {
  const double curvature = first - 2.0 * second + third;
  const double slope = 0.5 * (third - first);  // slope at the second value
  if (curvature == 0.0) {
    return std::nullopt;
  }
  const double position = 1.0 - slope / curvature;
  return position >= from && position <= to ? std::optional<double>(second - 0.5 * slope * slope / curvature)
                                            : std::nullopt;
}

// Returns the extreme of the force near its extreme sample `at` by fitting a parabola. The force has a corner at a
// turning point. There the parabola uses only the samples on the side on which it has its extreme.
double peak(const std::vector<double>& force, std::size_t at) {
  const std::size_t size = force.size();
  const auto value = [&](std::size_t offset) { return force[(at + size + offset - 2) % size]; };  // offset 2 is `at`
  if (at % (size / 2) != 0) {
    return vertex(value(1), value(2), value(3), 0.0, 2.0).value_or(force[at]);
  }
  const auto before = vertex(value(0), value(1), value(2), 1.0, 2.0);
  return before ? *before : vertex(value(2), value(3), value(4), 0.0, 1.0).value_or(force[at]);
}

}  // namespace

Characteristics SettledLoop::characteristics() const {
  const auto [low, high] = std::minmax_element(force.begin(), force.end());
  const double range = peak(force, high - force.begin()) - peak(force, low - force.begin());
  const double step = 2.0 * element::kPi / static_cast<double>(force.size());
  double loss = 0.0;
  double all = 0.0;
  for (std::size_t i = 0; i < force.size(); ++i) {
    const double part = force[i] * amplitude * std::sin(step * static_cast<double>(i)) * step;
    loss += part;
    all += std::abs(part);
  }
  // A loss below the rounding error of the sum is set to 0.
  const double rounding = std::numeric_limits<double>::epsilon() * static_cast<double>(force.size()) * all;
  loss = std::abs(loss) > rounding ? loss : 0.0;
  if (range == 0.0) {
    return {};  // no force arises, as within free play
  }
  // For Coulomb friction, whose loop is a rectangle, the sine exceeds 1. The loss angle is limited to 90 degrees.
  const double sine = std::clamp(loss / (0.5 * element::kPi * range * amplitude), -1.0, 1.0);
  return {0.5 * range / amplitude, std::asin(sine), loss};
}

SettledLoop simulateSettledLoop(const component::Component& component, double frequency, double amplitude,
                                const LoopOptions& options) {
  checkArguments(frequency, amplitude, options);
  SettledLoop loop;
  loop.frequency = frequency;
  loop.amplitude = amplitude;
  loop.displacement = sineDisplacement(amplitude, options.mean, options.samples);
  loop.force.assign(options.samples, 0.0);
  const std::vector<ParallelPointer> laws = parallelLaws(component);
  if (laws.empty()) {
    simulateWhole(loop, component, options);
  } else {
    simulateParallel(loop, laws, options);
  }
  return loop;
}

}  // namespace rubber_suspension::response
