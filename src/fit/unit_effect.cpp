// Unit effects of atoms.
#include "fit/unit_effect.h"

#include <algorithm>
#include <iterator>

#include "rubber_suspension/element/catalogue.h"
#include "rubber_suspension/fit/hypothesis.h"

namespace rubber_suspension::fit {
namespace {

// Share of the specimen's force that a softening atom takes at scale 1, by the factors of its law.
std::vector<Eigen::VectorXd> softenedShare(const Atom& atom, const std::vector<log::Record>& records) {
  const auto law = std::get<std::shared_ptr<const element::ForceEffect>>(element::makeElement(atom.at(atom.typical)));
  std::vector<double> memory(law->memorySize());
  std::vector<Eigen::VectorXd> result;
  for (const log::Record& record : records) {
    const Eigen::VectorXd& z = record.displacement;
    Eigen::VectorXd factor(z.size());
    if (result.empty()) {
      law->initialise(z[0], memory.data());
      factor[0] = 1.0;
    } else {
      factor[0] = law->relax(z[0], memory.data());
    }
    for (Eigen::Index i = 1; i < z.size(); ++i) {
      factor[i] = law->step({record.dt, z[i], z[i] - z[i - 1]}, {}, memory.data());
    }
    result.emplace_back((1.0 - factor.array()) / atom.typical);
  }
  return result;
}

std::vector<Eigen::VectorXd> addedForce(const Atom& atom, const std::vector<log::Record>& records) {
  std::vector<Eigen::VectorXd> result;
  if (atom.exact) {
    std::transform(records.begin(), records.end(), std::back_inserter(result), atom.exact);
    return result;
  }
  result = simulate({atom.at(atom.typical)}, records);
  for (Eigen::VectorXd& force : result) {
    force /= atom.typical;
  }
  return result;
}

}  // namespace

std::vector<Eigen::VectorXd> unitEffect(const Atom& atom, const std::vector<log::Record>& records) {
  return atom.softening ? softenedShare(atom, records) : addedForce(atom, records);
}

}  // namespace rubber_suspension::fit
