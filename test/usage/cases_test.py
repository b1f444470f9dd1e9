#!/usr/bin/python3
"""Small inputs as laboratories write them. Each must be read correctly, or refused with a message that names the
remedy.

RUBBER_SUSPENSION_CASES names their folder. Without this variable the test is skipped with one line.
Usage: cases_test.py FOLDER_OF_THE_COMMANDS
"""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

PROGRAMS = pathlib.Path(sys.argv[1]).resolve()
SKIPPED = 77
BUSH = """components:
  bush:
    model: elements
    elements:
      - {type: spring, stiffness: 1.2 kN/mm}
      - {type: maxwell, stiffness: 0.2 kN/mm, break_frequency: 3 Hz}
"""

# Expected results of `replay` for logs: file, further arguments, status, words on stderr, number of rows.
LOGS = (
    ("continued_blocks/mts793_blocks.dat", "", 0, "one log", 2400),
    ("continued_blocks/mts793_blocks.dat", "--segment all", 0, "the header is repeated 5 times while time continues", 2400),
    ("continued_blocks/mts793_50_rows.dat", "", 0, "the header is repeated 11 times", 600),
    ("unit_row_in_brackets/unit_row_lost.csv", "", 0, "force from 'Force (Ch 2) [kN]'", 120),
    ("unit_row_in_brackets/unit_row_lost.csv", "--columns time=1 displacement=2 force=3", 0, "'Force (Ch 2) [kN]'", 120),
    ("unit_row_in_brackets/unitrow_c.csv", "", 0, "displacement from 'Position (LVDT 1) [in]'", 2400),
    ("header_named/pre_unknown.csv", "", 1,
     ":4: there is no column of displacement; the header has 'Zeit', 'Kanal 1', 'Kanal 2'; accepted: displacement_<m|mm|um>, or "
     "--columns displacement=NAME", 0),
    ("header_named/pre_unknown.csv",
     "--columns time=1 displacement=2 force=3 --unit time=s displacement=mm force=N", 0, "header in line 4", 2400),
    ("header_named/sample_rate_preamble.csv", "", 1, "the header has 'Disp_1 [mm]', 'Load_1 [kN]'", 0),
    ("header_named/sample_rate_preamble.csv", "--sampling-rate 200", 0,
     "displacement from 'Disp_1 [mm]', force from 'Load_1 [kN]'", 2400),
    ("split_sign/split_sign.csv", "", 0, "force from 'Kraft [N]'", 2400),
    ("split_sign/footer_stats.txt", "", 0, "3 rows of statistics below the data", 2400),
    ("thousands/german.csv", "", 0, "decimal comma", None),
    ("thousands/quoted.csv", "", 0, "thousands separators", None),
    ("thousands/german_integers.csv", "", 0, "decimal comma, thousands separators", None),
    ("thousands/quoted_integers.csv", "", 0, "thousands separators", None),
    ("bad_words/Overrun.csv", "", 0, "Overrun", None),
    ("bad_words/OL.csv", "", 0, "OL", None),
    ("stamps/blocks_of_10.csv", "", 1, "--sampling-rate", 0),
    ("stamps/swapped.csv", "", 1, "--sampling-rate", 0),
    ("mts_buffers/specimen.dat", "", 0, "the header is repeated 3 times while time continues", None),
    ("lvm_segments/log.lvm", "", 1, "--segment 1", 0),
    ("unit_case/KN.csv", "", 0, "", None),
    ("unit_case/Mm.csv", "", 1, "did you mean 'mm'?", 0),
    ("rostopic_echo_yaml/echo.txt", "", 1, "rostopic echo -p", 0),
)

# Expected results of `estimate --from-table` for tables: file, status, words on stdout or stderr.
TABLES = (
    ("tables_of_laboratories/kdyn_din.csv", 0, "18 points"),
    ("tables_of_laboratories/t_german.csv", 0, "18 points"),
    ("tables_of_laboratories/t_kc.csv", 0, "18 points"),
    ("tables_of_laboratories/t_kc3.csv", 0, "18 points"),
    ("tables_of_laboratories/t_preamble.csv", 0, "18 points"),
    ("tables_of_laboratories/t_unitrow2.csv", 0, "18 points"),
    ("tables_of_laboratories/t_negphase.csv", 1, "all loss angles are negative"),
    ("dma_table/modulus.csv", 1, "a quantity of the material"),
    ("lab_tables/matrix.csv", 1, "a matrix, which lacks the loss angle"),
)


def run(command, *arguments):
    return subprocess.run([PROGRAMS / command, *arguments], capture_output=True, text=True, timeout=120, check=False)


def differences(cases, scratch):
    component = scratch / "bush.yaml"
    component.write_text(BUSH)
    for name, options, status, words, rows in LOGS:
        output = scratch / "force.csv"
        output.unlink(missing_ok=True)
        result = run("replay", "--config", component, "--log", cases / name, "--output", output, *options.split())
        if (result.returncode, words in result.stderr) != (status, True):
            yield f"{name} {options}: status {result.returncode}, {result.stderr.strip()}; expected: {status}, {words}"
        elif status == 0 and rows is not None:
            with open(output) as file:
                found = sum(1 for _ in csv.reader(file)) - 1
            if found != rows:
                yield f"{name} {options}: {found} rows; expected: {rows}"
        if status != 0 and output.exists():
            yield f"{name} {options}: refused, and an output is there"
    for name, status, words in TABLES:
        result = run("estimate", "--config", component, "--from-table", cases / name)
        said = result.stdout + result.stderr
        if (result.returncode, words in said) != (status, True):
            yield f"{name}: status {result.returncode}, {said.strip()}; expected: {status}, {words}"
    reversed_phases = cases / "tables_of_laboratories" / "t_negphase.csv"
    run("diagnose", "--config", component, "--from-table", reversed_phases, "--output", scratch / "reversed")
    report = json.loads((scratch / "reversed" / "report.json").read_text())
    if (report["verdict"], [one["finding"] for one in report["rig_findings"]]) != ("check_bench", ["sign"]):
        yield f"t_negphase.csv: {report['verdict']}, {report['rig_findings']}; expected: check_bench, sign"
    # The units of damping are those that laboratories write.
    result = run("estimate", "--config", cases / "tables_of_laboratories" / "el.yaml")
    if result.returncode != 0:
        yield f"el.yaml: {result.stderr.strip()}"


def main():
    folder = os.environ.get("RUBBER_SUSPENSION_CASES", "")
    if not pathlib.Path(folder, "continued_blocks").is_dir():
        print("skipped: RUBBER_SUSPENSION_CASES names no folder of cases")
        return SKIPPED
    with tempfile.TemporaryDirectory() as scratch:
        wrong = list(differences(pathlib.Path(folder), pathlib.Path(scratch)))
    print("\n".join(wrong) or f"{len(LOGS) + len(TABLES) + 2} cases")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
