#!/usr/bin/env python3
"""coverage_table.py SUMMARY: the table of scripts/coverage from gcovr's --json-summary.

A row for each room and its folders, then the files with most lines that no test executes. Exit code 1 when a room is
below its floor."""
import collections
import json
import sys

FLOORS = {"hw": 95, "ref": 95, "traces": 95, "sim": 85}
WORST = 15


def row(name, lines, covered, note=""):
    percent = 100 * covered / lines if lines else 100
    print(f"{name:<28} {lines:>7} {covered:>8} {percent:>8.1f}{note}")


def main():
    if sys.argv[1:] in (["-h"], ["--help"]):
        print(__doc__)
        return 0
    if len(sys.argv) != 2:
        print("error: coverage_table.py: coverage_table.py SUMMARY would be right", file=sys.stderr)
        return 2
    with open(sys.argv[1], encoding="utf-8") as file:
        files = json.load(file)["files"]
    sums = collections.defaultdict(lambda: [0, 0])
    for entry in files:
        parts = entry["filename"].split("/")[:-1]
        for folder in {parts[0], "/".join(parts[:2])}:
            sums[folder][0] += entry["line_total"]
            sums[folder][1] += entry["line_covered"]

    failed = False
    print(f"{'folder':<28} {'lines':>7} {'covered':>8} {'percent':>8}")
    for folder in sorted(sums):
        lines, covered = sums[folder]
        floor = FLOORS.get(folder)
        note = ""
        if floor is not None:
            below = 100 * covered < floor * lines
            failed |= below
            note = f"   {'below' if below else 'at least'} {floor}"
        row(folder, lines, covered, note)

    def missing(entry):
        return entry["line_total"] - entry["line_covered"]

    print("\nmost lines not executed")
    for entry in sorted(files, key=missing, reverse=True)[:WORST]:
        if missing(entry):
            row(entry["filename"], entry["line_total"], entry["line_covered"])
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
