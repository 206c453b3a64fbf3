#!/usr/bin/env python3
"""cohort_test.py BIN_DIR SCRATCH [SOUND KILLS]: the workflow over SOUND (5) sound and three broken cases, killed KILLS (2)
times at random moments and taken up again, against a run left alone. 77: no snakemake."""
import pathlib
import random
import shutil
import subprocess
import sys
import time

import cohort

BIN, SCRATCH = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
SOUND, KILLS = (int(word) for word in sys.argv[3:5]) if len(sys.argv) > 3 else (5, 2)


def run_killed(command, seconds):
    """Ends the workflow and all it started after so many seconds; true when it was still at work."""
    with subprocess.Popen(command, cwd=SCRATCH, start_new_session=True, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL) as running:
        time.sleep(seconds)
        at_work = running.poll() is None
        cohort.kill_session(running.pid)
    return at_work


def check_overview(out, names):
    rows = cohort.rows_of(out)
    assert list(rows) == names, rows
    failed = {name: row["message"] for name, row in rows.items() if row["status"] == "failed"}
    assert set(failed) == set(cohort.BROKEN), failed
    for name, words in cohort.BROKEN.items():
        assert words in failed[name], failed
    assert "volume_cm3" in rows["halved"]["outliers"], rows["halved"]
    assert 70 < float(rows["sound00"]["volume_cm3"]) < 80, rows["sound00"]
    page = (out / "overview.html").read_text()
    assert page.count('class="failed"') == 3 and page.count("<img") == SOUND, page
    for name in failed:
        assert f'href="#{name}"' in page and f'id="{name}"' in page, name
    for name in set(names) - set(failed):
        assert (out / f"cases/{name}/picture.png").stat().st_size > 1000


def main():
    if not shutil.which("snakemake"):
        print("snakemake is not installed")
        return 77
    names = cohort.make_cases(BIN, SCRATCH, SOUND)
    begin = time.monotonic()
    subprocess.run(cohort.command(BIN, SCRATCH, "left_alone"), cwd=SCRATCH, check=True)
    whole = time.monotonic() - begin
    check_overview(SCRATCH / "left_alone", names)

    moments = random.Random(11)
    killed = sum(run_killed(cohort.command(BIN, SCRATCH), moments.uniform(0.1, 0.6) * whole / max(1, KILLS / 3))
                 for _ in range(KILLS))
    assert killed >= KILLS / 2, f"{killed} of {KILLS} were still at work"
    subprocess.run(cohort.command(BIN, SCRATCH), cwd=SCRATCH, check=True)
    check_overview(SCRATCH / "results", names)
    left_alone, taken_up = (cohort.results_of(SCRATCH / out) for out in ("left_alone", "results"))
    assert taken_up == left_alone, set(taken_up.items()) ^ set(left_alone.items())
    assert len(left_alone) == 3 * SOUND + 3

    (SCRATCH / "truncated/a.dcm").unlink()
    shutil.copytree(SCRATCH / "sample/series", SCRATCH / "truncated", dirs_exist_ok=True)
    subprocess.run(cohort.command(BIN, SCRATCH, config=["again=failed"]), cwd=SCRATCH, check=True)
    assert cohort.rows_of(SCRATCH / "results")["truncated"]["status"] == "done"
    print(f"{len(names)} cases, killed {killed} times: the same {len(left_alone)} files")
    return 0


sys.exit(main())
