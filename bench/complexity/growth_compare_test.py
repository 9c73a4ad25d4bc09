#!/usr/bin/env python3
"""What growth_compare says of doctored results: growth_compare_test.py PROGRAM"""
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

program = sys.argv[1]
scratch = tempfile.TemporaryDirectory()  # gone at the end
folder = pathlib.Path(scratch.name)
problems = []


def sample(size):
    return {"size": size, "seconds": 1e-6 * size, "instructions": 0, "allocations": 7.0 * size, "bytes": 90.0 * size,
            "accesses": 300.0 * size, "predicates": 5.0 * size, "unfiltered": 0.5 * size,
            "batches": [1e-6 * size * (1 + 0.01 * i) for i in range(5)]}


old = {"programs": [{"title": "Growth", "families": [{"name": name, "samples": [sample(n) for n in (100, 1000, 10000)]}
                                                      for name in ("family", "other")]}],
       "macro": [{"part": "memory", "rows": [{"structure": "Map", "input": "hexagons", "measured": 50.0}]},
                 {"part": "capabilities", "rows": [
                     {"capability": "map check", "input": "hexagons", "calls": {"orient2d": {"filter": 900, "small": 100}}},
                     {"capability": "read map", "input": "hexagons"}]}]}


def samples(results):
    return results["programs"][0]["families"][0]["samples"]


def expect(name, status, doctor):
    new = copy.deepcopy(old)
    doctor(new)
    for file, results in (("old.json", old), ("new.json", new)):
        (folder / file).write_text(json.dumps(results))
    run = subprocess.run([program, folder / "old.json", folder / "new.json"], capture_output=True, text=True)
    if run.returncode != status:
        problems.append(f"{name}: exit status {run.returncode}, not {status}: {run.stdout}{run.stderr}")


def times(factor, key):
    def doctor(results):
        samples(results)[1][key] *= factor
    return doctor


def slower(factor, batches=5):
    def doctor(results):
        for s in samples(results):
            s["seconds"] *= factor
            s["batches"] = [b * factor if i < batches else b for i, b in enumerate(s["batches"])]
    return doctor


expect("the same", 0, lambda results: None)
for key in ("allocations", "bytes", "accesses", "predicates"):
    expect(f"{key} 1.9 % up", 0, times(1.019, key))
    expect(f"{key} 2.1 % up", 1, times(1.021, key))
    expect(f"{key} 10 % down", 0, times(0.9, key))
expect("beyond the filter 11.9 instead of 10 % of the calls", 0, times(1.19, "unfiltered"))
expect("beyond the filter 12.1 %", 1, times(1.21, "unfiltered"))
expect("beyond the filter 5 %", 0, times(0.5, "unfiltered"))
expect("14 % slower", 0, slower(1.14))
expect("16 % slower", 1, slower(1.16))
expect("16 % slower, in one batch of five", 0, slower(1.16, batches=1))
expect("20 % faster", 0, slower(0.8))
def holds(factor):
    def doctor(results):
        results["macro"][0]["rows"][0]["measured"] *= factor
    return doctor


def families(results):
    return results["programs"][0]["families"]


def other_sizes(results, count=2):
    for family in families(results)[:count]:
        for s in family["samples"]:
            s["size"] += 1


def without_calls(results):
    for family in families(results):
        for s in family["samples"]:
            del s["predicates"], s["unfiltered"]


expect("a structure 1.9 % larger", 0, holds(1.019))
expect("a structure 2.1 % larger", 1, holds(1.021))
expect("a structure 10 % smaller", 0, holds(0.9))
expect("without structures", 1, lambda results: results.pop("macro"))
expect("a structure that is gone", 1, lambda results: results["macro"][0]["rows"][0].update(structure="Other"))
expect("calls are not counted", 0, without_calls)
def asks(count):
    def doctor(results):
        results["macro"][1]["rows"][0]["calls"]["orient2d"]["filter"] = count
    return doctor


expect("a capability that asks 1.9 % more", 0, asks(919))
expect("a capability that asks 2.1 % more", 1, asks(921))
expect("a capability that asks less", 0, asks(500))
expect("a capability that is gone", 1, lambda results: results["macro"][1]["rows"][0].update(input="fan"))
expect("no capability counts its calls", 0, lambda results: results["macro"][1]["rows"].pop(0))
expect("no size in both", 2, other_sizes)
expect("no size of one family in both", 1, lambda results: other_sizes(results, 1))
expect("a size that is gone", 0, lambda results: samples(results).pop())
expect("a family that failed", 1, lambda results: families(results)[0].pop("samples"))
expect("a family that is gone", 1, lambda results: families(results).pop())
expect("a family with another name", 1, lambda results: families(results)[0].update(name="new"))
expect("a new family", 0, lambda results: families(results).append({"name": "new", "samples": [sample(7)]}))
expect("no families", 2, lambda results: families(results).clear())
expect("no programs", 2, lambda results: results.pop("programs"))

print("\n".join(problems) or "growth_compare judges as it should")
sys.exit(1 if problems else 0)
