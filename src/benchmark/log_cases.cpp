// Reading a log from text, canonical and of another dialect, against the numbers alone by the C library.
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>
#include <string>

#include "benchmark/cases.h"
#include "benchmark/test_signal.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::benchmark {
namespace {

enum class Dialect { canonical, german };

// A file in the memory of the machine where it has such a place, gone when this is.
class LogFile {
 public:
  LogFile(std::size_t samples, Dialect dialect) : displacement(benchmarkDisplacement(samples)) {
    std::string pattern = (std::filesystem::temp_directory_path() / "rubber_suspension_log_XXXXXX").string();
    const int descriptor = mkstemp(pattern.data());
    if (descriptor < 0) {
      throw std::runtime_error("no temporary file can be made");
    }
    close(descriptor);
    path = pattern;
    text = dialect == Dialect::german ? "Zeit [s];Weg [m];Kraft [N]\n" : "time_s,displacement_m,force_N\n";
    for (std::size_t i = 0; i < samples; ++i) {
      std::string row = fmt::format("{:.6f},{:.17g},{:.17g}\n", 1e-3 * static_cast<double>(i), displacement[i],
                                    1e6 * displacement[i]);
      if (dialect == Dialect::german) {
        std::replace(row.begin(), row.end(), ',', ';');
        std::replace(row.begin(), row.end(), '.', ',');
      }
      text += row;
    }
    std::ofstream(path, std::ios::binary) << text;
    std::replace(text.begin(), text.end(), ';', ' ');
    std::replace(text.begin(), text.end(), ',', dialect == Dialect::german ? '.' : ' ');
  }
  LogFile(const LogFile&) = delete;
  LogFile& operator=(const LogFile&) = delete;
  ~LogFile() { std::filesystem::remove(path); }

  // What a reader cannot do without: the file, and strtod on each number.
  void readNumbersAlone() {
    std::ifstream file(path, std::ios::binary);
    const std::string content((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const char* at = text.c_str() + text.find('\n') + 1;
    bare = content.empty() ? 1.0 : 0.0;
    for (std::size_t number = 0; number < 3 * displacement.size(); ++number) {
      char* end = nullptr;
      const double value = std::strtod(at, &end);
      bare += number % 3 == 1 ? std::abs(value) : 0.0;
      at = end;
    }
  }

  void readLog() {
    const log::Log log = log::readLog(path);
    library = 0.0;
    for (const double value : log.displacement) {
      library += std::abs(value);
    }
  }

  std::vector<double> displacement;
  std::string path;
  std::string text;  // with points and blanks
  double bare = 0.0;
  double library = 0.0;
};

Case readCase(std::size_t samples, Dialect dialect) {
  const auto file = std::make_shared<LogFile>(samples, dialect);
  Case result;
  result.name =
      dialect == Dialect::canonical ? "reading a log, `readLog`" : "the same with semicolons and decimal commas";
  result.baseline = "file, and `strtod` on each number";
  result.unit = "row";
  result.count = result.baseline_count = static_cast<double>(samples);
  result.bare = [file] { file->readNumbersAlone(); };
  result.library = [file] { file->readLog(); };
  result.error = [file] { return std::abs(file->library - file->bare) / file->bare; };
  result.error_meaning = "of the sum of the displacements";
  result.tolerance = 0.0;  // both read the same numbers to the last bit and add them in the same order
  return result;
}

}  // namespace

std::vector<Case> logCases(const BenchmarkSize& size) {
  return {readCase(size.samples, Dialect::canonical), readCase(size.samples, Dialect::german)};
}

}  // namespace rubber_suspension::benchmark
