// A test piece on a rig.
#include "benchmark/measured_log.h"

#include <utility>
#include <vector>

#include "benchmark/test_signal.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr double kNoise = 50.0;  // standard deviation of the measured force's noise [N]; the friction is 3 kN

std::vector<element::ElementDescription> testPiece() {
  std::vector<element::ElementDescription> elements = describedComponent().elements();
  elements.push_back({"iwan", {{"maximum_force", {3000.0}}, {"displacement", {5e-4}}}});
  return elements;
}

}  // namespace

io::ComponentDescription describedComponent() {
  return {"benchmark",
          {{"spring", {{"stiffness", {3.0e6}}}}, {"maxwell", {{"stiffness", {1.3e6}}, {"break_frequency", {1.43}}}}}};
}

MeasuringRig::MeasuringRig(unsigned seed) : test_piece_(testPiece()), state_(test_piece_.makeState()), random_(seed) {}

double MeasuringRig::force(double displacement) {
  double noise = 0.0;  // twelve uniform numbers make a normal one
  for (int i = 0; i < 12; ++i) {
    noise += static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  return test_piece_.step(state_, kStep, displacement).total + kNoise * (noise - 6.0);
}

log::Log measuredLog(const std::string& name, std::size_t samples, double scale, unsigned seed) {
  MeasuringRig rig(seed);
  log::Log log;
  log.name = name;
  log.stamp = evenStamps(samples);
  log.displacement = benchmarkDisplacement(samples);
  for (double& z : log.displacement) {
    z *= scale;
    log.force.push_back(rig.force(z));
  }
  return log;
}

}  // namespace rubber_suspension::benchmark
