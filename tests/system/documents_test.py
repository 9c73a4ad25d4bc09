#!/usr/bin/env python3
"""Documents, recipes and the list of headers: documents_test.py ROOT

Every relative link and anchor in README.md, CHANGELOG.md and docs/*.md leads somewhere; JSON files parse; the Conan
recipe runs as far as it does without Conan; the figures that documents quote are the recorded ones (bench/figures.json, which
stays small) and no generated page is kept; the version is the same wherever it is written; what installed headers
include is installed, and the macros they leave behind are plumb's."""
import json
import pathlib
import re
import subprocess
import sys
import types

root = pathlib.Path(sys.argv[1])
problems = []


def strip_blocks(text):
    """Without fenced and indented blocks."""
    lines, fenced = [], False
    for line in text.split("\n"):
        if line.startswith("```"):
            fenced = not fenced
        elif not fenced and not line.startswith("    "):
            lines.append(line)
    return "\n".join(lines)


def anchors(text):
    """As GitHub makes them from headings."""
    found = set()
    for title in re.findall(r"^#+ +(.*)$", strip_blocks(text), flags=re.M):
        name = re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-")
        found.add(name)
    return found


def check_links(page):
    text = re.sub(r"`[^`\n]*`", "", strip_blocks(page.read_text()))
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", target):
            continue
        path, _, anchor = target.partition("#")
        file = (page.parent / path).resolve() if path else page
        if not file.exists():
            problems.append(f"{page}: no {path}")
        elif anchor and anchor not in anchors(file.read_text()):
            problems.append(f"{page}: no #{anchor} in {file.name}")


pages = [*(root / name for name in ("README.md", "CHANGELOG.md", "CONTRIBUTING.md", "HACKING.md", "SECURITY.md")), *sorted(root.glob("docs/*.md"))]
for page in pages:
    check_links(page)

index = (root / "docs/index.md").read_text()
for page in sorted(root.glob("docs/*.md")):
    if page.name != "index.md" and f"({page.name})" not in index:
        problems.append(f"docs/index.md: lacks {page.name}")

recipes = {}
for file in [*root.glob("docs/schema/*.json"), *root.glob("packaging/**/*.json")]:
    try:
        recipes[file.name] = json.loads(file.read_text())
    except ValueError as error:
        problems.append(f"{file}: {error}")


def conan_recipe(path):
    """The class of a recipe, with Conan's modules and their functions replaced by nothing."""

    def nothing(*arguments, **named):
        return None

    def load(recipe, file):
        return pathlib.Path(file).read_text()

    def copy(recipe, pattern, folder, to):
        if not any(pathlib.Path(folder).glob(pattern)):
            problems.append(f"{path}: nothing matches {pattern}")

    offered = {"conan": {"ConanFile": object}, "conan.errors": {"ConanInvalidConfiguration": Exception},
               "conan.tools": {}, "conan.tools.build": {"check_min_cppstd": nothing},
               "conan.tools.cmake": dict.fromkeys(("CMake", "CMakeDeps", "CMakeToolchain", "cmake_layout"), nothing),
               "conan.tools.files": {"copy": copy, "load": load}}
    for name, contents in offered.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(contents)
    scope = {}
    exec(compile(path.read_text(), str(path), "exec"), scope)
    return scope["PlumbConan"]


recipe = conan_recipe(root / "packaging/conan/conanfile.py")()
recipe.recipe_folder, recipe.export_sources_folder = str(root / "packaging/conan"), ""
recipe.set_version()
recipe.export_sources()


# The declarations of a header, all of them, as a shared library exports them.
VISIBLE = re.compile(r"#pragma GCC visibility push\(default\)\nnamespace plumb.*\n}  // namespace plumb[:\w]*\n"
                     r"#pragma GCC visibility pop\n(?!.*^namespace plumb)", flags=re.M | re.S)


def check_visibility(listed):
    for file in [*root.glob("predicates/plumb/**/*.*"), *root.glob("engine/plumb/**/*.*")]:
        text = file.read_text()
        name = str(file.relative_to(root).with_suffix(".h")).split("/", 1)[1]
        is_exported, is_pushed = name in listed and "namespace plumb" in text, "visibility push" in text
        if is_pushed > is_exported or (file.suffix == ".h" and (is_exported > is_pushed or
                                                                (is_pushed and not VISIBLE.search(text)))):
            problems.append(f"{file}: visible is what public-headers.txt lists, all of it, and nothing else")


def check_headers():
    lists = re.split(r"^\[(\w+)\]$", (root / "cmake/public-headers.txt").read_text(), flags=re.M)
    parts = {part: names.split() for part, names in zip(lists[1::2], lists[2::2])}
    listed = sum(parts.values(), [])
    check_visibility(listed)
    for name in sorted(listed):
        file = root / ("predicates" if name.startswith("plumb/predicates/") else "engine") / name
        if listed.count(name) > 1 or not file.exists():
            problems.append(f"cmake/public-headers.txt: {name} is not there, or listed twice")
            continue
        text = file.read_text()
        for included in re.findall(r'#include "(plumb/[^"]+)"', text):
            if included not in listed or (included in parts["between"] and name not in parts["between"]):
                problems.append(f"{file}: includes {included}, which is not installed")
        for macro in set(re.findall(r"^ *# *define (\w+)", text, flags=re.M)):
            if not macro.startswith("PLUMB_"):
                problems.append(f"{file}: defines {macro}")
        if re.search(r"^ *using namespace", text, flags=re.M):
            problems.append(f"{file}: using namespace")


check_headers()

checked = subprocess.run([sys.executable, root / "bench/figures", "--check"], cwd=root, capture_output=True, text=True)
if checked.returncode != 0:
    problems.append(f"{checked.stdout}{checked.stderr}(bench/figures puts the recorded figures into the documents)")
if len((root / "bench/figures.json").read_text().splitlines()) > 2000:
    problems.append("bench/figures.json: more than 2,000 lines")
for page in root.glob("docs/**/*.html"):
    problems.append(f"{page}: a generated page does not belong here (bench/run -o, target docs)")

header = (root / "engine/plumb/base/version.h").read_text()
version = ".".join(re.findall(r"#define PLUMB_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))
if f'"{version}"' not in header:
    problems.append(f"engine/plumb/base/version.h: PLUMB_VERSION_STRING is not {version}")
if recipes.get("vcpkg.json", {}).get("version") != version:
    problems.append(f"packaging/vcpkg/vcpkg.json: the version is not {version}")
if recipe.version != version:
    problems.append(f"packaging/conan/conanfile.py: the version is {recipe.version}, not {version}")

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
