#!/usr/bin/env python3
"""What shared libraries export is what headers declare: exported_symbols.py NM CLANG LIST -I... [-D...] LIBRARY...

Clang lists the declarations of all headers of LIST (public-headers.txt), with the names that the linker has for them. The
libraries export each that is not inline, of each template that is defined in no header an instance, and besides only what
compilers make of headers: inline functions, instances of templates, tables and type information of classes."""
import json
import re
import subprocess
import sys

nm, clang, header_list, *rest = sys.argv[1:]
definitions = [word for word in rest if word.startswith(("-D", "-I"))]
libraries = [word for word in rest if not word.startswith(("-D", "-I"))]
FUNCTIONS = ("FunctionDecl", "CXXMethodDecl", "CXXConstructorDecl", "CXXDestructorDecl", "CXXConversionDecl")
TEMPLATES = ("FunctionTemplateDecl", "ClassTemplateDecl", "ClassTemplatePartialSpecializationDecl")


def output_of(*command, text=None):
    return subprocess.run(command, input=text, text=True, stdout=subprocess.PIPE, check=True).stdout


def demangled(symbols):
    """Without the variants of constructors and destructors, which read the same."""
    return dict(zip(symbols, output_of("c++filt", text="\n".join(symbols)).split("\n")))


def syntax_tree():
    headers = [line for line in open(header_list, encoding="utf-8").read().split("\n") if line.startswith("plumb/")]
    headers.remove("plumb/predicates/arithmetic/fixed_portable.h")  # of the two, fixed.h chooses one
    text = output_of(clang, "-std=c++20", "-fsyntax-only", *definitions, "-Xclang", "-ast-dump=json",
                     "-Xclang", "-ast-dump-filter=plumb::", "-x", "c++", "-", text="".join(f'#include "{h}"\n' for h in headers))
    decoder, at = json.JSONDecoder(), 0
    while at < len(text):
        node, at = decoder.raw_decode(text, at)
        yield node
        at = re.compile(r"\s*").match(text, at).end()


def is_defined_here(node):
    """Inline, deleted, or a constant: nothing for a library to define."""
    if node["kind"] == "VarDecl":
        return node.get("storageClass") != "extern"
    return (any(node.get(key) for key in ("inline", "constexpr", "isImplicit", "explicitlyDeleted", "explicitlyDefaulted", "pure"))
            or any(child.get("kind") == "CompoundStmt" for child in node.get("inner", [])))


declared, inline, templates, classes = set(), set(), set(), set()
defined_templates = set()  # in headers


def collect(node):
    kind = node.get("kind")
    if kind in TEMPLATES:
        templates.add(node["name"])
        if kind != "FunctionTemplateDecl" or any(is_defined_here(child) for child in node["inner"] if child["kind"] in FUNCTIONS):
            defined_templates.add(node["name"])
        return
    if kind == "CXXRecordDecl" and node.get("completeDefinition"):
        classes.add(node["name"] if "name" in node else "")
    if kind in (*FUNCTIONS, "VarDecl") and "mangledName" in node:
        declared.add(node["mangledName"])
        if is_defined_here(node):
            inline.add(node["mangledName"])
    if kind not in FUNCTIONS:
        for child in node.get("inner", []):
            collect(child)


def without_brackets(text):
    for inner in (r"\([^()]*\)", r"<[^<>]*>"):
        while text != (text := re.sub(inner, "", text)):
            pass
    return text


def parts_of(name):
    """Of a function, {"plumb", class, its own name}."""
    words = without_brackets(name.replace("[abi:cxx11]", "")).removesuffix(" const").split(" ")
    return set(words[-1].split("::"))


def comes_of_headers(name):
    """Is it an instance of a template, or the table or type information of a class?"""
    of_class = re.match(r"(?:vtable|typeinfo|typeinfo name) for (?:\w+::)+(\w+)$", name)
    if of_class:
        return of_class[1] in classes
    return not templates.isdisjoint(parts_of(name))


for tree in syntax_tree():
    collect(tree)
exported = set()
for library in libraries:
    symbols = [line.split()[-1] for line in output_of(nm, "--dynamic", "--defined-only", library).splitlines()]
    exported.update(symbols)
    print(f"{library}: {len(symbols)} symbols")
names = demangled(sorted(exported | declared))
shown = {names[symbol] for symbol in exported}
missing = {names[symbol] for symbol in declared - inline} - shown
instantiated = set().union(*(parts_of(name) for name in shown if "<" in name))
missing |= {f"an instance of {name}()" for name in templates - defined_templates - instantiated}
foreign = {name for name in shown - {names[symbol] for symbol in declared} if not comes_of_headers(name)}
print(f"{len(declared - inline)} declared by headers, {len(shown)} exported")
for name in sorted(missing):
    print(f"not exported: {name}")
for name in sorted(foreign):
    print(f"not declared by a header: {name}")
sys.exit(1 if missing or foreign or not exported else 0)
