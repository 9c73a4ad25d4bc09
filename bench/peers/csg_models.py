#!/usr/bin/env python3
"""Evaluates OpenSCAD models with `plumb solid csg`, and compares the results with what is expected.

    bench/peers/csg_models.py [--plumb PROGRAM] [--only TEXT] FOLDER

FOLDER has models (.csg) and a table expected.tsv with a header line and the columns `model`,
`volume` and `marked_volumes`; a column `cpu_manifold_native` is summed for comparison. Volumes may
differ by five parts in a million, since some expected ones come from meshes of floats.

Prints a line for each model: CPU seconds of the program that writes it exactly (.nef), and what
differs in volume or number of parts. The
exit status is 1 if a model is wrong.
"""
import argparse
import csv
import json
import os
import pathlib
import resource
import subprocess
import sys

TOLERANCE = 5e-6


def evaluate(program, model):
    """Returns the CPU seconds and the JSON of a model, or the message of an error."""
    command = [program, "solid", "csg", str(model), "--quiet"]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    run = subprocess.run([*command, "--format", "nef", "-o", os.devnull], capture_output=True,
                         text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu = after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime
    if run.returncode != 0:
        return cpu, None, run.stderr.strip()
    facts = subprocess.run([*command, "--json"], capture_output=True, text=True, check=True)
    return cpu, json.loads(facts.stdout), ""


def flaws_of(row, result):
    """Returns what differs from the row of the table."""
    flaws = []
    expected, volume = float(row["volume"]), result["volume"]["double"]
    if abs(volume - expected) > TOLERANCE * abs(expected):
        flaws.append(f"volume {volume!r}, expected {expected!r}")
    if result["marked_volumes"] != int(row["marked_volumes"]):
        flaws.append(f"{result['marked_volumes']} parts, expected {row['marked_volumes']}")
    return flaws


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--plumb", default="./plumb")
    parser.add_argument("--only", default="")
    arguments = parser.parse_args()
    with open(arguments.folder / "expected.tsv", encoding="utf-8") as table:
        lines = list(table)
    start = next(i for i, line in enumerate(lines) if line.startswith("model\t"))
    total, peer, wrong, slowest = 0.0, 0.0, 0, (0.0, "")
    for row in csv.DictReader(lines[start:], delimiter="\t"):
        if arguments.only not in row["model"]:
            continue
        cpu, result, error = evaluate(arguments.plumb, arguments.folder / (row["model"] + ".csg"))
        flaws = flaws_of(row, result) if result else [error]
        total += cpu
        peer += float(row.get("cpu_manifold_native") or 0)
        wrong += bool(flaws)
        slowest = max(slowest, (cpu, row["model"]))
        print(f"{cpu:8.3f}  {row['model']}  {'; '.join(flaws) or 'ok'}", flush=True)
    print(f"{total:8.3f}  CPU seconds in all; slowest {slowest[1]} {slowest[0]:.3f}; "
          f"Manifold {peer:.3f}; {wrong} wrong")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
