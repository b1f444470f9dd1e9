// Computes state-space models of the linear part of a component.
#include "command/linear_part.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <stdexcept>

#include "element/each.h"
#include "element/refuse.h"
#include "estimation/models.h"
#include "log/mat_file.h"
#include "log/new_file.h"
#include "log/text.h"
#include "rubber_suspension/element/inertia_track.h"

namespace rubber_suspension::command {
namespace {

using Parallel = std::shared_ptr<const element::ParallelElement>;

class LinearPartBuilder {
 public:
  explicit LinearPartBuilder(double nominal_displacement) : displacement_(nominal_displacement) {}

  void add(const element::ElementDescription& entry) {
    const element::ElementPointer element = element::makeElement(entry);
    const auto* law = std::get_if<Parallel>(&element);
    if (law == nullptr || (*law)->onRig() || !addLaw(**law, entry.type)) {
      left_out_.push_back(entry.type);
    }
  }

  LinearPart part(const std::string& name) {
    for (const element::BasicLaws::MaxwellNumbers& maxwell : sum_.maxwells) {
      blocks_.push_back({Eigen::MatrixXd::Constant(1, 1, -maxwell.rate), Eigen::RowVector2d(0.0, maxwell.stiffness),
                         Eigen::RowVectorXd::Ones(1)});
    }
    Eigen::Index size = 0;
    for (const Block& block : blocks_) {
      size += block.a.rows();
    }
    LinearPart part{name,
                    Eigen::MatrixXd::Zero(size, size),
                    Eigen::MatrixXd::Zero(size, 2),
                    Eigen::RowVectorXd::Zero(size),
                    Eigen::RowVector2d(sum_.stiffness, sum_.damping),
                    tangents_,
                    left_out_};
    Eigen::Index at = 0;
    for (const Block& block : blocks_) {
      const Eigen::Index states = block.a.rows();
      part.a.block(at, at, states, states) = block.a;
      part.b.middleRows(at, states) = block.b;
      part.c.segment(at, states) = block.c;
      at += states;
    }
    return part;
  }

 private:
  struct Block {
    Eigen::MatrixXd a;
    Eigen::MatrixXd b;
    Eigen::RowVectorXd c;
  };

  bool addLaw(const element::ParallelElement& law, const std::string& type) {
    if (!law.linear()) {
      return law.part() == element::Part::elastic && addTangent(law, type);
    }
    if (law.addTo(sum_)) {
      return true;
    }
    if (const auto* track = dynamic_cast<const element::InertiaTrack*>(&law)) {
      addTrack(*track);
      return true;
    }
    // A law whose K* is imaginary and proportional to omega acts as a dashpot.
    const std::complex<double> slow = *law.complexStiffness(1.0);
    const bool dashpot = slow.real() == 0.0 && *law.complexStiffness(2.0) == 2.0 * slow;
    sum_.damping += dashpot ? slow.imag() : 0.0;
    return dashpot;
  }

  bool addTangent(const element::ParallelElement& law, const std::string& type) {
    sum_.stiffness += estimation::slopeAbout(law, displacement_);
    tangents_.push_back(type);
    return true;
  }

  // The states are the deflection z - q, where q is the position of the moving mass, and the rate dq/dt.
  void addTrack(const element::InertiaTrack& track) {
    Block block{Eigen::MatrixXd(2, 2), Eigen::MatrixXd::Zero(2, 2), Eigen::RowVector2d(track.stiffness(), 0.0)};
    block.a << 0.0, -1.0, track.stiffness() / track.mass(), -track.damping() / track.mass();
    block.b(0, 1) = 1.0;
    blocks_.push_back(block);
  }

  double displacement_;
  element::BasicLaws sum_;
  std::vector<Block> blocks_;
  std::vector<std::string> tangents_;
  std::vector<std::string> left_out_;
};

nlohmann::ordered_json rowsOf(const Eigen::MatrixXd& matrix) {
  auto rows = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    const Eigen::VectorXd row = matrix.row(i);
    rows.push_back(std::vector<double>(row.begin(), row.end()));
  }
  return rows;
}

std::string jsonOf(const std::vector<LinearPart>& parts) {
  const auto component = [](const LinearPart& part) -> nlohmann::ordered_json {
    return {{"component", part.component}, {"inputs", {"displacement_m", "velocity_m_per_s"}},
            {"output", "force_n"},         {"A", rowsOf(part.a)},
            {"B", rowsOf(part.b)},         {"C", rowsOf(part.c)},
            {"D", rowsOf(part.d)},         {"tangents", part.tangents},
            {"left_out", part.left_out}};
  };
  const nlohmann::ordered_json json = {{"schema", "rubber_suspension/state_space/1"},
                                       {"components", element::each(parts, component)}};
  return json.dump(2) + "\n";
}

log::NamedMatrix named(const std::string& name, const Eigen::MatrixXd& matrix) {
  return {name, static_cast<std::size_t>(matrix.rows()), static_cast<std::size_t>(matrix.cols()),
          std::vector<double>(matrix.data(), matrix.data() + matrix.size())};
}

}  // namespace

LinearPart linearPartOf(const io::ComponentDescription& description) {
  const estimation::Specification& specification = description.specification();
  const bool estimated = description.model() != estimation::Model::elements && specification.preloads().empty();
  LinearPartBuilder builder(estimation::nominalDisplacement(specification));
  for (const element::ElementDescription& entry :
       estimated ? estimation::estimateTangent(description.model(), specification) : description.elements()) {
    builder.add(entry);
  }
  for (const element::ElementDescription& entry : description.add) {
    builder.add(entry);
  }
  return builder.part(description.name);
}

void writeLinearParts(const std::vector<LinearPart>& parts, const std::string& path) {
  const bool mat = log::endsWith(path, ".mat");
  if (log::endsWith(path, ".json")) {
    log::writeNewFile(path, jsonOf(parts));
    return;
  }
  element::refuseIf(!mat || parts.size() != 1, "{}: cannot hold the linear part; accepted: a name that ends in .json{}",
                    path, mat ? ", or a single component for .mat" : " or .mat");
  const LinearPart& part = parts.front();
  log::writeMatFile(path, {named("A", part.a), named("B", part.b), named("C", part.c), named("D", part.d)});
}

}  // namespace rubber_suspension::command
