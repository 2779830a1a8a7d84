#!/usr/bin/env python3
"""coverage_messages.py LINES ROOT: which messages of bad input no test gives, from gcovr's --json.  A message is a
statement that throws an InputError, or a call of one of the functions that do (see scripts/make-reference)."""

import json
import re
import sys

THROWS = re.compile(r"\b(throw InputError|throw FileError|fail_at|fail|refuse|truncated)\s*\(")
DECLARES = re.compile(r"^\s*(//|\[\[noreturn\]\]|void |.*\bvoid \w*(::)?(fail|refuse|truncated))")


def main():
    if sys.argv[1:] in (["-h"], ["--help"]):
        print(__doc__)
        return
    if len(sys.argv) != 3:
        print("error: coverage_messages.py: coverage_messages.py LINES ROOT would be right", file=sys.stderr)
        sys.exit(2)
    lines_file, root = sys.argv[1:]
    with open(lines_file, encoding="utf-8") as file:
        files = json.load(file)["files"]
    total, missing = 0, []
    for entry in files:
        counts = {}
        for line in entry["lines"]:
            counts[line["line_number"]] = counts.get(line["line_number"], 0) + line["count"]
        try:
            with open(f"{root}/{entry['file']}", encoding="utf-8") as file:
                source = file.read().splitlines()
        except FileNotFoundError:  # generated
            continue
        for number, text in enumerate(source, 1):
            if not THROWS.search(text) or DECLARES.search(text):
                continue
            count = next((counts[n] for n in range(number, number + 4) if n in counts), None)
            if count is None:
                continue
            total += 1
            if count == 0:
                missing.append(f"  {entry['file']}:{number}: {text.strip()[:100]}")
    print(f"\nmessages of bad input: {total}, of which no test gives {len(missing)}")
    print("\n".join(missing))


main()
