// The command `benchmark`: how long the library takes on this machine.
#include "benchmark/own_work.h"
#include "command_line/command.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  bool quick = false;
  double long_log = 0.0;

  OptionTable table();
};

OptionTable Options::table() {
  OptionTable options = {
      Option("--quick", quick, "shorter logs and fewer runs: a few seconds"),
      Option("--long-log", long_log, "SECONDS",
             "only diagnose one log of that length, which is made as it is read, and print JSON: the time, and the "
             "memory that the process took")
          .within(1, 604800)};
  return options.excludes({"--quick"}, {"--long-log"});
}

int run(const Options& options) {
  if (options.long_log > 0.0) {
    std::cout << benchmark::diagnoseLongLog(options.long_log) << '\n';
    return kSuccess;
  }
  std::vector<benchmark::Work> all = benchmark::forces(options.quick ? 20000 : 100000);
  const auto diagnoses = benchmark::diagnoses(options.quick ? 2.0 : 20.0);
  all.insert(all.end(), diagnoses.begin(), diagnoses.end());
  std::cout << "| work | time, median | quartiles |\n|---|---|---|\n";
  for (const benchmark::Work& work : all) {
    const int runs = work.clock == benchmark::Clock::wall ? 3 : 101;
    std::cout << benchmark::row(work, options.quick ? 1 + runs / 10 : runs) << std::flush;
  }
  return kSuccess;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"benchmark",
       "Measures how long the library takes on this machine for forces, an estimation and a diagnosis, and prints a "
       "Markdown table. The component is a spring, five Maxwell elements and friction, at 1 kHz. Times are CPU times "
       "of the thread, so that other programs matter little; for the diagnosis they are wall times.",
       {{"In a few seconds", "--quick"},
        {"Time and memory for a log of five minutes, which is searched whole", "--long-log 300"},
        {"For a log of an hour, of which excerpts are searched", "--long-log 3600"}}},
      run);
}
