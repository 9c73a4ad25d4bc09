#!/usr/bin/env python3
"""What bench/figures makes of small documents: figures_test.py FIGURES"""
import json
import pathlib
import subprocess
import sys
import tempfile

program = sys.argv[1]
scratch = tempfile.TemporaryDirectory()  # gone at the end
folder = pathlib.Path(scratch.name)
problems = []

# A result of bench/run, reduced to the figures by the program itself.
fit = {"power": 0.987, "half_width": 0.014}
family = {"name": "grid", "bound": {"power": 1, "logs": 0}, "fits": {"seconds": fit}, "goal": {"power": 1.5, "half_width": 0.1},
          "samples": [{"size": 1000, "seconds": 1e-4}, {"size": 3000, "seconds": 1}, {"size": 100000, "seconds": 0.0234}]}
result = {"machine": {"cores": 2}, "programs": [{"families": [family, {"name": "failed", "failure": "why"}]}],
          "macro": [{"part": "memory", "rows": [{"structure": "Map", "input": "hexagons", "unit": "corners", "elements": 7000,
                                                 "measured": 10.04, "predicted": 10.0}]}],
          "micro": [{"program": "numbers_bench", "benchmarks": []}], "peers": []}
(folder / "result.json").write_text(json.dumps(result))
subprocess.run([program, "--record", folder / "result.json", folder / "figures.json"], check=True)
recorded = (folder / "figures.json").read_text()
if json.loads(recorded)["families"]["grid"]["most"] != {"size": 100000, "seconds": 0.0234} or "3000" in recorded:
    problems.append(f"recorded: {recorded}")
if len([line for line in recorded.splitlines() if "grid" in line or "hexagons" in line]) != 2:
    problems.append(f"a figure a line: {recorded}")

OLD_TABLE = "<!-- figures: memory -->\nold\n<!-- end of figures -->"
NEW_TABLE = ("<!-- figures: memory -->\n| structure | input | for each of | measured | predicted |\n|---|---|---|---|---|\n"
             "| `Map` | hexagons | 7,000 corners | 10.0 | 10.0 |\n<!-- end of figures -->")


def figures(text, *options):
    document = folder / "document.md"
    document.write_text(text)
    done = subprocess.run([program, *options, folder / "figures.json", document], capture_output=True, text=True)
    return done.returncode, document.read_text()


def expect(name, old, new, status=0):
    """`old` becomes `new`, with that exit status; --check refuses `old` if that is another one, and takes `new`."""
    found = figures(old)
    if found != (status, new):
        problems.append(f"{name}: {found}")
    if old != new and figures(old, "--check") != (1, old):
        problems.append(f"{name}: --check takes what is wrong")
    if figures(new, "--check") != (0, new):
        problems.append(f"{name}: --check refuses what is right")


expect("an exponent", "*grid* 0.95 +- 0.03", "*grid* 0.99 +- 0.01")
expect("one that was not known", "*grid* *?*", "*grid* 0.99 +- 0.01")
expect("of time alone", "*grid*, time alone *?*", "*grid*, time alone 1.50 +- 0.10")
expect("of no family", "*fan* 0.95 +- 0.03", "*fan* *?*", 1)
expect("a word", "| 1<!--= seconds grid--> s", "| 0.0234<!--= seconds grid--> s")
expect("a size", "1<!--= size grid-->", "100,000<!--= size grid-->")
expect("nanoseconds each", "1<!--= least grid-->, 2<!--= most grid-->", "100<!--= least grid-->, 234<!--= most grid-->")
expect("bytes", "9<!--= measured Map-->", "10.0<!--= measured Map-->")
expect("a word of no family", "9<!--= seconds fan-->", "?<!--= seconds fan-->", 1)
expect("a table", OLD_TABLE, NEW_TABLE)
expect("a table of a part that is not there", OLD_TABLE.replace("memory", "threads"), OLD_TABLE.replace("memory", "threads"))
expect("other words", "grid 1.00 +- 0.01, <!-- figures -->, *grid* is a family", "grid 1.00 +- 0.01, <!-- figures -->, *grid* is a family")

print("\n".join(problems) or "bench/figures puts in what it should")
sys.exit(1 if problems else 0)
