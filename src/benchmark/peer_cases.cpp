// General solvers against the library on a log that they take as linear between samples, too: the exact solution of
// that is the library's own, so that the error is the solver's. Spring and friction are added alike.
#include <functional>
#include <memory>
#include <string>

#include "benchmark/bare_loop.h"
#include "benchmark/cases.h"
#include "benchmark/peer/peers.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/component/component.h"
#include "rubber_suspension/element/constants.h"

namespace rubber_suspension::benchmark {
namespace {

constexpr int kElements = 5;
constexpr double kHighestBreakFrequency = 1000.0;  // [Hz]; relaxes six times over within a sampling interval
// A general solver is good to its own tolerance only.
constexpr double kErrorOfPeers = 1e-2;

using Solver = std::function<void(const PeerWork&, std::vector<double>&)>;

struct PeerBench {
  BareParameters parameters = bareParameters(kElements, kHighestBreakFrequency);
  component::Component component{elementsOf(parameters)};
  PeerWork work;
  std::vector<double> peer;
  std::vector<double> library;

  explicit PeerBench(std::size_t samples) : peer(samples), library(samples) {
    work.stiffness = parameters.stiffness;
    for (const double frequency : parameters.break_frequency) {
      work.rate.push_back(2.0 * element::kPi * frequency);
    }
    work.dt = kStep;
    work.displacement = benchmarkDisplacement(samples);
  }

  void runLibrary() {
    component::ComponentState state = component.makeState();
    library[0] = component.initialise(state, work.displacement[0]).total;
    component.simulate(state, kStep, work.displacement.data() + 1, library.size() - 1, library.data() + 1);
  }

  void runPeer(const Solver& solve) {
    solve(work, peer);
    BareFriction friction;
    friction.last_displacement = friction.reference_displacement = work.displacement[0];
    peer[0] = parameters.spring * work.displacement[0];
    for (std::size_t i = 1; i < peer.size(); ++i) {
      peer[i] += parameters.spring * work.displacement[i] +
                 friction.advance(work.displacement[i], parameters.maximum_force, parameters.friction_displacement);
    }
  }
};

Case peerCase(const std::shared_ptr<PeerBench>& bench, const std::string& name, const Solver& solve) {
  Case result;
  result.name = "a log with break frequencies up to 1 kHz, `Component::simulate`";
  result.baseline = name;
  result.unit = "step";
  result.count = result.baseline_count = static_cast<double>(bench->work.displacement.size());
  result.bare = [bench, solve] { bench->runPeer(solve); };
  result.library = [bench] { bench->runLibrary(); };
  result.error = [bench] { return relativeDifference(bench->library, bench->peer); };
  result.error_meaning = "of the other's largest force";
  result.tolerance = kErrorOfPeers;
  result.most_repetitions = 15;
  return result;
}

}  // namespace

std::vector<Case> peerCases(const BenchmarkSize& size) {
  constexpr std::size_t kMostSamples = 20000;
  const auto bench = std::make_shared<PeerBench>(std::min(kMostSamples, size.samples));
  // For those that take microseconds for a sample.
  constexpr std::size_t kMostSamplesOfSlow = 2000;
  [[maybe_unused]] const auto slow = std::make_shared<PeerBench>(std::min(kMostSamplesOfSlow, size.samples));
  std::vector<Case> cases;
  for (const int substeps : {3, 10}) {
    cases.push_back(peerCase(
        bench, "Boost.odeint, RK4, " + std::to_string(substeps) + " steps per sample",
        [substeps](const PeerWork& work, std::vector<double>& force) { odeintRungeKutta4(work, substeps, force); }));
  }
  cases.push_back(peerCase(bench, "Boost.odeint, Dormand-Prince", odeintDormandPrince));
#ifdef RUBBER_SUSPENSION_WITH_GSL
  cases.push_back(peerCase(bench, "GSL, Runge-Kutta-Fehlberg", gslFehlberg));
#endif
#ifdef RUBBER_SUSPENSION_WITH_CVODE
  cases.push_back(peerCase(bench, "SUNDIALS CVODE, BDF", cvodeBackwardDifferentiation));
#endif
#ifdef RUBBER_SUSPENSION_WITH_SIMBODY
  cases.push_back(peerCase(slow, "Simbody, Runge-Kutta-Merson", simbodyMerson));
#endif
#ifdef RUBBER_SUSPENSION_WITH_MUJOCO
  for (const int substeps : {3, 10}) {
    cases.push_back(peerCase(
        slow, "MuJoCo, RK4, " + std::to_string(substeps) + " steps per sample",
        [substeps](const PeerWork& work, std::vector<double>& force) { mujocoRungeKutta4(work, substeps, force); }));
  }
#endif
  return cases;
}

}  // namespace rubber_suspension::benchmark
