#!/usr/bin/env python3
"""What Windows does otherwise than POSIX, asked of the program for Windows: windows_test.py PROGRAM

PROGRAM is build/windows/plumb-emulated, which runs it by Wine, or plumb.exe. Names of files with other letters than ASCII and with
backslashes; standard input and output in bytes; an output that exists already; an exit status and a message after an error.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM = ""
CORPUS = pathlib.Path(__file__).resolve().parents[2] / "corpus"
LETTERS = "Würfel-立方体-куб"


class OnWindows(unittest.TestCase):
    def setUp(self):
        self._scratch = tempfile.TemporaryDirectory()
        self.addCleanup(self._scratch.cleanup)
        self.folder = pathlib.Path(self._scratch.name)

    def run_plumb(self, *words, status=0, stdin=b""):
        done = subprocess.run([PROGRAM, *words], input=stdin, capture_output=True, check=False, cwd=self.folder)
        self.assertEqual(done.returncode, status, done.stderr.decode(errors="replace"))
        return done

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    def make_boxes(self):
        self.run_plumb("solid", "make", "box", "--size", "2,2,2", "-o", "a.off")
        self.run_plumb("solid", "make", "box", "--centre", "--size", "2,2,2", "-o", "b.off")

    def test_two_boxes_unite(self):
        self.make_boxes()
        self.run_plumb("solid", "union", "a.off", "b.off", "-o", "c.nef")
        properties = json.loads(self.run_plumb("solid", "info", "c.nef", "--json").stdout)
        # Two cubes of 8 that share one of 1.
        self.assertIn('"15"', json.dumps(properties))

    def test_names_have_letters_of_all_scripts(self):
        self.make_boxes()
        (self.folder / "a.off").rename(self.folder / f"{LETTERS}.off")
        self.run_plumb("solid", "union", f"{LETTERS}.off", "b.off", "-o", f"{LETTERS}.stl")
        self.assertEqual(self.files(), sorted([f"{LETTERS}.off", f"{LETTERS}.stl", "b.off"]))

    def test_messages_name_files_in_utf8(self):
        error = self.run_plumb("solid", "union", f"{LETTERS}.off", f"{LETTERS}.off", "-o", "c.off", status=2).stderr
        self.assertIn(LETTERS.encode(), error)

    def test_backslashes_part_folders(self):
        self.make_boxes()
        (self.folder / LETTERS).mkdir()
        self.run_plumb("solid", "union", "a.off", ".\\b.off", "-o", f"{LETTERS}\\c.off")
        self.assertTrue((self.folder / LETTERS / "c.off").is_file())

    def test_folders_and_titles_have_letters_of_all_scripts(self):
        (self.folder / LETTERS).mkdir()
        self.run_plumb("solid", "make", "box", "-o", f"{LETTERS}/c.obj")
        self.run_plumb("solid", "make", "box", "-o", f"{LETTERS}.off")
        self.run_plumb("view", f"{LETTERS}/c.obj", "-o", f"{LETTERS}.svg")
        self.run_plumb("view", f"{LETTERS}.off", "-o", f"{LETTERS}/{LETTERS}.html")
        self.run_plumb("convex", "decompose", f"{LETTERS}/c.obj", "-o", f"{LETTERS}/pieces")
        made = sorted(path.relative_to(self.folder).as_posix() for path in self.folder.rglob("*") if path.is_file())
        inside = sorted(f"{LETTERS}/{name}" for name in (f"{LETTERS}.html", "c.obj", "pieces/piece_0001.off"))
        self.assertEqual(made, sorted([f"{LETTERS}.off", f"{LETTERS}.svg", *inside]))
        self.assertIn(LETTERS, (self.folder / LETTERS / f"{LETTERS}.html").read_text(encoding="utf-8"))

    def test_a_name_that_is_not_utf8_is_not_found(self):
        (self.folder / "a.obj").write_bytes(b"mtllib W\xfcrfel.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                            b"f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n")
        self.run_plumb("solid", "info", "a.obj")

    def test_standard_output_is_bytes(self):
        self.make_boxes()
        for kind in ("off", "stl"):
            self.run_plumb("solid", "union", "a.off", "b.off", "-o", f"c.{kind}")
            written = self.run_plumb("solid", "union", "a.off", "b.off", "-o", "-", "--format", kind).stdout
            self.assertEqual(written, (self.folder / f"c.{kind}").read_bytes())
        self.assertNotIn(b"\r", (self.folder / "c.off").read_bytes())

    def test_standard_input_is_bytes(self):
        # Ctrl-Z would end a text, and CR LF would lose a byte: both stand in the header of a binary STL file.
        stl = bytearray((CORPUS / "solids" / "tetrahedron.binary.stl").read_bytes())
        stl[40:44] = b"\x1a\r\n\x1a"
        (self.folder / "a.stl").write_bytes(stl)
        self.make_boxes()
        self.run_plumb("solid", "union", "a.stl", "b.off", "-o", "c.off")
        self.run_plumb("solid", "union", "-", "b.off", "-o", "d.off", stdin=bytes(stl))
        self.assertEqual((self.folder / "d.off").read_bytes(), (self.folder / "c.off").read_bytes())

    def test_output_replaces_a_file_whole_or_not_at_all(self):
        self.make_boxes()
        (self.folder / "c.off").write_bytes(b"old")
        (self.folder / "broken.off").write_bytes(b"OFF\n1 1 0\n0 0\n")
        self.run_plumb("solid", "union", "a.off", "broken.off", "-o", "c.off", status=2)
        self.assertEqual((self.folder / "c.off").read_bytes(), b"old")
        self.run_plumb("solid", "union", "a.off", "b.off", "-o", "c.off")
        self.assertTrue((self.folder / "c.off").read_bytes().startswith(b"OFF"))
        self.assertEqual(self.files(), ["a.off", "b.off", "broken.off", "c.off"])

    def test_lines_may_end_as_on_windows(self):
        self.make_boxes()
        text = (self.folder / "a.off").read_bytes()
        (self.folder / "crlf.off").write_bytes(text.replace(b"\n", b"\r\n"))
        self.run_plumb("solid", "union", "a.off", "b.off", "-o", "c.nef", "--canonical")
        self.run_plumb("solid", "union", "crlf.off", "b.off", "-o", "d.nef", "--canonical")
        self.assertEqual((self.folder / "d.nef").read_bytes(), (self.folder / "c.nef").read_bytes())

    def test_limits_of_memory_and_time_stop(self):
        bunny, ball = str(CORPUS / "solids" / "bunny.off"), str(CORPUS / "solids" / "ball.off")
        for limit in (["--limit-memory", "1"], ["--limit-seconds", "0.01"]):
            self.run_plumb("solid", "union", bunny, ball, "-o", "c.off", *limit, status=3)
        self.assertEqual(self.files(), [])

    def test_the_program_checks_itself(self):
        self.run_plumb("self-test")


if __name__ == "__main__":
    PROGRAM = str(pathlib.Path(sys.argv.pop(1)).resolve())
    unittest.main()
