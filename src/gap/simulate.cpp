// Simulates elements over records.
#include "gap/simulate.h"

#include "gap/log_driver.h"
#include "io/cancellation.h"

namespace rubber_suspension::gap {
namespace {

Forces simulate(const std::vector<element::ElementDescription>& elements, const std::vector<PreparedRecord>& records,
                const Drive& drive, Before before) {
  LogDriver driver(elements);
  Forces forces;
  for (const PreparedRecord& record : records) {
    io::checkCancelled();
    const Eigen::VectorXd other = drive ? drive(record) : Eigen::VectorXd();
    forces.push_back(
        driver.over(record, drive ? other : record.displacement, forces.empty() ? Before::nothing : before));
  }
  return forces;
}

}  // namespace

Forces simulate(const std::vector<element::ElementDescription>& elements, const std::vector<PreparedRecord>& records,
                const Drive& drive) {
  return simulate(elements, records, drive, Before::another_log);
}

Eigen::VectorXd asRecorded(const log::Record& record) { return record.raw_displacement; }

Forces simulateEach(const std::vector<element::ElementDescription>& elements,
                    const std::vector<PreparedRecord>& records, const Drive& drive) {
  return simulate(elements, records, drive, Before::nothing);
}

}  // namespace rubber_suspension::gap
