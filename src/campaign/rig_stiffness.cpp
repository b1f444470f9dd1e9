// What one rig does to all types that are tested on it, by the probabilities of its possible causes.
#include "campaign/rig_stiffness.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>

#include "campaign/random_effects.h"
#include "numerics/symmetric.h"

namespace rubber_suspension::campaign {
namespace {

constexpr double kWrong = 0.07;            // standard deviation of the logarithm of a wrong value or factor
constexpr double kWrongEach = 0.035;       // of one stiffness of a type against its others
constexpr double kLargest = 0.14;          // standard deviation of what a compliance takes of the stiffest value
constexpr double kSpecification = 0.01;    // by which the values of any type err
constexpr double kDiscretisation = 0.002;  // of any value, by the time step of its logs

// The means of all types one below the other, and how well they are known.
struct Means {
  Eigen::VectorXd logarithm;
  Eigen::VectorXd stiffness;
  Eigen::MatrixXd covariance;  // without what the causes add
  Eigen::Index each = 0;       // stiffnesses of a type
};

Eigen::MatrixXd matrixOf(const TypeOnRig& type) {
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(type.logarithms.size()),
                       static_cast<Eigen::Index>(type.stiffness.size()));
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const std::vector<double>& row = type.logarithms[static_cast<std::size_t>(i)];
    rows.row(i) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), rows.cols());
  }
  return rows;
}

// Between components, pooled over the types: rubber of one kind scatters alike. Larger than the sample's own by what
// its few components leave open (the mean of an inverse Wishart distribution).
std::optional<Eigen::MatrixXd> pooledCovariance(const std::vector<Eigen::MatrixXd>& types) {
  const Eigen::Index each = types.front().cols();
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(each, each);
  Eigen::Index degrees = 0;
  for (const Eigen::MatrixXd& rows : types) {
    const Eigen::MatrixXd centred = rows.rowwise() - rows.colwise().mean();
    products += centred.transpose() * centred;
    degrees += rows.rows() - 1;
  }
  const Eigen::Index left = degrees - each - 1;
  return left > 0 ? std::optional<Eigen::MatrixXd>(products / static_cast<double>(left)) : std::nullopt;
}

std::optional<Means> meansOf(const std::vector<TypeOnRig>& types) {
  std::vector<Eigen::MatrixXd> rows;
  std::transform(types.begin(), types.end(), std::back_inserter(rows), matrixOf);
  const auto between = pooledCovariance(rows);
  if (!between) {
    return std::nullopt;
  }
  Means means;
  means.each = between->cols();
  const Eigen::Index size = means.each * static_cast<Eigen::Index>(types.size());
  means.logarithm.resize(size);
  means.stiffness.resize(size);
  means.covariance = Eigen::MatrixXd::Constant(size, size, kGainError * kGainError);
  for (std::size_t t = 0; t < types.size(); ++t) {
    const Eigen::Index place = means.each * static_cast<Eigen::Index>(t);
    means.logarithm.segment(place, means.each) = rows[t].colwise().mean().transpose();
    means.stiffness.segment(place, means.each) =
        Eigen::Map<const Eigen::VectorXd>(types[t].stiffness.data(), means.each);
    auto block = means.covariance.block(place, place, means.each, means.each);
    block += *between / static_cast<double>(rows[t].rows());
    block.array() += kSpecification * kSpecification;
    block.diagonal().array() += kDiscretisation * kDiscretisation;
  }
  return means;
}

double logDensity(const Eigen::VectorXd& difference, const Eigen::MatrixXd& covariance) {
  const numerics::Cholesky factor(covariance);
  const double logarithms = 2.0 * factor.diagonal().array().log().sum();
  const double turns = std::log(boost::math::constants::two_pi<double>());
  return -0.5 *
         (difference.dot(factor.solve(difference)) + logarithms + static_cast<double>(difference.size()) * turns);
}

// Each type off by a factor of its own, and each of its stiffnesses a little more.
Eigen::MatrixXd withOwnValues(const Means& means) {
  Eigen::MatrixXd covariance = means.covariance;
  for (Eigen::Index place = 0; place < covariance.rows(); place += means.each) {
    covariance.block(place, place, means.each, means.each).array() += kWrong * kWrong;
  }
  covariance.diagonal().array() += kWrongEach * kWrongEach;
  return covariance;
}

// Compliances by how much they take of the stiffest value, and the logarithm of likelihood times prior of each.
struct ComplianceGrid {
  std::vector<double> compliance;  // [m/N], increasing
  std::vector<double> weight;      // adds up to 1
  double logarithm = 0.0;          // of the marginal likelihood
};

ComplianceGrid weighCompliances(const Means& means) {
  constexpr int kSteps = 600;
  constexpr double kFarthest = 4.0 * kLargest;
  const double stiffest = means.stiffness.maxCoeff();
  const double step = kFarthest / kSteps;
  const double height = std::log(2.0 / (kLargest * std::sqrt(boost::math::constants::two_pi<double>())));
  ComplianceGrid grid;
  std::vector<double> logarithms;
  for (int i = 0; i < kSteps; ++i) {
    const double taken = (i + 0.5) * step;
    const double compliance = std::expm1(taken) / stiffest;
    const Eigen::VectorXd expected = -(compliance * means.stiffness.array()).log1p();
    grid.compliance.push_back(compliance);
    logarithms.push_back(height - 0.5 * std::pow(taken / kLargest, 2) +
                         logDensity(means.logarithm - expected, means.covariance));
  }
  const double most = *std::max_element(logarithms.begin(), logarithms.end());
  double sum = 0.0;
  for (const double logarithm : logarithms) {
    grid.weight.push_back(std::exp(logarithm - most));
    sum += grid.weight.back();
  }
  for (double& weight : grid.weight) {
    weight /= sum;
  }
  grid.logarithm = most + std::log(sum * step);
  return grid;
}

double quantileOf(const ComplianceGrid& grid, double probability) {
  double sum = 0.0;
  for (std::size_t i = 0; i < grid.weight.size(); ++i) {
    sum += grid.weight[i];
    if (sum >= probability) {
      return grid.compliance[i];
    }
  }
  return grid.compliance.back();
}

bool hasLever(const std::vector<TypeOnRig>& types) {
  double least = types.front().stiffness.front();
  double most = least;
  for (const TypeOnRig& type : types) {
    least = std::min(least, type.stiffness.front());
    most = std::max(most, type.stiffness.front());
  }
  return most >= kLeastLever * least;
}

}  // namespace

std::optional<RigJudgement> judgeRig(const std::vector<TypeOnRig>& types) {
  std::vector<TypeOnRig> enough;
  std::copy_if(types.begin(), types.end(), std::back_inserter(enough), [](const TypeOnRig& type) {
    return type.logarithms.size() >= kFewestComponents && !type.stiffness.empty();
  });
  if (enough.size() < 2 || !hasLever(enough)) {
    return std::nullopt;
  }
  const auto means = meansOf(enough);
  if (!means) {
    return std::nullopt;
  }
  const ComplianceGrid grid = weighCompliances(*means);
  const std::array<double, kRigCauses> logarithms = {
      logDensity(means->logarithm, means->covariance),
      logDensity(means->logarithm, (means->covariance.array() + kWrong * kWrong).matrix()),
      logDensity(means->logarithm, withOwnValues(*means)), grid.logarithm};
  const double most = *std::max_element(logarithms.begin(), logarithms.end());
  RigJudgement judgement;
  double sum = 0.0;
  for (std::size_t i = 0; i < kRigCauses; ++i) {
    judgement.probabilities.at(i) = std::exp(logarithms.at(i) - most);
    sum += judgement.probabilities.at(i);
  }
  for (double& probability : judgement.probabilities) {
    probability /= sum;
  }
  for (std::size_t i = 0; i < grid.weight.size(); ++i) {
    judgement.compliance += grid.weight[i] * grid.compliance[i];
  }
  for (std::size_t i = 0; i < grid.weight.size(); ++i) {
    judgement.compliance_error += grid.weight[i] * std::pow(grid.compliance[i] - judgement.compliance, 2);
  }
  judgement.compliance_error = std::sqrt(judgement.compliance_error);
  judgement.compliance_interval = {quantileOf(grid, 0.025), quantileOf(grid, 0.975)};
  return judgement;
}

std::optional<double> withoutCompliance(double logarithm, double configured, double compliance) {
  const double inverse = std::exp(-logarithm) - compliance * configured;  // configured over true stiffness
  return inverse > 0.0 ? std::optional<double>(-std::log(inverse)) : std::nullopt;
}

}  // namespace rubber_suspension::campaign
