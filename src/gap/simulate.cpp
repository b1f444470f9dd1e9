// Simulation of elements over prepared records.
#include "gap/simulate.h"

#include "rubber_suspension/component/component.h"

namespace rubber_suspension::gap {

Forces simulate(const std::vector<element::ElementDescription>& elements, const std::vector<log::Record>& records,
                const Drive& drive) {
  const component::Component component(elements);
  component::ComponentState state = component.makeState();
  Forces forces;
  for (std::size_t r = 0; r < records.size(); ++r) {
    const Eigen::VectorXd other = drive ? drive(records[r]) : Eigen::VectorXd();
    const Eigen::VectorXd& z = drive ? other : records[r].displacement;
    Eigen::VectorXd force(z.size());
    force[0] = (r == 0 ? component.initialise(state, z[0]) : component.relax(state, z[0])).total;
    component.simulate(state, records[r].dt, z.data() + 1, static_cast<std::size_t>(z.size() - 1), force.data() + 1);
    forces.push_back(std::move(force));
  }
  return forces;
}

Eigen::VectorXd asRecorded(const log::Record& record) { return record.raw_displacement; }

Forces simulateEach(const std::vector<element::ElementDescription>& elements, const std::vector<log::Record>& records) {
  Forces forces;
  for (const log::Record& record : records) {
    forces.push_back(simulate(elements, {record}, asRecorded).front());
  }
  return forces;
}

}  // namespace rubber_suspension::gap
