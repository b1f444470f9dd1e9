// The program `benchmark_pairs` compares the time of the library with handwritten loops, and of some of its functions
// with others. It also states the error of the results.
#include <fmt/format.h>

#include "benchmark/cases.h"
#include "command_line/command.h"
#include "command_line/plot_option.h"

namespace {

using namespace rubber_suspension;
using namespace rubber_suspension::command_line;

struct Options {
  bool quick = false;
  std::size_t samples = 0;
  int pairs = 0;
  std::string plot;

  OptionTable table();
};

OptionTable Options::table() {
  return {Option("--quick", quick, "shorter logs and fewer pairs: under a minute"),
          Option("--samples", samples, "COUNT",
                 "samples of the logs that are simulated; if absent 100000, with --quick 20000")
              .within(10, 10000000),
          Option("--pairs", pairs, "COUNT",
                 "pairs of runs of plain loop and library, per row; if absent 101, with --quick 15")
              .rare()
              .within(1, 100000),
          plotOption(plot, "the ratios")};
}

std::vector<benchmark::Case> allCases(const benchmark::BenchmarkSize& size) {
  std::vector<benchmark::Case> all;
  for (const auto part : {benchmark::forceCases, benchmark::sixDirectionCases, benchmark::bundleCases}) {
    for (benchmark::Case& work : part(size)) {
      all.push_back(std::move(work));
    }
  }
  return all;
}

int run(const Options& options) {
  benchmark::BenchmarkSize size;
  size.samples = options.samples > 0 ? options.samples : options.quick ? 20000 : 100000;
  const int pairs = options.pairs > 0 ? options.pairs : options.quick ? 15 : 101;
  std::vector<benchmark::Result> results;
  bool accurate = true;
  for (benchmark::Case& work : allCases(size)) {
    std::cerr << "measuring " << work.name << '\n';
    results.push_back(benchmark::measure(work, pairs));
    if (!results.back().accurate) {
      printError("benchmark_pairs", work.name + ": the error is beyond its tolerance");
      accurate = false;
    }
    if (results.back().slow) {
      printError("benchmark_pairs", fmt::format("{}: {:.3g} times the time of {}; accepted: {:g} times", work.name,
                                                results.back().ratio.lower, work.baseline, work.most));
      accurate = false;
    }
  }
  std::cout << benchmark::markdown(results);
  drawPlot(options.plot, [&] { return benchmark::ratioFigure(results); });
  return accurate ? kSuccess : kFailed;
}

}  // namespace

int main(int argc, char** argv) {
  return runCommand<Options>(
      argc, argv,
      {"benchmark_pairs",
       "Times the library against hand-written loops, taking turns in one process, and prints a "
       "Markdown table: ratios are medians over pairs of runs, with quartiles in brackets, the error of the forces "
       "beside them. Times are CPU times of the thread, so that other programs matter little.",
       {{"In a minute", "--quick"},
        {"All of it, with a picture", "--plot ratios.svg"},
        {"With short logs", "--samples 500 --pairs 15"}}},
      run);
}
