// Model parameters of single logs.
#include "diagnosis/results/model_parameters_by_log.h"

#include <algorithm>
#include <cmath>

#include "numerics/bounded_least_squares.h"

namespace rubber_suspension::diagnosis {

std::vector<ParameterByLog> parametersByLog(const fit::Fitter& fitter, const fit::Fit& joint) {
  constexpr double kPrior = 0.1;  // standard deviation of a logarithm
  constexpr double kFarthestByLog = 2.0;
  std::vector<ParameterByLog> result;
  const fit::BlockGrams blocks = fitter.linearise({}, joint.parameters);
  const Eigen::Index size = fitter.model().size();
  for (std::size_t r = 0; r < fitter.records().size(); ++r) {
    Eigen::MatrixXd gram = Eigen::MatrixXd::Zero(size + 1, size + 1);
    for (std::size_t b = 0; b < blocks.gram.size(); ++b) {
      if (blocks.record[b] == static_cast<int>(r)) {
        gram += static_cast<double>(fitter.records().size()) * blocks.gram[b];
      }
    }
    const double variance = std::max(gram(size, size), 1e-12);
    Eigen::MatrixXd normal = gram.topLeftCorner(size, size);
    normal.diagonal().array() += variance / (kPrior * kPrior) / 100.0;
    const Eigen::VectorXd farthest = Eigen::VectorXd::Constant(size, kFarthestByLog);
    const Eigen::VectorXd step = numerics::boundedLeastSquares(normal, gram.col(size).head(size), -farthest, farthest);
    const log::Record& record = fitter.records()[r];
    ParameterByLog row;
    row.log = record.name;
    row.amplitude = std::sqrt(2.0 * (record.displacement.array() - record.displacement.mean()).square().mean());
    row.frequency = record.mean_frequency;
    row.ratios = fitter.model().ratios(joint.parameters.model + step);
    result.push_back(std::move(row));
  }
  return result;
}

}  // namespace rubber_suspension::diagnosis
