// Malformed mesh files as data: shared by the readers' tests and the program's.
#pragma once

#include <string>
#include <vector>

#include "hostile_text.h"

namespace plumb::testing {

/// `text` with its only `from` replaced.
inline std::string changed(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

/// A valid tetrahedron; cases below break one thing each.
inline const std::string kOffTetrahedron =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline std::vector<HostileText> hostile_off() {
  const std::string million(1'000'000, '7');
  const auto with = [](const std::string& from, const std::string& to) {
    // Counts may lie a little without the file being too short for them.
    return changed(kOffTetrahedron, from, to) + "# ...................................\n";
  };
  return {
      {"empty", "", 1, 1, "no content"},
      {"only comments", "# x\n\n# y\n", 4, 1, "no content"},
      {"binary with zero bytes", bytes_with_nul("\0\0\0\1\2", 5), 1, 1, "byte 0x00"},
      {"another word", with("OFF", "PLY"), 1, 1, "expected OFF"},
      {"lower case", with("OFF", "off"), 1, 1, "expected OFF"},
      {"OFF and a word", with("OFF", "OFFSET"), 1, 4, "'SET'"},
      {"homogeneous", with("OFF", "4OFF"), 1, 1, "three coordinates"},
      {"homogeneous with colours", with("OFF", "C4OFF"), 1, 1, "three coordinates"},
      {"n-dimensional", with("OFF", "nOFF\n3"), 1, 1, "three coordinates"},
      {"binary", with("OFF", "OFF BINARY"), 1, 5, "binary OFF"},
      {"no counts", "OFF\n", 2, 1, "numbers of vertices"},
      {"one count", "OFF\n4\n", 2, 2, "number of faces"},
      {"four counts", with("4 4 6", "4 4 6 1"), 2, 7, "'1'"},
      {"negative count", with("4 4 6", "-4 4 6"), 2, 1, "'-4'"},
      {"a count with a point", with("4 4 6", "4.0 4 6"), 2, 1, "'4.0'"},
      {"2^31 vertices", with("4 4 6", "2147483648 4 6"), 2, 1, "too short"},
      {"2^32 - 2 faces", with("4 4 6", "4 4294967294 6"), 2, 1, "too short"},
      {"2^32 edges", with("4 4 6", "4 4 4294967296"), 2, 5, "at most"},
      {"more vertices claimed", with("4 4 6", "5 4 6"), 7, 7, "after the coordinates of vertex 5"},
      {"fewer vertices claimed", with("4 4 6", "3 4 6"), 6, 1, "face 1 has 0 corners"},
      {"more faces claimed", with("4 4 6", "4 5 6"), 12, 1, "face 5 of 5"},
      {"fewer faces claimed", with("4 4 6", "4 3 6"), 10, 1, "after the last face"},
      {"two coordinates", with("1 0 0", "1 0"), 4, 4, "vertex 2 needs three numbers"},
      {"four coordinates", with("1 0 0", "1 0 0 0"), 4, 7, "after the coordinates of vertex 2"},
      {"nan", with("1 0 0", "1 nan 0"), 4, 3, "'nan'"},
      {"inf", with("1 0 0", "1 0 -inf"), 4, 5, "'-inf'"},
      {"1/0", with("1 0 0", "1/0 0 0"), 4, 3, "denominator is 0"},
      {"1e400", with("1 0 0", "1e400 0 0"), 4, 1, "largest double"},
      {"1e999999999", with("1 0 0", "1 0 1e999999999"), 4, 5, "largest double"},
      {"hexadecimal", with("1 0 0", "0x1 0 0"), 4, 1, "'0x1'"},
      {"10^6 digits", with("1 0 0", "1 " + million + " 0"), 4, 3, "1000000 characters"},
      {"10^6 digits after the point", with("1 0 0", "1 0." + million + " 0"), 4, 3,
       "1000002 characters"},
      {"a lone carriage return", with("1 0 0", "1 0\r0"), 4, 4, "carriage return"},
      {"truncated in a vertex", kOffTetrahedron.substr(0, 18) + std::string(60, ' '), 4, 63,
       "vertex 2 needs three numbers"},
      {"truncated in the vertices", kOffTetrahedron.substr(0, 16) + std::string(60, '\n'), 64, 1,
       "the file ends where vertex 2 of 4"},
      {"truncated in the faces", kOffTetrahedron.substr(0, 42) + std::string(60, '\n'), 68, 1,
       "the file ends where face 2 of 4"},
      {"no corners", with("3 0 2 1", "0"), 7, 1, "face 1 has 0 corners; at least 3"},
      {"one corner", with("3 0 2 1", "1 0"), 7, 1, "face 1 has 1 corner; at least 3"},
      {"two corners", with("3 0 2 1", "2 0 2"), 7, 1, "face 1 has 2 corners"},
      {"corners missing", with("3 0 2 1", "4 0 2 1"), 7, 8, "the number of a vertex"},
      {"2^32 - 2 corners", with("3 0 2 1", "4294967294 0 2 1"), 7, 17, "the number of a vertex"},
      {"2^32 corners", with("3 0 2 1", "4294967296 0 2 1"), 7, 1, "at most"},
      {"negative corners", with("3 0 2 1", "-3 0 2 1"), 7, 1, "the number of corners"},
      {"a vertex beyond the last", with("3 0 2 1", "3 0 2 4"), 7, 7, "ids run from 0 to 3"},
      {"a negative vertex", with("3 0 2 1", "3 0 -1 1"), 7, 5, "ids run from 0 to 3"},
      {"vertex 2^32", with("3 0 2 1", "3 0 4294967296 1"), 7, 5, "ids run from 0 to 3"},
      {"a vertex with a point", with("3 0 2 1", "3 0 2.0 1"), 7, 5, "a vertex id"},
      {"a vertex twice", with("3 0 2 1", "3 0 2 2"), 7, 1, "twice in a row: corner 2"},
      {"the first vertex again", with("3 0 2 1", "4 0 2 1 0"), 7, 1, "twice in a row: corner 4"},
      {"five numbers of a colour", with("3 0 2 1", "3 0 2 1 1 2 3 4 5"), 7, 17, "'5'"},
      {"a colour that is none", with("3 0 2 1", "3 0 2 1 red"), 7, 9, "'red'"},
      {"a face without vertices", "OFF\n0 1 0\n3 0 1 2\n", 3, 1, "no vertices"},
      {"normals that are not there", with("OFF", "NOFF"), 3, 6, "lacks numbers"},
      {"more colours than announced", changed(with("OFF", "COFF"), "1 0 0", "1 0 0 1 2 3 4 5"), 4,
       15, "'5'"},
      {"text after the last face", kOffTetrahedron + "end\n", 11, 1, "after the last face"},
      {"Latin-1 in a comment behind a line", with("1 0 0", "1 0 0 # caf\xE9"), 4, 12, "not UTF-8"},
  };
}

}  // namespace plumb::testing
