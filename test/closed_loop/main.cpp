// closed_loop tests whether the experiment that a diagnosis proposes decides between explanations. Virtual benches play
// it or a random programme of the same length, and each new log is diagnosed with the earlier logs.
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
  int cases = 12;
  int seed = 1;
  int threads = 1;
  int least_proposed = 0;
  int least_decided = 0;
  bool random = false;
  bool verbose = false;

  command_line::OptionTable table() {
    using command_line::Option;
    return {Option("--cases", cases, "COUNT", "number of benches that leave two names or more open").within(1, 100000),
            Option("--seed", seed, "NUMBER", "of the first bench").within(0, 1e9),
            Option("--threads", threads, "COUNT", "of each diagnosis").within(1, 64),
            Option("--least-proposed", least_proposed, "COUNT", "exit status 1 where fewer benches have a proposal")
                .within(0, 100000),
            Option("--least-decided", least_decided, "COUNT",
                   "exit status 1 where the log proposed leaves the truth alone at 90 % on fewer benches")
                .within(0, 100000),
            Option("--random", random, "a random programme of the same length beside each proposal"),
            Option("--verbose", verbose, "each case")};
  }
};

struct Tally {
  int open = 0;           // benches whose logs leave two or more effects undecided
  int proposed = 0;       // number of these benches with a proposed experiment
  int by_proposal = 0;    // benches whose true effect alone has 90 % after the proposed log
  int by_random = 0;      // benches whose true effect alone has 90 % after a random log of the same length
  double promised = 0.0;  // sum of the stated confidences
};

diagnosis::Diagnosis diagnose(const VirtualBench& bench, const std::vector<log::Log>& logs, int threads) {
  diagnosis::DiagnosisOptions options;
  options.threads = threads;
  options.limits = bench.limits();
  return diagnosis::diagnose(bench.component(), logs, {}, options);
}

// Returns the number of effects that the logs neither confirm nor exclude.
int openNames(const diagnosis::Diagnosis& diagnosis) {
  constexpr double kSure = 0.9;
  return static_cast<int>(std::count_if(
      diagnosis.candidates.begin(), diagnosis.candidates.end(),
      [](const auto& candidate) { return candidate.probability > 1.0 - kSure && candidate.probability < kSure; }));
}

bool isTheTruthAlone(const diagnosis::Diagnosis& diagnosis, const std::string& truth) {
  constexpr double kSure = 0.9;
  return diagnosis.answer.effects == std::vector<std::string>{truth} && diagnosis.answer.probability >= kSure;
}

diagnosis::Diagnosis diagnoseWith(VirtualBench& bench, std::vector<log::Log> logs, const Programme& programme,
                                  int threads) {
  logs.push_back(bench.play(programme));
  return diagnose(bench, logs, threads);
}

std::string resultOf(const diagnosis::Diagnosis& diagnosis) {
  const diagnosis::Posterior& posterior = diagnosis.answer.posterior;
  std::string text = fmt::format(
      "{} {}, none {:.2f} values {:.2f} effects {:.2f} others {:.2f}, gap {:.4f} {:.4f} {:.4f} "
      "floor {:.4f};",
      toString(diagnosis.answer.verdict), diagnosis.answer.confounded, posterior.none, posterior.parameter_error,
      posterior.effects, posterior.none_of_these, diagnosis.gaps.unseen.as_configured,
      diagnosis.gaps.unseen.re_estimated, diagnosis.gaps.unseen.augmented, diagnosis.gaps.unseen.noise_floor);
  constexpr std::size_t kMost = 4;
  for (std::size_t i = 0; i < std::min(kMost, diagnosis.candidates.size()); ++i) {
    const diagnosis::CandidateResult& candidate = diagnosis.candidates[i];
    text += fmt::format(" {} {:.2f} {:.4f}", candidate.effect, candidate.probability, candidate.gap);
  }
  return text;
}

void runCase(unsigned seed, const Options& options, Tally& tally) {
  VirtualBench bench(seed);
  const std::vector<log::Log> logs = {bench.play(bench.poorProgramme())};
  const diagnosis::Diagnosis before = diagnose(bench, logs, options.threads);
  if (options.verbose) {
    fmt::print("{} {}: {}\n", seed, bench.effect(), resultOf(before));
  }
  if (openNames(before) < 2) {
    return;
  }
  ++tally.open;
  if (before.next.proposed.displacement.empty()) {
    if (options.verbose) {
      fmt::print("  none: {}\n", before.next.text);
    }
    return;
  }
  ++tally.proposed;
  tally.promised += before.next.proposed.probability;
  const VirtualBench::Memory memory = bench.memory();
  const Programme proposed{"proposed", before.next.proposed.dt, before.next.proposed.displacement};
  const diagnosis::Diagnosis after = diagnoseWith(bench, logs, proposed, options.threads);
  const double duration = static_cast<double>(proposed.displacement.size() - 1) * proposed.dt;
  tally.by_proposal += isTheTruthAlone(after, bench.effect()) ? 1 : 0;
  if (options.verbose) {
    fmt::print("  {}\n  proposed ({:.1f} s): {}\n", before.next.text, duration, resultOf(after));
  }
  if (options.random) {
    bench.goBackTo(memory);
    const diagnosis::Diagnosis random = diagnoseWith(bench, logs, bench.randomProgramme(duration), options.threads);
    tally.by_random += isTheTruthAlone(random, bench.effect()) ? 1 : 0;
    fmt::print("{}", options.verbose ? fmt::format("  random: {}\n", resultOf(random)) : "");
  }
}

int run(const Options& options) {
  Tally tally;
  int benches = 0;
  for (; tally.open < options.cases; ++benches) {
    runCase(static_cast<unsigned>(options.seed + benches), options, tally);
    std::fflush(stdout);
  }
  fmt::print(
      "{} benches of one log, on {} of which two names or more are open: an experiment is proposed for {}, after it "
      "the "
      "truth stands alone at 90 % on {}{}; confidence stated {:.2f} on average\n",
      benches, tally.open, tally.proposed, tally.by_proposal,
      options.random ? fmt::format(", after a random programme of the same length on {}", tally.by_random) : "",
      tally.promised / std::max(1, tally.proposed));
  return tally.proposed >= options.least_proposed && tally.by_proposal >= options.least_decided ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return command_line::runCommand(
      argc, argv, {"closed_loop", "Plays on virtual benches what a diagnosis proposes, and diagnoses again."},
      options.table(), [&] { return run(options); });
}
