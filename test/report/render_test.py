#!/usr/bin/python3
"""Tests of pages that render_report draws from reports of this test: their content, names that resemble HTML, reports
of an earlier version, computers without Jinja2 or Matplotlib, and the style sheet.

Usage: render_test.py FOLDER_OF_THE_SCRIPTS
"""
import html.parser
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(sys.argv[1]).resolve()
HOSTILE = "<script>alert('1')</script> \"x\" onload='y' {{ 7*7 }} $a$ & </title>"
FIGURE = {"name": "loops", "file": "figure_loops.csv", "title": "Force over displacement", "caption": "Three cycles.",
          "axes": [{"title": HOSTILE, "x_label": "displacement [mm]", "y_label": "force [kN]", "log_x": False, "log_y": False,
                    "curves": [{"label": "measured", "style": "-", "colour": 0, "width": 3.0, "breaks": [2.5]}], "maps": []}]}


def size(frequency, amplitude, quantity, share, squared):
    return {"log": HOSTILE, "frequency_hz": frequency, "amplitude_m": amplitude, "quantity": quantity, "share": share,
            "squared_gap": squared, "noise_ratio": 10.0}


def candidate(effect, probability, **more):
    return {"effect": effect, "documentation": "a law", "probability": probability, "probability_text": "97 %", "gap": 0.02,
            "closed": 0.94, "interval_95": [0.92, 1.1], "testable": True, "visible_share": 0.9, "on_rig": False,
            "parameters": {}, "parameters_text": "maximum force 6 kN", "why_out": "", "add": [], **more}


def report():
    """Return a report that names friction."""
    errors = {"stiffness": 0.02, "loss_angle_rad": 0.01, "energy_per_cycle": None}
    return {
        "schema": "rubber_suspension/gap_report/1", "component": HOSTILE, "verdict": "named", "probability": 0.97,
        "sentence": "The model lacks friction. " + HOSTILE, "effects": ["friction"],
        "gap": {"as_configured": 0.14, "re_estimated": 0.12, "augmented": 0.02, "full_law": 0.02, "noise_floor": 0.015,
                "noise_source": "the rig"},
        "gap_as_recorded": {"as_configured": 0.14, "re_estimated": 0.12, "augmented": 0.02},
        "share_of_configured_gap": {"values": 0.14, "friction": 0.72},
        "rig_findings": [{"log": HOSTILE, "finding": "force_zero", "value": 31.0, "interval_95": [29.0, 33.0], "unit": "N",
                          "beyond_tolerance": True, "text": "", "value_text": "31 N (29 N to 33 N)", "fatal": False,
                          "sure": True, "meaning": "It does not read 0.", "remedy": "Zero the load cell."}],
        "taken_out": [{"log": HOSTILE, "kind": "zero", "share_of_force": 0.05}],
        "closed": {"fraction": 0.94, "interval_95": [0.92, 1.1]}, "confounded": [["friction"]],
        "alternatives": [{"verdict": "none", "effects": [], "probability": 0.02, "probability_text": "2 %"}], "excluded": [],
        "candidates": [candidate("friction", 0.97), candidate("creep", 0.001, why_out="leaves 11.0 %")],
        "posterior": {"none": 0.02, "parameter_error": 0.0, "effects": 0.97, "none_of_these": 0.01},
        "where": [size([2.0, 4.0], [2e-4, 5e-4], "stiffness", 0.6, 0.0121), size([4.0, 8.0], [2e-4, 5e-4], "loss", 0.3, 0.0025),
                  size([0.0, 50.0], [2e-4, 5e-4], "drift", 0.1, 0.0001)],
        "where_after": [size([4.0, 8.0], [2e-4, 5e-4], "loss", 1.0, 0.0004)], "excited_hz": [1.0, 20.0],
        "next_experiment": "sine at 4 Hz", "model_sizes": [], "effect_sizes": [], "written": [],
        "whole_component": {"sentence": "At 4 Hz the whole component has K = 2 kN/mm."},
        "errors": {"re_estimated": errors, "augmented": errors}, "samples": {"searched": 100, "recorded": 200},
        "admission": [{"log": HOSTILE, "hold_out": True, "duration_s": 20.0, "step_s": 0.01, "largest_displacement_m": 1e-3,
                       "highest_frequency_hz": 20.0, "noise_floor": 0.01, "repeats": 0.25, "gap_as_recorded": 0.14, "gap": 0.12,
                       "notes": ["one", "two"],
                       "iso18571": {side: {"corridor": 0.9, "phase": 0.9, "magnitude": 0.9, "slope": 0.9, "total": 0.9,
                                           "grade": "good"} for side in ("as_configured", "augmented")} | {"repeats": True}}],
        "in_words": {
            "headline": "The model lacks friction: gap 12.0 % to 2.0 %.", "verdict": "the model lacks the effects named here",
            "probability": "97 %", "closed": ["94", "92", "100"],
            "gap": {"as_configured": "14.0 %", "re_estimated": "12.0 %", "augmented": "2.0 %", "noise_floor": "1.5 %"},
            "shares": [{"by": "values", "share": "14 %"}, {"by": "friction", "share": "72 %"}],
            "posterior": {"none": "2 %", "parameter_error": "below 1 %", "none_of_these": "1 %"},
            "not_testable": "Every candidate would show in these logs.",
            "law": [{"number": "maximum force", "value": "6 kN", "interval_95": "5.7 to 6.4 kN"}],
            "changed": [{"value": "K_n", "before": "2 kN/mm", "after": "3 kN/mm", "interval_95": "2.9 to 3.1 kN/mm",
                         "change": "+50.0 %"}],
            "added": ["add: friction (maximum force 6 kN)"], "taken_out": [HOSTILE + ": zero 5 %"]},
        "figures": [FIGURE], "surrogate_gap": 0.02, "next_experiment_log": "next_experiment.csv",
        "experiment": {"how_to_play": "play next_experiment.csv (2 s at 100 Hz; as a drive file of RPC III next_experiment.drv)",
                       "command": "roslaunch rubber_suspension bench.launch component:=" + HOSTILE},
        "could_show": {
            "size": 0.1, "why": HOSTILE, "noise_floor": 0.01, "size_text": "10 %", "noise_floor_text": "1 %",
            "outcomes_in_numbers": "1 found", "outcomes_in_words": "Found: friction.",
            "implanted": [{"effect": "friction", "outcome": "found", "taken_for": [], "named_as": {"friction": 0.9},
                           "nothing_named": 0.1, "visible_share": 0.8, "least_size": None, "outcome_text": "found",
                           "taken_for_text": "", "least_size_text": "none"}]},
        "comparison": {"with": HOSTILE, "date": "2026", "changes": [
            {"what": "verdict", "before": "none", "after": "named", "differs": True}]},
        "meta": {"version": "1", "date": "2026-01-01T00:00:00Z", "command_line": HOSTILE,
                 "files": [{"option": "--log", "name": HOSTILE, "sha256": "ab"}]}}


class Page(html.parser.HTMLParser):
    """Collects the content of a page as a browser shows it."""

    def __init__(self, text):
        super().__init__()
        self.text, self.tags, self.attributes, self.unquoted, self.words = text, [], [], [], []
        self.feed(text)
        self.shown = " ".join("".join(self.words).split())

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        self.attributes += [name for name, _ in attributes]
        self.unquoted += re.findall(r"\s[\w:-]+=[^\"\s]", re.sub(r'"[^"]*"', '""', self.get_starttag_text()))

    def handle_data(self, data):
        if self.tags and self.tags[-1] != "style":
            self.words.append(data)


class Folder(unittest.TestCase):
    def setUp(self):
        self.scratch = tempfile.TemporaryDirectory(prefix="render.")
        self.folder = pathlib.Path(self.scratch.name)
        self.addCleanup(self.scratch.cleanup)

    def write(self, content, name="report.json"):
        (self.folder / name).write_text(content if isinstance(content, str) else json.dumps(content))

    def write_report(self, content):
        self.write(content)
        self.write("components: {}\n# " + HOSTILE, "augmented.yaml")
        panel = '"' + HOSTILE.replace('"', '""') + '"'
        self.write("curve,panel,displacement_mm,force_kN\n" + "".join(
            "\"measured\",%s,%d,%g\n" % (panel, x, 0.5 * x) for x in (1, 2, 3, 4)), "figure_loops.csv")
        self.write("curve,panel,frequency_Hz_low\n", "figure_where.csv")

    def run_script(self, *arguments, module=None):
        environment = dict(os.environ)
        if module:  # a module with this name that fails comes first in the path
            modules = self.folder / "modules"
            modules.mkdir()
            (modules / (module + ".py")).write_text("raise ImportError('none here')\n")
            environment["PYTHONPATH"] = str(modules)
        return subprocess.run([SCRIPTS / "render_report", *arguments], env=environment, capture_output=True, text=True,
                              check=False)

    def page(self, content, name="report.html", says=""):
        if isinstance(content, dict) and content["schema"] == "rubber_suspension/gap_report/1":
            self.write_report(content)
        result = self.run_script(str(self.folder))
        self.assertEqual((result.returncode, result.stderr), (0, says))
        return Page((self.folder / name).read_text())

    def assert_harmless(self, page):
        self.assertNotIn("script", page.tags)
        self.assertNotIn("onload", page.attributes)
        self.assertEqual(page.unquoted, [])
        self.assertNotIn("49", page.shown)
        self.assertIn(HOSTILE, page.shown)


class Reports(Folder):
    def test_answers_the_five_questions(self):
        page = self.page(report())
        first = page.text[:page.text.index("<h2>")]
        for answer in ("<h1>The model lacks friction: gap 12.0 % to 2.0 %.</h1>", ">maximum force</td>", ">6 kN</td>",
                       ">5.7 to 6.4 kN</td>", "friction 72 %", "other parameter values 14 %", "left 14 %", "94 % is removed",
                       "92 to 100 %", ">97 %</span>", "all else", "class=\"s5 largest\">11</td>", ">2.0</td>",
                       "at 2 to 4 Hz and 0.2 to 0.5 mm, most of it stiffness in", "<th>else</th>", ">1.0</td>",
                       "sine at 4 Hz", "<a href=\"next_experiment.csv\">next_experiment.csv</a>", "(2 s at 100 Hz",
                       "At 4 Hz the whole component has K = 2 kN/mm.", "whisker"):
            self.assertIn(answer, first)
        self.assertNotRegex(page.text, r"(?<![\w.])-?(nan|inf|Undefined)(?![\w.])")

    def test_shows_all_that_the_data_holds(self):
        shown = self.page(report()).shown
        for text in ("31 N (29 N to 33 N) beyond the rig's tolerance", "Zero the load cell.", "zero 5", "good",
                     "The measured force repeats itself.", "excerpts, each listed below as a log", "+50.0 %",
                     "+ add: friction (maximum force 6 kN)", "leaves 11.0 %", "1 candidates below 1 %", "one and two", "25 %",
                     "What changed", "Found: friction.", "friction 90 % and nothing 10 %", "Command of this run:", "0.57\u00b0",
                     "Three cycles."):
            self.assertIn(text, shown)

    def test_a_bar_is_as_long_as_its_gap(self):
        text = self.page(report()).text
        widths = re.findall(r"style=\"width:([\d.]+)%\"", text)
        self.assertEqual(widths[:6], ["14.0", "72.0", "14.0", "85.7", "14.3", "10.7"])

    def test_what_was_removed_from_the_logs_is_a_part_of_the_bar(self):
        content = report()
        content["gap_as_recorded"]["augmented"] = 0.28
        text = self.page(content).text
        widths = re.findall(r"style=\"width:([\d.]+)%\"", text)
        self.assertEqual(widths[:6], ["7.0", "36.0", "7.0", "42.9", "7.1", "92.9"])
        self.assertIn("removed from the logs before", text)

    def test_parts_end_with_the_rail(self):
        content = report()
        content["share_of_configured_gap"] = {"values": 0.9, "friction": 0.4}
        widths = re.findall(r"style=\"width:([\d.]+)%\"", self.page(content).text)
        self.assertEqual(widths[:3], ["90.0", "10.0", "0.0"])

    def test_the_cells_of_the_map_add_up(self):
        content = report()
        content["where"] = [size([2.0, 4.0], [2e-4, 5e-4], "stiffness", 0.6, 0.6 * 0.14 ** 2),
                            size([32.0, 64.0], [5e-4, 1e-3], "harmonics", 0.3, 0.3 * 0.14 ** 2),
                            size([0.0, 50.0], [2e-4, 5e-4], "drift", 0.1, 0.1 * 0.14 ** 2)]
        text = self.page(content).text
        before = text[text.index("before: as configured"):text.index("after: augmented")]
        cells = [float(cell) for cell in re.findall(r"class=\"s\d[^>]*>([\d.]+)</td>", before)]
        self.assertAlmostEqual(sum(cell ** 2 for cell in cells) ** 0.5, 14.0, delta=0.5)

    def test_candidates_that_are_not_named_are_of_the_full_law(self):
        content = report()
        content["candidates"][0]["law"], content["candidates"][1]["law"] = "written", "full"
        self.assertEqual(self.page(content).shown.count("(full law)"), 1)

    def test_names_are_harmless_text(self):
        page = self.page(report())
        self.assert_harmless(page)
        svg = page.text[page.text.index("<svg"):page.text.index("</svg>")]
        self.assertIn("&lt;script&gt;", svg)

    def test_a_bench_to_be_checked(self):
        content = report()
        content.update(verdict="check_bench", effects=[], candidates=[], where=[], where_after=[], figures=[dict(FIGURE, name="bench")])
        content["rig_findings"][0].update(finding="sign", fatal=True, text="evidence")
        del content["experiment"], content["could_show"]
        page = self.page(content)
        for text in ("What is wrong", "At the bench: Zero the load cell.", "physics would be fitted to a fault of the bench",
                     "It does not read 0. evidence.", "Broad: measured."):
            self.assertIn(text, page.shown)
        self.assertLess(page.text.index("<svg"), page.text.index("<h2>"))
        self.assertNotIn("How sure", page.shown)
        self.assert_harmless(page)

    def test_a_defect_claims_nothing(self):
        content = report()
        content.update(verdict="defect", effects=[], figures=[])
        page = self.page(content)
        self.assertIn("No effect is named and no component file is written.", page.shown)
        self.assertNotIn("31 N", page.shown)
        self.assertIn("largest |z| [mm]", page.shown)

    def test_a_rotation_and_a_table(self):
        content = report()
        stiffness = {"stiffness_N_per_m": 2e6, "loss_angle_rad": 0.1}
        content.update(units={"m": "rad", "N": "N m"}, table={
            "name": HOSTILE, "never_shown": ["stress_softening"], "notes": [HOSTILE],
            "rows": [{"frequency_hz": 4.0, "amplitude_m": 1e-3, "mean_displacement_m": 0.0, "measured": stiffness,
                      "as_configured": stiffness, "augmented": dict(stiffness, stiffness_N_per_m=1.9e6)}]})
        page = self.page(content)
        for text in ("amplitude [mrad]", "2 kN/mm, 5.73\u00b0", "5.0 %", "All 1 rows, measured and simulated", "stress softening"):
            self.assertIn(text, page.shown)
        self.assertNotIn("temperature [", page.shown)
        self.assert_harmless(page)

    def test_fields_have_their_titles(self):
        self.assertRegex(self.page(report()).text, "<td class=\"n\" data-title=\"probability\">97 %</td>")

    def test_the_same_data_gives_the_same_page(self):
        first = self.page(report()).text
        self.assertEqual(first, self.page(report()).text)
        self.assertNotIn("http", re.sub(r' xmlns(:\w+)?="[^"]*"', "", first))

    def test_an_older_report_is_drawn_without_what_it_lacks(self):
        content = report()
        for key in ("in_words", "where_after", "excited_hz", "figures"):
            del content[key]
        for entry in content["rig_findings"]:
            for key in ("value_text", "fatal", "sure", "meaning", "remedy"):
                del entry[key]
        page = self.page(content, says="render_report: %s/report.json: is of an earlier version and lacks in_words, where_after, "
                         "excited_hz, figures: the page shows the rest\n" % self.folder)
        for text in ("97 %", "14.0 %", "friction 72 %", "Force zero".lower(), "Loops", "displacement [mm]"):
            self.assertIn(text, page.shown)
        self.assertIn("<svg", page.text)
        self.assert_harmless(page)

    def test_without_jinja2_there_is_no_page(self):
        self.page(report())
        result = self.run_script(str(self.folder), module="jinja2")
        self.assertEqual(result.returncode, 0)
        self.assertRegex(result.stderr, r"^render_report: .*report.html: not drawn: needs Jinja2 \(none here\); install python3-jinja2\n$")
        self.assertFalse((self.folder / "report.html").exists(), "that of the earlier report")

    def test_without_matplotlib_there_are_no_figures(self):
        self.write_report(report())
        result = self.run_script(str(self.folder), module="matplotlib")
        self.assertEqual(result.returncode, 0)
        text = (self.folder / "report.html").read_text()
        self.assertIn("No figures: figures need Matplotlib (none here); install python3-matplotlib", text)
        self.assertNotIn("<svg", text)
        self.assertIn("How sure", text)

    def test_refuses_what_is_no_report(self):
        whole = report()
        del whole["gap"]
        for content in ("", "[]", "{}", "{\"schema\": []}", "{\"schema\": \"rubber_suspension/gap_report/2\"}", "[" * 100000, whole):
            self.write(content)
            result = self.run_script(str(self.folder))
            self.assertEqual(result.returncode, 1, content)
            self.assertRegex(result.stderr, r"^render_report: .*report\.json: [^\n]+\n$")
            self.assertFalse((self.folder / "report.html").exists())
        (self.folder / "report.json").unlink()
        self.assertIn("holds no report", self.run_script(str(self.folder)).stderr)

    def test_keeps_a_file_that_is_no_page(self):
        self.write_report(report())
        (self.folder / "report.html").write_text("mine")
        self.assertEqual(self.run_script(str(self.folder)).returncode, 1)
        self.assertEqual((self.folder / "report.html").read_text(), "mine")
        self.assertEqual(self.run_script(str(self.folder), "--force").returncode, 0)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()),
                         ["augmented.yaml", "figure_loops.csv", "figure_where.csv", "report.html", "report.json"])


class OtherPages(Folder):
    def test_six_directions(self):
        (self.folder / "x").mkdir()
        self.write_report(report())
        for name in ("report.json", "augmented.yaml", "figure_loops.csv"):
            (self.folder / name).rename(self.folder / "x" / name)
        self.write({"schema": "rubber_suspension/gap_report/six_directions/1", "component": HOSTILE, "directions": [
            {"direction": "x", "report": "x/report.json", "verdict": "named", "effects": [], "sentence": HOSTILE,
             "in_words": {"gap": {"as_configured": "14.0 %", "augmented": "2.0 %", "noise_floor": "1.5 %"}},
             "gap": {"as_configured": 0.14, "re_estimated": 0.1, "augmented": 0.02, "noise_floor": 0.015}}],
            "cross_map": {"meaning": "Share", "sentence": "x couples with y.", "shares": [
                {"of": "x", "by": "y", "share": 0.2, "share_text": "20 %", "rms": 3.0, "unit": "N"}]},
            "meta": {"version": "1", "date": "", "command_line": HOSTILE}})
        page = self.page(None)
        for text in ("14.0 %", "x couples with y.", "20 %", "by rz"):
            self.assertIn(text, page.shown)
        self.assertIn("<a href=\"x/report.html\">x</a>", page.text)
        self.assertTrue((self.folder / "x" / "report.html").exists())
        self.assert_harmless(page)

    def test_a_plan(self):
        self.write({"schema": "rubber_suspension/experiment_plan/1", "component": HOSTILE, "could_show": report()["could_show"],
                    "logs": [{"log": HOSTILE, "duration_s": 20.0, "sampling_rate_hz": 100.0, "largest_displacement_m": 1e-3,
                              "highest_rate_m_per_s": 0.1, "largest_force_N": 3000.0, "in_words": {
                                  "largest_displacement": "1 mm", "highest_rate": "0.1 m/s", "largest_force": "3 kN"}}],
                    "meta": {"version": "1", "date": "", "command_line": HOSTILE}}, "plan.json")
        page = self.page(None, "plan.html")
        self.assertIn("Experiment plan", page.shown)
        self.assertIn("Of 1 effects: 1 found.", page.shown)
        self.assertIn("3 kN", page.shown)
        self.assert_harmless(page)

    def fleet(self, count=1):
        statistics = {"components": 12, "median": 0.0, "quartiles": [-0.1, 0.1], "median_interval_95": [-0.05, 0.05]}
        link = {"component": HOSTILE, "report": "reports/00/\"><b>/report.html"}
        share = {"name": "friction", "components": 12, "share": 1.0, "interval_95": [0.8, 1.0]}
        return {"schema": "rubber_suspension/fleet/3", "jobs": {"done": 1, "failed": 2, "missing": 3},
                "types": [{"name": HOSTILE, "components": count, "verdicts": [share], "effects": [share],
                           "parameters": [{"name": "stiffness", **statistics}],
                           "far_out": [dict(link, id="1", parameter="stiffness", value=0.5877866649)],
                           "listed": [dict(link, verdict="named", effects=["friction", "creep"])]}],
                "rigs": [{"name": "", "type": HOSTILE, "parameter": "stiffness", **statistics}]}

    def test_a_fleet(self):
        self.write(self.fleet(), "fleet.json")
        page = self.page(None, "fleet.html")
        for text in ("1 jobs done, 2 failed, 3 missing", "+80.0 %", "100.0 %", "quartiles", "friction, creep",
                     "all jobs without the name of a rig", "-4.9 % to +5.1 %"):
            self.assertIn(text, page.shown)
        self.assertIn("<a href=\"reports/00/&#34;&gt;&lt;b&gt;/report.html\">", page.text)
        self.assertNotIn("more, in table.csv", page.shown)
        self.assert_harmless(page)

    def test_a_large_or_empty_fleet(self):
        self.write(self.fleet(502), "fleet.json")
        self.assertIn("and 2 more, in table.csv", self.page(None, "fleet.html").shown)
        self.write(dict(self.fleet(), types=[], rigs=[]), "fleet.json")
        self.assertIn("there is no fleet to compare", self.page(None, "fleet.html").shown)


class StyleSheet(unittest.TestCase):
    STYLE = (SCRIPTS / "report_page" / "style.css").read_text()

    def test_contrast_of_level_aa(self):
        """Checks WCAG 2.1 with the variables of the three schemes: light, dark, print."""
        def luminance(colour):
            linear = [c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
                      for c in (int(colour[i:i + 2], 16) / 255.0 for i in (0, 2, 4))]
            return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]

        def contrast(one, other):
            low, high = sorted((luminance(one), luminance(other)))
            return (high + 0.05) / (low + 0.05)

        schemes = [dict(re.findall(r"--(\w+):\s*#([0-9a-f]{6})", block))
                   for block in re.findall(r":root\s*\{([^}]*)\}", self.STYLE)]
        self.assertEqual(len(schemes), 3)
        self.assertIn("@media screen and (prefers-color-scheme: dark)", self.STYLE)
        schemes[2] = {**schemes[0], **schemes[2]}  # the print scheme inherits from the light scheme
        for scheme in schemes:
            for text in ("ink", "note", "link", "added", "removed"):
                for background in ("paper", "soft"):
                    self.assertGreaterEqual(contrast(scheme[text], scheme[background]), 4.5, text + " on " + background)
            self.assertGreaterEqual(contrast(scheme["mark"], scheme["paper"]), 3.0)

    def test_no_width_beyond_400_pixels(self):
        widths = re.findall(r"(?:^|[^-])\b(min-width|width):?\s*([\d.]+)(rem|px)\b", self.STYLE)
        self.assertTrue(widths)
        for name, value, unit in widths:
            self.assertLessEqual(float(value) * (16.0 if unit == "rem" else 1.0), 400.0 - 32.0, name)
        self.assertIn("overflow-wrap: anywhere", self.STYLE)
        self.assertIn("minmax(min(100%,", self.STYLE)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[2:], verbosity=2)
