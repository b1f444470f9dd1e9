// The menu of experiments and the choice among them.
#include "diagnosis/report/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {
namespace {

template <class Law>
Experiment make(const std::string& description, double length, double dt, Law displacement) {
  Experiment experiment{description, dt, Eigen::VectorXd(static_cast<Eigen::Index>(length / dt))};
  for (Eigen::Index i = 0; i < experiment.displacement.size(); ++i) {
    experiment.displacement[i] = displacement(static_cast<double>(i) * dt);
  }
  return experiment;
}

// Steps that resolve the motion; no finer than the logs.
double stepFor(const fit::Excitation& excitation, double frequency) {
  return std::max(excitation.dt, 1.0 / (200.0 * frequency));
}

void addSines(const fit::Excitation& excitation, std::vector<Experiment>& menu) {
  for (const double part : {0.1, 0.3, 1.0}) {
    for (const double share : {0.1, 0.3, 1.0}) {
      const double frequency = part * excitation.highest_frequency;
      const double amplitude =
          std::min(share * excitation.largest_displacement, excitation.highest_rate / (2.0 * element::kPi * frequency));
      menu.push_back(make(fmt::format("sine at {:.3g} Hz with an amplitude of {:.3g} mm", frequency, 1e3 * amplitude),
                          8.0 / frequency, stepFor(excitation, frequency),
                          [=](double t) { return amplitude * std::sin(2.0 * element::kPi * frequency * t); }));
    }
  }
}

// The fastest sine of full stroke that the rig has shown to be able to run.
double fullStrokeFrequency(const fit::Excitation& excitation) {
  return std::min(excitation.highest_frequency,
                  excitation.highest_rate / (2.0 * element::kPi * excitation.largest_displacement));
}

}  // namespace

std::vector<Experiment> experimentMenu(const fit::Excitation& excitation) {
  const double z = excitation.largest_displacement;
  const double frequency = fullStrokeFrequency(excitation);
  const double dt = stepFor(excitation, frequency);
  const double omega = 2.0 * element::kPi * frequency;
  std::vector<Experiment> menu;
  addSines(excitation, menu);
  const double rise = 1.0 / frequency;
  menu.push_back(make(fmt::format("ramp of {:.3g} s to {:.3g} mm and hold for 60 s", rise, 500.0 * z), 60.0 + rise, dt,
                      [=](double t) { return 0.5 * z * std::min(1.0, t / rise); }));
  for (const double side : {1.0, -1.0}) {
    menu.push_back(make(fmt::format("preload of {:.3g} mm, then a sine at {:.3g} Hz with {:.3g} mm about it",
                                    side * 500.0 * z, frequency, 300.0 * z),
                        8.0 / frequency, dt, [=](double t) {
                          return side * 0.5 * z * std::min(1.0, t * frequency) + 0.3 * z * std::sin(omega * t);
                        }));
  }
  const double phase = 5.0 / frequency;
  menu.push_back(make(
      fmt::format("sine at {:.3g} Hz: 5 cycles with {:.3g} mm, 5 with {:.3g} mm, and 5 with {:.3g} mm again", frequency,
                  200.0 * z, 1000.0 * z, 200.0 * z),
      3.0 * phase, dt, [=](double t) { return (t >= phase && t < 2.0 * phase ? z : 0.2 * z) * std::sin(omega * t); }));
  menu.push_back(make(fmt::format("sine at {:.3g} Hz with {:.3g} mm for 5 minutes", frequency, 1000.0 * z), 300.0, dt,
                      [=](double t) { return z * std::sin(omega * t); }));
  return menu;
}

Discrimination mostTelling(const std::vector<Experiment>& menu, const std::vector<element::ElementDescription>& one,
                           const std::vector<element::ElementDescription>& other, double noise) {
  const component::Component first(one);
  const component::Component second(other);
  Discrimination best;
  for (const Experiment& experiment : menu) {
    component::ComponentState a = first.makeState();
    component::ComponentState b = second.makeState();
    first.initialise(a, experiment.displacement[0]);
    second.initialise(b, experiment.displacement[0]);
    double sum = 0.0;
    for (Eigen::Index i = 1; i < experiment.displacement.size(); ++i) {
      const double z = experiment.displacement[i];
      sum += std::pow(first.step(a, experiment.dt, z).total - second.step(b, experiment.dt, z).total, 2);
    }
    const double difference = std::sqrt(sum / static_cast<double>(experiment.displacement.size())) / noise;
    if (std::isfinite(difference) && difference > best.difference) {
      best = {&experiment, difference};
    }
  }
  return best;
}

}  // namespace rubber_suspension::diagnosis
