#!/usr/bin/env python3
"""predict_cases.py OUT TABLE JOB: the memory that the cases of one job take, in MB, as `isostack reconstruct --dry-run`
tells it, into OUT/jobs/JOB.json. A case it refuses fails when it runs, and takes no more than reading its input."""
import argparse
import json
import math
import pathlib
import shlex

import cases
from program import Failure, Program, Stopped

PICTURE_MB = 600  # of `isostack view`


def predicted_mb(case, program, threads):
    try:
        done = program.run("reconstruct", case["input"], *shlex.split(case["options"]), "--dry-run", "--json",
                           "--threads", threads, "--quiet")
        return math.ceil(json.loads(done["stdout"])["predicted_process_bytes"] / 1e6)
    except Failure:
        return 0
    except Stopped:
        raise SystemExit(1) from None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("table")
    parser.add_argument("job")
    parser.add_argument("--size", type=int, default=1)
    parser.add_argument("--program", default="isostack")
    parser.add_argument("--threads", default="1")
    job = parser.parse_args()
    rows = cases.jobs_of(cases.read_table(job.table), job.size)[job.job]
    program = Program(job.program)
    megabytes = {case["id"]: predicted_mb(case, program, job.threads) for case in rows}
    program.close()
    prediction = {"mem_mb": max(PICTURE_MB, *megabytes.values()), "cases": megabytes}
    cases.write_whole(job.out / "jobs" / (job.job + ".json"), json.dumps(prediction, indent=2) + "\n")


if __name__ == "__main__":
    main()
