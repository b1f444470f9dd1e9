#!/usr/bin/python3
# Writes the cases of a blind trial: logs of virtual rigs whose effects are known to the sealed labels alone.
# The same set, seed and number of cases always give the same files.
"""Generate cases of the blind trial."""
import argparse
import concurrent.futures
import os
import resource
import sys

for variable in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(variable, "1")
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import numpy as np  # noqa: E402

from virtual_rig import bench, case, implant, trial_2  # noqa: E402

MOST_MEMORY = 4 * 2**30  # of a process [B]; a case takes a tenth of it
OWN_BENCH = ("trial_2", "implants")  # sets whose cases say themselves what the bench does


def one(job):
    """Build and write case number `number`; returns its name."""
    try:
        return build_and_write(job)
    except MemoryError as error:
        raise MemoryError(f"case number {job[2]}: {error}") from error


def build_and_write(job):
    if job[0] == "trial_2":
        _, seed, number, planned, output, labels, duration = job
        return write(trial_2.build(seed, number, planned, duration), output, labels)
    if job[0] == "implants":
        return implant.write(*job[1:])
    case_set, seed, number, (kind, effects, small), output, labels, *rest = job
    faults, size = rest[0] if rest else ((), 1.0)
    layout = case.Layout(duration=rest[1] if len(rest) > 1 else 1.0)
    built = case.build(case_set, seed, number, kind, effects, small, layout, inexact=len(rest) > 2 and rest[2])
    if faults:
        rng = np.random.default_rng([seed, number, len(faults)])
        built["logs"], built["label"]["bench"] = bench.apply(built["logs"], faults, size, rng)
    return write(built, output, labels)


def write(built, output, labels):
    name = built["label"]["case"]
    case.write(built, os.path.join(output, name), labels)
    return name


def jobs_of(arguments, labels):
    """What `one` takes, for each case."""
    if arguments.set == "implants":
        plans = implant.plan(arguments.cases, arguments.seed)
    elif arguments.set == "trial_2":
        plans = trial_2.plan(arguments.cases, arguments.seed)
    else:
        plans = case.plan(arguments.set, arguments.cases, arguments.seed)
    numbers = range(len(plans)) if arguments.only is None else arguments.only
    head, output = (arguments.set, arguments.seed), (arguments.output, labels)
    if arguments.set == "implants":
        return [(*head, i, plans[i], *output) for i in numbers]
    if arguments.set == "trial_2":
        numbers = [i for i in numbers if arguments.kind in (None, plans[i].kind)]
        return [(*head, i, plans[i], *output, arguments.duration) for i in numbers]
    numbers = [i for i in numbers if arguments.kind in (None, plans[i][0])]
    faults = tuple(name for name in arguments.bench.split(",") if name)
    return [(*head, i, plans[i], *output, (faults, arguments.size), arguments.duration, arguments.form_error)
            for i in numbers]


def limit_memory():
    """A case that would need more than a machine has fails, and is named, in place of taking the machine with it."""
    resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--set", choices=[*sorted(case.SETS), *OWN_BENCH], required=True,
                        help="bank: to calibrate on; test: sealed, with laws that the bank does not have; trial_2: "
                        "sealed laws alone; implants: known effects in measured logs")
    parser.add_argument("--cases", type=int, required=True)
    parser.add_argument("--seed", type=int, required=True)
    parser.add_argument("--output", required=True, help="folder of the cases")
    parser.add_argument("--labels", help="folder of the sealed labels (default: OUTPUT_labels)")
    parser.add_argument("--only", type=int, action="append", help="number of a single case (may be repeated)")
    parser.add_argument("--bench", default="", metavar="FAULT,...",
                        help="what the bench does to each log: " + ", ".join([*bench.NUISANCES, *bench.FAULTS]))
    parser.add_argument("--size", type=float, default=1.0, help="of these nuisances; 1 is usual")
    parser.add_argument("--kind", help="cases of this kind only: single, pair, none, parameter_error, unknown; in "
                        "trial_2 small, triple and mixed, too")
    parser.add_argument("--duration", type=float, default=1.0, help="of the logs, as a share of the usual 30 to 60 s")
    parser.add_argument("--form-error", action="store_true", help="of bank and test: laws that are off those of any "
                        "textbook by 10 to 30 %%, mixed and drifting, on a base that its model does not quite describe")
    parser.add_argument("--jobs", type=int, default=1)
    arguments = parser.parse_args()
    if not 0.1 <= arguments.duration <= 1.0:
        parser.error("--duration takes a share from 0.1 to 1")
    if arguments.cases < 1 or arguments.jobs < 1:
        parser.error("--cases and --jobs take a number of at least 1")
    labels = arguments.labels or arguments.output.rstrip("/") + "_labels"
    if arguments.set in OWN_BENCH and arguments.bench:
        parser.error(f"--bench: the cases of --set {arguments.set} say themselves what the bench does")
    if arguments.set in OWN_BENCH and arguments.form_error:
        parser.error(f"--form-error: for --set bank and test, not for {arguments.set}")
    jobs = jobs_of(arguments, labels)
    if not jobs:
        sys.exit("generate.py: no cases" + (f", because no measured log is below {implant.data_folder()}"
                                            if arguments.set == "implants" else ""))
    with concurrent.futures.ProcessPoolExecutor(arguments.jobs, initializer=limit_memory) as pool:
        for done, name in enumerate(pool.map(one, jobs), 1):
            print(f"{done}/{len(jobs)} {name}", flush=True)


if __name__ == "__main__":
    main()
