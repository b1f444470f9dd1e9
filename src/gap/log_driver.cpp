// Drives a component over logs.
#include "gap/log_driver.h"

namespace rubber_suspension::gap {
namespace {

// Extends a channel at its beginning to this number of samples by repeating its first value.
Eigen::VectorXd heldBefore(const Eigen::VectorXd& channel, Eigen::Index samples) {
  Eigen::VectorXd held(samples);
  held << Eigen::VectorXd::Constant(samples - channel.size(), channel[0]), channel;
  return held;
}

}  // namespace

void LogDriver::begin(Before before, const log::LeadIn* lead_in) {
  before_ = before;
  lead_in_ = lead_in;
  begins_ = true;
}

double LogDriver::rest(double displacement) {
  return (before_ == Before::nothing ? component_.initialise(state_, displacement)
                                     : component_.relax(state_, displacement))
      .total;
}

void LogDriver::leadIn() {
  const std::vector<double>& displacement = lead_in_->displacement;
  if (before_ == Before::nothing || !lead_in_->continues) {
    rest(displacement[0]);
  }
  led_in_.resize(displacement.size());
  component_.simulate(state_, lead_in_->dt, displacement.data(), displacement.size(), led_in_.data());
}

void LogDriver::drive(const log::EvenBlocks::Piece& piece, double dt, double* force) {
  if (piece.samples == 0) {
    return;
  }
  std::size_t done = 0;
  if (begins_) {
    begins_ = false;
    follows(piece) ? component_.setTemperature(state_, piece.temperature[0]) : component_.forgetTemperature(state_);
    if (lead_in_ != nullptr && !lead_in_->displacement.empty()) {
      leadIn();
    } else {
      force[done++] = rest(piece.displacement[0]);
    }
  }
  if (piece.gap > 0.0) {
    if (follows(piece)) {
      component_.setTemperature(state_, piece.temperature[0]);
    }
    force[done++] = component_.step(state_, piece.gap, piece.displacement[0]).total;
  }
  const std::size_t left = piece.samples - done;
  if (follows(piece)) {
    component_.simulate(state_, dt, piece.displacement + done, piece.temperature + done, left, force + done);
  } else {
    component_.simulate(state_, dt, piece.displacement + done, left, force + done);
  }
  if (piece.across != nullptr) {
    element::addAcross(radial_, piece.displacement, piece.across, piece.samples, force);
  }
}

Eigen::VectorXd LogDriver::over(const log::Record& record, const Eigen::VectorXd& displacement, Before before) {
  const auto channel = [&](bool matters, const Eigen::VectorXd& recorded) {
    return matters && recorded.size() > 0 ? heldBefore(recorded, displacement.size()) : Eigen::VectorXd();
  };
  const Eigen::VectorXd temperature = channel(component_.shiftsWithTemperature(), record.temperature);
  const Eigen::VectorXd across = channel(!radial_.empty(), record.across);
  Eigen::VectorXd force(displacement.size());
  begin(before, &record.lead_in);
  drive({0.0, static_cast<std::size_t>(displacement.size()), displacement.data(), nullptr,
         temperature.size() > 0 ? temperature.data() : nullptr, across.size() > 0 ? across.data() : nullptr, nullptr},
        record.dt, force.data());
  return force;
}

}  // namespace rubber_suspension::gap
