#!/usr/bin/env python3
"""slurm_test.py BIN_DIR SCRATCH: a cohort through sbatch on a cluster of one node, against the same run locally. 77: no
snakemake, or no Slurm that starts."""
import pathlib
import re
import shutil
import subprocess
import sys

import cohort
import slurm_node

BIN, SCRATCH = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
PROFILE = cohort.WORKFLOW.parent / "profiles/slurm"


def check_requests(out):
    """Jobs asked for the memory that was predicted, and for the threads."""
    jobs = subprocess.run(["scontrol", "--oneliner", "show", "job"], check=True, capture_output=True, text=True).stdout
    asked = [int(float(number) * {"M": 1, "G": 1024}[unit])
             for number, unit in re.findall(r"JobName=isostack-run .*?MinMemoryNode=([\d.]+)([MG])", jobs)]
    predicted = [cohort.json_of(path)["mem_mb"] for path in out.glob("jobs/*.json")]
    assert len(asked) == len(predicted) and all(any(abs(a - p) <= 0.01 * p for p in predicted) for a in asked), jobs
    assert "NumCPUs=2" in jobs, jobs


def main():
    if not shutil.which("snakemake"):
        print("snakemake is not installed")
        return 77
    cohort.make_cases(BIN, SCRATCH, 2)
    try:
        with slurm_node.slurm_node(SCRATCH / "slurm"):
            subprocess.run(cohort.command(BIN, SCRATCH, "cluster", ["--profile", PROFILE], ["threads=2", "chunk=3"]),
                           cwd=SCRATCH, check=True, timeout=300)
            check_requests(SCRATCH / "cluster")
    except slurm_node.CannotStart as reason:
        print(reason)
        return 77
    subprocess.run(cohort.command(BIN, SCRATCH, "local", config=["threads=2"]), cwd=SCRATCH, check=True)
    cluster, local = (cohort.results_of(SCRATCH / out) for out in ("cluster", "local"))
    assert cluster == local and len(local) == 9, set(cluster.items()) ^ set(local.items())
    assert sum(row["status"] == "failed" for row in cohort.rows_of(SCRATCH / "cluster").values()) == 3
    print("the same results through sbatch")
    return 0


sys.exit(main())
