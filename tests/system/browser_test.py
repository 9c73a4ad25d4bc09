#!/usr/bin/env python3
"""What `plumb demo` and `plumb view` leave behind, in headless Chromium: browser_test.py PROGRAM [SCREENSHOTS]

Pages make no errors and ask the network for nothing; on a desktop and on a phone nothing is wider than the window;
pictures are there; canvases are not blank; dragging, wheel, keys and double click do what the help under the canvas
says. Without Chromium: exit 77, skipped. With SCREENSHOTS, a folder, pages are pictured there for people to look at."""
import pathlib
import subprocess
import sys
import tempfile

from browser import Browser, find_browser

program = str(pathlib.Path(sys.argv[1]).resolve())
shots = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else None
DESKTOP, PHONE = (1280, 900), (390, 844)
problems = []

# The canvas in a page or a frame of it, drawn now: how many colours, and a number that tells pictures apart.
LOOK = """(view => {
  view.draw();  // what is seen can be read until the browser shows it
  const canvas = view.document.querySelector('canvas'), copy = document.createElement('canvas');
  [copy.width, copy.height] = [canvas.width, canvas.height];
  const pen = copy.getContext('2d');
  pen.drawImage(canvas, 0, 0);
  const bytes = new Uint32Array(pen.getImageData(0, 0, copy.width, copy.height).data.buffer);
  let sum = 0, painted = 0;
  for (const b of bytes) { sum = (Math.imul(sum, 31) + b) | 0; painted += b !== 0xffffffff; }
  return {colours: new Set(bytes).size, painted: painted / bytes.length, sum};
})"""
PLACE = """(view => {
  const frame = view.frameElement, r = view.document.querySelector('canvas').getBoundingClientRect();
  const f = frame ? frame.getBoundingClientRect() : {left: 0, top: 0};
  return [f.left + r.left + r.width / 2, f.top + r.top + r.height / 2, r.width, r.height];
})"""


def expect(condition, what):
    if not condition:
        problems.append(what)


def check_layout(browser, name):
    wide = browser.value("document.documentElement.scrollWidth - document.documentElement.clientWidth")
    expect(wide <= 0, f"{name}: {wide} pixels wider than the window")
    missing = browser.value("""Promise.all([...document.images].map(image => image.decode().catch(() => 0)))
        .then(() => [...document.images].filter(i => !i.naturalWidth).map(i => i.alt))""")
    expect(missing == [], f"{name}: no picture for {missing}")


def is_blank(seen):
    return seen["colours"] < 4 or seen["painted"] < .01


def check_controls(browser, name, view):
    """Each control changes the picture, and the double click brings the first one back."""
    x, y, width, height = browser.value(f"{PLACE}({view})")
    look = lambda: browser.value(f"{LOOK}({view})")
    reset = lambda: browser.click(x, y, times=2)
    first = look()
    expect(not is_blank(first), f"{name}: the canvas is blank: {first}")
    controls = {
        "dragging": lambda: browser.drag((x, y), (x + width / 6, y + height / 8)),
        "the wheel": lambda: browser.mouse("mouseWheel", x, y, deltaX=0, deltaY=-300),
        "an arrow key": lambda: browser.key("ArrowLeft", 37),
        "the key +": lambda: browser.key("+", 187, "+"),
    }
    for control, use in controls.items():
        use()
        changed = look()
        expect(changed["sum"] != first["sum"], f"{name}: {control} does nothing")
        expect(not is_blank(changed), f"{name}: the canvas is blank after {control}")
        reset()
        expect(look()["sum"] == first["sum"], f"{name}: a double click does not bring the first view back")


def check_layers(browser, name):
    """Every layer that can be shown or not makes a difference."""
    for i in range(browser.value("document.querySelectorAll('#layers input').length")):
        before = browser.value(f"{LOOK}(window)")
        browser.value(f"document.querySelectorAll('#layers input')[{i}].click()")
        if before["sum"] == browser.value(f"{LOOK}(window)")["sum"]:
            yield i
        browser.value(f"document.querySelectorAll('#layers input')[{i}].click()")


def open_page(browser, page, size):
    """Its name in messages."""
    name = f"{page.name} at {size[0]}"
    browser.open(page.as_uri(), *size)
    check_layout(browser, name)
    if shots:
        browser.screenshot(shots / f"{page.stem}-{size[0]}.png")
    return name


def check_index(browser, page, size):
    name = open_page(browser, page, size)
    buttons = browser.value("document.querySelectorAll('figure button').length")
    expect(buttons > 3, f"{name}: {buttons} pictures can be turned")
    for i in range(buttons):
        title = browser.value("""new Promise(done => {
          const button = document.querySelector('figure button'), title = button.title;
          button.scrollIntoView({block: 'center'});
          button.click();
          const frame = [...document.querySelectorAll('iframe')].find(f => f.title === title);
          frame.addEventListener('load', () => { frame.scrollIntoView({block: 'center'}); done(title); });
        })""")
        view = f"[...document.querySelectorAll('iframe')].find(f => f.title === {title!r}).contentWindow"
        if i in (0, buttons - 1):
            check_controls(browser, f"{name}, {title}", view)
        else:
            seen = browser.value(f"{LOOK}({view})")
            expect(not is_blank(seen), f"{name}, {title}: the canvas is blank: {seen}")
        if shots and i in (0, buttons - 1):
            browser.screenshot(shots / f"index-{size[0]}-{i}.png")
        if i > 0:  # no more than a browser holds at a time
            browser.value("document.querySelector('iframe').remove()")
    check_layout(browser, name)


def check_view(browser, page, size):
    name = open_page(browser, page, size)
    check_controls(browser, name, "window")
    idle = list(check_layers(browser, name))
    layers = browser.value("document.querySelectorAll('#layers input').length")
    expect(len(idle) < max(layers, 1), f"{name}: no layer makes a difference")


def check_plane(browser, page, size):
    """A picture with lines and text, in SVG: it is moved and scaled."""
    name = open_page(browser, page, size)
    look = lambda: browser.value(
        "[...document.querySelectorAll('*')].map(e => e.style && e.style.transform).find(t => t)")
    first, middle = look(), (size[0] / 2, size[1] / 2)
    for control, use in {
        "dragging": lambda: browser.drag(middle, (middle[0] + 50, middle[1] + 30)),
        "the wheel": lambda: browser.mouse("mouseWheel", *middle, deltaX=0, deltaY=-300),
    }.items():
        use()
        expect(look() != first, f"{name}: {control} does nothing")
        browser.click(*middle, times=2)
        expect(look() == first, f"{name}: a double click does not bring the first view back")


chromium = find_browser()
if chromium is None:
    print("skipped: there is no Chromium")
    sys.exit(77)
with tempfile.TemporaryDirectory() as scratch:
    demo = pathlib.Path(scratch) / "demo"
    subprocess.run([program, "demo", "-q", "-o", str(demo)], check=True, stdout=subprocess.DEVNULL)
    plane = pathlib.Path(scratch) / "star.html"
    subprocess.run([program, "view", "corpus/plane/star.wkt", "-o", str(plane)], check=True)
    with Browser(chromium, seconds=240) as browser:
        for size in (DESKTOP, PHONE):
            check_index(browser, demo / "index.html", size)
            for page in (demo / "torus-labels.html", demo / "comb-pieces.html"):
                check_view(browser, page, size)
            check_plane(browser, plane, size)
        problems += browser.complaints
print(*problems or ["no complaints"], sep="\n")
sys.exit(1 if problems else 0)
