#!/usr/bin/env python3
"""docs/design/checkpoints.md lists every checkpoint, and every nested loop that has none.

checkpoints_test.py ROOT           compares the page with the sources; exits with 1 if they differ
checkpoints_test.py ROOT --list    prints the class of every loop of the libraries

A loop is of one of these classes, of which the page explains why each needs no other checkpoint:
  constant   the header names a literal or constant bound
  watched    the loop contains a checkpoint, gives a context to what it calls, or calls a function of
             the same file that contains a checkpoint
  step       it lies in a watched loop
  pass       it lies in no other loop, apart from constant ones
  items      it lies in another loop, and its header names the variable of that loop
  nested     any other loop in a loop. The page lists each of them with a reason
"""
import collections
import pathlib
import re
import sys

FOLDERS = ("engine/plumb", "predicates/plumb")
LOOP = re.compile(r"\b(for|while)\s*\(|\bdo\s*\{")
CHECKPOINT = re.compile(r"\b(?:checkpoint|check_limits)\(")
WATCHED = re.compile(r"[cC]ontext|\blook(?:_at_limits)?\(|\bcheckpoint|\bcheck_limits|\bwatch\w*\(|\bcount_(?:step|work)\(")
CONSTANT = re.compile(r":\s*\{|:\s*&?k[A-Z]\w*\)|[<!]=?\s*(?:\d{1,2}|k[A-Z]\w*)(?:U|\.0)?\s*(?:;|&&)|\baxis\b|: (?:side|corner)s?_?\)")
PHASE = re.compile(r"\b(?:checkpoint|check_limits)\(\s*\"([^\"]+)\"")
SCOPE = re.compile(r"(inline\s+)?namespace\b|(template\s*<.*>\s*)?(class|struct|union|enum)\b(?!.*\)\s*(const)?\s*$)|extern\b", re.S)

PLANTED = """
namespace plumb {
void f(const Map& m, Context& context) {
  for (int v = 0; v < m.size(); ++v) {
    for (int w = 0; w < m.size(); ++w) g("for (;;) {", v, w);
    for (int h : m.around(v)) g(h);
    for (int i = 0; i < 3; ++i) g(i);
  }
  for (int v = 0; v < m.size(); ++v) {
    context.checkpoint("planted", v, m.size());
    for (int w = 0; w < m.size(); ++w) g(v, w);
  }
}
}
"""
PLANTED_CLASSES = ["pass", "nested", "items", "constant", "watched", "step"]


def without_comments(text, keeps_strings=False):
    """Returns the text without comments, and without the contents of strings and characters."""
    token = re.compile(r'//[^\n]*|/\*.*?\*/|R"([^(\s]*)\((?:.*?)\)\1"|"(?:\\.|[^"\\\n])*"|(?<![\w])\'(?:\\.|[^\'\\\n])*\'', re.S)

    def replaced(match):
        found = match.group(0)
        if found.startswith("/"):
            return "\n" * found.count("\n")
        return found if keeps_strings else found[-1] * 2 + "\n" * found.count("\n")

    return token.sub(replaced, text)


def closing(text, begin):
    """Returns the position behind the bracket that closes the one at `begin`."""
    pairs, depth = {"(": ")", "{": "}", "[": "]"}, 0
    opens, closes = text[begin], pairs[text[begin]]
    for i in range(begin, len(text)):
        depth += (text[i] == opens) - (text[i] == closes)
        if depth == 0:
            return i + 1
    return len(text)


def end_of_statement(text, begin):
    """Returns the position behind the statement that begins at `begin`."""
    while begin < len(text) and text[begin].isspace():
        begin += 1
    if text[begin:begin + 1] == "{":
        return closing(text, begin)
    i = begin
    while i < len(text):
        if text[i] in "([{":
            i = closing(text, i)
            if text[i - 1] == "}" and not re.match(r"\s*[;,)]", text[i:]):
                return i
        elif text[i] == ";":
            return i + 1
        else:
            i += 1
    return i


def functions(text):
    """Yields the header and the body of each function that lies in no other function."""
    i = start = 0
    while i < len(text):
        if text[i] in ";}":
            start = i + 1
        elif text[i] == "#":
            while (i := text.find("\n", i)) > 0 and text[i - 1] == "\\":
                i += 1
            if i < 0:
                return
            start = i + 1
        elif text[i] == "{":
            header = text[start:i].strip()
            if header == "" or SCOPE.match(header):
                start = i + 1
            else:
                end = closing(text, i)
                if "(" in header and not header.endswith("="):
                    yield header, text[i:end]
                i, start = end - 1, end
        i += 1


def name_of(header):
    words = header.split("(")[0].split()
    return words[-1] if words else "?"


def variable_of(header):
    """Returns the pattern of the variables of a loop."""
    found = re.match(r"for\s*\((?:[^;:=]|::)*?\b(\w+)\s*[=:](?!:)", header) or re.match(r"for\s*\((?:[^;:=]|::)*\[([^\]]*)\]\s*:", header)
    return "|".join(name.strip() for name in found.group(1).split(",")) if found else None


def loops_of(body):
    """Returns (begin, end, header) of each loop."""
    result = []
    for found in LOOP.finditer(body):
        begin = found.start()
        if found.group(0).startswith("do"):
            result.append((begin, closing(body, found.end() - 1), "do"))
            continue
        head_end = closing(body, found.end() - 1)
        if not (found.group(1) == "while" and re.match(r"\s*;", body[head_end:])):  # The end of a do loop.
            result.append((begin, end_of_statement(body, head_end), body[begin:head_end]))
    return result


def classes_of(body, helpers):
    """Returns the class and the header of each loop."""
    calls_helper = re.compile(r"\b(?:" + "|".join(helpers) + r")\(") if helpers else None
    found = loops_of(body)
    kinds = []
    for begin, end, header in found:
        loop = body[begin:end]
        if CONSTANT.search(header):
            kinds.append("constant")
        elif WATCHED.search(loop) or (calls_helper and calls_helper.search(loop)):
            kinds.append("watched")
        else:
            kinds.append("")
    for i, (begin, end, header) in enumerate(found):
        around = [k for k, other in enumerate(found) if k != i and other[0] < begin and end <= other[1]]
        if kinds[i]:
            continue
        if any(kinds[k] == "watched" for k in around):
            kinds[i] = "step"
            continue
        variables = [variable_of(found[k][2]) for k in around if kinds[k] != "constant"]
        if not variables:
            kinds[i] = "pass"
        else:
            kinds[i] = "items" if any(v and re.search(rf"\b(?:{v})\b", header) for v in variables) else "nested"
    return [(kind, header) for kind, (_, _, header) in zip(kinds, found)]


def helpers_of(text):
    """Returns the names of functions that contain a checkpoint."""
    direct = re.findall(r"\b(\w+)\([^(){};]*\)\s*(?:const\s*)?\{[^{}]*\b(?:checkpoint|check_limits)\(", text)
    whole = [name_of(header).split("::")[-1] for header, body in functions(text) if CHECKPOINT.search(body)]
    return {name for name in direct + whole if name not in ("if", "for", "while", "switch") and name.isidentifier()}


def scan(root):
    """Returns {(file, function): [(class, header)]} and {file: phases}."""
    loops, phases = {}, {}
    for folder in FOLDERS:
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            file = path.relative_to(root).as_posix()
            source = path.read_text(encoding="utf-8")
            text = without_comments(source)
            helpers = helpers_of(text)
            for header, body in functions(text):
                classes = classes_of(body, helpers)
                if classes:
                    loops.setdefault((file, name_of(header)), []).extend(classes)
            named = PHASE.findall(without_comments(source, keeps_strings=True))
            if named:
                phases[file] = sorted(set(named))
    return loops, phases


def rows_of(page, title):
    """Returns the cells of each row of the table below a heading."""
    section = page.split(f"\n## {title}\n", 1)[1].split("\n## ", 1)[0]
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in section.splitlines() if line.startswith("|")]
    return rows[2:]


def differences(root, loops, phases):
    page = (root / "docs/design/checkpoints.md").read_text(encoding="utf-8")
    listed = {}
    for cells in rows_of(page, "Nested loops"):
        for function in re.findall(r"`([^`]+)`", cells[1]):
            listed[cells[0].strip("`"), function] = cells[2]
    nested = {key for key, found in loops.items() if any(kind == "nested" for kind, _ in found)}
    for file, function in sorted(nested - set(listed)):
        yield f"{file}: {function}: a loop in a loop without a checkpoint; give it one, or list it with a reason"
    for file, function in sorted(set(listed) - nested):
        yield f"{file}: {function} is listed, but has no such loop"
    for key, reason in sorted(listed.items()):
        if not reason:
            yield f"{key[0]}: {key[1]} is listed without a reason"
    stated = {cells[0].strip("`"): sorted(re.findall(r"`([^`]+)`", cells[1])) for cells in rows_of(page, "Checkpoints of each file")}
    for file in sorted(set(stated) | set(phases)):
        if stated.get(file, []) != phases.get(file, []):
            yield f"{file}: the page names the phases {stated.get(file, [])}, the source {phases.get(file, [])}"


def main():
    root = pathlib.Path(sys.argv[1])
    planted = [kind for _, body in functions(without_comments(PLANTED)) for kind, _ in classes_of(body, set())]
    if planted != PLANTED_CLASSES:
        print("the loops of the planted text are", planted)
        return 1
    loops, phases = scan(root)
    counts = collections.Counter(kind for found in loops.values() for kind, _ in found)
    print(", ".join(f"{counts[kind]} {kind}" for kind in ("watched", "step", "constant", "pass", "items", "nested")))
    if "--list" in sys.argv:
        for (file, function), found in sorted(loops.items()):
            for kind, header in found:
                print(f"{kind:9}{file}: {function}: {' '.join(header.split())}")
        return 0
    wrong = list(differences(root, loops, phases))
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
