// Joint fits of own parameters and atoms.
#include "rubber_suspension/fit/hypothesis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "fit/unit_effect.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/fit/bounded_least_squares.h"
#include "rubber_suspension/fit/parallel.h"

namespace rubber_suspension::fit {
namespace {

constexpr double kOwnStep = 1e-4;     // of a logarithm, for difference quotients
constexpr double kAtomStep = 0.02;    // of the typical scale
constexpr double kEnoughGain = 1e-3;  // of the gap, to go on
constexpr double kLongestStep = 0.4;  // of a logarithm: the model is far from linear beyond
constexpr double kOwnPrice = 5.0;     // times the noise of the force, between hypotheses
constexpr double kOwnTether = 2.0;    // the same within a fit, where it must not keep parameters from what logs tell
constexpr double kLeastNoise = 1e-3;  // of the force's deviation: no model is better than that

}  // namespace

std::vector<Eigen::VectorXd> simulate(const std::vector<element::ElementDescription>& elements,
                                      const std::vector<log::Record>& records, const Drive& drive) {
  const component::Component component(elements);
  component::ComponentState state = component.makeState();
  std::vector<Eigen::VectorXd> forces;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::VectorXd other = drive ? drive(records[r]) : Eigen::VectorXd();
    const Eigen::VectorXd& z = drive ? other : records[r].displacement;
    Eigen::VectorXd force(z.size());
    force[0] = (r == 0 ? component.initialise(state, z[0]) : component.relax(state, z[0])).total;
    component.simulate(state, records[r].dt, z.data() + 1, static_cast<std::size_t>(z.size() - 1), force.data() + 1);
    forces.push_back(std::move(force));
  }
  return forces;
}

Fitter::Fitter(std::vector<log::Record> records, const OwnParameters& own) : records_(std::move(records)), own_(own) {
  for (const log::Record& record : records_) {
    const double samples = static_cast<double>(record.size()) * static_cast<double>(records_.size());
    weights_.push_back(1.0 / (record.force_deviation * std::sqrt(samples)));
    force_noise_ +=
        std::max(log::whiteNoiseFloor(record, record.force), kLeastNoise) / static_cast<double>(records_.size());
  }
  const auto own_elements = own_.elements(Eigen::VectorXd::Zero(own_.size()));
  for (const element::ElementDescription& description :
       own_elements.value_or(std::vector<element::ElementDescription>{})) {
    const element::ElementPointer element = element::makeElement(description);
    if (const auto* parallel = std::get_if<std::shared_ptr<const element::ParallelElement>>(&element)) {
      own_company_.on_rig = own_company_.on_rig || (*parallel)->onRig();
    } else if (std::holds_alternative<std::shared_ptr<const element::ForceEffect>>(element)) {
      own_company_.scales = true;
    } else {
      own_company_.displaces = true;
    }
  }
}

Point Fitter::configured(std::size_t atoms) const {
  return {Eigen::VectorXd::Zero(own_.size()), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(atoms))};
}

std::optional<std::vector<element::ElementDescription>> Fitter::elements(const Point& point,
                                                                         const std::vector<Atom>& atoms) const {
  auto result = own_.elements(point.own);
  for (std::size_t a = 0; result && a < atoms.size(); ++a) {
    const double scale = point.scales[static_cast<Eigen::Index>(a)];
    if (scale != 0.0) {
      result->push_back(atoms[a].at(scale));
    }
  }
  return result;
}

void Fitter::precompute(std::vector<Candidate>& candidates, int threads) const {
  std::vector<Atom*> known;
  for (Candidate& candidate : candidates) {
    for (Atom& atom : candidate.atoms) {
      if (atom.additive || atom.softening) {
        known.push_back(&atom);
      }
    }
  }
  parallelFor(known.size(), threads, [&](std::size_t i) {
    Atom& atom = *known[i];
    atom.unit_effect = std::make_shared<const std::vector<Eigen::VectorXd>>(unitEffect(atom, records_));
  });
}

Fitter::Company Fitter::companyOf(const Point& point, const std::vector<Atom>& atoms) const {
  Company company = own_company_;
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    const bool at_work = point.scales[static_cast<Eigen::Index>(a)] != 0.0;
    company.softens = company.softens || (at_work && atoms[a].softening);
    company.displaces = company.displaces || (at_work && !atoms[a].softening && !atoms[a].additive);
  }
  return company;
}

bool Fitter::isKnown(const Atom& atom, const Company& company) {
  if (!atom.unit_effect || atom.on_rig) {
    return atom.unit_effect != nullptr;
  }
  // A factor on the simulated force would scale what sits on the rig, too.
  const bool factors_known = !company.on_rig || !(atom.softening || company.softens);
  return !company.displaces && factors_known && (atom.softening || !company.scales);
}

std::optional<std::vector<Eigen::VectorXd>> Fitter::forces(const Point& point, const std::vector<Atom>& atoms) const {
  // What is known by its unit effect is added or multiplied; the rest has to be simulated.
  const Company company = companyOf(point, atoms);
  Point rest = point;
  Point known = point;
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    (isKnown(atoms[a], company) ? rest : known).scales[static_cast<Eigen::Index>(a)] = 0.0;
  }
  const auto description = elements(rest, atoms);
  if (!description) {
    return std::nullopt;
  }
  auto result = simulate(*description, records_);
  for (std::size_t r = 0; r < records_.size(); ++r) {
    addForces(known, atoms, false, r, result[r]);
    soften(known, atoms, r, result[r]);
    addForces(known, atoms, true, r, result[r]);
  }
  return result;
}

void Fitter::addForces(const Point& point, const std::vector<Atom>& atoms, bool on_rig, std::size_t record,
                       Eigen::VectorXd& force) {
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    const double scale = point.scales[static_cast<Eigen::Index>(a)];
    if (scale != 0.0 && !atoms[a].softening && atoms[a].on_rig == on_rig) {
      force += scale * (*atoms[a].unit_effect)[record];
    }
  }
}

void Fitter::soften(const Point& point, const std::vector<Atom>& atoms, std::size_t record, Eigen::VectorXd& force) {
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    const double scale = point.scales[static_cast<Eigen::Index>(a)];
    if (scale != 0.0 && atoms[a].softening) {
      force.array() *= 1.0 - scale * (*atoms[a].unit_effect)[record].array();
    }
  }
}

double Fitter::gapAt(const Point& point, const std::vector<Atom>& atoms) const {
  const auto simulated = forces(point, atoms);
  if (!simulated) {
    return std::numeric_limits<double>::infinity();
  }
  double sum = 0.0;
  for (std::size_t r = 0; r < records_.size(); ++r) {
    sum += std::pow(weights_[r], 2) * (records_[r].force - (*simulated)[r]).squaredNorm();
  }
  return std::isfinite(sum) ? std::sqrt(sum) : std::numeric_limits<double>::infinity();
}

BlockGrams Fitter::linearise(const Point& point, const std::vector<Atom>& atoms, bool trends,
                             const std::vector<bool>& active, int threads) const {
  const auto base = forces(point, atoms);
  if (!base) {
    throw std::invalid_argument("the model has no solution at the point of linearisation");
  }
  const auto own = static_cast<std::size_t>(own_.size());
  std::vector<ForceColumn> columns(own + atoms.size());
  parallelFor(columns.size(), threads, [&](std::size_t j) {
    if (j < own) {
      columns[j] = ownColumn(point, atoms, static_cast<Eigen::Index>(j), *base);
    } else if (active.empty() || active[j - own]) {
      columns[j] = atomColumn(point, atoms, j - own, *base);
    }
  });
  BlockGrams result = normalEquations(records_, weights_, *base, columns, trends, threads);
  const Eigen::Index last = result.gram[0].rows() - 1;
  result.prior = Eigen::MatrixXd::Zero(last + 1, last + 1);
  for (Eigen::Index j = 0; j < own_.size(); ++j) {
    result.prior(j, j) = std::pow(kOwnTether * force_noise_, 2);
    result.prior(j, last) = result.prior(last, j) = -result.prior(j, j) * point.own[j];
  }
  result.sumUp();
  return result;
}

ForceColumn Fitter::ownColumn(const Point& point, const std::vector<Atom>& atoms, Eigen::Index j,
                              const std::vector<Eigen::VectorXd>& base) const {
  Point moved = point;
  double step = kOwnStep;
  moved.own[j] += step;
  auto column = forces(moved, atoms);
  if (!column) {
    step = -kOwnStep;
    moved.own[j] = point.own[j] + step;
    column = forces(moved, atoms);
  }
  if (!column) {
    column = base;  // no model on either side: the parameter cannot move
  }
  for (std::size_t r = 0; r < base.size(); ++r) {
    (*column)[r] = ((*column)[r] - base[r]) / step;
  }
  return std::make_shared<const std::vector<Eigen::VectorXd>>(std::move(*column));
}

ForceColumn Fitter::atomColumn(const Point& point, const std::vector<Atom>& atoms, std::size_t a,
                               const std::vector<Eigen::VectorXd>& base) const {
  const Company company = companyOf(point, atoms);
  if (isKnown(atoms[a], company)) {
    return knownColumn(point, atoms, a, base);
  }
  const auto i = static_cast<Eigen::Index>(a);
  const double room = point.scales[i] + atoms[a].typical > atoms[a].upper ? -1.0 : 1.0;
  const double step = (point.scales[i] == 0.0 ? 1.0 : kAtomStep) * atoms[a].typical * room;
  Point moved = point;
  moved.scales[i] += step;
  auto column = *forces(moved, atoms);
  for (std::size_t r = 0; r < base.size(); ++r) {
    column[r] = (column[r] - base[r]) / step;
  }
  return std::make_shared<const std::vector<Eigen::VectorXd>>(std::move(column));
}

// Where an atom's effect is known the force is linear in its scale.
ForceColumn Fitter::knownColumn(const Point& point, const std::vector<Atom>& atoms, std::size_t a,
                                const std::vector<Eigen::VectorXd>& base) const {
  const Atom& atom = atoms[a];
  if (atom.on_rig || !(atom.softening || companyOf(point, atoms).softens)) {
    return atom.unit_effect;
  }
  std::vector<Eigen::VectorXd> column = *atom.unit_effect;
  Point others = point;
  others.scales = -others.scales;
  for (std::size_t r = 0; r < base.size(); ++r) {
    if (atom.softening) {
      Eigen::VectorXd specimen = base[r];
      addForces(others, atoms, true, r, specimen);
      const double scale = point.scales[static_cast<Eigen::Index>(a)];
      column[r].array() *= -specimen.array() / (1.0 - scale * column[r].array());
    } else {
      soften(point, atoms, r, column[r]);
    }
  }
  return std::make_shared<const std::vector<Eigen::VectorXd>>(std::move(column));
}

void Fitter::stepBounds(const Point& point, const std::vector<Atom>& atoms, Eigen::Index columns,
                        Eigen::VectorXd& lower, Eigen::VectorXd& upper) const {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  lower = Eigen::VectorXd::Constant(columns, -kInfinity);
  upper = Eigen::VectorXd::Constant(columns, kInfinity);
  for (Eigen::Index j = 0; j < own_.size(); ++j) {
    lower[j] = -own_.bound(j) - point.own[j];
    upper[j] = own_.bound(j) - point.own[j];
  }
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    const auto i = static_cast<Eigen::Index>(a);
    lower[own_.size() + i] = atoms[a].lower - point.scales[i];
    upper[own_.size() + i] = atoms[a].upper - point.scales[i];
  }
}

double Fitter::departure(const Point& point) const { return kOwnPrice * force_noise_ * point.own.norm(); }

double Fitter::cost(const Point& point, const std::vector<Atom>& atoms) const {
  return std::hypot(gapAt(point, atoms), kOwnTether * force_noise_ * point.own.norm());
}

BlockGrams Fitter::descend(const std::vector<Atom>& atoms, int iterations, bool trends, bool own_fixed,
                           const std::vector<bool>& first_active, Point& point) const {
  BlockGrams blocks = linearise(point, atoms, trends, first_active);
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  double least = cost(point, atoms);
  const Eigen::Index unknowns = blocks.gram[0].rows() - 1;
  for (int iteration = 0; iteration < iterations; ++iteration) {
    const Eigen::MatrixXd& total = blocks.sum;
    stepBounds(point, atoms, unknowns, lower, upper);
    const double longest = own_fixed ? 0.0 : kLongestStep;
    lower.head(own_.size()) = lower.head(own_.size()).cwiseMax(-longest);
    upper.head(own_.size()) = upper.head(own_.size()).cwiseMin(longest);
    const Eigen::VectorXd step =
        boundedLeastSquares(total.topLeftCorner(unknowns, unknowns), total.col(unknowns).head(unknowns), lower, upper);
    if (!step.allFinite()) {
      break;
    }
    double factor = 1.0;
    bool improved = false;
    for (int halving = 0; halving < 6 && !improved; ++halving, factor *= 0.5) {
      Point trial = point;
      trial.own += factor * step.head(own_.size());
      trial.scales += factor * step.segment(own_.size(), trial.scales.size());
      for (std::size_t a = 0; a < atoms.size(); ++a) {  // rounding must not leave the bounds
        auto& scale = trial.scales[static_cast<Eigen::Index>(a)];
        scale = std::clamp(scale, atoms[a].lower, atoms[a].upper);
        scale = std::abs(scale) < 1e-9 * atoms[a].typical ? 0.0 : scale;
      }
      const double trial_cost = cost(trial, atoms);
      if (trial_cost < least) {
        improved = least - trial_cost > kEnoughGain * least;
        least = trial_cost;
        point = trial;
        if (!improved) {
          break;
        }
      }
    }
    if (!improved) {
      break;
    }
    // What the first step leaves at nothing takes no further part: its force would have to be simulated each time.
    std::vector<bool> active(atoms.size());
    for (std::size_t a = 0; a < atoms.size(); ++a) {
      active[a] = atoms[a].additive || point.scales[static_cast<Eigen::Index>(a)] != 0.0;
    }
    blocks = linearise(point, atoms, trends, active);
  }
  return blocks;
}

Point Fitter::scalesAlone(const std::vector<Atom>& atoms, const Point& start, int iterations) const {
  std::vector<bool> active(atoms.size());
  std::transform(atoms.begin(), atoms.end(), active.begin(), [](const Atom& atom) { return !atom.refines; });
  Point point = start;
  descend(atoms, iterations, false, true, active, point);
  return point;
}

Fit Fitter::fit(const std::vector<Atom>& atoms, const Point& start, int iterations, bool trends,
                const std::vector<bool>& active) const {
  Fit result;
  result.point = start;
  const BlockGrams blocks = descend(atoms, iterations, trends, false, active, result.point);
  const Eigen::Index unknowns = blocks.gram[0].rows() - 1;
  std::vector<Eigen::Index> columns(static_cast<std::size_t>(unknowns));
  for (Eigen::Index j = 0; j < unknowns; ++j) {
    columns[static_cast<std::size_t>(j)] = j;
  }
  Eigen::VectorXd lower;
  Eigen::VectorXd upper;
  stepBounds(result.point, atoms, unknowns, lower, upper);
  result.block_errors = crossValidate(blocks, columns, lower, upper);
  result.block_weights = blocks.weight;
  double held_out = 0.0;
  for (std::size_t b = 0; b < blocks.weight.size(); ++b) {
    held_out += result.block_errors[b] * blocks.weight[b];
  }
  // A law that gives way under some log (a series mount about a softening specimen) is no explanation of it.
  result.held_out = std::isfinite(held_out) ? std::sqrt(held_out) : std::numeric_limits<double>::infinity();
  result.departure = departure(result.point);
  result.gap = gapAt(result.point, atoms);
  return result;
}

}  // namespace rubber_suspension::fit
