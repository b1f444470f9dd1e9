// One piece of work of the library alone.
#include "benchmark/single_work.h"

#include <fmt/format.h>

#include <algorithm>
#include <ctime>
#include <vector>

#include "rubber_suspension/fit/identification.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"

namespace rubber_suspension::benchmark {
namespace {

template <class Work>
double medianSeconds(Work work, int runs) {
  std::vector<double> seconds;
  for (int i = 0; i < runs; ++i) {
    timespec start{};
    timespec end{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &start);
    work();
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &end);
    seconds.push_back(static_cast<double>(end.tv_sec - start.tv_sec) +
                      1e-9 * static_cast<double>(end.tv_nsec - start.tv_nsec));
  }
  std::nth_element(seconds.begin(), seconds.begin() + runs / 2, seconds.end());
  return seconds[static_cast<std::size_t>(runs / 2)];
}

}  // namespace

std::string singleWork(const std::string& work, const std::string& component_file, const std::string& log_file) {
  constexpr int kRuns = 5;
  const io::ComponentDescription description = io::selectComponent(io::loadComponentFile(component_file), "");
  const log::Log log = log::readLog(log_file);
  if (work == "simulate") {
    const component::Component component = description.makeComponent();
    const double seconds = medianSeconds([&] { gap::simulateLog(component, log); }, kRuns);
    return fmt::format("{{\"seconds\": {:.9g}}}", seconds);
  }
  fit::IdentificationOptions options;
  options.starts = 1;
  fit::Identification fit;
  const double seconds = medianSeconds([&] { fit = fit::identify(description.allElements(), {log}, options); }, kRuns);
  const double cost = fit.residual * fit.residual * static_cast<double>(log.size());
  return fmt::format("{{\"seconds\": {:.9g}, \"cost\": {:.12g}}}", seconds, cost);
}

}  // namespace rubber_suspension::benchmark
