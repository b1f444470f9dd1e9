// closed_loop: does the experiment that a diagnosis proposes decide? Virtual benches play it, and a random programme of
// the same length beside it; both are diagnosed again with the logs before.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "command_line/command.h"
#include "rubber_suspension/diagnosis/diagnosis.h"
#include "virtual_bench.h"

namespace {

using namespace rubber_suspension;
using closed_loop::Programme;
using closed_loop::VirtualBench;

struct Options {
  int cases = 6;
  int seed = 1;
  int threads = 1;
  double least_share = 0.0;
  bool verbose = false;

  command_line::OptionTable table() {
    using command_line::Option;
    return {
        Option("--cases", cases, "COUNT", "number of benches").within(1, 100000),
        Option("--seed", seed, "NUMBER", "of the first bench").within(0, 1e9),
        Option("--threads", threads, "COUNT", "of each diagnosis").within(1, 64),
        Option("--least-share", least_share, "SHARE",
               "exit status 1 where proposals shrink a smaller share of the sets that have one, or fewer than random "
               "programmes do")
            .within(0, 1),
        Option("--verbose", verbose, "each case")};
  }
};

struct Tally {
  int ambiguous = 0;      // sets of more than one member that hold the truth
  int without = 0;        // of these: no experiment was proposed
  int by_proposal = 0;    // shrunk to the truth by the log proposed
  int by_random = 0;      // shrunk to the truth by a random programme of the same length
  double promised = 0.0;  // sum of the confidences stated
};

diagnosis::Diagnosis diagnose(const VirtualBench& bench, const std::vector<log::Log>& logs, int threads) {
  diagnosis::DiagnosisOptions options;
  options.threads = threads;
  options.limits = bench.limits();
  return diagnosis::diagnose(bench.component(), logs, {}, options);
}

// Several sets that cannot be told apart, of which one is the truth.
bool isAmbiguous(const diagnosis::Diagnosis& diagnosis, const std::string& truth) {
  const std::vector<std::vector<std::string>>& sets = diagnosis.confounded;
  return sets.size() > 1 && std::find(sets.begin(), sets.end(), std::vector<std::string>{truth}) != sets.end();
}

bool isTheTruthAlone(const diagnosis::Diagnosis& diagnosis, const std::string& truth) {
  return diagnosis.effects == std::vector<std::string>{truth} &&
         diagnosis.confounded == std::vector<std::vector<std::string>>{{truth}};
}

diagnosis::Diagnosis diagnoseWith(VirtualBench& bench, std::vector<log::Log> logs, const Programme& programme,
                                  int threads) {
  logs.push_back(bench.play(programme));
  return diagnose(bench, logs, threads);
}

std::string resultOf(const diagnosis::Diagnosis& diagnosis) {
  const diagnosis::Posterior& posterior = diagnosis.posterior;
  std::string text = fmt::format(
      "{} {}, none {:.2f} values {:.2f} effects {:.2f} others {:.2f}, gap {:.4f} {:.4f} {:.4f} "
      "floor {:.4f};",
      toString(diagnosis.verdict), diagnosis.confounded, posterior.none, posterior.parameter_error, posterior.effects,
      posterior.none_of_these, diagnosis.gap.as_configured, diagnosis.gap.re_estimated, diagnosis.gap.augmented,
      diagnosis.gap.noise_floor);
  constexpr std::size_t kMost = 4;
  for (std::size_t i = 0; i < std::min(kMost, diagnosis.candidates.size()); ++i) {
    const diagnosis::CandidateResult& candidate = diagnosis.candidates[i];
    text += fmt::format(" {} {:.2f} {:.4f}", candidate.effect, candidate.probability, candidate.gap);
  }
  return text;
}

void runCase(unsigned seed, const Options& options, Tally& tally) {
  VirtualBench bench(seed);
  std::vector<log::Log> logs;
  for (const Programme& programme : bench.poorProgrammes()) {
    logs.push_back(bench.play(programme));
  }
  const diagnosis::Diagnosis before = diagnose(bench, logs, options.threads);
  if (options.verbose) {
    fmt::print("{} {}: {}\n", seed, bench.effect(), resultOf(before));
  }
  if (!isAmbiguous(before, bench.effect())) {
    return;
  }
  ++tally.ambiguous;
  if (before.proposed.displacement.empty()) {
    ++tally.without;
    if (options.verbose) {
      fmt::print("  none: {}\n", before.next_experiment);
    }
    return;
  }
  tally.promised += before.proposed.probability;
  const VirtualBench::Memory memory = bench.memory();
  const Programme proposed{"proposed", before.proposed.dt, before.proposed.displacement};
  const diagnosis::Diagnosis after = diagnoseWith(bench, logs, proposed, options.threads);
  bench.goBackTo(memory);
  const double duration = static_cast<double>(proposed.displacement.size() - 1) * proposed.dt;
  const diagnosis::Diagnosis random = diagnoseWith(bench, logs, bench.randomProgramme(duration), options.threads);
  tally.by_proposal += isTheTruthAlone(after, bench.effect()) ? 1 : 0;
  tally.by_random += isTheTruthAlone(random, bench.effect()) ? 1 : 0;
  if (options.verbose) {
    fmt::print("  {}\n  proposed ({:.1f} s): {}\n  random: {}\n", before.next_experiment, duration, resultOf(after),
               resultOf(random));
  }
}

int run(const Options& options) {
  Tally tally;
  for (int i = 0; i < options.cases; ++i) {
    runCase(static_cast<unsigned>(options.seed + i), options, tally);
    std::fflush(stdout);
  }
  const int proposed = tally.ambiguous - tally.without;
  fmt::print(
      "{} benches, {} sets of more than one member with the truth: {} shrunk to the truth by the experiment proposed, "
      "{} "
      "by a random programme of the same length; none proposed for {}; confidence stated {:.2f} on average\n",
      options.cases, tally.ambiguous, tally.by_proposal, tally.by_random, tally.without,
      tally.promised / std::max(1, proposed));
  const bool enough = tally.by_proposal >= options.least_share * proposed && tally.by_proposal >= tally.by_random;
  return proposed > 0 && enough ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return command_line::runCommand(
      argc, argv, {"closed_loop", "Plays on virtual benches what a diagnosis proposes, and diagnoses again."},
      options.table(), [&] { return run(options); });
}
