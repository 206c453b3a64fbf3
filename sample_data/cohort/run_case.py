#!/usr/bin/env python3
"""One case: surface, report, picture and the pipeline that repeats it, in a folder of its own.

result.json appears last and whole; it says "done", or "failed" with the program's exit code and message. Always exits
with 0 but when it is stopped, so that one broken case does not end a run over hundreds.
"""
import argparse
import json
import os
import pathlib
import shlex
import shutil
import subprocess
import tempfile


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--program", default="isostack")
    parser.add_argument("--input", required=True)
    parser.add_argument("--options", default="", help="of `isostack reconstruct`")
    parser.add_argument("--threads", default="1")
    return parser.parse_args()


class Failure(Exception):
    def __init__(self, step, exit_code, message):
        super().__init__(message)
        self.result = {"status": "failed", "step": step, "exit_code": exit_code, "message": message}


def isostack(case, step, *words, display=False):
    command = [case.program, step, *map(str, words), "--threads", case.threads, "--quiet"]
    if display and not os.environ.get("DISPLAY"):
        command = ["xvfb-run", "-a", *command]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode in (5, -2, -9, -15):  # stopped from outside: no result, so that it runs again
        raise SystemExit(run.returncode if run.returncode > 0 else 128 - run.returncode)
    if run.returncode != 0:
        raise Failure(step, run.returncode, run.stderr.strip().splitlines()[-1] if run.stderr.strip() else "it died")


def write_whole(path, text):
    with tempfile.NamedTemporaryFile("w", dir=path.parent, delete=False) as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.replace(file.name, path)


def run(case):
    surface = case.folder / "surface.ply"
    record = case.folder / "pipeline.json"
    record.unlink(missing_ok=True)
    isostack(case, "reconstruct", case.input, *shlex.split(case.options), "-o", surface, "--report",
             case.folder / "report.json", "--record", record)
    report = json.loads((case.folder / "report.json").read_text())
    isostack(case, "view", *report["outputs"], "--screenshot", case.folder / "picture.png", "--size", "480,400", display=True)
    return {"status": "done", "report": report}


def main():
    case = arguments()
    shutil.rmtree(case.folder, ignore_errors=True)  # what a stopped run left
    case.folder.mkdir(parents=True)
    try:
        result = run(case)
    except Failure as failure:
        result = failure.result
    write_whole(case.folder / "result.json", json.dumps(result, indent=2) + "\n")


if __name__ == "__main__":
    main()
