// The command `benchmark` measures the computing time of the library on this computer.
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
  OptionTable options = {Option("--quick", quick, "use shorter logs and fewer runs; takes a few seconds"),
                         Option("--long-log", long_log, "SECONDS",
                                "only diagnose one log of this length, which is generated while it is read; print the "
                                "time and the memory of the process as JSON")
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
       "Measures the time that forces, an estimation and a diagnosis take on this machine, and prints a Markdown "
       "table. The component is a spring, five Maxwell elements and friction, sampled at 1 kHz. Times are CPU times of "
       "the thread, on which other programs have little influence; the times of the diagnosis are wall-clock times.",
       {{"In a few seconds", "--quick"},
        {"Time and memory for a log of five minutes, of which all samples are searched", "--long-log 300"},
        {"Time and memory for a log of one hour, of which only excerpts are searched", "--long-log 3600"}}},
      run);
}
