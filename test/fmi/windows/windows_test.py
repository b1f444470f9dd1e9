#!/usr/bin/python3
"""Runs the Linux and the Windows binary of an FMU with one program, the latter under wine. Their forces must be equal.

Usage: windows_test.py FOLDER_OF_THE_COMMANDS. Skipped without wine, mingw-w64 or the binary for Windows.
"""
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree as ElementTree
import zipfile

PROGRAMS = pathlib.Path(sys.argv.pop(1))
HERE = pathlib.Path(__file__).resolve().parent
CONFIG = HERE.parents[2] / "config" / "example.yaml"
MINGW = shutil.which("x86_64-w64-mingw32-g++-posix")
WINE = shutil.which("wine64") or next(iter(map(str, pathlib.Path("/usr/lib/wine").glob("wine64"))), None)
STOP = 0.5  # [s]
FOLDERS = {2: ("linux64", "win64"), 3: ("x86_64-linux", "x86_64-windows")}


def build(compiler, program, *options):
    subprocess.run([compiler, "-std=c++17", "-O1", "-static-libgcc", "-static-libstdc++", *options, HERE / "driver.cpp", "-o",
                    program], check=True)


class Windows(unittest.TestCase):
    def test_both_binaries_give_one_force(self):
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            build("g++", folder / "driver", "-ldl")
            build(MINGW, folder / "driver.exe", "-static")
            environment = {**os.environ, "WINEPREFIX": str(folder / "wine"), "WINEDEBUG": "-all", "DISPLAY": ""}
            # The two C libraries differ in the last digit of exp() and pow(), so estimated elements differ as well.
            for component in ("left_secondary", "berg_example"):
                for version in (2, 3):
                    with self.subTest(component=component, version=version):
                        self.check(folder, component, version, environment)

    def check(self, folder, component, version, environment):
        fmu = folder / f"{component}_{version}.fmu"
        subprocess.run([PROGRAMS / "export", "--config", CONFIG, "--component", component, "--format", f"fmu{version}",
                        "--output", fmu], check=True, capture_output=True)
        unpacked = folder / fmu.stem
        with zipfile.ZipFile(fmu) as archive:
            archive.extractall(unpacked)
        tree = ElementTree.parse(unpacked / "modelDescription.xml").getroot()
        token = tree.get("guid") or tree.get("instantiationToken")
        references = {variable.get("name"): variable.get("valueReference") for variable in tree.find("ModelVariables")}
        lines = "".join(f"{0.001 * i:.3f} {2e-3 * math.sin(0.05 * i) + 3e-4 * math.sin(0.41 * i)!r}\n" for i in range(500))
        answers = []
        for start, platform, ending in (([folder / "driver"], FOLDERS[version][0], "so"),
                                        ([WINE, folder / "driver.exe"], FOLDERS[version][1], "dll")):
            binary = unpacked / "binaries" / platform / f"{component}.{ending}"
            answer = subprocess.run([*start, binary, str(version), token, references["displacement"], references["force"],
                                     str(STOP)], input=lines, capture_output=True, text=True, env=environment, timeout=300,
                                    check=False)
            self.assertEqual(answer.returncode, 0, answer.stderr)
            *forces, past_the_stop = answer.stdout.split()
            self.assertEqual(len(forces), 500)
            self.assertEqual(past_the_stop, "3", "a step past the stop time is an error")
            self.assertIn("stop time", answer.stderr)
            answers.append([float(force) for force in forces])
        largest = max(map(abs, answers[0]))
        self.assertGreater(largest, 100.0)
        self.assertLess(max(abs(a - b) for a, b in zip(*answers)), 1e-9 * largest)


if __name__ == "__main__":
    if not (MINGW and WINE and (PROGRAMS / "rubber_suspension_fmu.dll").exists()):
        print("skipped: no wine64, mingw-w64 or binary for Windows (target fmu_windows)")
        sys.exit(77)
    unittest.main()
