#!/usr/bin/env python3
"""Documents and recipes: documents_test.py ROOT

Every relative link and anchor in README.md, CHANGELOG.md and docs/*.md leads somewhere; JSON files parse; Python files
compile; the version is the same wherever it is written."""
import json
import pathlib
import re
import sys

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


pages = [root / "README.md", root / "CHANGELOG.md", *sorted(root.glob("docs/*.md"))]
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
for file in root.glob("packaging/**/*.py"):
    try:
        compile(file.read_text(), str(file), "exec")
    except SyntaxError as error:
        problems.append(f"{file}: {error}")

header = (root / "engine/base/version.h").read_text()
version = ".".join(re.findall(r"#define PLUMB_VERSION_(?:MAJOR|MINOR|PATCH) (\d+)", header))
if f'"{version}"' not in header:
    problems.append(f"engine/base/version.h: PLUMB_VERSION_STRING is not {version}")
if recipes.get("vcpkg.json", {}).get("version") != version:
    problems.append(f"packaging/vcpkg/vcpkg.json: the version is not {version}")

for problem in problems:
    print(problem)
sys.exit(1 if problems else 0)
