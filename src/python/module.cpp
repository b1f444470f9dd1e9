// The Python module rubber_suspension_core: the libraries without ROS, for notebooks and scripts.
#include "python/bindings.h"

PYBIND11_MODULE(rubber_suspension_core, module) {
  using namespace rubber_suspension::python;
  module.doc() =
      "Simulates rubber components of vehicle suspensions and diagnoses the gap to measured logs. All in SI units.";
  module.attr("__version__") = RUBBER_SUSPENSION_VERSION;
  addErrors(module);
  addLogs(module);
  addComponents(module);
  addDiagnosis(module);
}
