// Components in Python: loaded from files, estimated or made from elements, stepped, and simulated over arrays.
#include <fmt/format.h>
#include <pybind11/complex.h>
#include <pybind11/numpy.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "element/refuse.h"
#include "estimation/models.h"
#include "python/bindings.h"
#include "rubber_suspension/gap/replay.h"
#include "rubber_suspension/io/component_file.h"
#include "rubber_suspension/response/sweep.h"

namespace rubber_suspension::python {
namespace {

using io::ComponentDescription;

class Motion {
 public:
  Motion(std::shared_ptr<const component::Component> component, double displacement)
      : component_(std::move(component)), state_(component_->makeState()) {
    requireFinite(displacement);
    force_ = component_->initialise(state_, displacement);
  }

  double step(double dt, double displacement) {
    requireFinite(displacement);
    requirePositive(dt);
    force_ = component_->step(state_, dt, displacement);
    requireFiniteForce(force_.total, displacement);
    return force_.total;
  }

  void setTemperature(double temperature) { component_->setTemperature(state_, temperature); }

  static void requireFinite(double displacement) {
    element::refuseIf(!std::isfinite(displacement), "displacement: {} is not finite; accepted: a finite number in m",
                      displacement);
  }

  static void requireFiniteForce(double force, double displacement) {
    element::refuseIf(!std::isfinite(force),
                      "displacement: {:g} m gives a force that is not finite; accepted: a smaller displacement",
                      displacement);
  }

  static void requirePositive(double dt) {
    element::refuseIf(!(dt > 0.0) || !std::isfinite(dt), "dt: {:g} s is out of range; accepted: greater than 0", dt);
  }

  const element::ComponentForce& force() const { return force_; }

 private:
  std::shared_ptr<const component::Component> component_;
  component::ComponentState state_;
  element::ComponentForce force_{};
};

// Returns the forces of a component that is at rest at the first displacement and then steps through all others.
Array simulate(const ComponentDescription& description, const py::object& displacement, double dt) {
  Motion::requirePositive(dt);
  const std::vector<double> path = toVector(displacement, "displacement");
  element::refuseIf(path.empty(), "displacement: the array is empty; accepted: at least one value");
  std::vector<double> force(path.size());
  {
    const py::gil_scoped_release others_run;
    const component::Component component = description.makeComponent();
    component::ComponentState state = component.makeState();
    force[0] = component.initialise(state, path[0]).total;
    component.simulate(state, dt, path.data() + 1, path.size() - 1, force.data() + 1);
  }
  for (std::size_t i = 0; i < path.size(); ++i) {
    Motion::requireFiniteForce(force[i], path[i]);
  }
  return toArray(force);
}

Array replay(const ComponentDescription& description, const log::Log& log) {
  std::vector<double> force;
  {
    const py::gil_scoped_release others_run;
    force = gap::simulateLog(description.makeComponent(), log);
  }
  return toArray(force);
}

// Returns the complex stiffness as a number for one frequency, or as an array of the same shape for an array.
py::object stiffness(const ComponentDescription& description,
                     const py::array_t<double, py::array::forcecast>& frequency,
                     const std::optional<double>& temperature) {
  const component::Component component = description.makeComponent();
  const auto at = [&](double f) {
    return temperature ? component.complexStiffness(f, *temperature) : component.complexStiffness(f);
  };
  if (!component.linear()) {
    return py::none();
  }
  if (frequency.ndim() == 0) {
    return py::cast(*at(*frequency.data()));
  }
  return py::vectorize([&](double f) { return *at(f); })(frequency);
}

// Returns stiffness and loss angle of the settled loops at pairs of frequency and amplitude.
py::tuple characteristics(const ComponentDescription& description, const py::object& frequency,
                          const py::object& amplitude) {
  const std::vector<double> frequencies = toVector(frequency, "frequency");
  const std::vector<double> amplitudes = toVector(amplitude, "amplitude");
  element::refuseIf(frequencies.size() != amplitudes.size(),
                    "there are {} frequencies and {} amplitudes; accepted: equal numbers", frequencies.size(),
                    amplitudes.size());
  std::vector<double> stiffness;
  std::vector<double> loss_angle;
  {
    const py::gil_scoped_release others_run;
    const component::Component component = description.makeComponent();
    for (std::size_t i = 0; i < frequencies.size(); ++i) {
      element::refuseIf(frequencies[i] <= 0.0 || amplitudes[i] <= 0.0,
                        "a sine of {:g} Hz and {:g} m is impossible; accepted: frequency and amplitude greater than 0",
                        frequencies[i], amplitudes[i]);
      const response::SweepPoint point = response::characteristicsAt(component, frequencies[i], amplitudes[i]);
      element::refuseIf(!point.settled, "{:g} Hz and {:g} m: the loop does not settle", frequencies[i], amplitudes[i]);
      stiffness.push_back(point.characteristics.stiffness);
      loss_angle.push_back(point.characteristics.loss_angle);
    }
  }
  return py::make_tuple(toArray(stiffness), toArray(loss_angle));
}

double toShare(const py::handle& value) {
  if (py::isinstance<py::str>(value) && py::cast<std::string>(value) == "guess") {
    return estimation::SheetTolerance::kGuess;
  }
  const element::ParameterInfo share{"tolerance", "1", element::Role::choice, element::Range::openBelow(0.0, 1.0),
                                     "a share, or 'guess'"};
  const double tolerance = toNumber(value, share);
  estimation::checkRange(share, tolerance);
  return tolerance;
}

// Converts one tolerance for all numbers, or a dict with a tolerance for each key.
estimation::SheetTolerance toTolerance(const py::handle& value) {
  if (!py::isinstance<py::dict>(value)) {
    return {toShare(value)};
  }
  estimation::SheetTolerance tolerance;
  for (const auto& [key, share] : py::cast<py::dict>(value)) {
    const auto name = py::cast<std::string>(key);
    element::refuseIf(!estimation::isOfSheet(name), "tolerance: '{}' is not an input of a data sheet", name);
    tolerance.by_key[name] = toShare(share);
  }
  return tolerance;
}

ComponentDescription estimate(const std::string& model, const std::string& name, const py::kwargs& inputs) {
  const std::optional<estimation::Model> found = estimation::modelFromString(model);
  element::refuseIf(!found || *found == estimation::Model::elements,
                    "'{}' is not a model with a specification; accepted: kelvin_voigt, "
                    "maxwell, maxwell_dashpot, friction, friction_dashpot, berg, multi_maxwell",
                    model);
  estimation::Specification specification;
  for (const auto& [key, value] : inputs) {
    const auto input = py::cast<std::string>(key);
    if (input == "tolerance") {
      specification.setTolerance(toTolerance(value));
      continue;
    }
    const element::ParameterInfo* parameter = element::findParameter(estimation::specificationParameters(), input);
    specification.set(input,
                      parameter == nullptr ? 0.0 : toNumber(value, *parameter));  // unknown keys are refused below
  }
  ComponentDescription description(name, *found, std::move(specification));
  io::toYaml({description});  // throws for a name that no file can contain
  return description;
}

ComponentDescription ofElements(const py::sequence& elements, const std::string& name) {
  ComponentDescription description(name, toElements(elements));
  description.makeComponent();  // throws if the elements do not fit together
  io::toYaml({description});    // throws for a name that no file can contain
  return description;
}

ComponentDescription load(const std::string& path, const std::string& name) {
  return io::selectComponent(io::loadComponentFile(path), name, path);
}

void addMotion(py::module_& module) {
  py::class_<Motion>(module, "Motion", "A component in motion with its history; Component.start() creates it.")
      .def_static("__new__",
                  [](const py::args&, const py::kwargs&) {
                    throw py::type_error("a Motion cannot be created directly; accepted: Component.start()");
                  })
      .def("step", &Motion::step, py::arg("dt"), py::arg("displacement"),
           "Advance by dt > 0 [s] to a displacement [m], linear in between; returns the force [N]. Raises ValueError.")
      .def("set_temperature", &Motion::setTemperature, py::arg("temperature"),
           "Temperature [degC] of the next steps, for a component that shifts with it. Raises ValueError.")
      .def_property_readonly(
          "force", [](const Motion& motion) { return motion.force().total; }, "[N]")
      .def_property_readonly(
          "elastic", [](const Motion& motion) { return motion.force().elastic; }, "[N]")
      .def_property_readonly(
          "viscous", [](const Motion& motion) { return motion.force().viscous; }, "[N]")
      .def_property_readonly("friction", [](const Motion& motion) { return motion.force().friction; }, "[N]");
}

}  // namespace

void addComponents(py::module_& module) {
  py::register_exception<io::ComponentFileError>(module, "ComponentFileError", PyExc_ValueError);
  addMotion(module);
  py::class_<ComponentDescription> type(module, "Component", "A component as a component file describes it.");
  makeByNew(type)
      .def(py::init(&ofElements), py::arg("elements"), py::arg("name") = "component",
           "A component from a list of elements such as {'type': 'spring', 'stiffness': '3 kN/mm'}. Raises ValueError.")
      .def_readonly("name", &ComponentDescription::name)
      .def_property_readonly("model", [](const ComponentDescription& d) { return estimation::toString(d.model()); })
      .def_property_readonly(
          "specification", [](const ComponentDescription& d) { return d.specification().values(); },
          "Inputs of the model in SI units; empty without a specification.")
      .def_property_readonly(
          "elements", [](const ComponentDescription& d) { return fromElements(d.allElements()); },
          "All elements: the elements of the model and the added elements.")
      .def("without_rig", &ComponentDescription::withoutRig,
           "The component without the elements that describe the test rig: entries with of_rig, and elements of the "
           "measuring chain.")
      .def(
          "start",
          [](const ComponentDescription& d, double displacement) {
            return Motion(std::make_shared<component::Component>(d.makeComponent()), displacement);
          },
          py::arg("displacement") = 0.0, "A Motion at rest at a displacement [m], relaxed and never loaded before.")
      .def("simulate", &simulate, py::arg("displacement"), py::arg("dt"),
           "Forces [N] for displacements [m] in steps of dt [s], from rest at the first. Raises ValueError.")
      .def("replay", &replay, py::arg("log"),
           "Forces [N] at the samples of a log, identical to the forces of replay and of the node. Raises LogError.")
      .def("stiffness", &stiffness, py::arg("frequency"), py::arg("temperature") = py::none(),
           "Complex dynamic stiffness [N/m] at a frequency [Hz] or an array of them, and at a temperature [degC] if "
           "the component shifts with temperature; None for a nonlinear component. Raises ValueError.")
      .def("characteristics", &characteristics, py::arg("frequency"), py::arg("amplitude"),
           "Stiffness [N/m] and loss angle [rad] under sines with arrays of frequencies [Hz] and amplitudes [m]: in "
           "closed form for a linear component, from settled loops for any other. Raises ValueError.")
      .def(
          "to_yaml", [](const ComponentDescription& d) { return io::toYaml({d}); }, "Text of a component file.")
      .def("__repr__", [](const ComponentDescription& d) {
        return fmt::format("<Component {}, model {}>", d.name, estimation::toString(d.model()));
      });
  module.def("load", &load, py::arg("path"), py::arg("component") = "",
             "Load a component by name from a file; without a name, the only component of the file. Raises "
             "ComponentFileError.");
  module.def("estimate", &estimate, py::arg("model"), py::pos_only(), py::arg("name") = "component",
             "A component from its specification: estimate('multi_maxwell', static_stiffness='3 kN/mm', ...). Raises "
             "ValueError.");
}

}  // namespace rubber_suspension::python
