// Laws that depend on the radius in two or three directions.
#include "component/radial_coupling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <string>

#include "element/position_table.h"
#include "rubber_suspension/element/berg_friction.h"
#include "rubber_suspension/element/iwan.h"
#include "rubber_suspension/element/maxwell.h"

namespace rubber_suspension::component {
namespace {

constexpr double kSameToRounding = 1e-9;

// Berg's friction has no radial form. A slider bank with the same numbers has one, but behaves differently.
[[noreturn]] void refuseBerg(const element::BergFriction& berg) {
  const double amplitude = berg.displacement();
  double force = 0.0;
  double loss = 0.0;
  for (const element::JenkinsSlider& slider :
       element::iwanSliders(berg.maximumForce(), berg.displacement(), 16 /* the default of iwan */)) {
    const double beyond = std::max(amplitude - slider.yield_displacement, 0.0);
    force += slider.stiffness * std::min(amplitude, slider.yield_displacement);
    loss += 4.0 * slider.maximumForce() * beyond;
  }
  throw std::invalid_argument(
      fmt::format("friction (Berg) cannot act along the radius of coupled directions; accepted: {{type: iwan, "
                  "maximum_force: {:g}, displacement: {:g}}}, whose settled loop at an amplitude of {:g} has {:.3g} "
                  "times the stiffness of this friction and {:.3g} times its loss",
                  berg.maximumForce(), berg.displacement(), amplitude, force / berg.settledForce(amplitude),
                  loss / berg.settledLoss(amplitude)));
}

constexpr const char* kStopType = "bump_stop";
constexpr std::size_t kVector = 3;

using ElementList = std::vector<element::ElementDescription>;

// Elements sorted by their treatment in the coupling.
struct SortedElements {
  ElementList along;  // treated separately in each direction
  ElementList elastic;
  ElementList scaled;
  ElementList friction;
};

ElementList& listFor(const element::ElementDescription& description, SortedElements& sorted) {
  static const std::map<std::string, ElementList SortedElements::*> lists = {
      {"spring", &SortedElements::along},
      {"maxwell", &SortedElements::along},
      {"dashpot", &SortedElements::along},
      {"springpot", &SortedElements::along},
      {"spring_table", &SortedElements::elastic},
      {kStopType, &SortedElements::elastic},
      {"radial_stiffness", &SortedElements::elastic},
      {"maxwell_along_curve", &SortedElements::scaled},
      {"dashpot_along_curve", &SortedElements::scaled},
      {"iwan", &SortedElements::friction},
      {"iwan_table", &SortedElements::friction},
  };
  const element::ElementPointer element = element::makeElement(description);
  if (const auto found = lists.find(description.type); found != lists.end()) {
    return sorted.*found->second;
  }
  if (const auto* berg = dynamic_cast<const element::BergFriction*>(element::parallelLaw(element))) {
    refuseBerg(*berg);
  }
  throw std::invalid_argument(fmt::format(
      "{} cannot act along the radius of coupled directions; accepted: spring, static_curve or spring_table, maxwell, "
      "dashpot, springpot, iwan, iwan_table, bump_stop, radial_stiffness; or coupling: rectangular",
      description.type));
}

SortedElements sort(const std::vector<element::ElementDescription>& elements) {
  SortedElements sorted;
  for (const element::ElementDescription& element : elements) {
    const element::ElementDescription description = element::complete(element);
    listFor(description, sorted).push_back(description);
  }
  return sorted;
}

// Returns the force [N] of an elastic law, which depends only on the displacement.
double forceAt(const element::ElementPointer& law, double displacement) {
  return element::parallelLaw(law)->initialise(displacement, nullptr);
}

std::vector<element::JenkinsSlider> slidersOf(const element::ElementDescription& friction) {
  const element::ElementPointer element = element::makeElement(friction);
  return dynamic_cast<const element::SliderBank&>(*parallelLaw(element)).sliders();
}

}  // namespace

void RadialLaw::addCurve(const element::ElementDescription& table) {
  if (hasCurve()) {
    throw std::invalid_argument(
        "there is a second static curve or spring_table; accepted: one curve or table for all coupled directions");
  }
  const std::vector<double>& displacement = table.list("displacement");
  const element::ElementPointer law = element::makeElement(
      {table.type, {{"displacement", displacement}, {"force", table.list("force")}, {"monotone", {0.0}}}});
  double largest = 0.0;
  for (const double force : table.list("force")) {
    largest = std::max(largest, std::abs(force));
  }
  const bool both_sides = displacement.front() < 0.0;
  for (const double z : displacement) {
    if (both_sides && std::abs(forceAt(law, z) + forceAt(law, -z)) > kSameToRounding * largest) {
      throw std::invalid_argument(
          fmt::format("the static curve has the force {:g} at {:g} and {:g} at {:g}, but both displacements are the "
                      "same radius; accepted: an odd curve, or points at displacements from 0 on",
                      forceAt(law, z), z, forceAt(law, -z), -z));
    }
  }
  if (std::abs(forceAt(law, 0.0)) > kSameToRounding * largest) {
    throw std::invalid_argument(fmt::format(
        "the static curve has the force {:g} at 0, where the radius has no direction; accepted: the force 0 at 0",
        forceAt(law, 0.0)));
  }
  points_.push_back({0.0, 0.0, 0.0, 0.0});
  for (const double z : displacement) {
    if (z > 0.0) {
      points_.push_back({z, forceAt(law, z), 0.0, 0.0});
    }
  }
  for (std::size_t i = 0; i + 1 < points_.size(); ++i) {
    const double width = points_[i + 1].radius - points_[i].radius;
    points_[i].slope = (points_[i + 1].force - points_[i].force) / width;
    points_[i + 1].energy = points_[i].energy + 0.5 * (points_[i].force + points_[i + 1].force) * width;
  }
  // The table continues beyond its last point, even if its force becomes negative.
  const double beyond = points_.back().radius + std::max(points_.back().radius, 1.0);
  points_.back().slope = (forceAt(law, beyond) - points_.back().force) / (beyond - points_.back().radius);
}

void RadialLaw::addStop(const element::ElementDescription& stop) {
  if (stop.value("side") < 0.0) {
    throw std::invalid_argument("bump_stop.side: is -1, but a radius is never negative; accepted: 0 or 1");
  }
  element::ElementDescription of_radius = stop;
  of_radius.values["side"] = {0.0};
  stops_.push_back({element::makeElement(of_radius), stop.value("gap"), stop.value("exponent")});
}

void RadialLaw::addStiffening(const element::ElementDescription& radial) {
  stiffenings_.push_back(element::radialLaws({radial}).front());
}

const RadialLaw::Point& RadialLaw::pointBefore(double r) const {
  const auto after = std::upper_bound(points_.begin() + 1, points_.end(), r,
                                      [](double value, const Point& point) { return value < point.radius; });
  return *(after - 1);
}

double RadialLaw::curve(double r) const {
  if (points_.empty()) {
    return 0.0;
  }
  const Point& point = pointBefore(r);
  return point.force + point.slope * (r - point.radius);
}

double RadialLaw::curveEnergy(double r) const {
  if (points_.empty()) {
    return 0.0;
  }
  const Point& point = pointBefore(r);
  const double beyond = r - point.radius;
  return point.energy + beyond * (point.force + 0.5 * point.slope * beyond);
}

double RadialLaw::force(double r) const {
  double sum = curve(r);
  for (const Stop& stop : stops_) {
    sum += forceAt(stop.law, r);
  }
  for (const element::RadialStiffness& law : stiffenings_) {
    sum += law.alongRadius(r);
  }
  return sum;
}

double RadialLaw::own(double displacement) const {
  double sum = 0.0;
  for (const element::RadialStiffness& law : stiffenings_) {
    sum += law.own(displacement);
  }
  return sum;
}

double RadialLaw::energy(double r) const {
  double sum = curveEnergy(r);
  for (const Stop& stop : stops_) {
    sum += forceAt(stop.law, r) * (r - stop.gap) / (stop.exponent + 1.0);
  }
  for (const element::RadialStiffness& law : stiffenings_) {
    sum += law.energy(r);
  }
  return sum;
}

double RadialLaw::ratioOf(const element::ElementDescription& entry, const std::string& values) const {
  const element::PositionTable table(entry.type, entry.list("displacement"), values, entry.list(values));
  if (!hasCurve()) {
    throw std::invalid_argument(
        fmt::format("{}.{} has no curve to follow; accepted: a static_curve or spring_table in addition, or maxwell "
                    "and dashpot instead",
                    entry.type, values));
  }
  double ratio = 0.0;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const double end = i + 1 < points_.size() ? points_[i + 1].radius : 2.0 * points_[i].radius + 1.0;
    for (const double share : {0.25, 0.75}) {
      const double r = points_[i].radius + share * (end - points_[i].radius);
      const double here = table.at(r) / points_[i].slope;
      ratio = i == 0 && share == 0.25 ? here : ratio;
      if (!(here > 0.0 && std::abs(here - ratio) <= kSameToRounding * ratio)) {
        throw std::invalid_argument(
            fmt::format("{}.{} is not proportional to the slope of the static curve at {:g}; accepted: the values that "
                        "scale_with: static_curve computes",
                        entry.type, values, r));
      }
    }
  }
  return ratio;
}

void RadialLaw::appendRadii(std::vector<double>& radii) const {
  for (std::size_t i = 1; i < points_.size(); ++i) {
    radii.push_back(points_[i].radius);
  }
}

RadialCoupling::RadialCoupling(std::vector<Direction> directions, SixElements& elements)
    : directions_(std::move(directions)) {
  SortedElements first;
  for (std::size_t axis = 0; axis < directions_.size(); ++axis) {
    const Direction direction = directions_[axis];
    try {
      SortedElements sorted = sort(elements[direction]);
      first = axis == 0 ? sorted : first;
      takeElastic(axis, sorted.elastic);
      takeScaled(axis, sorted.scaled);
      one_law_ = one_law_ && sorted.elastic == first.elastic;
      if (sorted.friction != first.friction) {
        throw std::invalid_argument(fmt::format(
            "its friction differs from the friction of {}; accepted: the same friction in both coupled directions",
            toString(directions_.front())));
      }
      elements[direction] = std::move(sorted.along);
    } catch (const std::invalid_argument& error) {
      throw std::invalid_argument(fmt::format("{}: {}", toString(direction), error.what()));
    }
  }
  for (const element::ElementDescription& friction : first.friction) {
    const std::vector<element::JenkinsSlider> bank = slidersOf(friction);
    sliders_.insert(sliders_.end(), bank.begin(), bank.end());
  }
  std::sort(radii_.begin(), radii_.end());
  radii_.erase(std::unique(radii_.begin(), radii_.end()), radii_.end());
}

void RadialCoupling::takeElastic(std::size_t axis, const std::vector<element::ElementDescription>& elastic) {
  for (const element::ElementDescription& element : elastic) {
    element.type == kStopType    ? laws_[axis].addStop(element)
    : element::isRadial(element) ? laws_[axis].addStiffening(element)
                                 : laws_[axis].addCurve(element);
  }
  elastic_ = elastic_ || !laws_[axis].empty();
  laws_[axis].appendRadii(radii_);
}

void RadialCoupling::takeScaled(std::size_t axis, const std::vector<element::ElementDescription>& scaled) {
  for (const element::ElementDescription& element : scaled) {
    follows_ = true;
    if (element.values.count("damping") != 0) {
      damping_ratio_[static_cast<Eigen::Index>(axis)] += laws_[axis].ratioOf(element, "damping");
    } else {
      const double rate = element::Maxwell(1.0, element.value("break_frequency")).rate();
      branches_[axis].push_back({laws_[axis].ratioOf(element, "stiffness"), rate});
      ++branch_count_;
    }
  }
}

Eigen::Vector3d RadialCoupling::vectorOf(const Coordinates& coordinates) const {
  Eigen::Vector3d vector = Eigen::Vector3d::Zero();
  for (std::size_t axis = 0; axis < directions_.size(); ++axis) {
    vector[static_cast<Eigen::Index>(axis)] = coordinates[directions_[axis]];
  }
  return vector;
}

// Returns the gradient of U = sum c_i^2 U_i(r) with c = d/r: F_j = c_j (sum c_i^2 F_i + 2 (U_j - U)/r).
Eigen::Vector3d RadialCoupling::elasticForce(const Eigen::Vector3d& d, bool with_stops) const {
  const double r = d.norm();
  if (r == 0.0) {
    return Eigen::Vector3d::Zero();
  }
  const auto force = [&](const RadialLaw& law) { return with_stops ? law.force(r) : law.curve(r); };
  if (one_law_) {
    return force(laws_.front()) / r * d;
  }
  const Eigen::Vector3d c = d / r;
  const Eigen::Vector3d share = c.cwiseAbs2();
  Eigen::Vector3d forces = Eigen::Vector3d::Zero();
  Eigen::Vector3d energies = Eigen::Vector3d::Zero();
  for (std::size_t axis = 0; axis < directions_.size(); ++axis) {
    forces[static_cast<Eigen::Index>(axis)] = force(laws_[axis]);
    energies[static_cast<Eigen::Index>(axis)] = with_stops ? laws_[axis].energy(r) : laws_[axis].curveEnergy(r);
  }
  const Eigen::Vector3d tangential = 2.0 / r * (energies.array() - share.dot(energies));
  return c.cwiseProduct((tangential.array() + share.dot(forces)).matrix());
}

// Returns the force of all parts without memory.
Eigen::Vector3d RadialCoupling::heldForce(const Eigen::Vector3d& d) const {
  Eigen::Vector3d force = elasticForce(d, true);
  for (std::size_t axis = 0; axis < directions_.size(); ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    force[i] -= laws_[axis].own(d[i]);
  }
  return force;
}

void RadialCoupling::add(const Eigen::Vector3d& sum, double element::ComponentForce::* part, BushForce& force) const {
  for (std::size_t axis = 0; axis < directions_.size(); ++axis) {
    element::ComponentForce& direction = force.direction[directions_[axis]];
    direction.*part += sum[static_cast<Eigen::Index>(axis)];
    direction.total += sum[static_cast<Eigen::Index>(axis)];
  }
}

// The memory contains the slider positions, coordinate by coordinate, and then the branch forces, axis by axis.
void RadialCoupling::initialise(const Coordinates& coordinates, double* memory, BushForce& force) const {
  const Eigen::Vector3d d = vectorOf(coordinates);
  for (const double position : d) {
    memory = std::fill_n(memory, sliders_.size(), position);
  }
  std::fill_n(memory, branch_count_, 0.0);
  if (elastic_) {
    add(heldForce(d), &element::ComponentForce::elastic, force);
  }
}

void RadialCoupling::step(double dt, const Coordinates& begin, const Coordinates& end, double* memory,
                          BushForce& force) const {
  const Eigen::Vector3d d = vectorOf(end);
  if (elastic_) {
    add(heldForce(d), &element::ComponentForce::elastic, force);
  }
  if (!sliders_.empty()) {
    add(stepSliders(d, memory), &element::ComponentForce::friction, force);
  }
  if (follows_) {
    add(stepBranches(dt, vectorOf(begin), d, memory + kVector * sliders_.size()), &element::ComponentForce::viscous,
        force);
  }
}

// Limits the stretch of a slider's spring to the yield displacement without changing its direction; the slider moves by
// the excess.
Eigen::Vector3d RadialCoupling::stepSliders(const Eigen::Vector3d& d, double* memory) const {
  const std::size_t count = sliders_.size();
  double* const x = memory;
  double* const y = memory + count;
  double* const z = memory + 2 * count;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < count; ++i) {
    const element::JenkinsSlider& slider = sliders_[i];
    Eigen::Vector3d stretch(d.x() - x[i], d.y() - y[i], d.z() - z[i]);
    const double square = stretch.squaredNorm();
    if (square > slider.yield_displacement * slider.yield_displacement) {
      stretch *= slider.yield_displacement / std::sqrt(square);
      x[i] = d.x() - stretch.x();
      y[i] = d.y() - stretch.y();
      z[i] = d.z() - stretch.z();
    }
    force += slider.stiffness * stretch;
  }
  return force;
}

// Visits the pieces of a straight path between radii at which a slope changes, with the share s of the path at their
// ends. The radius at s is sqrt(least^2 + (length (s - nearest))^2).
template <class Visit>
void RadialCoupling::visitPieces(const Eigen::Vector3d& begin, const Eigen::Vector3d& end, Visit visit) const {
  const Eigen::Vector3d way = end - begin;
  const double square = way.squaredNorm();
  const double nearest = square > 0.0 ? -begin.dot(way) / square : 0.0;
  const double least_square = std::max(begin.squaredNorm() - nearest * nearest * square, 0.0);
  double at = 0.0;
  const auto advance = [&](double share) {
    if (share > at && share < 1.0) {
      visit(share - at, begin + share * way);
      at = share;
    }
  };
  const auto half_chord = [&](double radius) { return std::sqrt((radius * radius - least_square) / square); };
  const auto inner = std::upper_bound(radii_.begin(), radii_.end(), std::sqrt(least_square));
  for (auto radius = std::lower_bound(inner, radii_.end(), begin.norm()); nearest > 0.0 && radius != inner;) {
    advance(nearest - half_chord(*--radius));
  }
  const double last = std::max(begin.norm(), end.norm());
  for (auto radius = nearest > 0.0 ? inner : std::upper_bound(inner, radii_.end(), begin.norm());
       square > 0.0 && radius != radii_.end() && *radius < last; ++radius) {
    advance(nearest + half_chord(*radius));
  }
  visit(1.0 - at, end);
}

Eigen::Vector3d RadialCoupling::stepBranches(double dt, const Eigen::Vector3d& begin, const Eigen::Vector3d& end,
                                             double* memory) const {
  const Eigen::Vector3d before = elasticForce(begin, false);
  Eigen::Vector3d last = before;
  visitPieces(begin, end, [&](double share, const Eigen::Vector3d& position) {
    const Eigen::Vector3d force = elasticForce(position, false);
    double* branch_force = memory;
    for (std::size_t axis = 0; axis < directions_.size(); ++axis) {
      const auto i = static_cast<Eigen::Index>(axis);
      for (const Branch& branch : branches_[axis]) {
        const element::MaxwellStep coefficients(branch.ratio, element::Relaxation::over(share * dt * branch.rate));
        *branch_force = element::maxwellForce(coefficients.decay, coefficients.gain, *branch_force, force[i] - last[i]);
        ++branch_force;
      }
    }
    last = force;
  });
  Eigen::Vector3d sum = damping_ratio_.cwiseProduct(last - before) / dt;
  for (std::size_t axis = 0; axis < directions_.size(); ++axis) {
    for (std::size_t i = 0; i < branches_[axis].size(); ++i) {
      sum[static_cast<Eigen::Index>(axis)] += *memory++;
    }
  }
  return sum;
}

}  // namespace rubber_suspension::component
