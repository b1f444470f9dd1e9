// Fuzz target: any bytes of a log are refused with a LogError, or read as a valid log. The bytes are text, gzip,
// UTF-16, HDF5, RPC III, or a format that is refused by name. Text is read without options, with columns by number, as
// a second segment, and with a sampling rate. MATLAB files are excluded, because libmatio allocates any size that a
// damaged file states.
#include <algorithm>

#include "fuzz/memory_file.h"
#include "fuzz/valid_log.h"
#include "log/file_format.h"

using namespace rubber_suspension;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const fuzz::MemoryFile file(data, size);
  const std::string head(reinterpret_cast<const char*>(data), std::min(size, log::kFormatHead));
  const log::FileFormat format = log::formatOf(head);
  if (format == log::FileFormat::hdf5 || format == log::FileFormat::rpc) {
    fuzz::requireValidLogOrError([&] { return log::readLog(file.path()); });
    return 0;
  }
  fuzz::requireValidLogOrError([&] { return log::readCsvLog(file.path()); });
  static const log::LogFormat kByNumber =
      log::makeLogFormat({"time", "displacement", "force"}, "displacement=mm force=kN time=ms", 0.0);
  fuzz::requireValidLogOrError([&] { return log::readCsvLog(file.path(), kByNumber); });
  static const log::LogFormat kSecond = log::makeLogFormat({}, "", 0.0, ",", "2", 1.0);
  fuzz::requireValidLogOrError([&] { return log::readCsvLog(file.path(), kSecond); });
  static const log::LogFormat kAtRate = log::makeLogFormat({"displacement=1"}, "displacement=mm", 1000.0);
  fuzz::requireValidLogOrError([&] { return log::readCsvLog(file.path(), kAtRate); });
  return 0;
}
