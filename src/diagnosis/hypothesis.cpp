// Joint fits of own parameters and atoms.
#include "rubber_suspension/diagnosis/hypothesis.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "rubber_suspension/component/component.h"
#include "rubber_suspension/diagnosis/bounded_least_squares.h"
#include "rubber_suspension/diagnosis/parallel.h"

namespace rubber_suspension {
namespace {

constexpr double kOwnStep = 1e-4;     // of a logarithm, for difference quotients
constexpr double kAtomStep = 0.02;    // of the typical scale
constexpr int kTrendsPerLog = 10;     // the zero, a ramp and eight half cosines
constexpr double kBlockLength = 1.5;  // [s]
constexpr double kEnoughGain = 1e-3;  // of the gap, to go on
constexpr double kLongestStep = 0.4;  // of a logarithm: the model is far from linear beyond
constexpr double kOwnPrice = 5.0;     // times the noise of the force, between hypotheses
constexpr double kOwnTether = 2.0;    // the same within a fit, where it must not keep parameters from what logs tell
constexpr double kLeastNoise = 1e-3;  // of the force's deviation: no model is better than that
constexpr int kMostBlocks = 24;
constexpr int kFewestBlocks = 8;

int blocksOf(const Record& record) {
  const int count = static_cast<int>(std::lround(record.duration() / kBlockLength));
  return std::clamp(count, kFewestBlocks, kMostBlocks);
}

Eigen::MatrixXd trendColumns(const Record& record) {
  Eigen::MatrixXd columns(record.size(), kTrendsPerLog);
  const Eigen::ArrayXd time = Eigen::ArrayXd::LinSpaced(record.size(), 0.0, 1.0);
  columns.col(0).setOnes();
  columns.col(1) = (time - 0.5).matrix();
  for (int k = 2; k < kTrendsPerLog; ++k) {
    columns.col(k) = (time * M_PI * static_cast<double>(k - 1)).cos().matrix();
  }
  return columns;
}

// True if no effect that acts on the sum of the elements is at work.
bool isPlain(const Point& point, const std::vector<Atom>& atoms) {
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    if (point.scales[static_cast<Eigen::Index>(a)] != 0.0 && !atoms[a].additive) {
      return false;
    }
  }
  return true;
}

}  // namespace

std::vector<Eigen::VectorXd> simulate(const std::vector<ElementDescription>& elements,
                                      const std::vector<Record>& records, const Drive& drive) {
  const Component component(elements);
  ComponentState state = component.makeState();
  std::vector<Eigen::VectorXd> forces;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::VectorXd other = drive ? drive(records[r]) : Eigen::VectorXd();
    const Eigen::VectorXd& z = drive ? other : records[r].displacement;
    Eigen::VectorXd force(z.size());
    force[0] = (r == 0 ? component.rest(state, z[0]) : component.recover(state, z[0])).total;
    component.simulate(state, records[r].dt, z.data() + 1, static_cast<std::size_t>(z.size() - 1), force.data() + 1);
    forces.push_back(std::move(force));
  }
  return forces;
}

Eigen::MatrixXd BlockGrams::sum(int without_fold) const {
  Eigen::MatrixXd result = prior;
  for (std::size_t b = 0; b < gram.size(); ++b) {
    if (fold[b] != without_fold) {
      result += gram[b];
    }
  }
  return result;
}

Fitter::Fitter(std::vector<Record> records, const OwnParameters& own) : records_(std::move(records)), own_(own) {
  for (const Record& record : records_) {
    const double samples = static_cast<double>(record.size()) * static_cast<double>(records_.size());
    weights_.push_back(1.0 / (record.force_deviation * std::sqrt(samples)));
    force_noise_ += std::max(whiteNoiseFloor(record, record.force), kLeastNoise) / static_cast<double>(records_.size());
  }
}

Point Fitter::configured(std::size_t atoms) const {
  return {Eigen::VectorXd::Zero(own_.size()), Eigen::VectorXd::Zero(static_cast<Eigen::Index>(atoms))};
}

std::optional<std::vector<ElementDescription>> Fitter::elements(const Point& point,
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
  std::vector<Atom*> additive;
  for (Candidate& candidate : candidates) {
    for (Atom& atom : candidate.atoms) {
      if (atom.additive) {
        additive.push_back(&atom);
      }
    }
  }
  parallelFor(additive.size(), threads, [&](std::size_t i) {
    Atom& atom = *additive[i];
    std::vector<Eigen::VectorXd> unit;
    if (atom.exact) {
      std::transform(records_.begin(), records_.end(), std::back_inserter(unit), atom.exact);
    } else {
      unit = simulate({atom.at(atom.typical)}, records_);
      for (Eigen::VectorXd& force : unit) {
        force /= atom.typical;
      }
    }
    atom.unit_force = std::make_shared<const std::vector<Eigen::VectorXd>>(std::move(unit));
  });
}

std::optional<std::vector<Eigen::VectorXd>> Fitter::forces(const Point& point, const std::vector<Atom>& atoms) const {
  // What is known by its unit force is added; the rest has to be simulated.
  const bool plain = isPlain(point, atoms);
  std::vector<const Atom*> added;
  Point rest = point;
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    const bool known = atoms[a].unit_force && (plain || atoms[a].on_rig);
    added.push_back(known && point.scales[static_cast<Eigen::Index>(a)] != 0.0 ? &atoms[a] : nullptr);
    rest.scales[static_cast<Eigen::Index>(a)] *= known ? 0.0 : 1.0;
  }
  const auto description = elements(rest, atoms);
  if (!description) {
    return std::nullopt;
  }
  auto result = simulate(*description, records_);
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    for (std::size_t r = 0; added[a] != nullptr && r < records_.size(); ++r) {
      result[r] += point.scales[static_cast<Eigen::Index>(a)] * (*added[a]->unit_force)[r];
    }
  }
  return result;
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
                             const std::vector<bool>& active) const {
  const auto base = forces(point, atoms);
  if (!base) {
    throw std::invalid_argument("the model has no solution at the point of linearisation");
  }
  // The force is linear in the own parameters' part and in additive atoms alike as long as nothing acts on their sum.
  const bool plain = isPlain(point, atoms);
  std::vector<Columns> columns;
  for (Eigen::Index j = 0; j < own_.size(); ++j) {
    columns.push_back(std::make_shared<std::vector<Eigen::VectorXd>>(ownColumn(point, atoms, j, *base)));
  }
  auto zeros = std::make_shared<std::vector<Eigen::VectorXd>>();
  for (const Record& record : records_) {
    zeros->push_back(Eigen::VectorXd::Zero(record.size()));
  }
  for (std::size_t a = 0; a < atoms.size(); ++a) {
    if (!active.empty() && !active[a]) {
      columns.push_back(zeros);
    } else if (atoms[a].unit_force && (plain || atoms[a].on_rig)) {
      columns.push_back(atoms[a].unit_force);
    } else {
      columns.push_back(std::make_shared<std::vector<Eigen::VectorXd>>(atomColumn(point, atoms, a, *base)));
    }
  }
  BlockGrams result = normalEquations(*base, columns, trends);
  const Eigen::Index last = result.gram[0].rows() - 1;
  result.prior = Eigen::MatrixXd::Zero(last + 1, last + 1);
  for (Eigen::Index j = 0; j < own_.size(); ++j) {
    result.prior(j, j) = std::pow(kOwnTether * force_noise_, 2);
    result.prior(j, last) = result.prior(last, j) = -result.prior(j, j) * point.own[j];
  }
  return result;
}

std::vector<Eigen::VectorXd> Fitter::ownColumn(const Point& point, const std::vector<Atom>& atoms, Eigen::Index j,
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
  return *column;
}

std::vector<Eigen::VectorXd> Fitter::atomColumn(const Point& point, const std::vector<Atom>& atoms, std::size_t a,
                                                const std::vector<Eigen::VectorXd>& base) const {
  const auto i = static_cast<Eigen::Index>(a);
  const double room = point.scales[i] + atoms[a].typical > atoms[a].upper ? -1.0 : 1.0;
  const double step = (point.scales[i] == 0.0 ? 1.0 : kAtomStep) * atoms[a].typical * room;
  Point moved = point;
  moved.scales[i] += step;
  auto column = *forces(moved, atoms);
  for (std::size_t r = 0; r < base.size(); ++r) {
    column[r] = (column[r] - base[r]) / step;
  }
  return column;
}

BlockGrams Fitter::normalEquations(const std::vector<Eigen::VectorXd>& base, const std::vector<Columns>& columns,
                                   bool trends) const {
  BlockGrams result;
  const auto modelled = static_cast<Eigen::Index>(columns.size());
  const Eigen::Index trend_columns = trends ? kTrendsPerLog * static_cast<Eigen::Index>(records_.size()) : 0;
  const Eigen::Index width = modelled + trend_columns + 1;
  for (std::size_t r = 0; r < records_.size(); ++r) {
    const Record& record = records_[r];
    // Only this log's own trends: the others are zero here.
    const Eigen::Index own_trends = trends ? kTrendsPerLog : 0;
    Eigen::MatrixXd local(record.size(), modelled + own_trends + 1);
    for (Eigen::Index j = 0; j < modelled; ++j) {
      local.col(j) = weights_[r] * (*columns[static_cast<std::size_t>(j)])[r];
    }
    if (trends) {
      local.middleCols(modelled, own_trends) = weights_[r] * record.force_deviation * trendColumns(record);
    }
    local.col(modelled + own_trends) = weights_[r] * (record.force - base[r]);
    const int blocks = blocksOf(record);
    for (int b = 0; b < blocks; ++b) {
      const Eigen::Index first = record.size() * b / blocks;
      const Eigen::Index last = record.size() * (b + 1) / blocks;
      const auto rows = local.middleRows(first, last - first);
      Eigen::MatrixXd small = Eigen::MatrixXd::Zero(local.cols(), local.cols());
      small.selfadjointView<Eigen::Lower>().rankUpdate(rows.transpose());
      small.triangularView<Eigen::StrictlyUpper>() = small.transpose();
      Eigen::MatrixXd gram = small;
      if (trends) {
        gram = Eigen::MatrixXd::Zero(width, width);
        std::vector<Eigen::Index> place;
        for (Eigen::Index j = 0; j < modelled; ++j) {
          place.push_back(j);
        }
        for (Eigen::Index j = 0; j < own_trends; ++j) {
          place.push_back(modelled + kTrendsPerLog * static_cast<Eigen::Index>(r) + j);
        }
        place.push_back(width - 1);
        for (std::size_t i = 0; i < place.size(); ++i) {
          for (std::size_t j = 0; j < place.size(); ++j) {
            gram(place[i], place[j]) = small(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
          }
        }
      }
      result.gram.push_back(std::move(gram));
      result.fold.push_back((b + static_cast<int>(r)) % kFolds);
      result.record.push_back(static_cast<int>(r));
      result.weight.push_back(static_cast<double>(last - first) /
                              (static_cast<double>(record.size()) * static_cast<double>(records_.size())));
    }
  }
  return result;
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
    const Eigen::MatrixXd total = blocks.sum();
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
  Point point = start;
  descend(atoms, iterations, false, true, {}, point);
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

std::vector<double> crossValidate(const BlockGrams& blocks, const std::vector<Eigen::Index>& columns,
                                  const Eigen::VectorXd& lower, const Eigen::VectorXd& upper) {
  const auto count = static_cast<Eigen::Index>(columns.size());
  const Eigen::Index last = blocks.gram[0].rows() - 1;
  std::vector<double> errors(blocks.gram.size());
  Eigen::MatrixXd small(count, count);
  Eigen::VectorXd moment(count);
  for (int fold = 0; fold < kFolds; ++fold) {
    const Eigen::MatrixXd total = blocks.sum(fold);
    for (Eigen::Index i = 0; i < count; ++i) {
      const auto row = columns[static_cast<std::size_t>(i)];
      moment[i] = total(row, last);
      for (Eigen::Index j = 0; j < count; ++j) {
        small(i, j) = total(row, columns[static_cast<std::size_t>(j)]);
      }
    }
    const Eigen::VectorXd x = boundedLeastSquares(small, moment, lower, upper);
    for (std::size_t b = 0; b < blocks.gram.size(); ++b) {
      if (blocks.fold[b] != fold) {
        continue;
      }
      const Eigen::MatrixXd& gram = blocks.gram[b];
      double error = gram(last, last);
      for (Eigen::Index i = 0; i < count; ++i) {
        const auto row = columns[static_cast<std::size_t>(i)];
        error -= 2.0 * x[i] * gram(row, last);
        for (Eigen::Index j = 0; j < count; ++j) {
          error += x[i] * x[j] * gram(row, columns[static_cast<std::size_t>(j)]);
        }
      }
      errors[b] =
          std::isfinite(error) ? std::max(error, 0.0) / blocks.weight[b] : std::numeric_limits<double>::infinity();
    }
  }
  return errors;
}

}  // namespace rubber_suspension
