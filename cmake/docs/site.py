#!/usr/bin/env python3
"""The site of docs/: site.py PAGES API SITE MKDOCS, in the root of the tree.

PAGES is filled with docs/, with what its pages link to elsewhere in the tree, and with API (the HTML that Doxygen made)
as api/; MKDOCS makes SITE of it, where warnings are errors. Then every link of its own pages is followed in SITE."""
import html.parser
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import urllib.parse

pages, api, site = map(pathlib.Path, sys.argv[1:4])
docs = pathlib.Path("docs")
LINK = re.compile(r"(?<!`)(\]\()([^)\s#]+)(#[^)\s]*)?(\))")

# Nothing is wider than a telephone but tables, which scroll.
NARROW = "table { display: block; overflow-x: auto } img { max-width: 100% } code { overflow-wrap: anywhere }\n"


def listing(folder, title):
    """A page that links to the files of a folder."""
    names = sorted(p.name for p in folder.iterdir() if p.is_file() and p.name != "CMakeLists.txt")
    (folder / "index.md").write_text(f"# {title}\n\n" + "".join(f"- [{n}]({n})\n" for n in names))


def place_of(file):
    """Where a file of the tree lies in PAGES."""
    return file.relative_to(docs) if file.is_relative_to(docs) else pathlib.Path("tree") / file


def copy(file):
    """A file or folder that lies outside docs/, in PAGES; answers the page to link to."""
    place = place_of(file)
    to = pages / place
    if file.is_dir():
        shutil.copytree(file, to, dirs_exist_ok=True)
        for folder in [to, *(p for p in to.rglob("*") if p.is_dir())]:
            if not (folder / "index.md").exists():
                listing(folder, str(folder.relative_to(pages)))
        if not any(p.is_file() for p in file.iterdir()):
            first = sorted(p for p in to.iterdir() if p.is_dir())
            (to / "index.md").write_text(f"# {place}\n\n" + "".join(f"- [{p.name}]({p.name}/index.md)\n" for p in first))
        return place / "index.md"
    if not to.exists():
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(file, to)
        if file.suffix == ".md":
            link_page(file)
    return place


def link_page(page):
    """Lets the links of a page lead to where the files lie in PAGES."""

    def link(match):
        if re.match(r"[a-z]+:", match[2]):
            return match[0]
        file = pathlib.Path(os.path.normpath(page.parent / match[2]))
        to = os.path.relpath(copy(file), place_of(page).parent)
        return match[1] + to + (match[3] or "") + match[4]

    (pages / place_of(page)).write_text(LINK.sub(link, page.read_text()))


def stage():
    shutil.copytree(docs, pages)
    shutil.copytree(api, pages / "api")
    for page in sorted(docs.rglob("*.md")):
        link_page(page)
    (pages / "narrow.css").write_text(NARROW)
    index = (pages / "index.md").read_text()
    (pages / "index.md").write_text(index + "\n[The interface](api/index.html), class by class.\n")


def build():
    settings = {
        "site_name": "plumb",
        "docs_dir": str(pages.resolve()),
        "site_dir": str(site.resolve()),
        "use_directory_urls": False,
        # The theme's own highlighter comes from another server.
        "theme": {"name": "mkdocs", "highlightjs": False},
        "extra_css": ["narrow.css"],
        "plugins": ["search"],
        "markdown_extensions": ["tables", "fenced_code", "toc"],
        "nav": navigation(),
    }
    config = pages.parent / "mkdocs.yml"
    config.write_text(json.dumps(settings))  # JSON is YAML
    subprocess.run([sys.argv[4], "build", "--strict", "--config-file", str(config)], check=True)


def navigation():
    """As docs/index.md orders its pages."""
    groups, title = [], None
    for line in (docs / "index.md").read_text().split("\n"):
        if head := re.match(r"\| (\w+) \| \|", line):
            title = head[1].capitalize()
            groups.append({title: []})
        elif title:
            groups[-1][title] += [{n: p} for n, p in re.findall(r"\[([^\]]+)\]\(([\w/-]+\.md)\)", line)]
    return [{"plumb": "index.md"}, *groups, {"Interface": "api/index.html"}]


class Links(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.to, self.anchors = [], set()

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.to.append(value)
            elif name in ("id", "name") and value:
                self.anchors.add(value)


def read_links(file, known={}):
    if file not in known:
        known[file] = Links()
        known[file].feed(file.read_text(errors="replace"))
    return known[file]


def broken_links():
    for file in sorted(site.rglob("*.html")):
        if file.name == "404.html" or file.is_relative_to(site / "api") and file.name != "index.html":
            continue  # the first names paths from a server's root; Doxygen checks its own
        for link in read_links(file).to:
            parts = urllib.parse.urlsplit(link)
            if parts.scheme in ("data", "mailto", "javascript"):
                continue
            if parts.scheme or parts.netloc:
                if not file.is_relative_to(site / "tree") and re.search(r"\.(js|css|woff2?)$", parts.path):
                    yield f"{file}: {link} comes from another server"
                continue
            to = (file.parent / urllib.parse.unquote(parts.path)) if parts.path else file
            if not to.exists():
                yield f"{file}: no {link}"
            elif parts.fragment and to.suffix == ".html" and parts.fragment not in read_links(to).anchors:
                yield f"{file}: no #{parts.fragment} in {to.name}"


stage()
build()
broken = list(broken_links())
print(*broken, sep="\n", end="\n" if broken else "")
sys.exit(1 if broken else 0)
