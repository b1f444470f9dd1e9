// Fit of the settled loops of a model to the rows of a table.
#include "fit/table_fit.h"

#include <Eigen/Core>
#include <cmath>
#include <complex>
#include <utility>

#include "element/refuse.h"
#include "fit/model_parameters.h"
#include "fit/residual_covariance.h"
#include "numerics/trust_region.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::fit {
namespace {

// Samples per cycle, which determine the area to 2e-4. Measured loops are accurate to about a percent.
constexpr int kSamplesOfSweep = 180;
constexpr double kStepOfLogarithm = 1e-4;  // step of difference quotients

double misfitOf(const Eigen::VectorXd& residual) {
  return residual.norm() / std::sqrt(0.5 * static_cast<double>(residual.size()));
}

// Returns the bounds of the logarithms on either side; 0 for fixed parameters. `spread`: break frequencies are fixed,
// because they spread the elements over the range, where the stiffnesses have one best fit.
Eigen::VectorXd boundsOf(const ModelParameters& parameters, bool spread) {
  Eigen::VectorXd bounds = parameters.bounds();
  for (Eigen::Index i = 0; i < bounds.size(); ++i) {
    const std::string& name = parameters.names()[static_cast<std::size_t>(i)];
    if (spread && name.find("break_frequency") != std::string::npos) {
      bounds[i] = 0.0;
    }
  }
  return bounds;
}

std::complex<double> simulated(const component::Component& component, const TablePoint& point) {
  response::LoopOptions options;
  options.samples = kSamplesOfSweep;
  options.mean = point.mean;
  const auto loop = response::characteristicsAt(component, point.frequency, point.amplitude, options).characteristics;
  return std::polar(loop.stiffness, loop.loss_angle);
}

// Returns relative differences between model and points; real and imaginary parts alternate.
Eigen::VectorXd differences(const component::Component& component, const std::vector<TablePoint>& points) {
  Eigen::VectorXd result(2 * static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::complex<double> measured = points[i].complexStiffness();
    const std::complex<double> difference = (simulated(component, points[i]) - measured) / std::abs(measured);
    result.segment<2>(2 * static_cast<Eigen::Index>(i)) << difference.real(), difference.imag();
  }
  return result;
}

TableFit fitToOneTemperature(const io::ComponentDescription& description, const std::vector<TablePoint>& points,
                             bool spread) {
  const ModelParameters parameters(description, Level::elements);
  const Eigen::VectorXd bounds = boundsOf(parameters, spread);
  std::vector<Eigen::Index> moved;
  for (Eigen::Index i = 0; i < bounds.size(); ++i) {
    if (bounds[i] > 0.0) {
      moved.push_back(i);
    }
  }
  element::refuseIf(moved.empty(), "{}: has no parameter that can be fitted", description.name);
  const auto residuals = [&](const Eigen::VectorXd& x) {
    return differences(parameters.apply(x).makeComponent(), points);
  };
  numerics::DifferencedSquares squares(residuals, kStepOfLogarithm);
  const Eigen::VectorXd given = Eigen::VectorXd::Zero(bounds.size());
  const Eigen::VectorXd x = numerics::searchLeast(squares, given, {-bounds, bounds}, {200, 1e-12}).search;
  const Eigen::VectorXd residual = residuals(x);
  const Covariance covariance = covarianceOf(squares.jacobian(x)(Eigen::all, moved), residual.squaredNorm());
  TableFit fit;
  fit.component = parameters.apply(x);
  fit.misfit_before = misfitOf(residuals(given));
  fit.misfit = misfitOf(residual);
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const Eigen::Index i = moved[k];
    const bool at_bound = bounds[i] - std::abs(x[i]) < 1e-6;
    const double deviation = covariance.standardDeviation(static_cast<Eigen::Index>(k));
    fit.parameters.push_back({parameters.names()[static_cast<std::size_t>(i)], parameters.configured(i),
                              parameters.configured(i) * std::exp(x[i]), !at_bound && deviation < kUndetermined,
                              deviation});
  }
  return fit;
}

}  // namespace

TableFit fitToTable(const io::ComponentDescription& description, const std::vector<TablePoint>& points,
                    std::optional<Series> series) {
  checkPoints(points);
  std::optional<MasterCurve> curve;
  std::optional<element::ElementDescription> shift = description.temperature;
  if (hasTemperatures(points)) {
    curve = masterCurve(points, shift ? shift->value("reference") : middleTemperature(points));
    shift = curve->law;
  }
  const std::vector<TablePoint> reduced = shift ? reducedBy(*shift, points) : points;
  io::ComponentDescription begin = description;
  if (series) {
    begin = {description.name, seriesOf(*series, reduced)};
  }
  begin.temperature = shift;
  const bool spread = begin.model() == estimation::Model::multi_maxwell || series == Series::prony;
  TableFit fit = fitToOneTemperature(begin, reduced, spread);
  fit.master_curve = std::move(curve);
  return fit;
}

}  // namespace rubber_suspension::fit
