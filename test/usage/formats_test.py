#!/usr/bin/python3
"""Files of other programs, written and read by code of this test: RPC III, property files, tables, k and c.

Usage: formats_test.py FOLDER_OF_THE_COMMANDS.
"""
import cmath
import csv
import io
import json
import math
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import unittest

import numpy as np
import scipy.io

PROGRAMS = pathlib.Path(sys.argv.pop(1))
CONFIG = pathlib.Path(__file__).resolve().parents[2] / "config"
# A spring with two Maxwell elements, whose K* is known.
K, K1, F1, K2, F2 = 2e6, 5e5, 1.0, 8e5, 20.0
COMPONENT = f"""components:
  bush:
    model: elements
    elements:
      - {{type: spring, stiffness: {K}}}
      - {{type: maxwell, stiffness: {K1}, break_frequency: {F1}}}
      - {{type: maxwell, stiffness: {K2}, break_frequency: {F2}}}
"""


def stiffness(frequency):
    def maxwell(k, corner):
        return k * 1j * frequency / corner / (1 + 1j * frequency / corner)
    return K + maxwell(K1, F1) + maxwell(K2, F2)


def run(command, *arguments):
    return subprocess.run([PROGRAMS / command, *map(str, arguments)], capture_output=True, text=True, timeout=120, check=False)


def rpc(channels, step, big_end=False, floats=False, frame=256, group=512):
    """Return a file of RPC III. Each channel has a name, unit, scale and numbers. Zeros fill the last frame."""
    end, kind = (">" if big_end else "<"), ("f" if floats else "h")
    frames = math.ceil(len(channels[0][3]) / frame)
    records = {"FORMAT": "BINARY_IEEE_BIG_END" if big_end else "BINARY_IEEE_LITTLE_END", "NUM_HEADER_BLOCKS": "",
               "NUM_PARAMS": "", "FILE_TYPE": "TIME_HISTORY", "TIME_TYPE": "RESPONSE", "DELTA_T": repr(step),
               "DATA_TYPE": "FLOATING_POINT" if floats else "SHORT_INTEGER", "CHANNELS": str(len(channels)),
               "PTS_PER_FRAME": str(frame), "PTS_PER_GROUP": str(group), "FRAMES": str(frames)}
    for i, (name, unit, scale, _) in enumerate(channels, 1):
        records |= {f"DESC.CHAN_{i}": name, f"UNITS.CHAN_{i}": unit, f"SCALE.CHAN_{i}": repr(scale)}
    blocks = math.ceil(len(records) / 4)
    records["NUM_HEADER_BLOCKS"], records["NUM_PARAMS"] = str(blocks), str(len(records))
    head = b"".join(k.encode().ljust(32, b"\0") + v.encode("latin-1").ljust(96, b"\0") for k, v in records.items())
    data = b""
    for first in range(0, frames * frame, group):
        for _, _, _, numbers in channels:
            part = list(numbers[first:first + group])
            part += [0] * (group - len(part))
            data += struct.pack(f"{end}{group}{kind}", *part)
    return head.ljust(512 * blocks, b"\0") + data


def curves(text):
    """Return the blocks of numbers in an Adams property file by name. Each line is a position and a force."""
    blocks = {}
    name = None
    for line in text.splitlines():
        head = re.fullmatch(r"\[(\w+)\]", line.strip())
        if head:
            name = head.group(1)
            blocks[name] = []
        elif name and not line.startswith("$"):
            blocks[name].append(line.split("=") if "=" in line else [float(word) for word in line.split()])
    return blocks


class Formats(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(tempfile.mkdtemp())
        self.config = self.folder / "bush.yaml"
        self.config.write_text(COMPONENT, encoding="utf-8")

    def path(self, name, content=None):
        if isinstance(content, bytes):
            (self.folder / name).write_bytes(content)
        elif content is not None:
            (self.folder / name).write_text(content, encoding="utf-8")
        return self.folder / name

    def export(self, form, name, *options, config=None):
        answer = run("export", "--config", config or self.config, "--format", form, "--output", self.path(name), *options)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return answer

    def forces(self, log, *options):
        answer = run("replay", "--config", self.config, "--log", log, "--output", self.path("out.csv"), *options)
        self.assertEqual(answer.returncode, 0, answer.stderr)
        return np.loadtxt(self.path("out.csv"), delimiter=",", skiprows=1), answer.stdout

    def test_rpc_logs_give_the_forces_of_their_numbers(self):
        counts = np.round(3000 * np.sin(0.05 * np.arange(1024))).astype(int)
        load = np.round(2000 * np.cos(0.05 * np.arange(1024))).astype(int)
        text = "time_s,displacement_mm,force_kN\n" + "".join(
            f"{i * 0.001953125!r},{z * 0.001!r},{f * 0.002!r}\n" for i, (z, f) in enumerate(zip(counts.tolist(), load.tolist())))
        reference, said = self.forces(self.path("log.csv", text))
        gap = said.split("gap to the measured force ")[1].split()[0]
        for big_end in (False, True):
            for group in (256, 512, 1024, 768):
                file = rpc([("Weg Kolben", "mm", 0.001, counts), ("Kraft", "kN", 0.002, load)], 0.001953125, big_end,
                           group=group)
                forces, said = self.forces(self.path("log.rsp", file))
                self.assertEqual(np.abs(forces - reference).max(), 0.0)
                self.assertIn("gap to the measured force " + gap, said)
        file = rpc([("Weg", "mm", 1.0, counts * 0.001), ("Kraft", "kN", 1.0, load * 0.002)], 0.001953125, floats=True)
        forces, _ = self.forces(self.path("float.rsp", file))
        self.assertLess(np.abs(forces - reference).max(), 1e-6 * np.abs(reference[:, 2]).max())

    def test_damaged_rpc_is_refused_with_its_place(self):
        whole = rpc([("Weg", "mm", 0.001, list(range(512)))], 0.001)
        for damaged, message in ((whole[:-200], "bytes; accepted"), (whole[:900], "record 8"),
                                 (whole.replace(b"512", b"511", 1), "PTS_PER_GROUP is 511"),
                                 (whole.replace(b"TIME_HISTORY", b"RAINFLOW\0\0\0\0"), "FILE_TYPE"),
                                 (whole.replace(b"DELTA_T", b"DELTA_U"), "DELTA_T is missing"),
                                 (whole.replace(b"SCALE.CHAN_1", b"SCALE.CHAN_7"), "SCALE.CHAN_1 is missing")):
            log = self.path("bad.rsp", damaged)
            answer = run("replay", "--config", self.config, "--log", log, "--output", self.path("none.csv"))
            self.assertEqual(answer.returncode, 1)
            self.assertEqual(answer.stderr.count("\n"), 1, answer.stderr)
            self.assertIn(f"replay: {log}: ", answer.stderr)
            self.assertIn(message, answer.stderr)
            self.assertFalse(self.path("none.csv").exists())

    def test_a_log_that_is_refused_leaves_no_output(self):
        time = np.arange(4000) * 1e-3
        z = 1e-3 * np.sin(time)
        scipy.io.savemat(self.path("whole.mat"), {"time_s": time, "displacement_m": z, "force_N": K * z})
        mat = self.path("whole.mat").read_bytes()
        rows = [f"{t!r},{d!r},{K * d!r}\n" for t, d in zip(time.tolist(), z.tolist())]
        csv_with = "time_s,displacement_m,force_N\n{}{}{}".format
        halves = "".join(rows[:3000]), "".join(rows[3000:])
        # Files that are truncated, or contain a displacement or a simulated force out of range.
        for name, content, status in (("log.mat", mat, 0), ("log.mat", mat[:len(mat) // 2], 1),
                                      ("log.csv", csv_with(halves[0], "", halves[1]), 0),
                                      ("log.csv", csv_with(halves[0], "2.9995,1e31,0\n", halves[1]), 1),
                                      ("log.csv", csv_with(halves[0], "2.9995,1e25,0\n", halves[1]), 1)):
            log, output = self.path(name, content), self.path("forces.csv")
            output.unlink(missing_ok=True)
            answer = run("replay", "--config", self.config, "--log", log, "--output", output, "--compare")
            self.assertEqual((answer.returncode, output.exists()), (status, status == 0), answer.stderr)
            self.assertEqual(answer.stderr.startswith("replay: "), status == 1, answer.stderr)

    def test_kc_has_k_star_at_its_sine(self):
        self.export("kc", "kc.yaml", "--frequency", 4)
        lines = self.path("kc.yaml").read_text(encoding="utf-8").splitlines()
        values = {key: float(value) for key, value in (line.split(": ") for line in lines if not line.startswith("#"))}
        k_star = values["k_N_per_m"] + 2j * math.pi * 4 * values["c_Ns_per_m"]
        self.assertLess(abs(k_star / stiffness(4) - 1), 1e-6)
        self.assertAlmostEqual(values["k_N_per_mm"], values["k_N_per_m"] / 1e3, 3)
        off = re.search(r"at 40 Hz and 1 mm the component has ([\d.]+) kN/mm and ([\d.]+) degrees; the spring and the dashpot have ([\d.]+)",
                        self.path("kc.yaml").read_text(encoding="utf-8"))
        self.assertAlmostEqual(float(off[1]), abs(stiffness(40)) / 1e6, 3)
        self.assertAlmostEqual(float(off[2]), math.degrees(cmath.phase(stiffness(40))), 1)
        k_40 = values["k_N_per_m"] + 2j * math.pi * 40 * values["c_Ns_per_m"]
        self.assertAlmostEqual(float(off[3]), abs(k_40) / 1e6, 3)

    def test_bus_has_the_static_curve_and_the_loss(self):
        answer = self.export("adams_bus", "bush.bus", "--frequency", 4, "--largest-displacement", "10 mm", "--axis", "x")
        text = self.path("bush.bus").read_text(encoding="utf-8")
        blocks = curves(text)
        curve = np.array(blocks["FX_CURVE"])
        np.testing.assert_allclose(curve[:, 1], K / 1e3 * curve[:, 0], rtol=1e-8, atol=1e-6)
        self.assertEqual((curve[0, 0], curve[-1, 0]), (-10.0, 10.0))
        damping = {key.strip(): float(value) for key, value in blocks["DAMPING"]}
        self.assertLess(abs(damping["FX_DAMPING"] / (stiffness(4).imag / (2 * math.pi * 4) / 1e3) - 1), 1e-6)
        self.assertEqual(damping["FY_DAMPING"], 0.0)
        for note in answer.stderr.splitlines():  # the file contains the notes that the terminal shows
            self.assertIn("$ " + note.removeprefix("export: note: "), text)
        self.assertIn("at 4 Hz and 1 mm the component has", text)

    # Exporting a component, fitting it to the table and exporting it again gives K and loss angle within 0.1 %.
    def test_tables_are_read_back(self):
        example = CONFIG / "example.yaml"
        for name in ("left_secondary", "berg_example"):
            with self.subTest(name):
                self.check_table(example, name)

    def check_table(self, config, name):
        grid = ("--component", name, "--frequencies", 0.5, 1, 2, 4, 8, 16, "--amplitudes", "0.5 mm", "2 mm")
        self.export("table", "table.csv", *grid, config=config)
        text = self.path("table.csv").read_text(encoding="utf-8")
        self.assertRegex(text, r"\n# the component has [\d.]+ kN/mm and [\d.]+ degrees at ")
        answer = run("estimate", "--config", config, "--component", name, "--from-table", self.path("table.csv"),
                     "--output", self.path("fitted.yaml"))
        self.assertEqual(answer.returncode, 0, answer.stderr)
        self.export("table", "again.csv", *grid, config=self.path("fitted.yaml"))
        for before, after in zip(self.rows("table.csv"), self.rows("again.csv"), strict=True):
            self.assertLess(abs(after[0] / before[0] - 1), 1e-3, before)
            self.assertLess(abs(after[1] / before[1] - 1), 1e-3, before)

    def rows(self, name):
        lines = [line for line in self.path(name).read_text(encoding="utf-8").splitlines() if not line.startswith("#")]
        return [(float(row["stiffness_N_per_m"]), float(row["loss_angle_rad"])) for row in csv.DictReader(io.StringIO("\n".join(lines)))]

    def test_agreement_as_a_program_reads_it(self):
        time = np.arange(2000) * 1e-3
        z = 1e-3 * np.exp(-((time - 1) / 0.3) ** 2)
        text = "time_s,displacement_m,force_N\n" + "".join(f"{t:.3f},{d!r},{1.8e6 * d!r}\n" for t, d in zip(time.tolist(), z.tolist()))
        log = self.path("pulse.csv", text)
        forces, said = self.forces(log, "--compare", "--json", self.path("a.json"))
        agreement = json.loads(self.path("a.json").read_text(encoding="utf-8"))
        difference = forces[:, 2] - 1.8e6 * forces[:, 1]
        self.assertAlmostEqual(agreement["rms_N"], np.sqrt(np.mean(difference ** 2)), 6)
        self.assertAlmostEqual(agreement["peak_error_N"], np.abs(difference).max(), 6)
        largest = 1.8e3
        inside = np.clip((0.5 * largest - np.abs(difference)) / (0.45 * largest), 0, 1) ** 2
        self.assertAlmostEqual(agreement["iso18571"]["corridor"], inside.mean(), 9)
        self.assertIn("ISO/TS 18571", said)
        answer = run("replay", "--config", self.config, "--log", log, "--output", self.path("out.csv"), "--compare",
                     "--limits", "rms=1 N")
        self.assertEqual(answer.returncode, 1)
        self.assertIn("RMS error", answer.stderr)
        answer = run("replay", "--config", self.config, "--log", log, "--output", self.path("out.csv"), "--compare",
                     "--limits", "rmsx=1")
        self.assertEqual(answer.returncode, 2)


if __name__ == "__main__":
    unittest.main()
