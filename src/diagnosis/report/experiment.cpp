// The menu of experiments and the choice among them.
#include "diagnosis/report/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {
namespace {

using Law = std::function<double(double)>;

// From 0 to 1 within a duration, at rest at both ends.
double eased(double t, double duration) {
  return t <= 0.0 ? 0.0 : t >= duration ? 1.0 : 0.5 - 0.5 * std::cos(element::kPi * t / duration);
}

// Steps that resolve the motion; no finer than the logs.
double stepFor(const fit::Excitation& excitation, double frequency) {
  return std::max(excitation.dt, 1.0 / (200.0 * frequency));
}

class Menu {
 public:
  Menu(const fit::Excitation& excitation, const Stroke& stroke) : excitation_(excitation), stroke_(stroke) {
    // The fastest ease of the centre is pi/2 times its mean rate.
    travel_ = stroke.centre == 0.0 ? 0.0 : 0.5 * element::kPi * std::abs(stroke.centre) / excitation.highest_rate;
  }

  /// `motion` about the centre, of that length and eased over `cycle`, both in [s].
  void add(const std::string& description, double length, double cycle, const Law& motion) {
    const double dt = stepFor(excitation_, 1.0 / cycle);
    const double centre = stroke_.centre;
    const double whole = length + 2.0 * travel_;
    Experiment experiment{description + about(), dt, Eigen::VectorXd(static_cast<Eigen::Index>(whole / dt) + 2)};
    for (Eigen::Index i = 0; i < experiment.displacement.size(); ++i) {
      const double t = static_cast<double>(i) * dt - travel_;
      const double ease = std::min(eased(t, cycle), eased(length - t, cycle));
      const double there = std::min(eased(t + travel_, travel_), eased(length + travel_ - t, travel_));
      experiment.displacement[i] = (centre == 0.0 ? 0.0 : centre * there) + (ease > 0.0 ? ease * motion(t) : 0.0);
    }
    menu_.push_back(std::move(experiment));
  }

  std::vector<Experiment> take() { return std::move(menu_); }

 private:
  std::string about() const {
    return stroke_.centre == 0.0 ? "" : fmt::format(", all about {:.3g} mm", 1e3 * stroke_.centre);
  }

  const fit::Excitation& excitation_;
  const Stroke& stroke_;
  double travel_ = 0.0;  // to the centre [s]
  std::vector<Experiment> menu_;
};

void addSines(const fit::Excitation& excitation, const Stroke& stroke, Menu& menu) {
  for (const double part : {0.1, 0.3, 1.0}) {
    for (const double share : {0.1, 0.3, 1.0}) {
      const double frequency = part * excitation.highest_frequency;
      const double amplitude =
          std::min(share * stroke.half, excitation.highest_rate / (2.0 * element::kPi * frequency));
      menu.add(fmt::format("sine at {:.3g} Hz with an amplitude of {:.3g} mm", frequency, 1e3 * amplitude),
               8.0 / frequency, 1.0 / frequency,
               [=](double t) { return amplitude * std::sin(2.0 * element::kPi * frequency * t); });
    }
  }
}

// The fastest sine of full stroke that the rig has shown to be able to run.
double fullStrokeFrequency(const fit::Excitation& excitation, const Stroke& stroke) {
  return std::min(excitation.highest_frequency, excitation.highest_rate / (2.0 * element::kPi * stroke.half));
}

}  // namespace

Stroke strokeOf(double low, double high) {
  constexpr double kSymmetric = 0.05;  // of the half stroke: a zero that nobody set
  const Stroke stroke{0.5 * (low + high), 0.5 * (high - low)};
  return std::abs(stroke.centre) > kSymmetric * stroke.half ? stroke : Stroke{0.0, std::min(-low, high)};
}

std::vector<Experiment> experimentMenu(const fit::Excitation& excitation, const Stroke& stroke) {
  const double z = stroke.half;
  const double frequency = fullStrokeFrequency(excitation, stroke);
  const double omega = 2.0 * element::kPi * frequency;
  const double cycle = 1.0 / frequency;
  Menu menu(excitation, stroke);
  addSines(excitation, stroke, menu);
  menu.add(fmt::format("ramp of {:.3g} s to {:.3g} mm and hold for 60 s", cycle, 500.0 * z), 60.0 + 2.0 * cycle, cycle,
           [=](double) { return 0.5 * z; });
  for (const double side : {1.0, -1.0}) {
    menu.add(fmt::format("preload of {:.3g} mm, then a sine at {:.3g} Hz with {:.3g} mm about it", side * 500.0 * z,
                         frequency, 300.0 * z),
             10.0 * cycle, cycle, [=](double t) {
               const double fade = std::min(eased(t - cycle, cycle), eased(9.0 * cycle - t, cycle));
               return side * 0.5 * z + 0.3 * z * fade * std::sin(omega * t);
             });
  }
  const double phase = 5.0 * cycle;
  menu.add(fmt::format("sine at {:.3g} Hz: 5 cycles with {:.3g} mm, 5 with {:.3g} mm, and 5 with {:.3g} mm again",
                       frequency, 200.0 * z, 1000.0 * z, 200.0 * z),
           3.0 * phase, cycle,
           [=](double t) { return (t >= phase && t < 2.0 * phase ? z : 0.2 * z) * std::sin(omega * t); });
  menu.add(fmt::format("sine at {:.3g} Hz with {:.3g} mm for 5 minutes", frequency, 1000.0 * z), 300.0, cycle,
           [=](double t) { return z * std::sin(omega * t); });
  return menu.take();
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
