// Constructs the motions of the menu.
#include "diagnosis/experiment/menu.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <utility>

#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::diagnosis::experiment {
namespace {

constexpr double kTwoPi = 2.0 * element::kPi;
constexpr double kWithin = 1.0 - 1e-6;        // fraction of a bound that is used, so that rounding does not exceed it
constexpr double kMostSamplesOfMotion = 1e5;  // longer motions are sampled with a multiple of the time step
constexpr double kCyclesOfMotion = 40.0;  // largest number of cycles; a fit to some of them has to predict the others
constexpr double kFewestCycles = 6.0;
constexpr double kPerPeriod = 40.0;  // samples per period of the highest frequency that a comparison of models needs

using Law = std::function<double(double)>;

// Returns 0 before t = 0 and 1 after `duration`; in between, the value rises smoothly.
double eased(double t, double duration) {
  return t <= 0.0 ? 0.0 : t >= duration ? 1.0 : 0.5 - 0.5 * std::cos(element::kPi * t / duration);
}

double triangle(double t) { return 2.0 / element::kPi * std::asin(std::sin(kTwoPi * t)); }

// What defines a motion of the menu.
struct Shape {
  std::string kind;
  double length;      // [s]
  double ease;        // duration of the smooth start and of the smooth end [s]
  double frequency;   // highest frequency that the time steps have to resolve [Hz]
  double share;       // fraction of the half stroke that the peak reaches, unless the speed limits it
  Law law;            // displacement as a function of time [s]; its amplitude is scaled
  std::string words;  // description; each # is replaced by the peak [mm] times one of `parts`
  std::vector<double> parts = {1.0};
};

std::string described(const Shape& shape, double peak) {
  std::string text = shape.words;
  for (const double part : shape.parts) {
    text.replace(text.find('#'), 1, fmt::format("{:.3g}", 1e3 * part * peak));
  }
  return text;
}

class Menu {
 public:
  explicit Menu(const Bounds& bounds)
      : bounds_(bounds),
        // The largest rate of a smooth start is pi/2 times its mean rate.
        travel_(0.5 * element::kPi * std::abs(bounds.stroke.centre) / bounds.speed / kWithin),
        room_(bounds.duration - 2.0 * travel_) {}

  std::vector<Experiment> take() {
    if (room_ > 0.0) {
      findFrequencies();
      addSines();
      addTwoSines();
      addSweeps();
      addMultisines();
      addHolds();
      addTriangles();
      addPreloads();
      addAmplitudes();
      addRepeats();
    }
    return std::move(menu_);
  }

 private:
  void findFrequencies() {
    constexpr double kFewCycles = 5.0;
    // At a corner, the rate jumps between two samples, so that a force that depends on the rate is late by part of a
    // sample. With this number of samples per cycle, the lag is at most one percent of a cycle.
    constexpr double kSamplesOfTriangle = 400.0;
    highest_ = bounds_.frequency;
    full_ = std::min(highest_, bounds_.speed / (kTwoPi * bounds_.stroke.half));
    lowest_ = std::min(kFewCycles / room_, full_);
    corner_ = 1.0 / (kSamplesOfTriangle * bounds_.dt);
  }

  // Adds a motion, unless it takes longer than the permitted duration or its samples would be too far apart.
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
    menu_.push_back({shape.kind, described(shape, amplitude) + about(), dt,
                     amplitude / peak * motion + bounds_.stroke.centre * there, stride});
  }

  std::string about() const {
    return bounds_.stroke.centre == 0.0 ? "" : fmt::format(", all about {:.3g} mm", 1e3 * bounds_.stroke.centre);
  }

  // Returns the wanted number of cycles, or fewer if the duration limits it. Returns 0 if these are too few.
  double cyclesWithin(double frequency, double wanted) const {
    const double cycles = std::min(wanted, std::floor(0.95 * room_ * frequency));
    return cycles < kFewestCycles ? 0.0 : cycles;
  }

  void addSines() {
    for (const double part : {0.03, 0.1, 0.3, 1.0}) {
      for (const double share : {0.1, 0.3, 1.0}) {
        const double frequency = part * highest_;
        add({"sine", cyclesWithin(frequency, kCyclesOfMotion) / frequency, 1.0 / frequency, frequency, share,
             [=](double t) { return std::sin(kTwoPi * frequency * t); },
             fmt::format("sine at {:.3g} Hz with an amplitude of # mm", frequency)});
      }
    }
  }

  // Adds a motion of two sines of full stroke, one after the other. The second has the highest frequency that the speed
  // allows, and the first a quarter of it. Effects of the displacement alone are equal in both sines.
  void addTwoSines() {
    constexpr double kApart = 4.0;
    const double slow = full_ / kApart;
    const double half = 0.5 * std::min(0.95 * room_, kCyclesOfMotion / slow);
    const auto burst = [=](double t, double frequency) {
      return std::min(eased(t, 1.0 / frequency), eased(half - t, 1.0 / frequency)) * std::sin(kTwoPi * frequency * t);
    };
    add({"two sines", half * slow < kFewestCycles ? 0.0 : 2.0 * half, 1.0 / slow, full_, 1.0,
         [=](double t) { return burst(t, slow) + burst(t - half, full_); },
         fmt::format("sines with an amplitude of # mm, {:.3g} s at {:.3g} Hz and {:.3g} s at {:.3g} Hz", half, slow,
                     half, full_)});
  }

  // Adds a logarithmic sweep of constant amplitude up to the frequency `full_`, and of constant speed above it.
  void addSweeps() {
    const double length = 0.95 * room_;
    const double rise = std::log(highest_ / lowest_) / length;
    if (!(rise > 0.0)) {
      return;
    }
    const std::string words = fmt::format("sweep from {:.3g} to {:.3g} Hz within {:.3g} s with an amplitude of # mm",
                                          lowest_, highest_, length);
    const auto phase = [=](double t) { return kTwoPi * lowest_ * (std::exp(rise * t) - 1.0) / rise; };
    for (const double share : {0.1, 0.4}) {
      add({"sweep", length, 1.0 / lowest_, highest_, share, [=](double t) { return std::sin(phase(t)); }, words});
    }
    add({"sweep", length, 1.0 / lowest_, highest_, 1.0,
         [=](double t) { return std::min(1.0, full_ / (lowest_ * std::exp(rise * t))) * std::sin(phase(t)); },
         words + fmt::format(" up to {:.3g} Hz and at constant speed above this frequency", full_)});
  }

  // Adds multisines with odd or even harmonics of equal speed, and with phases that keep the peak low (Schroeder).
  void addMultisines() {
    constexpr int kLines = 8;
    for (const int first : {1, 2}) {
      const double base = highest_ / (first + 2.0 * (kLines - 1));
      for (const double share : {0.2, 1.0}) {
        add({"multisine", cyclesWithin(base, 0.5 * kCyclesOfMotion) / base, 1.0 / base, highest_, share,
             [=](double t) {
               double sum = 0.0;
               for (int i = 0; i < kLines; ++i) {
                 const double line = first + 2.0 * i;
                 sum += std::sin(kTwoPi * line * base * t - element::kPi * i * (i + 1.0) / kLines) / line;
               }
               return sum;
             },
             fmt::format("multisine of the {} multiples of {:.3g} Hz up to {:.3g} Hz with a peak of # mm",
                         first == 1 ? "odd" : "even", base, highest_)});
      }
    }
  }

  // Adds a staircase through the stroke, and a single step that is held.
  void addHolds() {
    static constexpr std::array<double, 8> kLevels = {0.5, 1.0, 0.5, 0.0, -0.5, -1.0, -0.5, 0.0};
    const double length = 0.95 * room_;
    const double cycle = 1.0 / full_;
    const double hold = length / static_cast<double>(kLevels.size());
    add({"steps",
         length,
         cycle,
         full_,
         1.0,
         [=](double t) {
           const auto level = std::min(kLevels.size() - 1, static_cast<std::size_t>(std::max(0.0, t / hold)));
           const double before = level == 0 ? 0.0 : kLevels[level - 1];
           return before + (kLevels[level] - before) * eased(t - hold * static_cast<double>(level), cycle);
         },
         fmt::format("steps to # mm, # mm and back, then in the same way to the other side; each step takes {:.3g} s, "
                     "and each level is held for {:.3g} s",
                     cycle, hold - cycle),
         {0.5, 1.0}});
    add({"hold", length, cycle, full_, 0.5, [](double /*t*/) { return 1.0; },
         fmt::format("ramp of {:.3g} s to # mm, then hold for {:.3g} s", cycle, length - 2.0 * cycle)});
  }

  void addTriangles() {
    for (const double part : {0.1, 1.0}) {
      for (const double share : {0.2, 1.0}) {
        const double frequency = part * std::min(full_, corner_);
        add({"triangle", cyclesWithin(frequency, kCyclesOfMotion) / frequency, 1.0 / frequency, full_, share,
             [=](double t) { return triangle(frequency * t); },
             fmt::format("triangle at {:.3g} Hz with an amplitude of # mm", frequency)});
      }
    }
  }

  void addPreloads() {
    const double cycle = 1.0 / full_;
    const double omega = kTwoPi * full_;
    const double cycles = cyclesWithin(full_, kCyclesOfMotion);
    for (const double side : {1.0, -1.0}) {
      add({"preload",
           cycles * cycle,
           cycle,
           full_,
           0.8,
           [=](double t) {
             const double fade = std::min(eased(t - cycle, cycle), eased((cycles - 1.0) * cycle - t, cycle));
             return side * 0.5 + 0.3 * fade * std::sin(omega * t);
           },
           fmt::format("preload of # mm, then a sine at {:.3g} Hz with an amplitude of # mm about this preload", full_),
           {side / 1.6, 0.6 / 1.6}});
    }
  }

  // Adds sines of several amplitudes one after the other, at the highest frequency of a sine of full stroke.
  void addAmplitudes() {
    const double omega = kTwoPi * full_;
    const double cycles = std::floor(cyclesWithin(full_, kCyclesOfMotion) / 3.0);  // cycles of each amplitude
    const double phase = cycles / full_;
    const auto addParts = [&](const std::string& kind, const std::vector<double>& part) {
      add({kind, 3.0 * phase, 1.0 / full_, full_, 1.0,
           [=](double t) {
             const double second = (part[1] - part[0]) * eased(t - phase, 1.0 / full_);
             const double third = (part[2] - part[1]) * eased(t - 2.0 * phase, 1.0 / full_);
             return (part[0] + second + third) * std::sin(omega * t);
           },
           fmt::format("sine at {:.3g} Hz: {:.0f} cycles each with amplitudes of # mm, # mm and # mm", full_, cycles),
           part});
    };
    addParts("small amplitude after a large one", {0.2, 1.0, 0.2});
    addParts("amplitudes", {0.1, 0.3, 1.0});
    addParts("amplitudes", {1.0, 0.3, 0.1});
  }

  // Adds sines of full stroke: repeated after a rest, between two rests, and without a rest.
  void addRepeats() {
    const double omega = kTwoPi * full_;
    const double cycle = 1.0 / full_;
    const double part = 5.0 * cycle;
    const double length = 0.95 * room_;
    const double standing = 0.5 * (length - part);
    const auto burst = [=](double t) {
      return std::min(eased(t, cycle), eased(part - t, cycle)) * std::sin(omega * t);
    };
    add({"repeat", 4.0 * part, cycle, full_, 1.0, [=](double t) { return burst(t) + burst(t - 3.0 * part); },
         fmt::format("5 cycles at {:.3g} Hz with an amplitude of # mm, a rest of {:.3g} s, and the same cycles again",
                     full_, 2.0 * part)});
    add({"standstill", standing > cycle ? length : 0.0, cycle, full_, 1.0,
         [=](double t) { return burst(t - standing); },
         fmt::format(
             "rest of {:.3g} s at 0, 5 cycles at {:.3g} Hz with an amplitude of # mm, and rest of {:.3g} s at 0",
             standing, full_, standing)});
    add({"long sine", length, cycle, full_, 1.0, [=](double t) { return std::sin(omega * t); },
         fmt::format("sine at {:.3g} Hz with an amplitude of # mm for {:.3g} s", full_, length)});
  }

  const Bounds& bounds_;
  double travel_;         // duration of the motion to the centre [s]
  double room_;           // time available for a motion about the centre [s]
  double highest_ = 0.0;  // highest frequency of the motions [Hz]
  double full_ = 0.0;     // highest frequency of a sine of full stroke [Hz]
  double lowest_ = 0.0;   // lowest frequency of which several cycles take no longer than `room_` [Hz]
  double corner_ = 0.0;   // highest frequency of a triangle [Hz]
  std::vector<Experiment> menu_;
};

}  // namespace

std::vector<Experiment> experimentMenu(const Bounds& bounds) {
  if (!(bounds.stroke.half > 0.0 && bounds.speed > 0.0 && bounds.frequency > 0.0 && bounds.dt > 0.0)) {
    return {};
  }
  return Menu(bounds).take();
}

}  // namespace rubber_suspension::diagnosis::experiment
