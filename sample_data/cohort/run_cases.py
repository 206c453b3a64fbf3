#!/usr/bin/env python3
"""run_cases.py OUT TABLE JOB: the cases of one job, each in a folder of its own: surface, report, picture and the
pipeline that repeats it.

A case's result.json appears last and whole; it says "done", or "failed" with the program's exit code and message. Cases
that have one for the same input and options are kept. Ends with 1 when a case was killed, which may be for want of
memory: the next attempt asks for more; the last one calls it a failure.
"""
import argparse
import fcntl
import json
import pathlib
import shlex

import cases
from program import Failure, Program, Stopped


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("table")
    parser.add_argument("job")
    parser.add_argument("--size", type=int, default=1, help="cases in a job")
    parser.add_argument("--program", default="isostack")
    parser.add_argument("--threads", default="1")
    parser.add_argument("--last", action="store_true", help="there will be no further attempt")
    return parser.parse_args()


def run(case, folder, program, threads):
    common = ("--threads", threads, "--quiet")
    report = folder / "report.json"
    program.run("reconstruct", case["input"], *shlex.split(case["options"]), "-o", folder / "surface.ply", "--report",
                report, "--record", folder / "pipeline.json", *common)
    outputs = json.loads(report.read_text(encoding="utf-8"))["outputs"]
    program.run("view", *outputs, "--screenshot", folder / "picture.png", "--size", "480,400", *common)
    return {"status": "done"}


def run_case(case, job, program):
    folder = job.out / "cases" / case["id"]
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / ".lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)  # a job whose workflow was killed may still be at it
        result = cases.result_of(job.out, case["id"])
        if result and result["case"] == case:
            return
        for left in folder.iterdir():  # by a stopped run, or of other options
            if left.name != ".lock":
                left.unlink()
        try:
            result = run(case, folder, program, job.threads)
        except Failure as failure:
            result = failure.result
        except Stopped:
            if not job.last:
                raise
            result = Failure("reconstruct", 137, "it was killed, three times: there may not be enough memory").result
        cases.write_whole(folder / "result.json", json.dumps({**result, "case": case}, indent=2) + "\n")


def main():
    job = arguments()
    rows = cases.jobs_of(cases.read_table(job.table), job.size)[job.job]
    program = Program(job.program, display=True)
    stopped = False
    for case in rows:
        try:
            run_case(case, job, program)
        except Stopped:
            stopped = True
            if program.process.poll() is not None:
                break
    program.close()
    raise SystemExit(1 if stopped else 0)


if __name__ == "__main__":
    main()
