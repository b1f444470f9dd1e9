// Recognises the format of a file by its first bytes.
#include "log/file_format.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <fstream>
#include <iterator>
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
  const char* remedy;  // how to convert the file to a format that can be read
};

constexpr const char* kAsAText = "export it as text (CSV)";
constexpr const char* kArrays =
    "python3 -c \"import numpy as n; d = n.load('LOG.npz'); n.savetxt('LOG.csv', n.c_[d['TIME'], d['DISPLACEMENT'], "
    "d['FORCE']], delimiter=',', header='time_s,displacement_UNIT,force_UNIT', comments='')\", where UNIT stands for "
    "the units of the arrays";
constexpr const char* kArray =
    "python3 -c \"import numpy as n; n.savetxt('LOG.csv', n.load('LOG.npy'), delimiter=',', "
    "header='time_s,displacement_UNIT,force_UNIT', comments='')\", where UNIT stands for the units of the array";

// The packages asammdf, npTDMS, rosbags and mcap in these commands are maintained, but Debian does not contain them.
constexpr Mark kMarks[] = {
    {"\x1F\x8B"sv, FileFormat::gzip, "gzip within gzip", "gunzip"},
    {"#ROSBAG V"sv, FileFormat::bag, "a ROS bag", "give it the extension .bag"},
    {"MATLAB "sv, FileFormat::matlab, "a MATLAB file", "give the file without gzip"},
    {"\x89HDF\r\n\x1A\n"sv, FileFormat::hdf5, "HDF5", "give the file without gzip"},
    {"MDF     "sv, FileFormat::foreign, "ASAM MDF",
     "pip install asammdf; python3 -c \"from asammdf import MDF; MDF('LOG.mf4').export('csv', 'LOG.csv', "
     "single_time_base=True, add_units=True)\""},
    {"TDSm"sv, FileFormat::foreign, "NI TDMS",
     "pip install npTDMS pandas; python3 -c \"from nptdms import TdmsFile; "
     "TdmsFile.read('LOG.tdms').as_dataframe(time_index=True).to_csv('LOG.csv', index_label='time_s')\""},
    {"FORMAT\0"sv, FileFormat::rpc, "MTS RPC III", "give the file without gzip"},
    {"\x89MCAP0\r\n"sv, FileFormat::foreign, "MCAP",
     "pip install mcap-ros1-support; python3 -c \"from mcap_ros1.reader import read_ros1_messages as r; "
     "print('time_s,displacement_m'); [print('%s,%r' % (m.ros_msg.header.stamp.to_sec(), m.ros_msg.displacement)) "
     "for m in r('LOG.mcap', topics=['/NAME/displacement'])]\" > LOG.csv"},
    {"SQLite format 3\0"sv, FileFormat::foreign, "SQLite, as in a bag of ROS 2 (.db3)",
     "pip install rosbags; its rosbags-convert turns the folder into a bag of ROS 1"},
    {"\xD0\xCF\x11\xE0"sv, FileFormat::foreign, "an old spreadsheet (.xls)", kAsAText},
    {"PAR1"sv, FileFormat::foreign, "Parquet", kAsAText},
    {"ARROW1"sv, FileFormat::foreign, "Feather", kAsAText},
    {"\x93NUMPY"sv, FileFormat::foreign, "a NumPy array", kArray},
    {"BZh"sv, FileFormat::foreign, "bzip2", "bunzip2"},
    {"\xFD"
     "7zXZ"sv,
     FileFormat::foreign, "xz", "unxz"},
    {"\x28\xB5\x2F\xFD"sv, FileFormat::foreign, "Zstandard", "unzstd"},
    {"%PDF"sv, FileFormat::foreign, "PDF", kAsAText},
    {"{\\rtf"sv, FileFormat::foreign, "RTF", kAsAText},
    {"<?xml"sv, FileFormat::foreign, "XML", kAsAText},
    {"<html"sv, FileFormat::foreign, "HTML", kAsAText},
    {"<!DOCTYPE"sv, FileFormat::foreign, "HTML", kAsAText},
    {"\x89PNG"sv, FileFormat::foreign, "a picture (PNG)", "give the log"},
    {"\x7F"
     "ELF"sv,
     FileFormat::foreign, "a program", "give the log"},
};

// A format for which a comparison of the first bytes is not sufficient.
struct Look {
  bool (*fits)(std::string_view head);
  const char* name;
  const char* remedy;
};

bool isZip(std::string_view head) { return head.substr(0, 4) == "PK\x03\x04"sv; }

// Returns the name of the first file in a ZIP archive; empty for other data.
std::string_view nameInZip(std::string_view head) {
  constexpr std::size_t kHeader = 30;  // bytes
  if (!isZip(head) || head.size() < kHeader) {
    return {};
  }
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(head[i])); };
  return head.substr(kHeader, byte(26) + 256 * byte(27));
}

// Returns line `number`, counted from 0, without its line end and the blanks around it.
std::string_view lineOf(std::string_view head, std::size_t number) {
  for (std::size_t i = 0; i < number; ++i) {
    const std::size_t end = head.find('\n');
    if (end == std::string_view::npos) {
      return {};
    }
    head.remove_prefix(end + 1);
  }
  std::string_view line = head.substr(0, head.find('\n'));
  line = line.substr(0, line.find('\r'));
  return trimmedView(line);
}

std::string_view behindBlanks(std::string_view head) {
  return head.substr(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
}

bool isJson(std::string_view head) {
  const std::string_view text = behindBlanks(head);
  const std::string_view first = text.substr(0, 1);
  const std::string_view second = text.empty() ? text : behindBlanks(text.substr(1)).substr(0, 1);
  return (first == "{" && (second == "\"" || second == "}")) || (first == "[" && (second == "{" || second == "["));
}

const Look kLooks[] = {
    {[](std::string_view head) { return endsWith(nameInZip(head), ".npy"); }, "arrays of NumPy (.npz)", kArrays},
    {[](std::string_view head) {
       return nameInZip(head) == "[Content_Types].xml" || startsWith(nameInZip(head), "xl/") ||
              startsWith(nameInZip(head), "docProps/") || nameInZip(head) == "_rels/.rels";
     },
     "a spreadsheet (.xlsx)", kAsAText},
    {[](std::string_view head) { return nameInZip(head) == "mimetype"; }, "a spreadsheet (.ods)", kAsAText},
    {isZip, "a ZIP archive", "unzip"},
    {[](std::string_view head) { return head.size() > 2 && head[0] == '\x80' && head[1] >= 2 && head[1] <= 5; },
     "a pickle of Python",
     "pip install pandas; python3 -c \"import pandas; "
     "pandas.read_pickle('LOG.pkl').reset_index().to_csv('LOG.csv', index=False)\""},
    {[](std::string_view head) { return lineOf(head, 0) == "-1" && startsWith(lineOf(head, 1), "58"); },
     "a universal file (UFF 58)",
     "pip install pyuff numpy; python3 -c \"import pyuff, numpy as n; s = pyuff.UFF('LOG.uff').read_sets(); "
     "n.savetxt('LOG.csv', n.c_[s[0]['x'], s[0]['data'], s[1]['data']], delimiter=',', "
     "header='time_s,displacement_UNIT,force_UNIT', comments='')\", where UNIT stands for the units of the sets"},
    {[](std::string_view head) {
       return head.find("#BEGINGLOBALHEADER") != std::string_view::npos ||
              head.find("#BEGINCHANNELHEADER") != std::string_view::npos;
     },
     "the header of a DIAdem file, whose numbers are in other files", "in DIAdem, save the channels as text (CSV)"},
    {[](std::string_view head) {
       return (lineOf(head, 0) == "header:" &&
               (startsWith(lineOf(head, 1), "seq:") || startsWith(lineOf(head, 1), "stamp:"))) ||
              (lineOf(head, 1) == "---" && startsWith(lineOf(head, 0), "data:"));
     },
     "output of rostopic echo",
     "record a bag with rosbag record TOPIC, or write rostopic echo -p TOPIC > LOG.csv and read it with --columns "
     "time=%time displacement=field.displacement --unit time=ns displacement=m"},
    {isJson, "JSON",
     "pip install pandas; python3 -c \"import pandas; pandas.read_json('LOG.json').to_csv('LOG.csv', index=False)\", "
     "with lines=True if each line is an object"},
};

const Mark* markOf(const std::string& head) {
  for (const Mark& mark : kMarks) {
    if (std::string_view(head).substr(0, mark.begin.size()) == mark.begin) {
      return &mark;
    }
  }
  return nullptr;
}

const Look* lookOf(const std::string& head) {
  const auto* const look =
      std::find_if(std::begin(kLooks), std::end(kLooks), [&](const Look& one) { return one.fits(head); });
  return look == std::end(kLooks) ? nullptr : look;
}

[[noreturn]] void refuse(const char* name, const char* remedy) {
  throw std::runtime_error(
      fmt::format("{}: this format cannot be read; accepted: text (CSV), also in gzip, .mat, HDF5, RPC III, ROS bag; "
                  "to convert it: {}",
                  name, remedy));
}

}  // namespace

FileFormat formatOf(const std::string& head) {
  const Mark* mark = markOf(head);
  return mark != nullptr ? mark->format : lookOf(head) != nullptr ? FileFormat::foreign : FileFormat::text;
}

void refuseUnpacked(std::size_t unpacked, std::size_t packed, bool large, std::size_t size) {
  constexpr std::size_t kFreely = 64UL * 1024 * 1024;  // bytes
  constexpr std::size_t kMostTimes = 100;
  element::refuseIf<std::runtime_error>(
      !large && unpacked > kFreely && unpacked / kMostTimes > packed,
      "expands to more than 64 MiB and to more than {} times its {} bytes; accepted: a smaller factor, or --large",
      kMostTimes, std::max(size, packed));
}

bool isRegularFile(const std::string& path) {
  struct stat status{};
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
  if (const Mark* const mark = markOf(head)) {
    refuse(mark->name, mark->remedy);
  }
  if (const Look* const look = lookOf(head)) {
    refuse(look->name, look->remedy);
  }
}

}  // namespace rubber_suspension::log
