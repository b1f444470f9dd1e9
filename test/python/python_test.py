#!/usr/bin/python3
"""Tests of the Python module rubber_suspension_core: forces equal those of the commands, errors are exceptions."""
import csv
import pathlib
import tempfile
import unittest

import numpy
import rubber_suspension_core as rs

CONFIG = pathlib.Path(__file__).resolve().parents[2] / "config"
EXAMPLE = str(CONFIG / "example.yaml")
DIAGNOSIS = CONFIG / "diagnosis_example"
FIVE_INPUTS = {"static_stiffness": "3 kN/mm", "dynamic_stiffness": 4.2e6, "nominal_frequency": 4.0,
               "maximum_stiffness": "4.9 MN/m", "high_frequency": "25 Hz"}


def sine(samples=2000, dt=1e-3, amplitude=2e-3, frequency=4.0):
    return amplitude * numpy.sin(2 * numpy.pi * frequency * dt * numpy.arange(samples))


class Components(unittest.TestCase):
    def test_is_that_of_the_file(self):
        component = rs.load(EXAMPLE, "left_secondary")
        self.assertEqual((component.name, component.model), ("left_secondary", "multi_maxwell"))
        self.assertEqual(component.specification["static_stiffness"], 3e6)
        self.assertIn("friction", [element["type"] for element in component.elements])
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            file.write(component.to_yaml())
            file.flush()
            self.assertEqual(rs.load(file.name).elements, component.elements)

    def test_takes_real_numbers_alone(self):
        component = rs.load(EXAMPLE, "left_secondary")
        masked = numpy.ma.array([0.0, 1e-3], mask=[False, True])
        dates = numpy.array(["2025-03-12", "2025-03-13"], dtype="datetime64[D]")
        structured = numpy.zeros(2, dtype=[("z", float)])
        for values in (masked, dates, structured, numpy.array([0.0, 1e-3j]), ["a", "b"], [0.0, numpy.nan], [[0.0], [1.0]]):
            with self.assertRaises(ValueError, msg=repr(values)):
                component.simulate(values, dt=1e-3)
        self.assertEqual(component.simulate([0, 1], dt=1e-3).shape, (2,))
        with self.assertRaises(ValueError):
            component.simulate([0.0, 1e304], dt=1e-3)
        with self.assertRaises(ValueError):
            component.start().step(1e-3, 1e304)

    def test_is_made_whole(self):
        with self.assertRaises(TypeError):
            rs.Motion.__new__(rs.Motion)
        for made in (rs.Log, rs.Component, rs.Diagnosis):
            with self.assertRaises(TypeError):
                made.__new__(made)
            with self.assertRaises(TypeError):
                made.__new__(int)
        log = rs.Log.__new__(rs.Log, [0.0, 1.0], [0.0, 1e-3])
        self.assertEqual(len(log), 2)

        class Named(rs.Component):
            def __init__(self, stiffness):
                super().__init__([{"type": "spring", "stiffness": stiffness}], name="named")
        self.assertEqual(Named(1e6).name, "named")
        with self.assertRaises(ValueError):
            rs.Component([{"type": "spring", "stiffness": 1e6}], name="a: b\n  c: {")

    def test_steps_are_the_simulation(self):
        component = rs.load(EXAMPLE, "left_secondary")
        displacement = sine()
        forces = component.simulate(displacement, dt=1e-3)
        motion = component.start(displacement[0])
        stepped = [motion.force] + [motion.step(1e-3, z) for z in displacement[1:]]
        self.assertEqual(forces.tolist(), stepped)  # equal to the last bit
        self.assertAlmostEqual(motion.elastic + motion.viscous + motion.friction, motion.force, delta=1e-6)

    def test_estimates_a_specification(self):
        component = rs.estimate("multi_maxwell", **FIVE_INPUTS)
        stiffness = component.stiffness(4.0)
        self.assertAlmostEqual(abs(stiffness) / 4.2e6, 1.0, delta=1e-6)  # K_n of the specification
        self.assertGreater(stiffness.imag, 0.0)
        self.assertIsNone(rs.load(EXAMPLE, "left_secondary").stiffness(4.0))  # None, because friction is not linear
        for tolerance, text in (("5 %", "tolerance: 0.05"), ("guess", "tolerance: guess"),
                                ({"static_stiffness": 0.02}, "tolerance: {static_stiffness: 0.02}")):
            self.assertIn(text, rs.estimate("multi_maxwell", tolerance=tolerance, **FIVE_INPUTS).to_yaml())

    def test_is_a_list_of_elements(self):
        component = rs.Component([{"type": "spring", "stiffness": "2 kN/mm"}], name="spring")
        self.assertEqual(component.simulate([0.0, 1e-3, -1e-3], dt=0.1).tolist(), [0.0, 2e3, -2e3])
        self.assertEqual(component.elements, [{"type": "spring", "stiffness": 2e6}])

    def test_leaves_its_rig_out(self):
        component = rs.Component([{"type": "spring", "stiffness": 2e6},
                                  {"type": "inertia", "mass": 10.0, "of_rig": True},
                                  {"type": "time_delay", "delay": 1e-3}])
        self.assertEqual([e.get("of_rig", False) for e in component.elements], [False, True, True])
        self.assertEqual([e["type"] for e in component.without_rig().elements], ["spring"])

    def test_follows_a_temperature(self):
        shift = {"type": "vertical_shift", "coefficient": 0.01, "reference": "20 degC"}
        component = rs.Component([{"type": "spring", "stiffness": 2e6}, shift])
        motion = component.start()
        self.assertEqual(motion.step(0.1, 1e-3), 2e3)
        motion.set_temperature(30.0)
        self.assertAlmostEqual(motion.step(0.1, 1e-3), 2.2e3, delta=1e-9)
        self.assertAlmostEqual(component.stiffness(1.0, temperature=30.0).real, 2.2e6, delta=1e-6)
        with self.assertRaisesRegex(ValueError, "temperature: -300 degC"):
            motion.set_temperature(-300.0)


class Errors(unittest.TestCase):
    def test_of_files(self):
        with self.assertRaisesRegex(rs.ComponentFileError, "did you mean 'left_secondary'"):
            rs.load(EXAMPLE, "left_secondry")
        with self.assertRaisesRegex(rs.LogError, "/nonexistent.csv"):
            rs.read_log("/nonexistent.csv")
        self.assertTrue(issubclass(rs.LogError, ValueError) and issubclass(rs.ComponentFileError, ValueError))

    def test_of_values(self):
        component = rs.Component([{"type": "spring", "stiffness": 1e6}])
        for displacement, dt, message in (([0.0, float("nan")], 1e-3, r"displacement\[1\]: nan is not finite"),
                                          ([[0.0], [1.0]], 1e-3, "has 2 dimensions; accepted: one"),
                                          ([], 1e-3, "empty"), ([0.0], 0.0, "dt: 0 s"), ([0.0], -1.0, "dt: -1 s"),
                                          ([0.0], float("inf"), "dt: inf s")):
            with self.assertRaisesRegex(ValueError, message):
                component.simulate(displacement, dt=dt)
        with self.assertRaisesRegex(ValueError, "not finite"):
            component.start(float("inf"))
        with self.assertRaisesRegex(ValueError, "dt: 0 s"):
            component.start().step(0.0, 1e-3)

    def test_of_elements(self):
        for entry, message in (({"type": "sprung", "stiffness": 1.0}, r"did you mean 'spring'"),
                               ({"stiffness": 1.0}, "type is missing"),
                               ({"type": "spring", "stifness": 1.0}, r"did you mean 'stiffness'"),
                               ({"type": "spring", "stiffness": "1 kn/mm"}, r"did you mean 'kN/mm'"),
                               ({"type": "spring", "stiffness": None}, "is not a number"),
                               ({"type": "spring", "stiffness": -1.0}, "out of range"),
                               ("spring", "is not a dict")):
            with self.assertRaisesRegex(ValueError, message):
                rs.Component([entry])

    def test_of_specifications(self):
        for change, message in (({"static_stifness": 1.0}, "did you mean 'static_stiffness'"),
                                ({"dynamic_stiffness": 2e6}, "is not above static_stiffness"),
                                ({"loss_angle": 0.1}, "exactly two of"),
                                ({"tolerance": 2.0}, "tolerance: 2 is out of range"),
                                ({"tolerance": {"nominal_frequency": 0.1}}, "not an input of a data sheet")):
            with self.assertRaisesRegex(ValueError, message):
                rs.estimate("multi_maxwell", **{**FIVE_INPUTS, **change})
        with self.assertRaisesRegex(ValueError, "accepted: kelvin_voigt"):
            rs.estimate("elements")


class Logs(unittest.TestCase):
    def test_reads_what_the_file_says(self):
        path = DIAGNOSIS / "log_1_sweep.csv"
        log = rs.read_log(str(path))
        with open(path, newline="", encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(log), len(rows))
        self.assertEqual([round(1e9 * t) for t in log.time], [round(1e9 * float(row["time_s"])) for row in rows])
        self.assertTrue(numpy.allclose(log.force, [1e3 * float(row["force_kN"]) for row in rows], rtol=1e-15))

    def test_made_of_arrays(self):
        component = rs.load(EXAMPLE, "left_secondary")
        time, displacement = 1e-3 * numpy.arange(2000), sine()
        log = rs.Log(time, displacement)
        # Stamps are whole nanoseconds, so the steps are exactly a millisecond.
        self.assertEqual(component.replay(log).tolist(), component.simulate(displacement, dt=1e-3).tolist())
        self.assertEqual(len(log.force), 0)
        with self.assertRaisesRegex(rs.LogError, "time"):
            rs.Log(time[::-1], displacement)
        with self.assertRaisesRegex(rs.LogError, "accepted"):
            rs.Log(time[:-1], displacement)
        with self.assertRaisesRegex(ValueError, "out of range"):
            rs.Log(1e12 * time, displacement)

    def test_gap_is_relative_to_the_deviation_of_the_force(self):
        measured = numpy.array([1.0, -1.0, 1.0, -1.0])
        self.assertAlmostEqual(rs.gap(measured, 0.5 * measured), 0.5, places=12)
        with self.assertRaises(ValueError):
            rs.gap(measured, measured[:2])


class Diagnosis(unittest.TestCase):
    def test_names_the_friction_of_the_example(self):
        component = rs.load(str(DIAGNOSIS / "component.yaml"))
        logs = [rs.read_log(str(path)) for path in sorted(DIAGNOSIS.glob("log_*.csv"))]
        hold_out = [rs.read_log(str(path)) for path in sorted(DIAGNOSIS.glob("hold_out_*.csv"))]
        found = rs.diagnose(component, logs, hold_out)
        self.assertEqual((found.verdict, found.effects), ("named", ["friction"]))
        self.assertEqual(found.report()["schema"], "rubber_suspension/gap_report/1")
        self.assertLess(rs.gap(hold_out[0].force, found.augmented.replay(hold_out[0])),
                        rs.gap(hold_out[0].force, component.replay(hold_out[0])))
        with tempfile.TemporaryDirectory() as folder:
            found.write(folder)
            self.assertEqual(rs.load(folder + "/augmented.yaml").elements, found.augmented.elements)

    def test_refuses_what_the_command_refuses(self):
        component = rs.load(str(DIAGNOSIS / "component.yaml"))
        with self.assertRaises(ValueError):
            rs.diagnose(component, [rs.Log([0.0, 1.0], [0.0, 1e-3])])
        with self.assertRaisesRegex(ValueError, "threads"):
            rs.diagnose(component, [], threads=0)


if __name__ == "__main__":
    unittest.main()
