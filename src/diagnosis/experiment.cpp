// The menu of experiments and the choice among them.
#include "rubber_suspension/diagnosis/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "rubber_suspension/component/component.h"

namespace rubber_suspension {
namespace {

constexpr double kLength = 10.0;  // [s] of an experiment
constexpr double kPi = 3.14159265358979323846;

template <class Law>
Experiment make(const std::string& description, double length, double dt, Law displacement) {
  Experiment experiment{description, dt, Eigen::VectorXd(static_cast<Eigen::Index>(length / dt))};
  for (Eigen::Index i = 0; i < experiment.displacement.size(); ++i) {
    experiment.displacement[i] = displacement(static_cast<double>(i) * dt);
  }
  return experiment;
}

void addSines(double z, double highest, double dt, std::vector<Experiment>& menu) {
  for (const double frequency : {0.1, 0.5, 2.0, 0.5 * highest, highest}) {
    for (const double share : {0.1, 0.3, 1.0}) {
      if (frequency > highest) {
        continue;
      }
      // Fast motion with the full stroke is beyond most test benches: the rate of a 2 Hz sine with full stroke is
      // allowed.
      const double amplitude = share * z * std::min(1.0, 2.0 / frequency);
      menu.push_back(make(fmt::format("sine at {:.3g} Hz with an amplitude of {:.3g} mm", frequency, 1e3 * amplitude),
                          std::max(kLength, 3.0 / frequency), dt,
                          [=](double t) { return amplitude * std::sin(2.0 * kPi * frequency * t); }));
    }
  }
}

}  // namespace

std::vector<Experiment> experimentMenu(double largest_displacement, double highest_frequency, double dt) {
  const double z = largest_displacement;
  std::vector<Experiment> menu;
  addSines(z, highest_frequency, dt, menu);
  menu.push_back(make(fmt::format("ramp of 0.2 s to {:.3g} mm and hold for 60 s", 500.0 * z), 60.0, dt,
                      [=](double t) { return 0.5 * z * std::min(1.0, t / 0.2); }));
  for (const double side : {1.0, -1.0}) {
    menu.push_back(make(
        fmt::format("preload of {:.3g} mm, then a sine at 1 Hz with {:.3g} mm about it", side * 500.0 * z, 300.0 * z),
        kLength, dt, [=](double t) { return side * 0.5 * z * std::min(1.0, t) + 0.3 * z * std::sin(2.0 * kPi * t); }));
  }
  menu.push_back(make(fmt::format("sine at 1 Hz: 5 s with {:.3g} mm, 5 s with {:.3g} mm, and 5 s with {:.3g} mm again",
                                  200.0 * z, 1000.0 * z, 200.0 * z),
                      15.0, dt,
                      [=](double t) { return (t >= 5.0 && t < 10.0 ? z : 0.2 * z) * std::sin(2.0 * kPi * t); }));
  menu.push_back(make(fmt::format("sine at 2 Hz with {:.3g} mm for 5 minutes", 700.0 * z), 300.0, 2.0 * dt,
                      [=](double t) { return 0.7 * z * std::sin(4.0 * kPi * t); }));
  return menu;
}

Discrimination mostTelling(const std::vector<Experiment>& menu, const std::vector<ElementDescription>& one,
                           const std::vector<ElementDescription>& other, double noise) {
  const Component first(one);
  const Component second(other);
  Discrimination best;
  for (const Experiment& experiment : menu) {
    ComponentState a = first.makeState();
    ComponentState b = second.makeState();
    first.rest(a, experiment.displacement[0]);
    second.rest(b, experiment.displacement[0]);
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

}  // namespace rubber_suspension
