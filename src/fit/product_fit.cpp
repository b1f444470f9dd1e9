// Variable projection on products of columns.
#include "fit/product_fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "fit/bounded_least_squares.h"
#include "numerics/least_squares.h"
#include "numerics/symmetric.h"

namespace rubber_suspension::fit {
namespace {

// Square of the part of a column across the others, relative to its length, above which coefficients are unique.
constexpr double kIndependent = 1e-10;

struct LawName {
  const char* type;
  const char* parameter;  // that its force is not linear in
  const char* scale;      // that its force is proportional to
};
constexpr LawName kMaxwellName{"maxwell", "break_frequency", "stiffness"};
constexpr LawName kFrictionName{"friction", "displacement", "maximum_force"};

std::vector<const element::ElementDescription*> ofType(const ForceModel& model, const std::string& type) {
  std::vector<const element::ElementDescription*> elements;
  for (const element::ElementDescription& element : model.elements()) {
    if (element.type == type) {
      elements.push_back(&element);
    }
  }
  return elements;
}

std::vector<double> deadBands(const ForceModel& model) {
  std::vector<double> dead_bands;
  for (const element::ElementDescription* friction : ofType(model, kFrictionName.type)) {
    dead_bands.push_back(friction->value("dead_band"));
  }
  return dead_bands;
}

// Of the unknown that belongs to an element; unknowns.size() where there is none.
std::size_t find(const std::vector<Unknown>& unknowns, std::size_t element) {
  const auto at =
      std::find_if(unknowns.begin(), unknowns.end(), [&](const Unknown& u) { return u.element == element; });
  return static_cast<std::size_t>(at - unknowns.begin());
}

// Products of columns scaled to length 1, and the scales.
struct Scaled {
  Eigen::MatrixXd products;
  Eigen::VectorXd scale;

  explicit Scaled(const Eigen::MatrixXd& of) {
    scale = of.diagonal().cwiseSqrt().unaryExpr([](double length) { return length > 0.0 ? 1.0 / length : 0.0; });
    products = scale.asDiagonal() * of * scale.asDiagonal();
  }
};

// Where the columns are independent and no coefficient meets its bound, the plain solution is the bounded one.
Eigen::VectorXd solve(const Eigen::MatrixXd& products, const Eigen::VectorXd& moments,
                      const std::vector<bool>& signed_columns) {
  const Scaled scaled(products);
  const numerics::Cholesky cholesky(scaled.products);
  if (cholesky.exists() && cholesky.diagonal().array().square().minCoeff() > kIndependent) {
    Eigen::VectorXd x =
        scaled.scale.asDiagonal() * cholesky.solve(Eigen::VectorXd(scaled.scale.asDiagonal() * moments));
    bool inside = true;
    for (Eigen::Index i = 0; i < x.size(); ++i) {
      inside = inside && (signed_columns[static_cast<std::size_t>(i)] || x[i] > 0.0);
    }
    if (inside) {
      return x;
    }
  }
  return nonNegativeLeastSquares(products, moments, signed_columns);
}

}  // namespace

bool ProductFit::appliesTo(const ForceModel& model, const std::vector<log::Log>& logs) {
  return !model.nonlinear().empty() && UnitColumns::steady(logs) &&
         std::all_of(model.elements().begin(), model.elements().end(), [](const element::ElementDescription& element) {
           return element.type == "spring" || (element.type == "dashpot" && element.value("order") == 1.0) ||
                  element.type == kMaxwellName.type || element.type == kFrictionName.type;
         });
}

ProductFit::ProductFit(const ForceModel& model, const std::vector<log::Log>& logs)
    : columns_(logs, ofType(model, kMaxwellName.type).size(), deadBands(model)),
      signed_columns_(model.signedColumns()),
      owner_(model.nonlinear().size(), kNone) {
  const auto basis = static_cast<Eigen::Index>(signed_columns_.size());
  combination_ = Eigen::MatrixXd::Zero(columns_.count(), 1 + basis + static_cast<Eigen::Index>(owner_.size()));
  combination_(UnitColumns::kForce, 0) = 1.0;
  combination_(UnitColumns::kOne, basis) = 1.0;
  for (const log::Log& log : logs) {
    unit_ += std::inner_product(log.force.begin(), log.force.end(), log.force.begin(), 0.0);
  }
  for (std::size_t i = 0; i < model.elements().size(); ++i) {
    addElement(model, i);
  }
}

void ProductFit::addElement(const ForceModel& model, std::size_t position) {
  const element::ElementDescription& element = model.elements()[position];
  const auto addLaw = [&](const LawName& name, std::vector<Law>& laws, Eigen::Index unit) {
    const std::size_t unknown = find(model.nonlinear(), position);
    const bool held = unknown == model.nonlinear().size();
    laws.push_back({element.value(name.parameter), held ? kNone : static_cast<Eigen::Index>(unknown)});
    const double scale = element.value(name.scale);
    const Eigen::Index column = addColumn(model, position, unit, scale);
    if (!held) {
      owner_[unknown] = column;
      combination_(unit + 1, 1 + static_cast<Eigen::Index>(signed_columns_.size() + unknown)) = scale;
    }
  };
  if (element.type == kMaxwellName.type) {
    addLaw(kMaxwellName, maxwells_, UnitColumns::maxwell(maxwells_.size()));
  } else if (element.type == kFrictionName.type) {
    addLaw(kFrictionName, frictions_, columns_.friction(frictions_.size()));
  } else if (element.type == "spring") {
    addColumn(model, position, UnitColumns::kDisplacement, element.value("stiffness"));
  } else {
    addColumn(model, position, UnitColumns::kRate, element.value("damping"));
  }
}

// The column of the basis that the element has, or kNone and its force as given taken from the measured one.
Eigen::Index ProductFit::addColumn(const ForceModel& model, std::size_t position, Eigen::Index unit, double scale) {
  const std::size_t linear = find(model.linear(), position);
  if (linear == model.linear().size()) {
    combination_(unit, 0) -= scale;
    return kNone;
  }
  combination_(unit, 1 + static_cast<Eigen::Index>(linear)) = scale;
  return static_cast<Eigen::Index>(linear);
}

UnitColumnValues ProductFit::valuesAt(const Eigen::VectorXd& search) const {
  const auto values = [&](const std::vector<Law>& laws) {
    std::vector<double> result;
    for (const Law& law : laws) {
      result.push_back(law.unknown == kNone ? law.given : std::exp(search[law.unknown]));
    }
    return result;
  };
  return {values(maxwells_), values(frictions_)};
}

// The share of derivatives that the basis takes, in its coefficients; columns that are held at zero take nothing.
Eigen::MatrixXd ProductFit::takenByBasis(const Eigen::MatrixXd& basis, const Eigen::MatrixXd& shared,
                                         const Eigen::VectorXd& coefficients) const {
  Scaled scaled(basis);
  for (Eigen::Index i = 0; i < coefficients.size(); ++i) {
    if (coefficients[i] == 0.0 && !signed_columns_[static_cast<std::size_t>(i)]) {
      scaled.products.row(i).setZero();
      scaled.products.col(i).setZero();
      scaled.scale[i] = 0.0;
    }
  }
  const Eigen::MatrixXd moments = scaled.scale.asDiagonal() * shared;
  return scaled.scale.asDiagonal() * numerics::solveLeastNorm(scaled.products, moments);
}

// By what the derivatives of the basis' columns are multiplied: the coefficients of those columns.
Eigen::VectorXd ProductFit::scales(const Eigen::VectorXd& coefficients) const {
  Eigen::VectorXd scales(static_cast<Eigen::Index>(owner_.size()));
  for (Eigen::Index i = 0; i < scales.size(); ++i) {
    const Eigen::Index owner = owner_[static_cast<std::size_t>(i)];
    scales[i] = owner == kNone ? 1.0 : coefficients[owner];
  }
  return scales;
}

const Eigen::MatrixXd& ProductFit::productsAt(const Eigen::VectorXd& search) {
  if (last_products_.size() == 0 || last_search_ != search) {
    last_products_ = columns_.products(valuesAt(search));
    last_search_ = search;
  }
  return last_products_;
}

const ProductFit::Value& ProductFit::valueAt(const Eigen::VectorXd& search) {
  const auto size = static_cast<Eigen::Index>(signed_columns_.size());
  products_ = combination_.transpose() * productsAt(search) * combination_;
  const Eigen::MatrixXd basis = products_.block(1, 1, size, size);
  const Eigen::VectorXd moments = products_.col(0).segment(1, size);
  value_.coefficients = solve(basis, moments, signed_columns_);
  const Eigen::VectorXd& x = value_.coefficients;
  value_.cost = products_(0, 0) - 2.0 * x.dot(moments) + x.dot(basis * x);
  return value_;
}

SumOfSquares::Slope ProductFit::slope() {
  const auto size = static_cast<Eigen::Index>(signed_columns_.size());
  const Eigen::Index nonlinear = last_search_.size();
  const Eigen::MatrixXd basis = products_.block(1, 1, size, size);
  const Eigen::MatrixXd derivatives = products_.bottomRightCorner(nonlinear, nonlinear);
  const Eigen::MatrixXd shared = products_.block(1, 1 + size, size, nonlinear);
  const Eigen::VectorXd& x = value_.coefficients;
  const Eigen::VectorXd scale = scales(x);
  return {
      scale.asDiagonal() * (shared.transpose() * x - products_.bottomLeftCorner(nonlinear, 1)),
      scale.asDiagonal() * (derivatives - shared.transpose() * takenByBasis(basis, shared, x)) * scale.asDiagonal()};
}

// Measured less simulated force, with the best coefficients.
ModelFit ProductFit::fitAt(const Eigen::VectorXd& search) {
  const Eigen::VectorXd coefficients = valueAt(search).coefficients;
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(combination_.cols());
  shares[0] = 1.0;
  shares.segment(1, coefficients.size()) = -coefficients;
  return {search, coefficients, columns_.combined(valuesAt(search), combination_ * shares)};
}

// The Jacobian in unit columns.
Eigen::MatrixXd ProductFit::jacobianCombination(const Eigen::VectorXd& coefficients) const {
  const Eigen::Index nonlinear = combination_.cols() - 1 - coefficients.size();
  Eigen::MatrixXd combination(combination_.rows(), combination_.cols() - 1);
  combination << combination_.rightCols(nonlinear) * scales(coefficients).asDiagonal(),
      combination_.middleCols(1, coefficients.size()) * coefficients.unaryExpr(&relativeUnit).asDiagonal();
  return combination;
}

Eigen::MatrixXd ProductFit::jacobian(const ModelFit& fit) {
  return columns_.combined(valuesAt(fit.search), jacobianCombination(fit.coefficients));
}

Eigen::MatrixXd ProductFit::jacobianProducts(const ModelFit& fit) {
  const Eigen::MatrixXd combination = jacobianCombination(fit.coefficients);
  return combination.transpose() * productsAt(fit.search) * combination;
}

}  // namespace rubber_suspension::fit
