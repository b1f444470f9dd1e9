// The menu of motions.
#include "diagnosis/experiment/menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis {
namespace {

constexpr double kTwoPi = 2.0 * element::kPi;
constexpr double kWithin = 1.0 - 1e-6;        // of a bound, so that rounding does not exceed it
constexpr double kMostSamplesOfMotion = 1e5;  // beyond, every second or third step of the bench will do
constexpr double kCyclesOfMotion =
    40.0;                            // of a motion, where there is room: a fit to part of it has to predict the rest
constexpr double kPerPeriod = 40.0;  // samples of the highest frequency by which models are compared

using Law = std::function<double(double)>;
using Words = std::function<std::string(double millimetres)>;

// From 0 to 1 within a duration, at rest at both ends.
double eased(double t, double duration) {
  return t <= 0.0 ? 0.0 : t >= duration ? 1.0 : 0.5 - 0.5 * std::cos(element::kPi * t / duration);
}

// A triangle of amplitude 1 and period 1 that begins at 0.
double triangle(double t) { return 2.0 / element::kPi * std::asin(std::sin(kTwoPi * t)); }

// The parts of a motion of the menu.
struct Shape {
  std::string kind;
  double length;     // [s]
  double ease;       // at its beginning and at its end [s]
  double frequency;  // highest that the steps have to resolve [Hz]
  double share;      // of the half stroke that its peak should reach, as far as the speed allows
  Law law;           // of time [s], of any amplitude
  Words words;       // of the peak that it has [mm]
};

class Menu {
 public:
  explicit Menu(const Bounds& bounds) : bounds_(bounds) {
    // The fastest ease of the centre is pi/2 times its mean rate.
    travel_ = 0.5 * element::kPi * std::abs(bounds.stroke.centre) / bounds.speed / kWithin;
  }

  /// The time left for a motion about the centre [s].
  double room() const { return bounds_.duration - 2.0 * travel_; }

  /// Left out where it takes longer than there is room.
  void add(const Shape& shape) {
    const double whole = shape.length + 2.0 * travel_;
    const double dt = bounds_.dt * std::max(1.0, std::ceil(whole / (kMostSamplesOfMotion * bounds_.dt)));
    const bool too_coarse = dt > bounds_.dt && dt > 1.0 / (kPerPeriod * shape.frequency);
    if (!(shape.length > 0.0) || whole > bounds_.duration - 2.0 * dt || too_coarse) {
      return;
    }
    const auto size = static_cast<Eigen::Index>(whole / dt) + 2;
    Eigen::VectorXd motion(size);
    Eigen::VectorXd there(size);
    for (Eigen::Index i = 0; i < size; ++i) {
      const double t = static_cast<double>(i) * dt - travel_;
      const double ease = std::min(eased(t, shape.ease), eased(shape.length - t, shape.ease));
      motion[i] = ease > 0.0 ? ease * shape.law(t) : 0.0;
      there[i] = bounds_.stroke.centre == 0.0
                     ? 0.0
                     : std::min(eased(t + travel_, travel_), eased(shape.length + travel_ - t, travel_));
    }
    const double peak = motion.cwiseAbs().maxCoeff();
    const double rate = (motion.tail(size - 1) - motion.head(size - 1)).cwiseAbs().maxCoeff() / dt;
    if (!(peak > 0.0)) {
      return;
    }
    const auto stride = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(1.0 / (kPerPeriod * shape.frequency * dt)));
    const double amplitude =
        std::min(kWithin * shape.share * bounds_.stroke.half, kWithin * bounds_.speed / rate * peak);
    menu_.push_back({shape.kind, shape.words(1e3 * amplitude) + about(), dt,
                     amplitude / peak * motion + bounds_.stroke.centre * there, stride});
  }

  std::vector<Experiment> take() { return std::move(menu_); }

 private:
  std::string about() const {
    return bounds_.stroke.centre == 0.0 ? "" : fmt::format(", all about {:.3g} mm", 1e3 * bounds_.stroke.centre);
  }

  const Bounds& bounds_;
  double travel_ = 0.0;  // to the centre [s]
  std::vector<Experiment> menu_;
};

// Frequencies that the motions of a menu are made of [Hz].
struct Frequencies {
  double highest;
  double full;    // the highest sine of full stroke
  double lowest;  // of which some cycles fit in
  double corner;  // the highest triangle
};

Frequencies frequenciesOf(const Bounds& bounds, double room) {
  constexpr double kFewCycles = 5.0;
  const double full = std::min(bounds.frequency, bounds.speed / (kTwoPi * bounds.stroke.half));
  // At a corner the rate jumps between two samples, so that a force by the rate seems late by a part of one: of a cycle
  // of so many samples a percent is spoilt.
  constexpr double kSamplesOfTriangle = 400.0;
  return {bounds.frequency, full, std::min(kFewCycles / room, full), 1.0 / (kSamplesOfTriangle * bounds.dt)};
}

// So many cycles, or as many as there is room for; 0 where these are fewer than tell anything.
double cyclesWithin(double room, double frequency, double wanted) {
  constexpr double kFewest = 6.0;
  const double cycles = std::min(wanted, std::floor(0.95 * room * frequency));
  return cycles < kFewest ? 0.0 : cycles;
}

void addSines(const Frequencies& f, double room, Menu& menu) {
  for (const double part : {0.03, 0.1, 0.3, 1.0}) {
    for (const double share : {0.1, 0.3, 1.0}) {
      const double frequency = part * f.highest;
      menu.add({"sine", cyclesWithin(room, frequency, kCyclesOfMotion) / frequency, 1.0 / frequency, frequency, share,
                [=](double t) { return std::sin(kTwoPi * frequency * t); },
                [=](double peak) {
                  return fmt::format("sine at {:.3g} Hz with an amplitude of {:.3g} mm", frequency, peak);
                }});
    }
  }
}

// Logarithmic in frequency, of one amplitude or, above the fastest sine of full stroke, of one speed.
void addSweeps(const Frequencies& f, double room, Menu& menu) {
  const double length = 0.95 * room;
  const double rise = std::log(f.highest / f.lowest) / length;
  if (!(rise > 0.0)) {
    return;
  }
  const auto phase = [=](double t) { return kTwoPi * f.lowest * (std::exp(rise * t) - 1.0) / rise; };
  for (const double share : {0.1, 0.4}) {
    menu.add({"sweep", length, 1.0 / f.lowest, f.highest, share, [=](double t) { return std::sin(phase(t)); },
              [=](double peak) {
                return fmt::format("sweep from {:.3g} to {:.3g} Hz within {:.3g} s with {:.3g} mm", f.lowest, f.highest,
                                   length, peak);
              }});
  }
  menu.add({"sweep", length, 1.0 / f.lowest, f.highest, 1.0,
            [=](double t) {
              const double now = f.lowest * std::exp(rise * t);
              return std::min(1.0, f.full / now) * std::sin(phase(t));
            },
            [=](double peak) {
              return fmt::format(
                  "sweep from {:.3g} to {:.3g} Hz within {:.3g} s with {:.3g} mm up to {:.3g} Hz and at "
                  "the same speed above",
                  f.lowest, f.highest, length, peak, f.full);
            }});
}

// Lines of an odd or an even multiple of one frequency, of equal speed, with phases that keep the peaks low
// (Schroeder).
void addMultisines(const Frequencies& f, double room, Menu& menu) {
  constexpr int kLines = 8;
  for (const int first : {1, 2}) {
    const double base = f.highest / (first + 2.0 * (kLines - 1));
    for (const double share : {0.2, 1.0}) {
      menu.add({"multisine", cyclesWithin(room, base, 0.5 * kCyclesOfMotion) / base, 1.0 / base, f.highest, share,
                [=](double t) {
                  double sum = 0.0;
                  for (int i = 0; i < kLines; ++i) {
                    const double line = first + 2.0 * i;
                    sum += std::sin(kTwoPi * line * base * t - element::kPi * i * (i + 1.0) / kLines) / line;
                  }
                  return sum;
                },
                [=](double peak) {
                  return fmt::format(
                      "multisine of the {} multiples of {:.3g} Hz up to {:.3g} Hz with a peak of {:.3g} mm",
                      first == 1 ? "odd" : "even", base, f.highest, peak);
                }});
    }
  }
}

// A staircase through the stroke, and one step that is held.
void addHolds(const Frequencies& f, double room, Menu& menu) {
  static constexpr std::array<double, 8> kLevels = {0.5, 1.0, 0.5, 0.0, -0.5, -1.0, -0.5, 0.0};
  const double cycle = 1.0 / f.full;
  const double hold = 0.95 * room / static_cast<double>(kLevels.size());
  menu.add({"steps", 0.95 * room, cycle, f.full, 1.0,
            [=](double t) {
              const auto level = std::min(kLevels.size() - 1, static_cast<std::size_t>(std::max(0.0, t / hold)));
              const double before = level == 0 ? 0.0 : kLevels[level - 1];
              return before + (kLevels[level] - before) * eased(t - hold * static_cast<double>(level), cycle);
            },
            [=](double peak) {
              return fmt::format(
                  "steps of {:.3g} s to {:.3g} mm, {:.3g} mm and back, and the same to the other side, "
                  "each held for {:.3g} s",
                  cycle, 0.5 * peak, peak, hold - cycle);
            }});
  menu.add({"hold", 0.95 * room, cycle, f.full, 0.5, [](double /*t*/) { return 1.0; },
            [=](double peak) {
              return fmt::format("ramp of {:.3g} s to {:.3g} mm and hold for {:.3g} s", cycle, peak,
                                 0.95 * room - 2.0 * cycle);
            }});
}

void addTriangles(const Frequencies& f, double room, Menu& menu) {
  for (const double part : {0.1, 1.0}) {
    for (const double share : {0.2, 1.0}) {
      const double frequency = part * std::min(f.full, f.corner);
      menu.add({"triangle", cyclesWithin(room, frequency, kCyclesOfMotion) / frequency, 1.0 / frequency, f.full, share,
                [=](double t) { return triangle(frequency * t); },
                [=](double peak) {
                  return fmt::format("triangle at {:.3g} Hz with an amplitude of {:.3g} mm", frequency, peak);
                }});
    }
  }
}

void addPreloads(const Frequencies& f, double room, Menu& menu) {
  const double cycle = 1.0 / f.full;
  const double omega = kTwoPi * f.full;
  const double cycles = cyclesWithin(room, f.full, kCyclesOfMotion);
  for (const double side : {1.0, -1.0}) {
    menu.add({"preload", cycles * cycle, cycle, f.full, 0.8,
              [=](double t) {
                const double fade = std::min(eased(t - cycle, cycle), eased((cycles - 1.0) * cycle - t, cycle));
                return side * 0.5 + 0.3 * fade * std::sin(omega * t);
              },
              [=](double peak) {
                return fmt::format("preload of {:.3g} mm, then a sine at {:.3g} Hz with {:.3g} mm about it",
                                   side * peak / 1.6, f.full, 0.6 * peak / 1.6);
              }});
  }
}

// Amplitudes one after the other, at the fastest sine of full stroke.
void addAmplitudes(const Frequencies& f, double room, Menu& menu) {
  const double omega = kTwoPi * f.full;
  const double cycles = std::floor(cyclesWithin(room, f.full, kCyclesOfMotion) / 3.0);  // of each amplitude
  const double phase = cycles / f.full;
  const auto add = [&](const std::string& kind, const std::array<double, 3>& part) {
    menu.add({kind, 3.0 * phase, 1.0 / f.full, f.full, 1.0,
              [=](double t) {
                const double second = (part[1] - part[0]) * eased(t - phase, 1.0 / f.full);
                const double third = (part[2] - part[1]) * eased(t - 2.0 * phase, 1.0 / f.full);
                return (part[0] + second + third) * std::sin(omega * t);
              },
              [=](double peak) {
                return fmt::format(
                    "sine at {:.3g} Hz: {:.0f} cycles with {:.3g} mm, as many with {:.3g} mm, and with {:.3g} mm",
                    f.full, cycles, part[0] * peak, part[1] * peak, part[2] * peak);
              }});
  };
  add("small after large", {0.2, 1.0, 0.2});
  add("amplitudes", {0.1, 0.3, 1.0});
  add("amplitudes", {1.0, 0.3, 0.1});
}

// Motion of full stroke that is repeated after a rest, that continues, and that stands between rests.
void addRepeats(const Frequencies& f, double room, Menu& menu) {
  const double omega = kTwoPi * f.full;
  const double cycle = 1.0 / f.full;
  const double part = 5.0 * cycle;
  const auto burst = [=](double t) { return std::min(eased(t, cycle), eased(part - t, cycle)) * std::sin(omega * t); };
  menu.add({"repeat", 4.0 * part, cycle, f.full, 1.0, [=](double t) { return burst(t) + burst(t - 3.0 * part); },
            [=](double peak) {
              return fmt::format("5 cycles at {:.3g} Hz with {:.3g} mm, a rest of {:.3g} s, and the same again", f.full,
                                 peak, 2.0 * part);
            }});
  const double standing = 0.475 * room - 0.5 * part;
  menu.add({"standstill", standing > cycle ? 0.95 * room : 0.0, cycle, f.full, 1.0,
            [=](double t) { return burst(t - standing); },
            [=](double peak) {
              return fmt::format("{:.3g} s at 0, 5 cycles at {:.3g} Hz with {:.3g} mm, and {:.3g} s at 0", standing,
                                 f.full, peak, standing);
            }});
  menu.add({"long sine", 0.95 * room, cycle, f.full, 1.0, [=](double t) { return std::sin(omega * t); },
            [=](double peak) {
              return fmt::format("sine at {:.3g} Hz with {:.3g} mm for {:.3g} s", f.full, peak, 0.95 * room);
            }});
}

}  // namespace

std::vector<Experiment> experimentMenu(const Bounds& bounds) {
  if (!(bounds.stroke.half > 0.0 && bounds.speed > 0.0 && bounds.frequency > 0.0 && bounds.dt > 0.0)) {
    return {};
  }
  Menu menu(bounds);
  const double room = menu.room();
  if (!(room > 0.0)) {
    return {};
  }
  const Frequencies f = frequenciesOf(bounds, room);
  addSines(f, room, menu);
  addSweeps(f, room, menu);
  addMultisines(f, room, menu);
  addHolds(f, room, menu);
  addTriangles(f, room, menu);
  addPreloads(f, room, menu);
  addAmplitudes(f, room, menu);
  addRepeats(f, room, menu);
  return menu.take();
}

}  // namespace rubber_suspension::diagnosis
