"""Mutants of a C++ source, made on its text: no compiler is asked.

The text has to be formatted as this project's is (clang-format): binary operators stand between blanks, brackets of
templates do not. Comments, strings, preprocessor lines, static_assert, PLUMB_CHECK, declarations of names and code
that only an option of the build compiles (PLUMB_PORTABLE, PLUMB_COUNT_RUNGS) have no mutants."""
import dataclasses
import hashlib
import os
import re


@dataclasses.dataclass
class Mutant:
    file: str
    line: int  # from 1
    old: str  # the line as it is
    new: str  # the line as it becomes
    rule: str
    key: str = ""  # the same as long as the line is, wherever it and its file move

    def __str__(self):
        return f"{self.file}:{self.line}: {self.rule}: {self.old.strip()}  =>  {self.new.strip()}"


def operator(text):
    """`text` between blanks, or at the end of a line."""
    return r"(?<=\s)" + re.escape(text) + r"(?=\s|$)"


# Rule, what is looked for, what it becomes (one mutant each).
TABLE = [
    *[("comparison", operator(old), new) for old, new in {
        "<": ["<=", ">="], "<=": ["<", ">"], ">": [">=", "<="], ">=": [">", "<"], "==": ["!="], "!=": ["=="]}.items()],
    *[("arithmetic", operator(old), [new]) for old, new in {
        "+": "-", "-": "+", "*": "+", "/": "*", "%": "/", "+=": "-=", "-=": "+=", "*=": "+=", "<<": ">>", ">>": "<<",
        "&": "|", "|": "&", "^": "|", "|=": "&=", "&=": "|="}.items()],
    ("arithmetic", r"\+\+(?=\w)|(?<=[\w\]])\+\+", ["--"]),
    ("arithmetic", r"(?<=[(\[{,=?:] )-(?=[a-z(])|(?<=[(\[{])-(?=[a-z(])|(?<=return )-(?=[a-z(])", [""]),
    ("logic", operator("&&"), ["||"]),
    ("logic", operator("||"), ["&&"]),
    ("logic", r"!(?=[A-Za-z_(])", [""]),
    ("constant", r"\btrue\b", ["false"]),
    ("constant", r"\bfalse\b", ["true"]),
    ("sign", r"\bSign::Positive\b", ["Sign::Negative"]),
    ("sign", r"\bSign::Negative\b", ["Sign::Positive"]),
    ("sign", r"\bSign::Zero\b", ["Sign::Positive", "Sign::Negative"]),
    ("minmax", r"\bstd::min\b", ["std::max"]),
    ("minmax", r"\bstd::max\b", ["std::min"]),
    ("minmax", r"\.front\(\)", [".back()"]),
    ("minmax", r"\.back\(\)", [".front()"]),
]
INTEGER = re.compile(r"(?<![\w.<'])(?<!p-)\d+(?=U?L?L?\b)(?!\w*[.>'])")
POWER = re.compile(r"(?<=\b0x1p)-?\d+")  # a bound or a gate: 2^8 is beyond the slack that proofs leave
CONDITION = re.compile(r"\b(?:if|while) \(")
STATEMENT = re.compile(r"\s+(?:[\w.\[\]>()*:-]+(?: [-+*/|&^]| <<| >>)?=? ?=? .*|\+\+.*|[\w.:>\[\]-]+\(.*\));$")
NO_STATEMENT = re.compile(r"\s+(?:return|throw|using|typedef|const|constexpr|auto|static|friend|else|for|case|explicit)\b"
                          r"|\s+[\w:<>,]+[&*]? [\w]+(?:\[.*\])?(?: =.*|\{.*|\(.*)?;$")
DECLARATION = re.compile(r"\s*(?:using|typedef|template|enum|friend class|namespace|class|struct)\b|.*= (?:default|delete|0);$")


def blanked(match):
    return re.sub(r"[^\n]", " ", match.group())


def without_calls(text, name):
    """Blanks for each `name(...)`, whose brackets may span lines."""
    for match in re.finditer(r"\b" + name + r"\(", text):
        end = matching_bracket(text, match.end() - 1)
        text = text[:match.start()] + re.sub(r"[^\n]", " ", text[match.start():end]) + text[end:]
    return text


def matching_bracket(text, begin):
    """The place behind the bracket that closes the one at `begin`; 0 when there is none."""
    depth = 0
    for i in range(begin, len(text)):
        depth += (text[i] == "(") - (text[i] == ")")
        if depth == 0:
            return i + 1
    return 0


def without_inactive(lines):
    """Blank lines for preprocessor lines and for what the ordinary build leaves out."""
    active, result, continued = [], [], False
    for line in lines:
        is_directive = continued or line.lstrip().startswith("#")
        continued = is_directive and line.endswith("\\")
        word = re.match(r"\s*#\s*(\w+)\s*(.*)", line)
        if word and word[1] in ("if", "ifdef", "ifndef"):
            is_option = re.search(r"\bPLUMB_(PORTABLE|COUNT_RUNGS)\b", word[2])
            negated = word[1] == "ifndef" or "!" in word[2]
            active.append(not is_option or negated)
        elif word and word[1] in ("else", "elif"):
            active[-1] = not active[-1]
        elif word and word[1] == "endif":
            active.pop()
        result.append("" if is_directive or not all(active) else line)
    return result


def code_of(text):
    """The lines of `text` with blanks for everything that has no mutants."""
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'', blanked, text, flags=re.S)
    for name in ("static_assert", "PLUMB_CHECK"):
        text = without_calls(text, name)
    return without_inactive(text.split("\n"))


def changed(line, begin, end, new):
    return line[:begin] + new + line[end:]


def changes_of(line, code, begins_statement):
    """(rule, line as it becomes) for every mutant of one line; `code` is the line without comments and strings."""
    for rule, pattern, replacements in TABLE:
        for match in re.finditer(pattern, code):
            for new in replacements:
                yield rule, changed(line, *match.span(), new)
    for match in INTEGER.finditer(code):
        value = int(match.group())
        for new in [1] if value == 0 else [value - 1, value + 1]:
            yield "constant", changed(line, *match.span(), str(new))
    for match in POWER.finditer(code):
        for by in (-8, 8):
            yield "power", changed(line, *match.span(), str(int(match.group()) + by))
    for match in CONDITION.finditer(code):
        end = matching_bracket(code, match.end() - 1)
        if end and "constexpr" not in code[:match.start()]:
            yield "condition", changed(line, match.end(), end - 1, f"!({line[match.end():end - 1]})")
    if begins_statement and STATEMENT.fullmatch(code) and not NO_STATEMENT.match(code):
        yield "statement", re.match(r"\s*", line).group() + ";"
    for match in re.finditer(r"\b(?:continue|break);$", code):
        yield "statement", changed(line, *match.span(), ";")


def mutants_of(file, text):
    """All mutants of a source, in the order of its lines."""
    lines, found, seen = text.split("\n"), [], {}
    codes = code_of(text)
    before = ""  # the last line of code: a statement begins after a complete one
    for number, (line, code) in enumerate(zip(lines, codes), 1):
        code = code.rstrip()
        if not code.strip():
            continue
        begins = before.endswith((";", "{", "}", ":")) or bool(re.search(r"\b(?:if|for|while) \(.*\)$", before))
        before = code
        if DECLARATION.match(code):
            continue
        for rule, new in changes_of(line, code, begins):
            times = seen[line, new] = seen.get((line, new), 0) + 1
            key = hashlib.sha1(f"{os.path.basename(file)}|{line}|{new}|{times}".encode()).hexdigest()[:16]
            found.append(Mutant(file, number, line, new, rule, key))
    return found


def sample(mutants, count, seed):
    """`count` of the mutants, the same ones as long as their lines are, in no order: a part of them is a sample, too."""
    def rank(mutant):
        return hashlib.sha1(f"{seed}|{mutant.key}".encode()).digest()
    return sorted(mutants, key=rank)[:count]
