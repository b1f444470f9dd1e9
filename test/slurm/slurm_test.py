#!/usr/bin/python3
"""A campaign on a real Slurm of two nodes on this computer has each result once, although a node dies with its tasks.

Usage: slurm_test.py FOLDER_OF_THE_COMMANDS. Exit status 77, with the reason, if Slurm is not installed or cannot start.
All files are in a temporary folder. Every daemon is ended by its process id.
"""

import json
import os
import pathlib
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
import unittest

SKIPPED = 77
PROGRAMS = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "sinfo", "scontrol")
JOBS = 200
SHARDS = 8
CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge/munge.sock,cred_expire=30
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SlurmctldPort={ports[0]}
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmdSpoolDir={folder}/spool-%n
StateSaveLocation={folder}/state
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
MpiDefault=none
SwitchType=switch/none
JobRequeue=1
SlurmdTimeout=10
InactiveLimit=0
KillWait=5
MinJobAge=300
SchedulerType=sched/backfill
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc={folder}/jobcomp.txt
JobAcctGatherType=jobacct_gather/none
MailProg=/bin/true
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[1]} CPUs=1 State=UNKNOWN
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[2]} CPUs=1 State=UNKNOWN
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""


def free_ports(count):
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return ports


def wait_for(what, seconds, condition):
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        if condition():
            return
        time.sleep(0.5)
    raise AssertionError(f"{what}: not within {seconds} s")


class Cluster:
    """munged, slurmctld and two slurmd with their own configuration."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.daemons = {}
        self.environment = {**os.environ, "SLURM_CONF": str(self.folder / "slurm.conf")}
        for name in ("munge", "state", "spool-n1", "spool-n2"):
            (self.folder / name).mkdir()
        (self.folder / "munge").chmod(0o755)
        text = CONFIGURATION.format(host=socket.gethostname().split(".")[0], folder=folder, ports=free_ports(3))
        (self.folder / "slurm.conf").write_text(text, encoding="utf-8")

    def start(self):
        key = self.folder / "munge" / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o600)
        self._daemon("munged", "munged", "--foreground", "--force", f"--key-file={key}",
                     f"--socket={self.folder}/munge/munge.sock", f"--pid-file={self.folder}/munge/munged.pid",
                     f"--log-file={self.folder}/munge/munged.log", f"--seed-file={self.folder}/munge/munged.seed")
        wait_for("munged", 20, (self.folder / "munge" / "munge.sock").exists)
        self._daemon("slurmctld", "slurmctld", "-D", "-c")
        for node in ("n1", "n2"):
            self._daemon(node, "slurmd", "-D", "-N", node)
        wait_for("two idle nodes", 60, lambda: self.ask("sinfo", "--noheader", "--Node", "--format=%t").split() == ["idle"] * 2)

    def _daemon(self, name, *command):
        with open(self.folder / f"{name}.out", "wb") as output:
            self.daemons[name] = subprocess.Popen(command, env=self.environment, stdout=output, stderr=output,
                                                  stdin=subprocess.DEVNULL, start_new_session=True)

    def ask(self, *command):
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False, timeout=60).stdout

    def kill_node(self, name):
        """Kill a whole node at once: first the processes that would report it (slurmstepd, slurmd), then the jobs.
        Return False without killing anything if no job runs on the node."""
        parents, names, workers = {}, {}, set()
        for entry in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                pid = int(entry.name)
                names[pid], rest = (entry / "stat").read_text().split("(", 1)[1].rsplit(")", 1)
                parents[pid] = int(rest.split()[1])
                environment = (entry / "environ").read_bytes()
            except (OSError, ValueError):
                continue  # the process has ended
            if f"SLURMD_NODENAME={name}\0".encode() in environment and str(self.folder).encode() in environment:
                workers.add(pid)
        reporters = {parents[pid] for pid in workers if names.get(parents[pid], "").startswith("slurmstepd")}
        if not workers or not reporters:
            return False
        for pid in [*reporters, self.daemons[name].pid, *workers]:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.daemons.pop(name).wait()
        return True

    def stop(self):
        self.ask("scancel", "--user=root")
        for daemon in reversed(list(self.daemons.values())):
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()


class OnSlurm(unittest.TestCase):
    programs = None

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="rubber_suspension_slurm_")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)
        self.cluster = Cluster(self.folder)
        self.addCleanup(self.cluster.stop)
        try:
            self.cluster.start()
        except AssertionError as error:
            print(f"skipped: Slurm does not start here: {error}")
            sys.stdout.flush()
            self.skipTest(str(error))
        self.write_inputs()

    def campaign(self, *arguments):
        return subprocess.run([pathlib.Path(self.programs) / "campaign", *arguments], env=self.cluster.environment,
                              capture_output=True, text=True, check=False, timeout=600)

    def write_inputs(self):
        folder = pathlib.Path(self.folder)
        (folder / "bush.yaml").write_text(
            "components:\n  bush:\n    model: maxwell\n    specification: {static_stiffness: 1.0e6, dynamic_stiffness: "
            "1.3e6, nominal_frequency: 4.0, break_frequency: 3.0}\n", encoding="utf-8")
        # The log is long enough that a task takes a second or more.
        rows = "".join(f"{0.001 * i:.3f},{1e-6 * (i % 2000 - 1000):.9f}\n" for i in range(40000))
        (folder / "log.csv").write_text("time_s,displacement_m\n" + rows, encoding="utf-8")
        (folder / "jobs.yaml").write_text(
            "jobs:\n  study:\n    command: replay\n    config: bush.yaml\n    log: log.csv\n"
            f"    monte_carlo: {{runs: {JOBS}, seed: 1, tolerances: {{static_stiffness: {{uniform: 5 %}}}}}}\n",
            encoding="utf-8")

    def records(self, name):
        """Return the records, except for the hidden file that a killed process was writing."""
        found = (pathlib.Path(self.folder) / name / "results").glob("*/*.json")
        return [path for path in found if not path.name.startswith(".")]

    def test_all_results_once_though_a_node_dies(self):
        folder = pathlib.Path(self.folder)
        for name in ("cluster", "alone"):
            made = self.campaign("make", "--jobs", str(folder / "jobs.yaml"), "--output", str(folder / name))
            self.assertEqual(made.returncode, 0, made.stderr)
        alone = self.campaign("run", str(folder / "alone"), "--threads", "1")
        self.assertEqual(alone.returncode, 0, alone.stderr)

        # Shards are so short that each node gets several tasks. The first shard gives the time of a job.
        first = self.campaign("run", str(folder / "cluster"), "--shard", "1/20", "--threads", "1")
        self.assertEqual(first.returncode, 0, first.stderr)
        seconds = self.seconds_per_job("cluster")
        minutes = f"{seconds * JOBS / SHARDS / 60.0:.6f}"
        submit = ["submit", str(folder / "cluster"), "--engine", "slurm", "--shard-minutes", minutes, "--threads", "1"]
        dry = self.campaign(*submit, "--dry-run")
        self.assertEqual(dry.returncode, 0, dry.stderr)
        self.assertIn("#SBATCH --requeue", dry.stdout)
        submitted = self.campaign(*submit)
        self.assertEqual(submitted.returncode, 0, submitted.stderr)
        second = self.campaign(*submit)
        self.assertEqual(second.returncode, 1, second.stdout)
        self.assertIn("accepted: submit again after it has ended", second.stderr)

        wait_for("the second node at work", 60, lambda: self.cluster.kill_node("n2"))
        wait_for("the end of the array, the tasks of the dead node requeued", 400,
                 lambda: not self.cluster.ask("squeue", "--noheader", "--format=%i").strip())

        completed = (folder / "jobcomp.txt").read_text(encoding="utf-8")
        self.assertIn("NODE_FAIL", completed)
        self.assertEqual(len(self.records("cluster")), JOBS)
        for name in ("cluster", "alone"):
            collected = self.campaign("collect", str(folder / name))
            self.assertIn(f"{JOBS} jobs done, 0 failed, 0 missing", collected.stdout)
        for table in ("table.csv", "table.json"):
            self.assertEqual((folder / "cluster" / table).read_bytes(), (folder / "alone" / table).read_bytes())
        again = self.campaign(*submit)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("nothing to submit", again.stdout)

    def seconds_per_job(self, name):
        times = [json.loads(path.read_text(encoding="utf-8"))["seconds"] for path in self.records(name)]
        return sum(times) / len(times)


def missing():
    lacking = [name for name in PROGRAMS if shutil.which(name) is None]
    if lacking:
        return f"not installed: {', '.join(lacking)} (Debian: slurmctld slurmd slurm-client munge)"
    return "needs root, as munged and slurmd do" if os.geteuid() != 0 else ""


if __name__ == "__main__":
    os.environ["PATH"] += ":/usr/sbin:/sbin"
    OnSlurm.programs = sys.argv[1]
    reason = missing()
    if reason:
        print(f"skipped: {reason}")
        sys.exit(SKIPPED)
    result = unittest.main(argv=sys.argv[:1], exit=False).result
    sys.exit(SKIPPED if result.skipped and result.wasSuccessful() else int(not result.wasSuccessful()))
