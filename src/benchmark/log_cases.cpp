// Reading a log from text, canonical and of another dialect, against the numbers alone by the C library.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "benchmark/cases.h"
#include "benchmark/temporary_file.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::benchmark {
namespace {

// A log as text, with semicolons and decimal commas where it is German.
std::string textOf(std::size_t samples, bool german) {
  std::string text = german ? "Zeit [s];Weg [m];Kraft [N]\n" : "time_s,displacement_m,force_N\n";
  const std::vector<double> displacement = benchmarkDisplacement(samples);
  for (std::size_t i = 0; i < samples; ++i) {
    std::string row =
        fmt::format("{:.6f},{:.17g},{:.17g}\n", 1e-3 * static_cast<double>(i), displacement[i], 1e6 * displacement[i]);
    if (german) {
      std::replace(row.begin(), row.end(), ',', ';');
      std::replace(row.begin(), row.end(), '.', ',');
    }
    text += row;
  }
  return text;
}

// Both sides leave the displacements.
struct LogBench {
  TemporaryFile file;
  std::string text;  // with points and blanks
  std::vector<double> bare;
  std::vector<double> library;

  LogBench(std::size_t samples, bool german)
      : file(textOf(samples, german), fmt::format("log_{}.csv", german)),
        text(textOf(samples, german)),
        bare(samples),
        library(samples) {
    std::replace(text.begin(), text.end(), ';', ' ');
    std::replace(text.begin(), text.end(), ',', german ? '.' : ' ');
  }

  // What a reader cannot do without: the file, and strtod on each number.
  void readNumbersAlone() {
    std::ifstream stream(file.path(), std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    const char* at = text.c_str() + text.find('\n') + 1;
    std::vector<double> displacement;
    for (std::size_t number = 0; number < 3 * bare.size() && content.size() == text.size(); ++number) {
      char* end = nullptr;
      const double value = std::strtod(at, &end);
      if (number % 3 == 1) {
        displacement.push_back(value);
      }
      at = end;
    }
    bare = std::move(displacement);
  }

  void read() { library = log::readLog(file.path()).displacement; }
};

Case readCase(std::size_t samples, bool german) {
  const auto bench = std::make_shared<LogBench>(samples, german);
  Case result = forceCase(bench, german ? "the same with semicolons and decimal commas" : "reading a log, `readLog`",
                          &LogBench::read, "file, and `strtod` on each number", &LogBench::readNumbersAlone);
  result.unit = "row";
  result.error_meaning = "of the largest displacement";
  result.tolerance = 0.0;  // both read the same numbers to the last bit
  return result;
}

}  // namespace

std::vector<Case> logCases(const BenchmarkSize& size) {
  return {readCase(size.samples, false), readCase(size.samples, true)};
}

}  // namespace rubber_suspension::benchmark
