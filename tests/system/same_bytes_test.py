#!/usr/bin/env python3
"""The program writes the same bytes on every processor and system: same_bytes_test.py PROGRAM [--write]

same_bytes.txt beside this file lists commands, each with the first half of the SHA-256 of what it writes. Little- and big-endian
processors, signed and unsigned char, long of 32 and of 64 bits, libraries with and without fused multiplication have to agree with
it (docs/platforms.md). With --write, the digests are replaced by those of PROGRAM; that is right only where a format or the
canonical form of a set changes on purpose.
"""
import hashlib
import pathlib
import subprocess
import sys
import tempfile

LIST = pathlib.Path(__file__).with_name("same_bytes.txt")
DIGITS = 32


def run(program, words, folder):
    """The digest of what `program words` writes; OUT.ext among the words is a file in folder, otherwise it is standard output."""
    out = None
    arguments = []
    for word in words:
        if word.startswith("OUT."):
            out = folder / word
            word = str(out)
        arguments.append(word)
    done = subprocess.run([program, *arguments], stdin=subprocess.DEVNULL, capture_output=True, check=False)
    if done.returncode not in (0, 1):
        raise SystemExit(f"{' '.join(words)}: exit {done.returncode}\n{done.stderr.decode(errors='replace')}")
    written = done.stdout if out is None else out.read_bytes() if out.exists() else b""
    if not written:
        raise SystemExit(f"{' '.join(words)}: nothing was written\n{done.stderr.decode(errors='replace')}")
    return hashlib.sha256(written).hexdigest()[:DIGITS]


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    writes = "--write" in sys.argv[2:]
    compared = 0
    lines = []
    differences = 0
    with tempfile.TemporaryDirectory() as scratch:
        for number, line in enumerate(LIST.read_text(encoding="utf-8").splitlines()):
            if not line.strip() or line.startswith("#"):
                lines.append(line)
                continue
            compared += 1
            expected, words = line.split(maxsplit=1)
            folder = pathlib.Path(scratch) / str(number)
            folder.mkdir()
            found = run(program, words.split(), folder)
            lines.append(f"{found} {words}")
            if found != expected:
                differences += 1
                if not writes:
                    print(f"{LIST.name}:{number + 1}: {words}: {found} instead of {expected}")
    if writes:
        LIST.write_text("\n".join(lines) + "\n", encoding="utf-8")
        return 0
    print(f"{compared} commands, {differences} differences")
    return 1 if differences else 0


if __name__ == "__main__":
    sys.exit(main())
