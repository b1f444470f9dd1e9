// A hypothesis: the model's own parameters and the scales of some atoms, fitted jointly to the logs.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>
#include <optional>
#include <vector>

#include "rubber_suspension/fit/candidate.h"
#include "rubber_suspension/fit/normal_equations.h"
#include "rubber_suspension/fit/own_parameters.h"
#include "rubber_suspension/log/record.h"

namespace rubber_suspension::fit {

/// Displacement of a record that drives a component.
using Drive = std::function<Eigen::VectorXd(const log::Record&)>;

/// Force of a component over logs in the order of their recording on one specimen [N]. It is driven by the records'
/// displacement unless `drive` gives another.
std::vector<Eigen::VectorXd> simulate(const std::vector<element::ElementDescription>& elements,
                                      const std::vector<log::Record>& records, const Drive& drive = {});

/// Point of a fit: logarithms of the own parameters, then scales of the atoms.
struct Point {
  Eigen::VectorXd own;
  Eigen::VectorXd scales;

  /// Largest magnitude among the logarithms: how far an own parameter is from its configured value.
  double furthestMove() const { return own.size() > 0 ? own.cwiseAbs().maxCoeff() : 0.0; }
};

/// The fitted hypothesis.
struct Fit {
  Point point;
  double gap = 0.0;                  ///< RMS residual over force deviation, in sample
  double departure = 0.0;            ///< what the own parameters' departure from the configuration costs, as a gap
  double held_out = 0.0;             ///< the same on blocks that took no part in the fit, by cross validation
  std::vector<double> block_errors;  ///< mean square held-out residual of each block, in units of the force's variance
  std::vector<double> block_weights;

  /// Held-out error and the price of the own parameters' departure together, by which fits compete.
  double score() const { return std::hypot(held_out, departure); }
};

/// Fits hypotheses to one set of logs. Thread-safe once constructed.
///
/// Own parameters are free, but to move them from their configured values has a price in the order of the noise: what
/// the logs do not determine stays as it was specified, and an effect need not compete with own parameters that are far
/// from all that was specified.
class Fitter {
 public:
  Fitter(std::vector<log::Record> records, const OwnParameters& own);

  const std::vector<log::Record>& records() const { return records_; }
  const OwnParameters& own() const { return own_; }

  /// Elements of a point; nothing where the own parameters have no solution.
  std::optional<std::vector<element::ElementDescription>> elements(const Point& point,
                                                                   const std::vector<Atom>& atoms) const;

  /// Residuals at a point and normal equations about it. Throws std::invalid_argument where the point has no model.
  /// Atoms that are not `active` get a column of zeros: they stay as they are. All are active where the list is empty.
  BlockGrams linearise(const Point& point, const std::vector<Atom>& atoms, bool trends,
                       const std::vector<bool>& active = {}, int threads = 1) const;

  /// Fit by Gauss-Newton steps within the bounds, from a start. `trends`: a slow trend per log, which no model run
  /// reproduces, is free too (drift of the load cell that is not a ramp).
  /// `active`: atoms that may move in the first step; all where it is empty.
  Fit fit(const std::vector<Atom>& atoms, const Point& start, int iterations, bool trends = false,
          const std::vector<bool>& active = {}) const;

  /// Where the scales arrive from a start while the own parameters stay as they are; atoms that refine stay, too.
  Point scalesAlone(const std::vector<Atom>& atoms, const Point& start, int iterations) const;

  /// Find the unit effects of additive and softening atoms once, so that hypotheses need not simulate them.
  void precompute(std::vector<Candidate>& candidates, int threads) const;

  /// Simulated forces at a point; nothing where the own parameters have no solution.
  std::optional<std::vector<Eigen::VectorXd>> forces(const Point& point, const std::vector<Atom>& atoms) const;

  /// The point of no change.
  Point configured(std::size_t atoms) const;

  /// RMS residual over force deviation at a point, without any fit.
  double gapAt(const Point& point, const std::vector<Atom>& atoms) const;

  /// Price of a point's own parameters, as a gap.
  double departure(const Point& point) const;

  /// Bounds on a step from a point: own parameters, atoms, trends.
  void stepBounds(const Point& point, const std::vector<Atom>& atoms, Eigen::Index columns, Eigen::VectorXd& lower,
                  Eigen::VectorXd& upper) const;

 private:
  /// Gauss-Newton steps from `point`, to where they end; normal equations there.
  BlockGrams descend(const std::vector<Atom>& atoms, int iterations, bool trends, bool own_fixed,
                     const std::vector<bool>& first_active, Point& point) const;
  double cost(const Point& point, const std::vector<Atom>& atoms) const;
  ForceColumn ownColumn(const Point& point, const std::vector<Atom>& atoms, Eigen::Index j,
                        const std::vector<Eigen::VectorXd>& base) const;
  ForceColumn atomColumn(const Point& point, const std::vector<Atom>& atoms, std::size_t a,
                         const std::vector<Eigen::VectorXd>& base) const;
  ForceColumn knownColumn(const Point& point, const std::vector<Atom>& atoms, std::size_t a,
                          const std::vector<Eigen::VectorXd>& base) const;

  /// What else is at work in a model, besides elements of the specimen that add up.
  struct Company {
    bool displaces = false;  ///< what acts on the displacement, or in a way that has to be simulated
    bool scales = false;     ///< force effects of the own model
    bool softens = false;    ///< softening atoms
    bool on_rig = false;     ///< elements of the own model that sit on the rig
  };
  Company companyOf(const Point& point, const std::vector<Atom>& atoms) const;

  /// True where the effect of an atom on the force follows from its unit effect, without simulation.
  static bool isKnown(const Atom& atom, const Company& company);

  /// Adds the forces of the atoms that sit on the rig, or of those that do not, to that of a log.
  static void addForces(const Point& point, const std::vector<Atom>& atoms, bool on_rig, std::size_t record,
                        Eigen::VectorXd& force);
  /// Multiplies the force of a log by the factors of the softening atoms.
  static void soften(const Point& point, const std::vector<Atom>& atoms, std::size_t record, Eigen::VectorXd& force);

  std::vector<log::Record> records_;
  const OwnParameters& own_;
  Company own_company_;
  std::vector<double> weights_;  // per record: 1/(force deviation sqrt(samples records))
  double force_noise_ = 0.0;     // of the measured force, in units of its deviation
};

}  // namespace rubber_suspension::fit
