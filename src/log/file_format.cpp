// The format of a file, by its first bytes.
#include "log/file_format.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <fstream>
#include <stdexcept>
#include <string_view>

#include "element/refuse.h"
#include "log/text.h"

namespace rubber_suspension::log {
namespace {

using namespace std::string_view_literals;

struct Mark {
  std::string_view begin;
  FileFormat format;
  const char* name;
  const char* remedy;  // what makes a file that can be read
};

constexpr const char* kAsAText = "export it as text (CSV)";

// asammdf, npTDMS and mcap are the readers of these formats that their users keep up; Debian has none of them.
constexpr Mark kMarks[] = {
    {"\x1F\x8B"sv, FileFormat::gzip, "gzip within gzip", "gunzip"},
    {"#ROSBAG V"sv, FileFormat::bag, "a ROS bag", "give it the extension .bag"},
    {"MATLAB "sv, FileFormat::matlab, "a MATLAB file", "give it as it is, not within gzip"},
    {"\x89HDF\r\n\x1A\n"sv, FileFormat::hdf5, "HDF5", "give it as it is, not within gzip"},
    {"MDF     "sv, FileFormat::foreign, "ASAM MDF",
     "pip install asammdf; python3 -c \"from asammdf import MDF; MDF('LOG.mf4').export('csv', 'LOG.csv', "
     "single_time_base=True, add_units=True)\""},
    {"TDSm"sv, FileFormat::foreign, "NI TDMS",
     "pip install npTDMS pandas; python3 -c \"from nptdms import TdmsFile; "
     "TdmsFile.read('LOG.tdms').as_dataframe(time_index=True).to_csv('LOG.csv', index_label='time_s')\""},
    {"FORMAT\0"sv, FileFormat::rpc, "MTS RPC III", "give it as it is, not within gzip"},
    {"\x89MCAP0\r\n"sv, FileFormat::foreign, "MCAP",
     "pip install mcap-ros1-support; python3 -c \"from mcap_ros1.reader import read_ros1_messages as r; "
     "print('time_s,displacement_m'); [print('%s,%r' % (m.ros_msg.header.stamp.to_sec(), m.ros_msg.displacement)) "
     "for m in r('LOG.mcap', topics=['/NAME/displacement'])]\" > LOG.csv"},
    {"PK\x03\x04"sv, FileFormat::foreign, "a ZIP archive or a spreadsheet (.xlsx, .ods)", kAsAText},
    {"\xD0\xCF\x11\xE0"sv, FileFormat::foreign, "an old spreadsheet (.xls)", kAsAText},
    {"PAR1"sv, FileFormat::foreign, "Parquet", kAsAText},
    {"\x93NUMPY"sv, FileFormat::foreign, "a NumPy array", "numpy.savetxt, with the names of the columns as header"},
    {"BZh"sv, FileFormat::foreign, "bzip2", "bunzip2"},
    {"\xFD"
     "7zXZ"sv,
     FileFormat::foreign, "xz", "unxz"},
    {"\x28\xB5\x2F\xFD"sv, FileFormat::foreign, "Zstandard", "unzstd"},
    {"%PDF"sv, FileFormat::foreign, "PDF", kAsAText},
    {"\x89PNG"sv, FileFormat::foreign, "a picture (PNG)", "give the log"},
    {"\x7F"
     "ELF"sv,
     FileFormat::foreign, "a program", "give the log"},
};

const Mark* markOf(const std::string& head) {
  for (const Mark& mark : kMarks) {
    if (std::string_view(head).substr(0, mark.begin.size()) == mark.begin) {
      return &mark;
    }
  }
  return nullptr;
}

}  // namespace

FileFormat formatOf(const std::string& head) {
  const Mark* mark = markOf(head);
  return mark == nullptr ? FileFormat::text : mark->format;
}

void refuseUnpacked(std::size_t unpacked, std::size_t packed, bool large) {
  constexpr std::size_t kFreely = 64UL * 1024 * 1024;  // bytes
  constexpr std::size_t kMostTimes = 100;
  element::refuseIf<std::runtime_error>(
      !large && unpacked > kFreely && unpacked / kMostTimes > packed,
      "unpacks to more than {} times its {} bytes; accepted: at most that beyond 64 MiB, or --large", kMostTimes,
      packed);
}

bool isRegularFile(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode);
}

FileFormat formatOfFile(const std::string& path) {
  if (!isRegularFile(path)) {
    return endsWith(path, ".mat") ? FileFormat::matlab : FileFormat::text;
  }
  std::ifstream file(path, std::ios::binary);
  std::string head(kFormatHead, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  const FileFormat format = formatOf(head);
  return format == FileFormat::text && endsWith(path, ".mat") ? FileFormat::matlab : format;
}

void refuseForeignFormat(const std::string& head) {
  const Mark* mark = markOf(head);
  if (mark != nullptr) {
    throw std::runtime_error(
        fmt::format("{}, which is not read; accepted: text (CSV), gzip of text, .mat, HDF5, RPC III, ROS bag; "
                    "to convert it: {}",
                    mark->name, mark->remedy));
  }
}

}  // namespace rubber_suspension::log
