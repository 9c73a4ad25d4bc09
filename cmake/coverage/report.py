#!/usr/bin/env python3
"""What the tests execute of predicates/ and engine/: report.py SOURCE_DIR BUILD_DIR PROGRAMS [--measured]

PROGRAMS is a file with the path of an instrumented program a line. Runs ctest (--measured: takes the counts of the last
run), then writes into BUILD_DIR/report:

  table.txt       lines and branches by part, and what each part must reach; also printed
  uncovered.txt   FILE:LINE:COLUMN of every branch that is not taken both ways, by part, with its text
  html            the sources with their counts

Exits 1 where a test fails or a part is below its limit. All programs count together, with the templates and inline
functions that each has a copy of: a branch is a place in a source, and taken one way if any copy takes it that way.

Not counted, because no test could take them (docs/testing.md says the same):
  - what is inside a macro, which is PLUMB_CHECK alone: it fails where an invariant is broken, that is, never;
  - conditions that the compiler decides: `if constexpr` and constants;
  - comparisons that the compiler writes (`= default`);
  - "no case fits" of a switch without default: such switches are over an enum and list all of it (-Wswitch).
What clean-up does when an exception passes is no branch to the compiler, so nothing has to be said of it."""
import argparse
import bisect
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Files of the module io that do not write.
READER = re.compile(r"(?!\w*(writer|output|report|mesh_text|solid_text))")
MODULES = ["base", "dcel", "plane", "sphere", "space", "convex", "surface", "io", "picture", "cli"]
# part -> the percentage of its branches that tests have to take.
LIMITS = {"predicates": 95, "readers": 95, **{module: 90 for module in MODULES}, "engine": 90}


def parts_of(path):
    """The rows of the table that a file counts in; readers are part of io, every module of engine."""
    folders = [folder for folder in path.split("/")[:-1] if folder != "plumb"]
    if folders[0] == "predicates":
        return ["predicates"]
    is_reader = folders[1] == "io" and READER.match(os.path.basename(path))
    return (["readers"] if is_reader else []) + [folders[1], "engine"]


def run(command, **options):
    return subprocess.run([str(word) for word in command], **options)


def measure(build, profiles):
    """Runs all tests; their counts end up in a few files for each program, added up as programs end."""
    shutil.rmtree(profiles, ignore_errors=True)
    profiles.mkdir()
    environment = {**os.environ, "LLVM_PROFILE_FILE": str(profiles / "%4m.profraw")}
    return run(["ctest", "--test-dir", build, "--output-on-failure", "--no-tests=error",
                "-j", os.environ.get("CTEST_PARALLEL_LEVEL", "1")], env=environment).returncode == 0


class File:
    """The counts of one source file, as llvm-cov exports them."""

    def __init__(self, path, exported):
        self.path = path
        self.text = pathlib.Path(exported["filename"]).read_text().splitlines()
        # line, column, count, whether counted, ...: what holds from there to the next.
        self.segments = exported["segments"]
        self.starts = [(s[0], s[1]) for s in self.segments]
        self.branches = {}
        for line, column, _, _, taken, passed, *_ in exported["branches"]:
            counts = self.branches.setdefault((line, column), [0, 0])
            counts[0] += taken
            counts[1] += passed

    def executions(self, place):
        """How often what is at a place was executed."""
        at = bisect.bisect_right(self.starts, place) - 1
        return self.segments[at][2] if at >= 0 and self.segments[at][3] else 0

    def lines(self):
        """Of lines with code: [executed, all]."""
        counts = {}
        for at, (line, _, count, counted, *_) in enumerate(self.segments):
            if counted:
                counts[line] = max(counts.get(line, 0), count)
            end = self.segments[at + 1][0] if at + 1 < len(self.segments) else line
            for other in range(line + 1, end + 1):  # the line of the next one, too, begins in this one
                if counted:
                    counts[other] = count
        return [sum(1 for count in counts.values() if count), len(counts)]

    def outcomes(self):
        """(place, "true" or "false", count) of every way that counts."""
        for (line, column), (taken, passed) in sorted(self.branches.items()):
            before, here = self.text[line - 1][:column - 1], self.text[line - 1]
            if taken == passed == 0 and ("if constexpr" in here or self.executions((line, column))):
                continue  # decided by the compiler
            if here.endswith("= default;"):
                continue
            if re.search(r"\bswitch \($", before):
                yield (line, column), "any case", passed
            elif re.match(r"\s*(case\b|default:)", self.text[line - 1][column - 1:]):
                yield (line, column), "this case", taken
            else:
                yield (line, column), "true", taken
                yield (line, column), "false", passed


def others(source):
    """Options that leave out most of what is neither predicates/ nor engine/."""
    return ["-ignore-filename-regex", "^/usr/", "-ignore-filename-regex", f"^{re.escape(str(source))}/(tests|fuzz|examples)/"]


def load(source, objects, profile):
    """Every file of predicates/ and engine/ with its counts."""
    command = ["llvm-cov", "export", "-format=text", "-skip-expansions", "-skip-functions",
               f"-instr-profile={profile}", *objects, *others(source)]
    exported = json.loads(run(command, check=True, stdout=subprocess.PIPE).stdout)
    for entry in exported["data"][0]["files"]:
        path = os.path.relpath(os.path.realpath(entry["filename"]), source)
        if path.split("/")[0] in ("predicates", "engine"):
            yield File(path, entry)


def percent(some, every):
    """Rounded down to tenths."""
    return 1000 * some // every / 10 if every else 100.0


def table(counts):
    """The rows, and whether all reach their limits."""
    rows, good = [f"{'':12}{'lines':>8}{'':>8}{'branches':>10}{'not taken':>11}{'':>8}{'limit':>7}"], True
    for part, limit in LIMITS.items():
        executed, lines, taken, branches = counts.get(part, [0, 0, 0, 0])
        reached = 100 * taken >= limit * branches
        good = good and reached
        rows.append(f"{part:12}{lines:8}{percent(executed, lines):7.1f}%{branches:10}{branches - taken:11}"
                    f"{percent(taken, branches):7.1f}%{limit:6}%{'' if reached else '  below'}")
    return "\n".join(rows) + "\n", good


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("source", type=pathlib.Path)
    arguments.add_argument("build", type=pathlib.Path)
    arguments.add_argument("programs", type=pathlib.Path)
    arguments.add_argument("--measured", action="store_true", help="the tests have run already")
    given = arguments.parse_args()
    given.source = given.source.resolve()
    profiles, report = given.build / "profiles", given.build / "report"
    passed = given.measured or measure(given.build, profiles)
    report.mkdir(exist_ok=True)
    profile = report / "all.profdata"
    # A program that a test kills leaves a broken file, which is left out.
    run(["llvm-profdata", "merge", "-sparse", "-failure-mode=all", "-o", profile, *profiles.glob("*.profraw")], check=True)
    programs = given.programs.read_text().split()
    objects = [programs[0], *(word for program in programs[1:] for word in ("-object", program))]
    counts, uncovered = {}, []
    for file in load(given.source, objects, profile):
        parts = parts_of(file.path)
        outcomes = list(file.outcomes())
        numbers = [*file.lines(), sum(1 for *_, count in outcomes if count), len(outcomes)]
        for part in parts:
            counts[part] = [a + b for a, b in zip(counts.get(part, [0] * 4), numbers)]
        for (line, column), way, count in outcomes:
            if count:
                continue
            uncovered.append(f"{parts[0]}\t{file.path}:{line}:{column}: {way}\t{file.text[line - 1].strip()}")
    (report / "uncovered.txt").write_text("\n".join(uncovered) + "\n")
    text, good = table(counts)
    (report / "table.txt").write_text(text)
    run(["llvm-cov", "show", "-format=html", "-show-branches=count", "-show-instantiations=false",
         f"-output-dir={report / 'html'}", f"-instr-profile={profile}", *objects, *others(given.source)],
        check=True, stdout=subprocess.DEVNULL)
    print(text, end="")
    print(f"{report}: table.txt, uncovered.txt, html/index.html")
    return 0 if passed and good else 1


sys.exit(main())
