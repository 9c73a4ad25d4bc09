#!/usr/bin/env python3
"""What bench/run leaves of a few programs on small sizes: run_test.py RUN BUILD"""
import json
import pathlib
import subprocess
import sys
import tempfile

run, build = sys.argv[1:]
problems = []


def expect(name, is_so):
    if not is_so:
        problems.append(name)


with tempfile.TemporaryDirectory() as folder:
    command = [run, "--build", build, "-o", folder, "--most", "0.1", "map_families", "memory_table", "numbers_bench",
               "space_unbounded"]
    done = subprocess.run(command, capture_output=True, text=True)
    expect(f"exit status {done.returncode}: {done.stderr}", done.returncode == 0)
    file = pathlib.Path(folder) / "benchmarks.json"
    results = json.loads(file.read_text())
    page = (pathlib.Path(folder) / "page.html").read_text()

expect("one program of families", [len(p["families"]) > 0 for p in results["programs"]] == [True])
samples = [s for p in results["programs"] for f in p["families"] for s in f["samples"]]
expect("every size has its counts", all(s["allocations"] > 0 and s["bytes"] > 0 for s in samples))
expect("memory and unbounded sets, and no other part", [m["part"] for m in results["macro"]] == ["memory", "unbounded"])
expect("cases of one micro-benchmark", [len(m["benchmarks"]) > 0 for m in results["micro"]] == [True])
expect("of the machine no name", "host_name" not in json.dumps(results) and "executable" not in json.dumps(results))
expect("nothing failed", results["failed"] == [])
expect("the page holds the results", '"numbers_bench"' in page and "/*DATA*/" not in page)
unknown = subprocess.run([run, "--build", build, "no_such_program"], capture_output=True, text=True)
expect(f"a program that is not there: {unknown.returncode}", unknown.returncode == 2)
part = subprocess.run([run, "--build", build, "--record", "--peers", "map_families"], capture_output=True, text=True)
expect(f"a part is not recorded: {part.returncode}", part.returncode == 2)

print("\n".join(problems) or "bench/run leaves what it should")
sys.exit(1 if problems else 0)
