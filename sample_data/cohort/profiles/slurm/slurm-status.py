#!/usr/bin/env python3
"""slurm-status.py JOB: "running", "success" or "failed", as Snakemake asks. The controller forgets a job some minutes
after its end; then the accounting, where there is one, still knows."""
import re
import subprocess
import sys

RUNNING = {"PENDING", "CONFIGURING", "RUNNING", "COMPLETING", "SUSPENDED", "REQUEUED", "RESIZING", "STAGE_OUT"}


def output_of(*command):
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    return run.stdout if run.returncode == 0 else ""


def state_of(job):
    found = re.search(r"JobState=(\w+)", output_of("scontrol", "--oneliner", "show", "job", job))
    found = found or re.search(r"(\w+)", output_of("sacct", "-j", job, "-X", "--noheader", "--format=State"))
    return found.group(1) if found else "UNKNOWN"


STATE = state_of(sys.argv[1])
print("running" if STATE in RUNNING else "success" if STATE == "COMPLETED" else "failed")
