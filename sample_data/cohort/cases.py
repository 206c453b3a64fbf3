"""The table of cases: id, input, options of `isostack reconstruct`."""
import csv
import hashlib
import json
import os
import pathlib
import sys
import tempfile


def read_table(table):
    """Rows of the table, in its order. Exits with a sentence when one is no case."""
    with open(table, newline="", encoding="utf-8-sig") as file:
        rows = list(csv.DictReader(file))
    names = set()
    for number, row in enumerate(rows, start=2):
        name = row.get("id") or ""
        if not row.get("input") or not name or not all(c.isalnum() or c in "-_." for c in name) or name.startswith("."):
            sys.exit(f"{table}, line {number}: a row needs an id of letters, digits, '-', '_' and '.', and an input")
        if name in names:
            sys.exit(f"{table}, line {number}: the id {name} stands twice")
        names.add(name)
    return [{"id": row["id"], "input": row["input"], "options": row.get("options") or ""} for row in rows]


def jobs_of(rows, size):
    """Cases that share a job, by a name that changes with them."""
    parts = [rows[i:i + size] for i in range(0, len(rows), size)]
    return {hashlib.sha256(json.dumps(part).encode()).hexdigest()[:16]: part for part in parts}


def result_of(out, name):
    """The case's result; none as long as there is none."""
    try:
        return json.loads((pathlib.Path(out) / "cases" / name / "result.json").read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None


def write_whole(path, text):
    """The file appears whole or not at all, also when the machine stops."""
    with tempfile.NamedTemporaryFile("w", dir=path.parent, prefix=".", delete=False, encoding="utf-8") as file:
        file.write(text)
        file.flush()
        os.fsync(file.fileno())
    os.chmod(file.name, 0o644)
    os.replace(file.name, path)
