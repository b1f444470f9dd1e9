#!/usr/bin/python3
# Writes the cases of a blind trial: logs of virtual rigs, whose effects only the sealed labels state. The same seed and
# number of cases always give the same files.
"""Generate cases of the blind trial."""
import argparse
import concurrent.futures
import functools
import math
import os
import resource
import sys

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(variable, "1")
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import numpy as np  # noqa: E402

from virtual_rig import bench, case  # noqa: E402

MOST_MEMORY = 4 * 2**30  # memory limit of a process [B]; a case needs a tenth of it


def one(arguments, job):
    """Build and write a case (number, entry of the plan), and return its name."""
    number, planned = job
    try:
        built = case.build(arguments.seed, number, *planned, arguments.further, arguments.duration, arguments.form_error)
        faults = tuple(name for name in arguments.bench.split(",") if name)
        if faults:
            rng = np.random.default_rng([arguments.seed, number, len(faults)])
            on_bench(built, faults, arguments.size, rng)
        name = built["label"]["case"]
        case.write(built, os.path.join(arguments.output, name), arguments.labels)
        return name
    except MemoryError as error:
        raise MemoryError(f"case number {number}: {error}") from error


def on_bench(built, faults, size, rng):
    """Apply the faults of the bench. Further logs get the noise only, because their gaps exclude other faults."""
    label = built["label"]
    built["logs"], label["bench"] = bench.apply(built["logs"], faults, size, rng)
    if built["further"] and "pink" in faults:
        built["further"], _ = bench.apply(built["further"], ("pink",), size, rng)
        label["noise"]["floor_further"] = math.hypot(label["noise"]["floor_further"], bench.NUISANCES["pink"] * size)


def limit_memory():
    """Limit the memory of a process, so that a case that needs more fails alone and is named."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def parsed(words=None):
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--set", choices=["bank"], default="bank", help="the only set")
    parser.add_argument("--cases", type=int, required=True)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--output", required=True, help="folder of the cases")
    parser.add_argument("--labels", help="folder of the sealed labels (default: OUTPUT_labels)")
    parser.add_argument("--only", type=int, action="append", help="number of a single case (may be repeated)")
    parser.add_argument("--bench", default="", metavar="FAULT,...",
                        help="what the bench does to each log: " + ", ".join(bench.NUISANCES))
    parser.add_argument("--size", type=float, default=1.0, help="of these nuisances; 1 is usual")
    parser.add_argument("--kind", help="cases of this kind only: single, pair, none, parameter_error or unknown")
    parser.add_argument("--duration", type=float, default=1.0, help="of the logs, as a share of the usual 30 to 60 s")
    parser.add_argument("--further", type=int, default=0, help="logs of each rig that lie with the label, for score.py; "
                        "with them the same seed gives other cases")
    parser.add_argument("--form-error", action="store_true", help="laws that are off those of any textbook by 10 to "
                        "30 %%, mixed and drifting, on a base that its model does not quite describe")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args(words)
    if not 0.1 <= arguments.duration <= 1.0:
        parser.error("--duration takes a share from 0.1 to 1")
    if arguments.cases < 1 or arguments.jobs < 1 or arguments.further < 0:
        parser.error("--cases and --jobs take a number of at least 1, --further of at least 0")
    arguments.labels = arguments.labels or arguments.output.rstrip("/") + "_labels"
    return arguments


def main():
    arguments = parsed()
    plans = case.plan(arguments.cases, arguments.seed)
    numbers = range(len(plans)) if arguments.only is None else arguments.only
    jobs = [(i, plans[i]) for i in numbers if arguments.kind in (None, plans[i][0])]
    if not jobs:
        sys.exit("generate.py: no cases")
    with concurrent.futures.ProcessPoolExecutor(arguments.jobs, initializer=limit_memory) as pool:
        for done, name in enumerate(pool.map(functools.partial(one, arguments), jobs), 1):
            print(f"{done}/{len(jobs)} {name}", flush=True)


if __name__ == "__main__":
    main()
