// Simulation of elements over prepared records.
#include "gap/simulate.h"

#include <algorithm>

#include "io/cancellation.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/radial_stiffness.h"

namespace rubber_suspension::gap {
namespace {

using component::Component;
using component::ComponentState;

enum class Before { nothing, another_record };

double rest(const Component& component, ComponentState& state, double displacement, Before before) {
  return (before == Before::nothing ? component.initialise(state, displacement) : component.relax(state, displacement))
      .total;
}

bool followsTemperature(const Component& component, const log::Record& record) {
  return component.shiftsWithTemperature() && record.temperature.size() > 0;
}

// A channel at each sample; of a motion before the record, its first value.
Eigen::VectorXd heldBefore(const Eigen::VectorXd& channel, Eigen::Index samples) {
  Eigen::VectorXd held(samples);
  held << Eigen::VectorXd::Constant(samples - channel.size(), channel[0]), channel;
  return held;
}

// Samples of a record's drive from `first` on.
void simulateFrom(const Component& component, ComponentState& state, const log::Record& record,
                  const Eigen::VectorXd& z, Eigen::Index first, Eigen::VectorXd& force) {
  const auto count = static_cast<std::size_t>(z.size() - first);
  if (followsTemperature(component, record)) {
    const Eigen::VectorXd temperature = heldBefore(record.temperature, z.size());
    component.simulate(state, record.dt, z.data() + first, temperature.data() + first, count, force.data() + first);
  } else {
    component.simulate(state, record.dt, z.data() + first, count, force.data() + first);
  }
}

// At the temperature of the first sample, where there is one.
void setTemperature(const Component& component, ComponentState& state, const log::Record& record) {
  if (followsTemperature(component, record)) {
    component.setTemperature(state, record.temperature[0]);
  } else {
    component.forgetTemperature(state);
  }
}

// A record that begins at rest.
Eigen::VectorXd simulateRested(const Component& component, ComponentState& state, const log::Record& record,
                               const Eigen::VectorXd& z, Before before) {
  Eigen::VectorXd force(z.size());
  force[0] = rest(component, state, z[0], before);
  simulateFrom(component, state, record, z, 1, force);
  return force;
}

// An excerpt, to which its lead-in leads.
Eigen::VectorXd simulateLedIn(const Component& component, ComponentState& state, const log::Record& record,
                              const Eigen::VectorXd& z, Before before) {
  const log::LeadIn& before_it = record.lead_in;
  if (before == Before::nothing || !before_it.continues) {
    rest(component, state, before_it.displacement[0], before);
  }
  const std::size_t samples = before_it.displacement.size();
  Eigen::VectorXd force(std::max(z.size(), static_cast<Eigen::Index>(samples)));
  component.simulate(state, before_it.dt, before_it.displacement.data(), samples, force.data());
  force.conservativeResize(z.size());
  simulateFrom(component, state, record, z, 0, force);
  return force;
}

}  // namespace

Forces simulate(const std::vector<element::ElementDescription>& elements, const std::vector<PreparedRecord>& records,
                const Drive& drive) {
  const Component component(elements);
  const std::vector<element::RadialStiffness> radial = element::radialLaws(elements);
  ComponentState state = component.makeState();
  Forces forces;
  for (std::size_t r = 0; r < records.size(); ++r) {
    io::checkCancelled();
    const PreparedRecord& record = records[r];
    const Eigen::VectorXd other = drive ? drive(record) : Eigen::VectorXd();
    const Eigen::VectorXd& z = drive ? other : record.displacement;
    const Before before = r == 0 ? Before::nothing : Before::another_record;
    setTemperature(component, state, record);
    forces.push_back(record.lead_in.displacement.empty() ? simulateRested(component, state, record, z, before)
                                                         : simulateLedIn(component, state, record, z, before));
    if (!radial.empty() && record.across.size() > 0) {
      const Eigen::VectorXd across = heldBefore(record.across, z.size());
      element::addAcross(radial, z.data(), across.data(), static_cast<std::size_t>(z.size()), forces.back().data());
    }
  }
  return forces;
}

Eigen::VectorXd asRecorded(const log::Record& record) { return record.raw_displacement; }

Forces simulateEach(const std::vector<element::ElementDescription>& elements,
                    const std::vector<PreparedRecord>& records, const Drive& drive) {
  Forces forces;
  for (const PreparedRecord& record : records) {
    forces.push_back(simulate(elements, {record}, drive).front());
  }
  return forces;
}

}  // namespace rubber_suspension::gap
