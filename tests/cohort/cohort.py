"""What the cohort's tests share: cases made of the sample, the workflow's command line, what came out."""
import csv
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess

WORKFLOW = pathlib.Path(__file__).resolve().parents[2] / "sample_data/cohort/Snakefile"
OPTIONS = "--gaussian 1 --largest --max-constraints 400 --resolution 6"
BROKEN = {"truncated": "a.dcm", "two_series": "series", "empty": "label"}

EMPTY_LABELS = b"""NRRD0004
type: uint8
dimension: 3
space: left-posterior-superior
sizes: 16 16 8
space directions: (1,0,0) (0,1,0) (0,0,2)
kinds: domain domain domain
encoding: raw
space origin: (0,0,0)

""" + bytes(16 * 16 * 8)


def make_cases(bin_dir, folder, sound):
    """`sound` cases, one of them a part of the organ, and the three broken ones; returns their ids."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    subprocess.run([bin_dir / "isostack_make_phantom", folder / "sample"], check=True)
    series = folder / "sample/series"
    (folder / "truncated").mkdir()
    (folder / "truncated/a.dcm").write_bytes(next(series.glob("*.dcm")).read_bytes()[:2000])
    two = folder / "two"
    shutil.copytree(series, two / "axial")
    shutil.copytree(folder / "sample/planes", two / "planes")
    labels = folder / "labels.nrrd"  # label 1 is nowhere
    labels.write_bytes(EMPTY_LABELS)
    rows = [(f"sound{i:02}", series, f"--level {24 + 0.2 * i:.1f} {OPTIONS} --slices {','.join(map(str, range(i % 2, 30, 2)))}")
            for i in range(sound - 1)]
    rows.append(("halved", series, f"--level 25 {OPTIONS} --slices 4,6,8,10,12"))
    rows += [("truncated", folder / "truncated", f"--level 25 {OPTIONS}"), ("two_series", two, f"--level 25 {OPTIONS}"),
             ("empty", labels, "--label 1 --max-constraints 300")]
    with open(folder / "cases.csv", "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(("id", "input", "options"))
        writer.writerows(rows)
    return [row[0] for row in rows]


def command(bin_dir, folder, out="results", options=(), config=()):
    return ["snakemake", "-s", WORKFLOW, "--cores", "2", "--quiet", "--nolock", "--rerun-incomplete", *options, "--config",
            f"table={folder / 'cases.csv'}", f"out={folder / out}", f"isostack={bin_dir / 'isostack'}", *config]


def members(session):
    """Processes of a session."""
    found = []
    for entry in pathlib.Path("/proc").iterdir():
        try:
            if entry.name.isdigit() and os.getsid(int(entry.name)) == session:
                found.append(int(entry.name))
        except ProcessLookupError:
            pass
    return found


def kill_session(session):
    """kill -9 of everything the workflow started."""
    while alive := members(session):
        for pid in alive:
            try:
                os.kill(pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
        for pid in alive:
            try:
                os.waitpid(pid, 0)
            except ChildProcessError:
                pass


def results_of(out):
    """Hashes of everything that came out; pipelines and reports without paths and times."""
    return {str(path.relative_to(out)): hashlib.sha256(path.read_bytes()).hexdigest()
            for path in sorted(out.glob("cases/*/*")) if path.name in ("surface.ply", "picture.png", "result.json")}


def rows_of(out):
    with open(out / "cases.csv", newline="", encoding="utf-8") as file:
        return {row["id"]: row for row in csv.DictReader(file)}


def json_of(path):
    return json.loads(path.read_text(encoding="utf-8"))
