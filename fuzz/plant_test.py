#!/usr/bin/env python3
"""What fuzz/plant makes of a small tree: plant_test.py PLANT"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

problems = []
SOUND = "int f(int a,\n      int b) { return a < b; }\n"


def expect(name, status, broken, files):
    """The exit status, and what is planted in a tree with these files under engine/."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        (root / "fuzz").mkdir()
        shutil.copy(sys.argv[1], root / "fuzz/plant")
        bug = {"file": "x.cpp", "sound": "int b) {return a < b;}", "broken": "int b) { return a <= b; }"}
        (root / "fuzz/planted.json").write_text(json.dumps({"target": bug}))
        for file, text in files.items():
            (root / "engine" / file).parent.mkdir(parents=True, exist_ok=True)
            (root / "engine" / file).write_text(text)
        done = subprocess.run([root / "fuzz/plant", "--into", root / "out"], capture_output=True, text=True)
        found = (root / "out/target.cpp").read_text().split("\n", 1)[1] if (root / "out/target.cpp").exists() else None
        said = "no longer applies" in done.stdout
        if (done.returncode, found) != (status, broken) or said != (status == 1):
            problems.append(f"{name}: {done.returncode}, {found}: {done.stdout}{done.stderr}")


BROKEN = SOUND.replace("a < b", "a <= b")
expect("where it was", 0, BROKEN, {"io/x.cpp": SOUND})
expect("moved", 0, BROKEN, {"plumb/io/mesh/x.cpp": SOUND, "y.cpp": SOUND})
expect("reformatted", 0, "int f(int a, int b) { return a <= b; }", {"x.cpp": "int f(int a, int b)\n{\n  return a < b; }"})
expect("renamed", 0, BROKEN, {"y.cpp": SOUND, "z.cpp": "int g();"})
expect("rewritten", 1, None, {"x.cpp": "int f();", "y.cpp": SOUND})
expect("twice in its file", 1, None, {"x.cpp": SOUND + SOUND})
expect("renamed, and twice in the tree", 1, None, {"y.cpp": SOUND, "z.cpp": SOUND})

print("\n".join(problems) or "fuzz/plant plants what it should")
sys.exit(1 if problems else 0)
