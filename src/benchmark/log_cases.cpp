// Reading a log from text, canonical and of another dialect, against the numbers alone by the C library.
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <numeric>

#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::benchmark {
namespace {

double sumOfMagnitudes(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0,
                         [](double sum, double value) { return sum + std::abs(value); });
}

// A file that is gone when this is, with semicolons and decimal commas where it is German.
struct LogFile {
  std::filesystem::path path;
  std::string text;  // with points and blanks
  std::size_t samples;
  double bare = 0.0;
  double library = 0.0;

  LogFile(std::size_t count, bool german)
      : path(std::filesystem::temp_directory_path() / fmt::format("rubber_suspension_log_{}_{}.csv", getpid(), german)),
        text(german ? "Zeit [s];Weg [m];Kraft [N]\n" : "time_s,displacement_m,force_N\n"),
        samples(count) {
    const std::vector<double> displacement = benchmarkDisplacement(samples);
    for (std::size_t i = 0; i < samples; ++i) {
      std::string row = fmt::format("{:.6f},{:.17g},{:.17g}\n", 1e-3 * static_cast<double>(i), displacement[i],
                                    1e6 * displacement[i]);
      if (german) {
        std::replace(row.begin(), row.end(), ',', ';');
        std::replace(row.begin(), row.end(), '.', ',');
      }
      text += row;
    }
    std::ofstream(path, std::ios::binary) << text;
    std::replace(text.begin(), text.end(), ';', ' ');
    std::replace(text.begin(), text.end(), ',', german ? '.' : ' ');
  }
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;
  ~LogFile() { std::filesystem::remove(path); }

  // What a reader cannot do without: the file, and strtod on each number.
  void readNumbersAlone() {
    std::ifstream file(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const char* at = text.c_str() + text.find('\n') + 1;
    std::vector<double> displacement;
    for (std::size_t number = 0; number < 3 * samples && content.size() == text.size(); ++number) {
      char* end = nullptr;
      const double value = std::strtod(at, &end);
      if (number % 3 == 1) {
        displacement.push_back(value);
      }
      at = end;
    }
    bare = sumOfMagnitudes(displacement);
  }
};

Case readCase(std::size_t samples, bool german) {
  const auto file = std::make_shared<LogFile>(samples, german);
  Case result;
  result.name = german ? "the same with semicolons and decimal commas" : "reading a log, `readLog`";
  result.baseline = "file, and `strtod` on each number";
  result.unit = "row";
  result.count = result.baseline_count = static_cast<double>(samples);
  result.bare = [file] { file->readNumbersAlone(); };
  result.library = [file] { file->library = sumOfMagnitudes(log::readLog(file->path).displacement); };
  result.error = [file] { return std::abs(file->library - file->bare) / file->bare; };
  result.error_meaning = "of the sum of the displacements";
  result.tolerance = 0.0;  // both read the same numbers to the last bit and add them in the same order
  return result;
}

}  // namespace

std::vector<Case> logCases(const BenchmarkSize& size) {
  return {readCase(size.samples, false), readCase(size.samples, true)};
}

}  // namespace rubber_suspension::benchmark
