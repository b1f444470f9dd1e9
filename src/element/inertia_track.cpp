// Hydraulic mount with an inertia track.
#include "rubber_suspension/element/inertia_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <stdexcept>

#include "element/registry.h"
#include "rubber_suspension/element/relaxation.h"

namespace rubber_suspension::element {
namespace {

constexpr double kRadiansBetweenTurns = 3.0;  // shorter than half a period
constexpr double kMostParts = 4096.0;
// Longest part of a split step: its angle at the resonance [rad] plus c_2 |dq/dt| dt/m.
constexpr double kSplit = 0.25;
constexpr double kMostTurned = 4.0;       // angle of a step above which no further parts are added [rad]
constexpr double kPastTurn = 1.0 + 1e-9;  // factor on the time of a turn, so that a part ends just after the turn
constexpr double kEdgeTolerance = 1e-15;  // error of the time of an edge, divided by the length of the part
constexpr int kMostStepsToEdge = 50;      // bisection needs as many steps
constexpr int kMostStops = 64;  // limit within one part, against endless loops if rounding makes edges coincide

// Contains exp(-a t) times cos(w t), sin(w t)/w and 1 - cos(w t), where w^2 = square - a^2, or the corresponding
// hyperbolic functions if w^2 is negative.
struct Oscillation {
  double cosine;
  double sine;     // exp(-a t) sin(w t)/w [s]
  double missing;  // exp(-a t) (1 - cos(w t))

  Oscillation(double decay, double square, double t) {
    const double difference = square - decay * decay;
    const double w = std::sqrt(std::abs(difference));
    const double damped = std::exp(-decay * t);
    if (difference > 0.0) {
      const double half = std::sin(0.5 * w * t);
      missing = 2.0 * damped * half * half;
      cosine = damped - missing;
      sine = damped * (w * t > 0.0 ? 2.0 * half * std::cos(0.5 * w * t) / w : t);
      return;
    }
    // exp(-a t) cosh(w t), computed from the slower of the two exponentials, which does not overflow.
    const double slow = std::exp(-square / (decay + w) * t);
    const double fall = -std::expm1(-2.0 * w * t);
    cosine = slow * (1.0 - 0.5 * fall);
    sine = w * t > 0.0 ? 0.5 * slow * fall / w : damped * t;
    const double half = 0.5 * w * t < 1.0 ? std::sinh(0.5 * w * t) : 0.0;
    missing = half > 0.0 ? -2.0 * damped * half * half : damped - cosine;
  }
};

// Coefficients of InertiaTrack::coupled() for one step length.
struct OverStep {
  double decay = 0.0;
  double square = 0.0;
  double dt = 0.0;
  double sine = 0.0;
  double kept = 0.0;
  double slowed = 0.0;
  double lost = 0.0;  // 1 - kept
  double after_velocity = 0.0;

  OverStep() = default;
  OverStep(double of_decay, double of_square, double over) : decay(of_decay), square(of_square), dt(over) {
    const Oscillation oscillation(decay, square, dt);
    sine = oscillation.sine;
    kept = oscillation.cosine + decay * sine;
    slowed = oscillation.cosine - decay * sine;
    lost = -std::expm1(-decay * dt) + oscillation.missing - decay * sine;
    after_velocity = sine + 2.0 * decay * lost / square;
  }
};

std::uint64_t bitsOf(double value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  return bits;
}

// Most steps have the same length as the step before, so each thread keeps the coefficients in a hash table.
const OverStep& overStep(double decay, double square, double dt) {
  constexpr std::uint64_t kPlaces = 512;
  constexpr std::uint64_t kSpread = 0x9E3779B97F4A7C15;  // for multiplicative hashing (Knuth)
  constexpr unsigned kBelowPlaces = 55;
  thread_local std::array<OverStep, kPlaces> kept;
  const std::uint64_t mixed = ((bitsOf(decay) * kSpread + bitsOf(square)) * kSpread + bitsOf(dt)) * kSpread;
  const std::uint64_t place = mixed >> kBelowPlaces;
  for (const std::uint64_t at : {place, place ^ 1U}) {
    if (kept[at].dt == dt && kept[at].decay == decay && kept[at].square == square) {
      return kept[at];
    }
  }
  kept[place ^ 1U] = kept[place];  // because two tracks may alternately use the same place
  return kept[place] = OverStep(decay, square, dt);
}

}  // namespace

InertiaTrack::InertiaTrack(double mass, double damping, double stiffness, double free_travel, double quadratic_damping)
    : mass_(mass),
      damping_(damping),
      stiffness_(stiffness),
      free_travel_(free_travel),
      decay_(0.5 * damping / mass),
      square_(stiffness / mass),
      brake_(quadratic_damping / mass) {}

// Solves de/dt = v - p, dp/dt = square e - 2 a p for a constant velocity v, by the matrix exponential and its integral.
InertiaTrack::Flow InertiaTrack::coupled(Flow flow, double dt, double velocity) const {
  const OverStep& over = overStep(decay_, square_, dt);
  return {over.kept * flow.deflection - over.sine * flow.rate + over.after_velocity * velocity,
          square_ * over.sine * flow.deflection + over.slowed * flow.rate + over.lost * velocity};
}

InertiaTrack::Flow InertiaTrack::free(Flow flow, double dt, double velocity) const {
  const Relaxation slowed = Relaxation::over(2.0 * decay_ * dt);
  return {flow.deflection + dt * (velocity - flow.rate * slowed.mean), flow.rate * slowed.decay};
}

// Advances within one piece of the force: -1 or 1 beyond the dead zone, 0 inside it.
InertiaTrack::Flow InertiaTrack::along(int piece, Flow flow, double dt, double velocity) const {
  if (piece == 0) {
    return free(flow, dt, velocity);
  }
  const double edge = piece * free_travel_;
  const Flow after = coupled({flow.deflection - edge, flow.rate}, dt, velocity);
  return {after.deflection + edge, after.rate};
}

// Returns the piece that contains the deflection or, on an edge, the piece that the motion enters.
int InertiaTrack::pieceOf(Flow flow, double velocity) const {
  const double beyond = std::abs(flow.deflection) - free_travel_;
  const double side = std::copysign(1.0, flow.deflection);
  return beyond > 0.0 || (beyond == 0.0 && side * (velocity - flow.rate) > 0.0) ? static_cast<int>(side) : 0;
}

bool InertiaTrack::isIn(int piece, double deflection) const {
  return piece == 0 ? std::abs(deflection) <= free_travel_ : piece * deflection >= free_travel_;
}

// Returns the time at which the deflection reverses, if it has reversed by the time dt. Beyond the dead zone its
// velocity u obeys u'' + 2 a u' + square u = 0, so that half a period contains at most one reversal. Inside the dead
// zone, the deflection reverses when the decaying rate of the fluid equals the velocity.
double InertiaTrack::timeOfTurn(int piece, Flow flow, double dt, double velocity) const {
  double time = std::log(flow.rate / velocity) / (2.0 * decay_);
  if (piece != 0) {
    const double speed = velocity - flow.rate;
    const double slope =
        square_ * (piece * free_travel_ - flow.deflection) + decay_ * (velocity + flow.rate);  // u' + a u
    const double difference = square_ - decay_ * decay_;
    const double w = std::sqrt(std::abs(difference));
    const double straight = -speed / slope;
    time = difference > 0.0 ? std::atan2(std::abs(speed) * w, -std::copysign(1.0, speed) * slope) / w
           : w > 0.0        ? std::atanh(w * straight) / w
                            : straight;
  }
  return time > 0.0 && time < dt ? std::min(dt, kPastTurn * time) : dt;
}

// Returns the time of an edge that the motion passes before dt without a reversal. Newton's method starts at dt; a step
// that leaves the interval is replaced by bisection.
double InertiaTrack::timeOfEdge(int piece, double edge, Flow flow, double dt, double velocity) const {
  double before = 0.0;
  double after = dt;
  double at = dt;
  for (int step = 0; step < kMostStepsToEdge && after - before > kEdgeTolerance * dt; ++step) {
    const Flow then = along(piece, flow, at, velocity);
    (isIn(piece, then.deflection) ? before : after) = at;
    const double moved = (then.deflection - edge) / (then.rate - velocity);
    const double next = at + moved;
    if (std::abs(moved) <= kEdgeTolerance * dt) {
      return std::clamp(next, before, after);
    }
    at = next > before && next < after ? next : 0.5 * (before + after);
  }
  return after;
}

// Advances in parts that end at edges of the dead zone and at reversals of the deflection.
void InertiaTrack::followDecoupled(Flow& flow, double dt, double velocity) const {
  for (int stop = 0; dt > 0.0; ++stop) {
    const int piece = pieceOf(flow, velocity);
    double part = dt;
    Flow end = along(piece, flow, part, velocity);
    if (stop < kMostStops && (velocity - flow.rate) * (velocity - end.rate) < 0.0) {
      part = timeOfTurn(piece, flow, dt, velocity);
      end = along(piece, flow, part, velocity);
    }
    if (stop < kMostStops && !isIn(piece, end.deflection)) {
      const double edge = std::copysign(free_travel_, piece == 0 ? end.deflection : piece);
      part = timeOfEdge(piece, edge, flow, part, velocity);
      end = {edge, along(piece, flow, part, velocity).rate};
    }
    flow = end;
    dt -= part;
  }
}

// Returns the number of parts into which a step is split, which is 1 if a single step is exact.
double InertiaTrack::partsOf(double rate, double dt, double velocity) const {
  const double turned = dt * std::sqrt(square_);
  const double braked = dt * brake_ * std::max(std::abs(rate), std::abs(velocity));
  // Steps of several radians are used for motion far below the resonance, where the quadratic loss is negligible.
  const double parts = brake_ > 0.0         ? (std::min(turned, kMostTurned) + braked) / kSplit
                       : free_travel_ > 0.0 ? turned / kRadiansBetweenTurns
                                            : 1.0;
  return std::clamp(std::ceil(parts), 1.0, kMostParts);
}

// Solves dp/dt = -(c_2/m) |p| p.
void InertiaTrack::brake(Flow& flow, double dt) const {
  if (brake_ > 0.0) {
    flow.rate /= 1.0 + brake_ * std::abs(flow.rate) * dt;
  }
}

double InertiaTrack::step(const Motion& motion, double* memory) const {
  Flow flow{memory[kDeflection], memory[kRate]};
  const double velocity = motion.increment / motion.dt;
  const double parts = partsOf(flow.rate, motion.dt, velocity);
  const double dt = motion.dt / parts;
  for (double part = 0.0; part < parts; part += 1.0) {
    brake(flow, 0.5 * dt);
    if (free_travel_ == 0.0) {
      flow = coupled(flow, dt, velocity);
    } else {
      followDecoupled(flow, dt, velocity);
    }
    brake(flow, 0.5 * dt);
  }
  memory[kDeflection] = flow.deflection;
  memory[kRate] = flow.rate;
  return stiffness_ * (flow.deflection - std::clamp(flow.deflection, -free_travel_, free_travel_));
}

std::optional<std::complex<double>> InertiaTrack::complexStiffness(double omega) const {
  if (free_travel_ > 0.0 || brake_ > 0.0) {
    return std::nullopt;
  }
  const std::complex<double> column(-mass_ * omega * omega, damping_ * omega);
  return stiffness_ * column / (column + stiffness_);
}

namespace {

constexpr std::array<const char*, 3> kMechanical = {"mass", "damping", "stiffness"};
constexpr std::array<const char*, 4> kFluid = {"inertance", "resistance", "compliance", "pumping_area"};

template <class Names>
std::size_t given(const ElementDescription& description, const Names& names) {
  return static_cast<std::size_t>(
      std::count_if(names.begin(), names.end(), [&](const char* name) { return description.value(name) > 0.0; }));
}

ElementPointer makeInertiaTrack(const ElementDescription& description) {
  const auto value = [&](const char* name) { return description.value(name); };
  const std::size_t mechanical = given(description, kMechanical);
  const std::size_t fluid = given(description, kFluid);
  const bool any_mechanical = mechanical > 0 || value("quadratic_damping") > 0.0;
  const bool any_fluid = fluid > 0 || value("quadratic_resistance") > 0.0;
  const double area = value("pumping_area");
  if (mechanical == kMechanical.size() && !any_fluid) {
    return std::make_shared<const InertiaTrack>(value("mass"), value("damping"), value("stiffness"),
                                                value("free_travel"), value("quadratic_damping"));
  }

  if (fluid == kFluid.size() && !any_mechanical) {
    return std::make_shared<const InertiaTrack>(value("inertance") * area * area, value("resistance") * area * area,
                                                area * area / value("compliance"), value("free_travel"),
                                                value("quadratic_resistance") * area * area * area);
  }
  throw std::invalid_argument(
      fmt::format("{}: {}; accepted: all of {}, optionally with quadratic_damping, or all of {}, optionally with "
                  "quadratic_resistance, each greater than 0",
                  description.type,
                  any_mechanical && any_fluid ? "mechanical and fluid parameters are mixed" : "parameters are missing",
                  fmt::join(kMechanical, ", "), fmt::join(kFluid, ", ")));
}

ElementType inertiaTrackType() {
  const Range range = Range::nonNegative();
  return {"inertia_track",
          "Fluid in a hydraulic mount, m d2q/dt2 + c dq/dt + c_2 |dq/dt| dq/dt = F, F = k_h (z - q), described with "
          "mass, damping and stiffness or with the quantities of the fluid; 0: not given.",
          {{"mass", "kg", Role::shape, range, "mass m of the column, referred to the pumping area", 0.0},
           {"damping", "N s/m", Role::shape, range, "damping c of the track, referred to the pumping area", 0.0},
           {"stiffness", "N/m", Role::shape, range, "bulge stiffness k_h of the upper chamber", 0.0},
           {"inertance", "kg/m^4", Role::shape, range, "inertance I of the track, m = I A_p^2", 0.0},
           {"resistance", "Pa s/m^3", Role::shape, range, "resistance R of the track, c = R A_p^2", 0.0},
           {"compliance", "m^3/Pa", Role::shape, range, "compliance C of the upper chamber, k_h = A_p^2/C", 0.0},
           {"pumping_area", "m^2", Role::reference, range, "effective piston area A_p of the rubber", 0.0},
           {"free_travel", "m", Role::shape, range, "free travel d of a decoupler to either side; 0: none", 0.0},
           {"quadratic_damping", "N s^2/m^2", Role::shape, range, "damping c_2 that multiplies the squared rate", 0.0},
           {"quadratic_resistance", "Pa s^2/m^6", Role::shape, range,
            "resistance R_2 that multiplies the squared flow, c_2 = R_2 A_p^3", 0.0}},
          makeInertiaTrack};
}

const ElementEntry kInertiaTrackEntry(220, inertiaTrackType());

}  // namespace
}  // namespace rubber_suspension::element
