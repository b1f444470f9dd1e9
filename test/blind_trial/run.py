#!/usr/bin/python3
# Runs `diagnose` on the cases of a blind trial with a time limit, and records time and peak memory of each. It reads
# the cases only, and never the labels.
"""Run a diagnosis over all cases of a blind trial."""
import argparse
import concurrent.futures
import json
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time


DEFECT = 3  # exit status if the report contradicts itself


def description(folder):
    """Return the content of case.json or, without that file, the component and the logs log_*.csv of the folder."""
    path = os.path.join(folder, "case.json")
    if os.path.isfile(path):
        with open(path, encoding="utf-8") as file:
            return json.load(file)
    with open(os.path.join(folder, "component.yaml"), encoding="utf-8") as file:
        component = re.search(r"^components:\s*\n\s+(\w+):", file.read(), re.MULTILINE).group(1)
    logs = sorted(name for name in os.listdir(folder) if re.fullmatch(r"log_.*\.csv", name))
    return {"component": component, "logs": logs, "hold_out": []}


def command(binary, folder, report_folder, evidence):
    """Return the command line for one case."""
    case = description(folder)
    out = [binary, "--config", os.path.join(folder, "component.yaml"), "--component", case["component"],
           "--output", report_folder] + ["--evidence"] * evidence
    if case.get("table"):  # the data sheet is wrong by some factor, not the units
        return out + ["--accept-units", "--from-table", os.path.join(folder, case["table"])]
    for option, key in (("--log", "logs"), ("--hold-out", "hold_out")):
        for log in case[key]:
            out += [option, os.path.join(folder, log)]
    return out


def run_one(binary, folder, report_folder, limit, evidence=False):
    """Run one diagnosis and return the content of run.json."""
    shutil.rmtree(report_folder, ignore_errors=True)
    os.makedirs(report_folder)
    start = time.monotonic()
    with open(os.path.join(report_folder, "stderr.txt"), "wb") as errors:
        process = subprocess.Popen(command(binary, folder, report_folder, evidence), stdout=subprocess.DEVNULL,
                                   stderr=errors, start_new_session=True)
        timer = threading.Timer(limit, os.killpg, (process.pid, signal.SIGKILL))
        timer.start()
        _, status, usage = os.wait4(process.pid, 0)
        timer.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.monotonic() - start
    result = {"seconds": seconds, "cpu_seconds": usage.ru_utime + usage.ru_stime,
              "peak_memory_bytes": usage.ru_maxrss * 1024, "exit_status": process.returncode,
              "timed_out": process.returncode == -signal.SIGKILL and seconds >= limit}
    with open(os.path.join(report_folder, "run.json"), "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1)
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--cases", required=True, help="folder that generate.py wrote")
    parser.add_argument("--diagnose", required=True, help="path of the command")
    parser.add_argument("--reports", required=True, help="folder for one folder of reports per case")
    parser.add_argument("--jobs", type=int, default=1, help="cases at a time")
    parser.add_argument("--timeout", type=float, default=60.0, help="limit for one case [s]")
    parser.add_argument("--evidence", action="store_true", help="keep the evidence of each case, for judge_again")
    parser.add_argument("--only", action="append", help="name of a single case (may be repeated)")
    arguments = parser.parse_args()
    if not os.access(arguments.diagnose, os.X_OK):
        parser.error(f"--diagnose {arguments.diagnose}: not a program")
    names = sorted(n for n in os.listdir(arguments.cases) if os.path.isfile(
        os.path.join(arguments.cases, n, "case.json")) and (arguments.only is None or n in arguments.only))
    if not names:
        parser.error(f"--cases {arguments.cases}: holds no cases")
    failed = defects = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        futures = {pool.submit(run_one, arguments.diagnose, os.path.join(arguments.cases, name),
                               os.path.join(arguments.reports, name), arguments.timeout,
                               arguments.evidence): name for name in names}
        for done, future in enumerate(concurrent.futures.as_completed(futures), 1):
            result = future.result()
            failed += result["exit_status"] not in (0, DEFECT)
            defects += result["exit_status"] == DEFECT
            print(f"{done}/{len(names)} {futures[future]} {result['seconds']:.1f} s, "
                  f"{result['peak_memory_bytes'] / 2**20:.0f} MiB, exit status {result['exit_status']}", flush=True)
    if defects:
        print(f"{defects} of {len(names)} reports contradict themselves", file=sys.stderr)
    if failed:
        print(f"{failed} of {len(names)} cases failed", file=sys.stderr)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
