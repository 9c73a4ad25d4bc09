#!/usr/bin/env python3
"""What Doxygen reads of a header: doxygen_filter.py HEADER

The comment that a header opens with is its page. A comment `///` speaks for the overloads right below it, too, and for
each name of `T a, b;`. What is defaulted or deleted goes without saying, and so do specialisations in namespace std.
Lines keep their numbers."""
import re
import sys

UNSAID = re.compile(r"\)( const)?( noexcept)? = (default|delete);$")
SEVERAL = re.compile(r"^( *)([\w:<>]+) ((?:\w+(?: = [^,;]+)?, )+\w+(?: = [^,;]+)?);(?: *///< *(.*))?$")


def with_page(lines):
    end = 0
    while lines[end].startswith("//"):
        end += 1
    if end == 0:
        return lines
    text = [line[2:] for line in lines[:end]]
    return ["/** @file", *text[:-1], f"{text[-1]} */ {lines[end]}", *lines[end + 1:]]


def one_by_one(line, comment):
    """`T a, b;` as `T a; T b;`, each with the comment."""
    match = SEVERAL.match(line)
    if not match:
        return line
    indent, kind, names, own = match.groups()
    said = own or comment
    return indent + " ".join(f"/** {said} */ {kind} {name};" if said else f"{kind} {name};" for name in names.split(", "))


def name_of(line):
    match = re.search(r"(operator\W+|\w+)\(", line)
    return match and match[1]


def spread(lines):
    out, comment, name = [], "", None
    is_open = False  # does the comment still wait for its declaration?
    for line in lines:
        text = line.strip()
        if UNSAID.search(line):
            line = ""
        elif text.startswith("///") and not text.startswith("///<"):
            comment = (comment if is_open else "") + text[3:]
            is_open, name = True, None
        elif not text or text.startswith(("//", "#")):
            is_open, comment, name = False, "", None
        elif is_open:
            line = one_by_one(line, comment.strip())
            is_open, name = False, name_of(line)
        else:
            if name and name_of(line) == name and "///<" not in line:
                line = f"/** {comment.strip()} */ {line}"
            line = one_by_one(line, "")
        out.append(line)
    return out


def without_std(text):
    return re.sub(r"^template <[^\n]*\nstruct std::.*?^};", lambda m: "\n" * m[0].count("\n"), text, flags=re.M | re.S)


print("\n".join(spread(with_page(without_std(open(sys.argv[1], encoding="utf-8").read()).split("\n")))), end="")
