#!/usr/bin/env python3
"""overview.py OUT TABLE: OUT/cases.csv and OUT/overview.html from the results of all cases of the table.

A value far from the cohort's others is marked: more than 3.5 robust standard deviations (1.4826 times the median distance
from the median) from the median, from five finished cases on; distances, contradictions and memory only when they are large.
"""
import csv
import html
import io
import json
import pathlib
import statistics
import sys

import cases

COLUMNS = {
    "volume_cm3": "volume, cm³",
    "area_cm2": "area, cm²",
    "components": "parts",
    "genus": "handles",
    "residual_mm": "largest distance of a contour point, mm",
    "contradiction_mm": "largest contradiction of slices, mm",
    "peak_mb": "memory, MB",
}
DECIMALS = {"volume_cm3": 2, "area_cm2": 1, "components": 0, "genus": 0, "residual_mm": 3, "contradiction_mm": 3, "peak_mb": 0}
LIMIT = 3.5
ONLY_LARGE = {"residual_mm", "contradiction_mm", "peak_mb"}  # little of these is no fault


def largest(values):
    values = [value for value in values if isinstance(value, (int, float))]
    return max(values) if values else None


def row_of(out, name):
    result = cases.result_of(out, name)
    row = {"id": name, "status": result["status"], "message": result.get("message", "")}
    if result["status"] != "done":
        return row
    report = json.loads((out / "cases" / name / "report.json").read_text(encoding="utf-8"))
    surfaces = report["surfaces"]
    measures = [surface["surface"] for surface in surfaces]
    row["volume_cm3"] = sum(m["volume_mm3"] for m in measures) / 1000
    row["area_cm2"] = sum(m["area_mm2"] for m in measures) / 100
    row["components"] = sum(m["components"] for m in measures)
    row["genus"] = sum(m["genus"] or 0 for m in measures)
    row["residual_mm"] = largest(s["contour_residual_mm"]["largest"] for s in surfaces)
    row["contradiction_mm"] = largest(s["contradictions"]["largest_mismatch_mm"] for s in surfaces)
    row["peak_mb"] = (largest(s["peak_bytes"] for s in surfaces) or 0) / 2**20
    return row


def mark_outliers(rows):
    done = [row for row in rows if row["status"] == "done"]
    for row in rows:
        row["outliers"] = []
    for column in COLUMNS:
        values = [row[column] for row in done if row[column] is not None]
        if len(values) < 5:
            continue
        median = statistics.median(values)
        spread = 1.4826 * statistics.median(abs(value - median) for value in values)
        least = 1e-9 + 0.01 * abs(median)  # equal values do not make everything else an outlier
        for row in done:
            if row[column] is None:
                continue
            away = row[column] - median
            if (away if column in ONLY_LARGE else abs(away)) > LIMIT * max(spread, least):
                row["outliers"].append(column)


def table_of(rows):
    text = io.StringIO(newline="")
    writer = csv.DictWriter(text, ["id", "status", *COLUMNS, "outliers", "message"], extrasaction="ignore")
    writer.writeheader()
    for row in rows:
        writer.writerow({**row, "outliers": " ".join(row["outliers"])})
    return text.getvalue()


def cell(row, column):
    value = row.get(column)
    text = "" if value is None else f"{value:.{DECIMALS[column]}f}"
    return f'<td class="number{" outlier" if column in row["outliers"] else ""}">{text}</td>'


def listed(rows):
    """": " and a link to the row of each of them, if there is one."""
    links = ", ".join(f'<a href="#{html.escape(row["id"])}">{html.escape(row["id"])}</a>' for row in rows)
    return ": " + links if links else ""


def page_of(rows):
    failed = [row for row in rows if row["status"] != "done"]
    marked = [row for row in rows if row["outliers"]]
    head = "".join(f"<th>{html.escape(title)}</th>" for title in ("case", "picture", *COLUMNS.values(), "remark"))
    body = ""
    for row in rows:
        name = html.escape(row["id"])
        picture = f'<img src="cases/{name}/picture.png" alt="{name}" loading="lazy">' if row["status"] == "done" else ""
        far = ", ".join(COLUMNS[column].split(",")[0] for column in row["outliers"])
        remark = html.escape(row["message"]) or (f"far from the others: {far}" if far else "")
        body += (f'<tr class="{row["status"]}" id="{name}"><td><a href="cases/{name}/result.json">{name}</a></td><td>{picture}</td>'
                 + "".join(cell(row, column) for column in COLUMNS) + f"<td>{remark}</td></tr>\n")
    return f"""<!doctype html>
<html lang="en"><meta charset="utf-8"><title>isostack cohort</title>
<style>
body {{ font-family: sans-serif; margin: 2em; }}
table {{ border-collapse: collapse; }}
th, td {{ border-bottom: 1px solid #ccc; padding: 0.3em 0.7em; text-align: left; vertical-align: middle; }}
img {{ width: 160px; }}
td.number {{ text-align: right; font-variant-numeric: tabular-nums; }}
tr.failed {{ background: #fbe3e1; }}
td.outlier {{ background: #fff0b8; font-weight: bold; }}
</style>
<h1>{len(rows)} cases</h1>
<p>{len(rows) - len(failed)} finished. Research software, not for clinical use.</p>
<p>{len(failed)} failed{listed(failed)}</p>
<p>{len(marked)} with values far from the others (yellow){listed(marked)}</p>
<table><tr>{head}</tr>
{body}</table></html>
"""


def main():
    out, table = pathlib.Path(sys.argv[1]), sys.argv[2]
    rows = [row_of(out, case["id"]) for case in cases.read_table(table)]
    mark_outliers(rows)
    cases.write_whole(out / "cases.csv", table_of(rows))
    cases.write_whole(out / "overview.html", page_of(rows))


if __name__ == "__main__":
    main()
