#!/usr/bin/env python3
"""cohort_test.py BIN_DIR SCRATCH: the workflow over sound and broken cases, stopped and taken up again. 77: no snakemake."""
import csv
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import time

BIN, SCRATCH = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
WORKFLOW = pathlib.Path(__file__).resolve().parents[2] / "sample_data/cohort/Snakefile"
OPTIONS = "--level 25 --gaussian 1 --max-constraints 500 --resolution 4"


def make_cases(table):
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    subprocess.run([BIN / "isostack_make_phantom", SCRATCH / "sample"], check=True)
    series = SCRATCH / "sample/series"
    truncated = SCRATCH / "truncated"
    truncated.mkdir()
    first = next(series.glob("*.dcm"))
    (truncated / "a.dcm").write_bytes(first.read_bytes()[:2000])
    rows = [(f"sound{i}", series, f"{OPTIONS} --slices {','.join(str(k) for k in range(i % 2, 30, 2))}") for i in range(4)]
    rows.append(("halved", series, OPTIONS + " --slices 4,6,8,10,12"))  # an outlier: a part of the organ
    rows.append(("doubled", series, OPTIONS))
    rows += [("truncated", truncated, OPTIONS), ("two_series", SCRATCH / "sample", OPTIONS),
             ("empty", series, OPTIONS.replace("25", "2500"))]
    with open(table, "w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(("id", "input", "options"))
        writer.writerows(rows)
    return [row[0] for row in rows]


def command(table):
    return ["snakemake", "-s", WORKFLOW, "--cores", "2", "--quiet", "--nolock", "--rerun-incomplete", "--config",
            f"table={table}", f"out={SCRATCH / 'results'}", f"isostack={BIN / 'isostack'}"]


def main():
    if not shutil.which("snakemake"):
        print("snakemake is not installed")
        return 77
    table = SCRATCH / "cases.csv"
    names = make_cases(table)
    killed = subprocess.Popen(command(table), cwd=SCRATCH, start_new_session=True, stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL)
    time.sleep(4)  # some cases are under way
    os.killpg(killed.pid, signal.SIGKILL)
    killed.wait()
    subprocess.run(command(table), cwd=SCRATCH, check=True)

    with open(SCRATCH / "results/cases.csv", newline="") as file:
        rows = {row["id"]: row for row in csv.DictReader(file)}
    assert list(rows) == names, rows
    failed = {name: row["message"] for name, row in rows.items() if row["status"] == "failed"}
    assert set(failed) == {"truncated", "two_series", "empty"}, failed
    assert "a.dcm" in failed["truncated"] and "series" in failed["two_series"], failed
    assert "volume_cm3" in rows["halved"]["outliers"], rows["halved"]
    assert not rows["sound0"]["outliers"] and 70 < float(rows["sound0"]["volume_cm3"]) < 80, rows["sound0"]
    page = (SCRATCH / "results/overview.html").read_text()
    assert page.count('class="failed"') == 3 and page.count("<img") == 6
    for name in set(names) - set(failed):
        assert (SCRATCH / f"results/cases/{name}/picture.png").stat().st_size > 1000
    print("cohort ran")
    return 0


sys.exit(main())
