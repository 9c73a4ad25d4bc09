#!/usr/bin/env python3
"""Measures what jobs take under limits, and prints the rows of the table in SECURITY.md ("A service for strangers").

    bench/limits.py [PROGRAM]

PROGRAM is plumb (default: build/release/plumb). Exits with 1 if a job does not end as it must: with 0 or 3, within the time
limit and 0.15 s of CPU time, and within 1.1 times the limit of memory, plus what the program itself holds. The peak of a job is
not less than the memory of this script (some 14 MB).
"""
import math
import os
import random
import subprocess
import sys
import tempfile

TOLERANCE_SECONDS = 0.15
EXIT_LIMIT = 3


def write_tetrahedra(path, digits, count):
    """Tetrahedra that cross each other, with fractions of so many digits above and below."""
    dice = random.Random(7)
    number = lambda first: "%d%d/1%d" % (first, dice.randrange(10 ** (digits - 2), 10 ** (digits - 1)),
                                         dice.randrange(10 ** (digits - 2), 10 ** (digits - 1)))
    with open(path, "w") as out:
        out.write("OFF\n%d %d 0\n" % (4 * count, 4 * count))
        for i in range(4 * count):
            out.write(" ".join(number(8 if i % 4 == axis else 1) for axis in (1, 2, 3)) + "\n")
        for i in range(0, 4 * count, 4):
            for face in ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3)):
                out.write("3 %d %d %d\n" % tuple(i + corner for corner in face))


def write_torus(path, around, across, centre):
    """A torus with the radii 2 and 1 and 2 * around * across triangles."""
    with open(path, "w") as out:
        out.write("OFF\n%d %d 0\n" % (around * across, 2 * around * across))
        for i in range(around):
            for j in range(across):
                u, v = 2 * math.pi * i / around, 2 * math.pi * j / across
                distance = 2 + math.cos(v)
                point = (distance * math.cos(u), distance * math.sin(u), math.sin(v))
                out.write("%r %r %r\n" % tuple(a + b for a, b in zip(point, centre)))
        for i in range(around):
            for j in range(across):
                a, b = i * across + j, (i + 1) % around * across + j
                c, d = (i + 1) % around * across + (j + 1) % across, i * across + (j + 1) % across
                out.write("3 %d %d %d\n3 %d %d %d\n" % (a, b, c, a, c, d))


def run(words):
    """Returns the exit status, the CPU seconds and the peak of resident memory in MB."""
    child = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    return os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "build/release/plumb"
    is_good = True
    _, _, base = run([program, "--version"])
    print("%s --version: %.0f MB" % (program, base))
    with tempfile.TemporaryDirectory() as folder:
        at = lambda name: os.path.join(folder, name)
        write_tetrahedra(at("bomb.off"), 2040, 10)
        write_torus(at("a.off"), 240, 120, (0, 0, 0))
        write_torus(at("b.off"), 240, 120, (1, 0.3, 0.2))
        print("| input | limit | ended | took |\n|---|---|---|---|")
        for seconds in (0.3, 1, 2):
            code, took, _ = run([program, "solid", "info", at("bomb.off"), "--limit-seconds", str(seconds)])
            is_good &= code == EXIT_LIMIT and took < seconds + TOLERANCE_SECONDS
            print("| ten tetrahedra, fractions of 2,040 over 2,040 digits | %g s | exit %d | %.2f s of CPU time |" % (seconds, code, took))
        for threads in (1, 2, 4):
            for megabytes in (20, 40, 60, 80, 120):
                code, _, peak = run([program, "solid", "union", at("a.off"), at("b.off"), "-q", "--threads", str(threads),
                                     "--limit-memory", str(megabytes), "-o", at("out.nef")])
                is_good &= code in (0, EXIT_LIMIT) and peak < base + 8 + 1.1 * megabytes
                print("| the union of two tori of 57,600 triangles, %d threads | %d MB | exit %d | %.0f MB |" % (threads, megabytes, code, peak))
    return 0 if is_good else 1


sys.exit(main())
