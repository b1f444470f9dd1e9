#!/usr/bin/python3
"""Tests of the layouts for plotting programs: every curve is a field of a message that the node publishes."""
import ast
import json
import pathlib
import re
import unittest
from xml.etree import ElementTree

PACKAGE = pathlib.Path(__file__).resolve().parents[2]
MESSAGES = {"displacement": "Displacement", "force": "Force", "measured_force": "MeasuredForce", "gap": "Gap"}
COMPONENT = "left_secondary"


def fields(message):
    text = (PACKAGE / "msg" / (message + ".msg")).read_text()
    return set(re.findall(r"^(?:float64|uint8|uint32)\s+(\w+)\s*(?:#.*)?$", text, re.MULTILINE))


class Curves(unittest.TestCase):
    def check(self, curve):
        _, component, topic, field = curve.split("/")
        self.assertEqual(component, COMPONENT)
        self.assertIn(field, fields(MESSAGES[topic]), curve)

    def test_plotjuggler(self):
        root = ElementTree.parse(PACKAGE / "config" / "bench_plotjuggler.xml").getroot()
        self.assertEqual([plot.get("mode") for plot in root.iter("plot")].count("XYPlot"), 1)
        for plot in root.iter("plot"):
            curves = plot.findall("curve")
            self.assertTrue(curves)
            for curve in curves:
                self.assertRegex(curve.get("color"), "^#[0-9a-f]{6}$")
                for name in (["name"] if plot.get("mode") == "TimeSeries" else ["curve_x", "curve_y"]):
                    self.check(curve.get(name))

    def test_plotjuggler_splitters_hold_as_many_as_they_say(self):
        root = ElementTree.parse(PACKAGE / "config" / "bench_plotjuggler.xml").getroot()
        for splitter in root.iter("DockSplitter"):
            self.assertEqual(int(splitter.get("count")), len(splitter))
            self.assertEqual(len(splitter.get("sizes").split(";")), len(splitter))

    def test_rqt_plot(self):
        groups = json.loads((PACKAGE / "config" / "bench_rqt_plot.perspective").read_text())["groups"]
        manager = groups["pluginmanager"]
        running = ast.literal_eval(manager["keys"]["running-plugins"]["repr"])
        self.assertEqual({"plugin__rqt_plot__Plot__%d" % i for i in running["rqt_plot/Plot"]}, set(manager["groups"]))
        for group in manager["groups"].values():
            keys = group["groups"]["plugin"]["keys"]
            for curve in ast.literal_eval(keys["topics"]["repr"]):
                self.check(curve)


if __name__ == "__main__":
    unittest.main()
