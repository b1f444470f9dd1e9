#!/usr/bin/python3
# A diagnosis must not take more memory than it states to need, with many logs, long or dense logs, or many pauses. With
# less memory it must state the need before the search. The system must not kill it.
"""Diagnoses under limits of the address space."""
import argparse
import os
import re
import resource
import subprocess
import sys
import tempfile

import numpy as np

MEBIBYTE = 1 << 20
OUT_OF_MEMORY = "out of memory; accepted"  # message while logs are read, before the need of the search is known
CONFIG = """components:
  bush:
    model: elements
    elements:
      - {type: spring, stiffness: 25000.0}
      - {type: maxwell, stiffness: 8000.0, break_frequency: 1.0}
"""


def write_log(path, rng, duration, rate, pauses):
    """Write a log of sines with friction of 8 N, interrupted by pauses of 9 s."""
    time = np.arange(0.0, duration, 1.0 / rate)
    displacement = 1e-3 * rng.uniform(0.5, 2.0) * (1.0 - np.cos(2.0 * np.pi * rng.integers(1, 5) * time))
    force = 25000.0 * displacement + 8.0 * np.tanh(np.gradient(displacement, time) / 1e-3)
    force += 0.05 * rng.standard_normal(time.size)
    piece = np.minimum((time * (pauses + 1) / duration).astype(int), pauses)
    np.savetxt(path, np.stack([time + 9.0 * piece, displacement, force], axis=1), "%.7g", ",",
               header="time_s,displacement_m,force_N", comments="")


# logs, hold-outs, seconds, samples per second, pauses per log, threads; the suite runs the first ten, which differ most
KINDS = [(1, 0, 8, 100, 0, 1), (1, 0, 8, 100, 0, 8), (5, 2, 10, 250, 0, 4), (100, 10, 2, 60, 0, 4),
         (1, 0, 100, 100, 99, 2), (2, 2, 20, 100, 9, 1), (1, 0, 20, 5000, 0, 2), (2, 0, 40, 2000, 0, 8),
         (1, 1, 200, 500, 0, 2), (30, 30, 4, 100, 1, 2), (1, 1, 20, 500, 0, 2), (5, 0, 20, 250, 0, 2),
         (20, 0, 4, 100, 0, 2), (50, 0, 3, 100, 0, 2), (100, 0, 2, 100, 0, 2), (200, 0, 2, 60, 0, 2),
         (1, 0, 30, 100, 29, 2), (3, 0, 20, 100, 19, 2), (1, 0, 60, 2000, 0, 2), (10, 0, 20, 1000, 0, 2)]


def diagnose(command, limit):
    """Return the exit status, standard error, and peak of the resident memory [bytes]."""
    def restrict():
        if limit:
            resource.setrlimit(resource.RLIMIT_AS, (limit, limit))
    process = subprocess.Popen(command, preexec_fn=restrict, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    return os.waitstatus_to_exitcode(status), errors, usage.ru_maxrss * 1024


def bytes_of(number, unit):
    return float(number) * (MEBIBYTE if unit == "MiB" else 1024 * MEBIBYTE)


def check(diagnose_program, kind, folder):
    """Return what is wrong with the memory of a diagnosis of this kind, or an empty text."""
    logs, held_out, duration, rate, pauses, threads = kind
    rng = np.random.default_rng(1)
    paths = []
    for i in range(logs + held_out):
        paths.append(os.path.join(folder, f"log_{i:03d}.csv"))
        write_log(paths[-1], rng, duration, rate, pauses)
    config = os.path.join(folder, "component.yaml")
    with open(config, "w", encoding="utf-8") as file:
        file.write(CONFIG)
    command = [diagnose_program, "--config", config, "--component", "bush", "--threads", str(threads), "--output",
               os.path.join(folder, "out"), "--log", *paths[:logs]]
    command += ["--hold-out", *paths[logs:]] if held_out else []
    said, limit = 0.0, 150  # too little for the search; threads need more addresses
    status, errors, peak = diagnose(command, limit * MEBIBYTE)
    while refused := re.search(r"needs about ([\d.]+) (MiB|GiB)", errors) or (said == 0.0 and OUT_OF_MEMORY in errors):
        said = said if refused is True else bytes_of(*refused.groups())
        limit = max(limit + 50, int(said / MEBIBYTE))
        status, errors, peak = diagnose(command, limit * MEBIBYTE)
    print(f"{kind}: needs {said / MEBIBYTE:.0f} MiB, took {peak / MEBIBYTE:.0f} MiB below {limit} MiB", flush=True)
    if status not in (0, 3):  # 3: a report without a verdict, after the search
        return f"status {status} below {limit} MiB: {errors.strip()[:200]}"
    return "" if peak <= said or said == 0.0 else f"took {peak / MEBIBYTE:.0f} MiB, said {said / MEBIBYTE:.0f} MiB"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("programs", help="folder of the programs")
    parser.add_argument("--kinds", type=int, default=len(KINDS), help="so many of them (default: all)")
    arguments = parser.parse_args()
    wrong = 0
    for kind in KINDS[:arguments.kinds]:
        with tempfile.TemporaryDirectory() as folder:
            problem = check(os.path.join(arguments.programs, "diagnose"), kind, folder)
        if problem:
            wrong += 1
            print(f"{kind}: {problem}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
