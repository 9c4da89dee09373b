#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A cohort on a real Slurm: 40 tasks, three killed and queued again, the node lost once. The tables
are those of one process, to the byte.

Usage: cohort_slurm.py PALPATE-CLI WORK     (as root, with the packages slurm-wlm and munge)

Starts munged, slurmctld and slurmd for this machine alone, in WORK, and ends them. Exit code 77: what
is needed is not here.
"""
import os
import pathlib
import pwd
import shutil
import signal
import socket
import subprocess
import sys
import time

CLI, WORK = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "packaging" / "cluster" / "slurm"
NEEDED = ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol", "scancel")
SCANS, TASKS = 40, 40
HOW = ("--hand", "slide", "--tool", "sphere", "--isovalue", "1000", "--seconds", "20")


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Slurm:
    def __init__(self):
        place = WORK / "slurm"
        for folder in ("munge", "state", "spool"):
            (place / folder).mkdir(parents=True)
        os.chmod(place / "munge", 0o700)
        key = place / "munge" / "key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.socket = place / "munge" / "socket"
        host = socket.gethostname().split(".")[0]
        cores, memory = os.cpu_count(), os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") >> 20
        (place / "slurm.conf").write_text(f"""ClusterName=trial
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={free_port()}
SlurmdPort={free_port()}
AuthType=auth/munge
AuthInfo=socket={self.socket}
CryptoType=crypto/munge
SlurmUser=root
SlurmdUser=root
StateSaveLocation={place}/state
SlurmdSpoolDir={place}/spool
SlurmctldPidFile={place}/slurmctld.pid
SlurmdPidFile={place}/slurmd.pid
SlurmctldLogFile={place}/slurmctld.log
SlurmdLogFile={place}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
SlurmdTimeout=10
MinJobAge=3600
SchedulerParameters=sched_min_interval=100000,requeue_delay=1
NodeName={host} NodeAddr=127.0.0.1 CPUs={cores} RealMemory={memory // 2} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
""")
        self.host, self.place = host, place
        self.env = {**os.environ, "SLURM_CONF": str(place / "slurm.conf"),
                    "PATH": f"{CLI.parent}:{os.environ['PATH']}"}
        self.programs = {}
        me = pwd.getpwuid(os.getuid()).pw_name
        assert me == "root"
        self.start("munged", "--foreground", "--force", f"--key-file={key}", f"--socket={self.socket}",
                   f"--pid-file={place}/munge/pid", f"--seed-file={place}/munge/seed",
                   f"--log-file={place}/munge/log")
        wait(self.socket.exists, 20, "munged")
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D")
        wait(lambda: "idle" in self.says("sinfo", "-h", "-o", "%t"), 60, "the node")

    def start(self, name, *words):
        with open(self.place / f"{name}.out", "ab") as log:
            self.programs[name] = subprocess.Popen([name, *words], env=self.env, stdout=log, stderr=log)

    def says(self, *words):
        return subprocess.run(words, env=self.env, capture_output=True, text=True, check=False).stdout

    def end(self):
        for program in reversed(list(self.programs.values())):
            program.terminate()
            try:
                program.wait(20)
            except subprocess.TimeoutExpired:
                program.kill()


def wait(what, seconds, name):
    for _ in range(seconds * 10):
        if what():
            return
        time.sleep(0.1)
    sys.exit(f"{name} did not come within {seconds} s")


def cli(*words):
    subprocess.run([CLI, *map(str, words)], check=True, capture_output=True)


def main():
    for name in NEEDED:
        if shutil.which(name) is None:
            print(f"SKIPPED: there is no {name} here")
            return 77
    if os.getuid() != 0:
        print("SKIPPED: Slurm's daemons need root here")
        return 77
    shutil.rmtree(WORK, ignore_errors=True)
    WORK.mkdir(parents=True)
    cli("convert", "--phantom", "sphere", WORK / "sphere.nrrd")
    manifest = WORK / "scans.tsv"
    manifest.write_text("label\tpath\tstiffness\n" + "".join(
        f"s{n:02}\tsphere.nrrd\t{200 + 20 * n}\n" for n in range(SCANS)))
    alone, out = WORK / "alone", WORK / "out"
    cli("cohort", manifest, alone, *HOW)
    slurm = Slurm()
    try:
        # the plan would put so short a cohort into fewer shards
        submitted = subprocess.run([SCRIPT, manifest, out, *HOW], env={**slurm.env, "PALPATE_SHARDS": str(TASKS)},
                                   capture_output=True, text=True, check=False)
        print(submitted.stdout, submitted.stderr)
        if submitted.returncode != 0:
            return 1
        array = submitted.stdout.split(" job ")[1].split(",")[0]

        def running():
            return slurm.says("squeue", "-h", "-r", "-t", "running", "-o", "%K", "-j", array).split()

        killed = 0
        while killed < 3:
            wait(running, 60, "a running task")
            task = running()[0]
            slurm.says("scontrol", "requeue", f"{array}_{task}")
            print("killed and queued again: task", task)
            killed += 1
            time.sleep(2)
        wait(running, 120, "a running task")
        print("the node is lost")
        lost = slurm.programs["slurmd"]
        lost.send_signal(signal.SIGKILL)
        lost.wait()
        for pid in slurm.says("pgrep", "-f", f"{CLI} cohort {manifest}").split():
            os.kill(int(pid), signal.SIGKILL)
        wait(lambda: "down" in slurm.says("sinfo", "-h", "-o", "%t"), 120, "the loss of the node")
        slurm.start("slurmd", "-D")
        wait(lambda: not slurm.says("squeue", "-h").strip(), 900, "the end of all jobs")
        print(slurm.says("sh", "-c", f"tail -n 3 {out}/logs/merge.txt"))
        for name in ("group_touches.tsv", "group_replays.tsv"):
            if (alone / name).read_bytes() != (out / name).read_bytes():
                print(f"{name} differs")
                return 1
        print(f"{TASKS} tasks, {killed} killed, the node lost once: the same tables")
        return 0
    finally:
        slurm.end()


if __name__ == "__main__":
    sys.exit(main())
