// Logs in Python: functions that read them from files or make them from arrays.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "element/refuse.h"
#include "python/bindings.h"
#include "rubber_suspension/gap/gap.h"
#include "rubber_suspension/log/log.h"

namespace rubber_suspension::python {
namespace {

// Limit of the stamps, which are 64-bit integers [ns]: 285 years.
constexpr double kLongestTime = 9.0e9;  // [s]

log::Log readLog(const std::string& path, const std::vector<std::string>& columns, const std::string& unit,
                 double sampling_rate, const std::string& decimal, const std::string& segment, double bridge,
                 bool accept_units, bool large, const std::string& sentinel) {
  log::LogFormat format = log::makeLogFormat(columns, unit, sampling_rate, decimal, segment, bridge, sentinel);
  format.accept_units = accept_units;
  format.large = large;
  const py::gil_scoped_release others_run;
  return log::readLog(path, format);
}

log::Log makeLog(const py::object& time, const py::object& displacement, const py::object& force,
                 const std::string& name) {
  log::Log log;
  log.name = name;
  for (const double t : toVector(time, "time")) {
    element::refuseIf(std::abs(t) > kLongestTime, "time: {:g} s is out of range; accepted: at most {:g} s", t,
                      kLongestTime);
    log.stamp.push_back(std::llround(t * 1e9));
  }
  log.displacement = toVector(displacement, "displacement");
  log.force = force.is_none() ? std::vector<double>() : toVector(force, "force");
  log::checkLog(log);
  return log;
}

Array timeOf(const log::Log& log) {
  std::vector<double> time(log.size());
  for (std::size_t i = 0; i < log.size(); ++i) {
    time[i] = log.time(i);
  }
  return toArray(time);
}

}  // namespace

void addErrors(py::module_& module) { py::register_exception<log::LogError>(module, "LogError", PyExc_ValueError); }

void addLogs(py::module_& module) {
  py::class_<log::Log> type(module, "Log", "A recorded log in SI units.");
  makeByNew(type)
      .def(py::init(&makeLog), py::arg("time"), py::arg("displacement"), py::arg("force") = py::none(),
           py::arg("name") = "log",
           "A log from arrays: time [s], which increases, displacement [m] and, if measured, force [N]. Raises "
           "LogError and ValueError.")
      .def_readonly("name", &log::Log::name)
      .def_readonly("notes", &log::Log::notes, "Notes on columns that were ignored or interpreted, with the reasons.")
      .def_property_readonly("time", &timeOf, "[s]")
      .def_property_readonly(
          "displacement", [](const log::Log& log) { return toArray(log.displacement); }, "[m]")
      .def_property_readonly(
          "force", [](const log::Log& log) { return toArray(log.force); }, "Measured force [N], or empty.")
      .def_property_readonly(
          "counts", [](const log::Log& log) { return toArray(log.counts); },
          "1 where the force was measured, 0 where it is interpolated; empty if it was measured throughout.")
      .def_property_readonly(
          "temperature", [](const log::Log& log) { return toArray(log.temperature); }, "[degC], or empty.")
      .def("__len__", &log::Log::size)
      .def("__repr__", [](const log::Log& log) { return fmt::format("<Log {}, {} samples>", log.name, log.size()); });
  module.def("read_log", &readLog, py::arg("path"), py::arg("columns") = std::vector<std::string>(),
             py::arg("unit") = "", py::arg("sampling_rate") = 0.0, py::arg("decimal") = "", py::arg("segment") = "",
             py::arg("bridge") = -1.0, py::arg("accept_units") = false, py::arg("large") = false,
             py::arg("sentinel") = "",
             "Read a log from text (CSV), .mat or HDF5; columns, unit, sampling_rate, decimal, segment, bridge, "
             "accept_units, large and sentinel have the meaning of the commands' options. Raises LogError.");
  module.def(
      "gap",
      [](const py::object& measured, const py::object& simulated) {
        return gap::relativeGap(toVector(measured, "measured"), toVector(simulated, "simulated"));
      },
      py::arg("measured"), py::arg("simulated"),
      "RMS of measured minus simulated force over the standard deviation of the measured force. Raises ValueError.");
}

}  // namespace rubber_suspension::python
