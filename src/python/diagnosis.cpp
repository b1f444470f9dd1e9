// The diagnosis in Python: one call, which returns plain values.
#include "rubber_suspension/diagnosis/diagnosis.h"

#include <algorithm>

#include "python/bindings.h"

namespace rubber_suspension::python {
namespace {

using diagnosis::Diagnosis;

Diagnosis diagnose(const io::ComponentDescription& component, const std::vector<log::Log>& logs,
                   const std::vector<log::Log>& hold_out, int threads, const std::vector<std::string>& exclude) {
  if (threads < 1 || threads > 64) {
    throw std::invalid_argument("threads: " + std::to_string(threads) + " is out of range; accepted: 1 to 64");
  }
  const auto is_same = [](const log::Log& one, const log::Log& other) {
    return one.stamp == other.stamp && one.displacement == other.displacement && one.force == other.force;
  };
  for (const log::Log& log : hold_out) {
    if (std::any_of(logs.begin(), logs.end(), [&](const log::Log& other) { return is_same(log, other); })) {
      throw std::invalid_argument(log.name + ": is both in logs and in hold_out; accepted: each log once");
    }
  }
  diagnosis::DiagnosisOptions options;
  options.threads = threads;
  options.excluded = exclude;
  const py::gil_scoped_release others_run;
  return diagnosis::diagnose(component, logs, hold_out, options);
}

py::object toReport(const Diagnosis& diagnosis) {
  return py::module_::import("json").attr("loads")(diagnosis::toJson(diagnosis));
}

void write(const Diagnosis& diagnosis, const std::string& folder) {
  const std::string problem = diagnosis::writeReport(diagnosis, folder);
  if (!problem.empty() && PyErr_WarnEx(PyExc_RuntimeWarning, problem.c_str(), 1) != 0) {
    throw py::error_already_set();
  }
}

}  // namespace

void addDiagnosis(py::module_& module) {
  py::class_<Diagnosis> type(module, "Diagnosis", "Result of a diagnosis.");
  makeByNew(type)
      .def_property_readonly("verdict", [](const Diagnosis& diagnosis) { return toString(diagnosis.answer.verdict); })
      .def_readonly("sentence", &Diagnosis::sentence, "The verdict in words.")
      .def_property_readonly(
          "effects", [](const Diagnosis& diagnosis) { return diagnosis.answer.effects; },
          "Names of the effects that the model lacks, most important first.")
      .def_property_readonly(
          "augmented", [](const Diagnosis& diagnosis) { return diagnosis.law.augmented; },
          "The component with the named effects added.")
      .def_readonly("re_estimated", &Diagnosis::re_estimated, "The component, re-estimated from the logs.")
      .def("report", &toReport, "All of report.json as a dict.")
      .def("write", &write, py::arg("folder"),
           "Write report.json, report.html and augmented.yaml into a folder, which is created if missing. Warns if the "
           "page cannot be drawn. Raises RuntimeError.")
      .def("__repr__", [](const Diagnosis& diagnosis) { return "<Diagnosis: " + diagnosis.sentence + ">"; });
  module.def("diagnose", &diagnose, py::arg("component"), py::arg("logs"),
             py::arg("hold_out") = std::vector<log::Log>(), py::arg("threads") = 2,
             py::arg("exclude") = std::vector<std::string>(),
             "Find where the component differs from measured logs, which effect it lacks, and how much of the gap this "
             "effect closes, like the command diagnose. Raises LogError and ValueError.");
}

}  // namespace rubber_suspension::python
