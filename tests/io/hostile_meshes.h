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

/// The same tetrahedron with faces on three lines each.
inline const std::string kOffOverLines =
    "OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0\n2\n1\n3 0\n1\n3\n3 0\n3\n2\n3 1\n2\n3\n";

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
      {"a lone carriage return first", "\rOFF\n" + kOffTetrahedron, 3, 1, "found 'OFF'"},
      {"another word", with("OFF", "PLY"), 1, 1, "expected OFF"},
      {"OFF and a word", with("OFF", "OFFSET"), 1, 4, "'SET'"},
      {"homogeneous", with("OFF", "4OFF"), 1, 1, "three coordinates"},
      {"homogeneous with colours", with("OFF", "C4OFF"), 1, 1, "three coordinates"},
      {"n-dimensional", with("OFF", "nOFF\n3"), 1, 1, "three coordinates"},
      {"another dimension says what to do", with("OFF", "4OFF"), 1, 1, "convert the file"},
      {"binary and a word", with("OFF", "OFF BINARYS"), 1, 5, "'BINARYS'"},
      {"more behind binary", with("OFF", "OFF BINARY 1"), 1, 12, "'1'"},
      {"binary without content", "OFF BINARY", 1, 11, "binary part"},
      {"no counts", "OFF\n", 2, 1, "numbers of vertices"},
      {"one count", "OFF\n4\n", 3, 1, "number of faces"},
      {"negative count", with("4 4 6", "-4 4 6"), 2, 1, "'-4'"},
      {"a count with a point", with("4 4 6", "4.0 4 6"), 2, 1, "'4.0'"},
      {"2^31 vertices", with("4 4 6", "2147483648 4 6"), 2, 1, "too short"},
      {"2^32 - 2 faces", with("4 4 6", "4 4294967294 6"), 2, 1, "too short"},
      {"more vertices claimed", with("4 4 6", "5 4 6"), 7, 7, "after the coordinates of vertex 5"},
      {"fewer vertices claimed", with("4 4 6", "3 4 6"), 8, 7, "ids run from 0 to 2"},
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
      {"corners missing", with("3 0 2 1", "4 0 2 1"), 7, 8, "the number of a vertex"},
      {"2^32 - 2 corners", with("3 0 2 1", "4294967294 0 2 1"), 7, 17, "the number of a vertex"},
      {"2^32 corners", with("3 0 2 1", "4294967296 0 2 1"), 7, 1, "at most"},
      {"negative corners", with("3 0 2 1", "-3 0 2 1"), 7, 1, "the number of corners"},
      {"a vertex beyond the last", with("3 0 2 1", "3 0 2 4"), 7, 7, "ids run from 0 to 3"},
      {"a negative vertex", with("3 0 2 1", "3 0 -1 1"), 7, 5, "ids run from 0 to 3"},
      {"vertex 2^32", with("3 0 2 1", "3 0 4294967296 1"), 7, 5, "ids run from 0 to 3"},
      {"a vertex with a point", with("3 0 2 1", "3 0 2.0 1"), 7, 5, "a vertex id"},
      {"five numbers of a colour", with("3 0 2 1", "3 0 2 1 1 2 3 4 5"), 7, 17, "'5'"},
      {"a face without vertices", "OFF\n0 1 0\n3 0 1 2\n", 3, 2, "there are none"},
      {"normals that are not there", with("OFF", "NOFF"), 3, 6, "lacks numbers"},
      {"more colours than announced", changed(with("OFF", "COFF"), "1 0 0", "1 0 0 1 2 3 4 5"), 4,
       15, "'5'"},
      {"a number more at a vertex", with("1 0 0", "1 0 0 7"), 4, 7, "'7'"},
      {"a number less at a vertex", with("\n0 0 0", "\n0 0 0 7"), 4, 6,
       "fewer numbers than vertex 1"},
      {"a bad index on one line",
       "OFF 4 4 6 0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 4 3 0 3 2 3 1 2 3", 1, 49,
       "face 2 names vertex '4'"},
      {"a bad number on one line",
       "OFF 4 4 6 0 0 0 1 0 0 0 nan 0 0 0 1 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3", 1, 25, "'nan'"},
      {"a bad index of a face on several lines",
       changed(kOffOverLines, "3 1\n2\n3\n", "3 1\n2\n4\n"), 18, 1, "face 4 names vertex '4'"},
  };
}

inline const std::string kObjTetrahedron =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

inline std::vector<HostileText> hostile_obj() {
  const std::string million(1'000'000, '7');
  const auto with = [](const std::string& from, const std::string& to) {
    return changed(kObjTetrahedron, from, to);
  };
  return {
      {"empty", "", 0, 0, "no content"},
      {"blank lines", "\n \r\n\n", 0, 0, "no content"},
      {"binary with zero bytes", bytes_with_nul("v\0\0\1\2", 5), 1, 2, "byte 0x00"},
      {"another format", "OFF\n4 4 6\n", 1, 1, "'OFF'"},
      {"another format after names", "o thing\n# x\n\nOFF\n4 4 6\n", 4, 1, "'OFF'"},
      {"a statement that is no text", kObjTetrahedron + "fa\xE9 1 2 3\n", 9, 3, "not UTF-8"},
      {"two coordinates", with("v 1 0 0", "v 1 0"), 2, 6, "vertex 2 needs three numbers"},
      {"two coordinates on two lines", with("v 1 0 0", "v 1\\\n 0"), 3, 3, "vertex 2 needs"},
      {"nan", with("v 1 0 0", "v 1 nan 0"), 2, 5, "'nan'"},
      {"-inf", with("v 1 0 0", "v 1 0 -inf"), 2, 7, "'-inf'"},
      {"a nan that a face needs, after another",
       "v nan 0 0\n" + with("f 1 3 2", "v 7 0 nan\nf 6 3 2"), 6, 7, "'nan'"},
      {"1/0", with("v 1 0 0", "v 1/0 0 0"), 2, 5, "denominator is 0"},
      {"1e400", with("v 1 0 0", "v 1e400 0 0"), 2, 3, "largest double"},
      {"1e999999999", with("v 1 0 0", "v 1 0 1e999999999"), 2, 7, "largest double"},
      {"10^6 digits", with("v 1 0 0", "v 1 " + million + " 0"), 2, 5, "1000000 characters"},
      {"vertex 0", with("f 1 3 2", "f 1 0 2"), 5, 5, "face 1 names vertex '0'; 4 vertices"},
      {"a vertex beyond the last", with("f 1 3 2", "f 1 5 2"), 5, 5, "names vertex '5'"},
      {"a vertex before the first", with("f 1 3 2", "f 1 -5 2"), 5, 5, "names vertex '-5'"},
      {"vertices that never come", "f 1 3 2\nf 2 5/1/1 4\nf 1 4 3\nv 0 0 0\nv 1 0 0\n", 2, 5,
       "face 2 names vertex '5'; the file has 2 vertices"},
      {"a vertex from the back before all", "f -1 1 2\n" + kObjTetrahedron, 1, 3,
       "'-1'; 0 vertices have been given before it"},
      {"vertex 2^64", with("f 1 3 2", "f 1 18446744073709551616 2"), 5, 5, "names vertex"},
      {"10^6 digits of a vertex", with("f 1 3 2", "f 1 " + million + " 2"), 5, 5, "names vertex"},
      {"a corner with a point", with("f 1 3 2", "f 1 3.0 2"), 5, 5, "expected a corner"},
      {"a corner with a plus", with("f 1 3 2", "f 1 +3 2"), 5, 5, "expected a corner"},
      {"a corner of slashes", with("f 1 3 2", "f 1 // 2"), 5, 5, "expected a corner"},
      {"a corner without vertex", with("f 1 3 2", "f 1 /3/2 2"), 5, 5, "expected a corner"},
      {"a corner of four numbers", with("f 1 3 2", "f 1 3/1/1/1 2"), 5, 5, "expected a corner"},
      {"a corner that is a word", with("f 1 3 2", "f 1 x/3 2"), 5, 5, "'x/3'"},
      {"a backslash in a line", with("f 1 3 2", "f 1 \\ 3 2"), 5, 5, "'\\'"},
      {"a lone carriage return", with("v 1 0 0", "v 1 0\r0"), 2, 6, "carriage return"},
  };
}

inline const std::string kStlFacet =
    "facet normal 0 0 -1\nouter loop\nvertex 0 0 0\nvertex 0 1 0\nvertex 1 0 "
    "0\nendloop\nendfacet\n";
inline const std::string kStlTriangle = "solid one\n" + kStlFacet + "endsolid one\n";

inline std::vector<HostileText> hostile_stl() {
  const std::string million(1'000'000, '7');
  const auto with = [](const std::string& from, const std::string& to) {
    return changed(kStlTriangle, from, to);
  };
  return {
      {"empty", "", 0, 0, "no content"},
      {"blank lines", "\n\n", 0, 0, "neither text"},
      {"another format", "OFF\n4 4 6\n", 0, 0, "neither text"},
      {"only the first word", "solid", 1, 6, "found the end of the file"},
      {"only the first line", "solid one\n", 2, 1, "facet or endsolid, found the end"},
      {"truncated in a facet", kStlTriangle.substr(0, 40), 3, 11, "expected vertex, found the end"},
      {"truncated in a vertex", kStlTriangle.substr(0, 50), 4, 10, "a number, found the end"},
      {"cut off before endfacet", kStlTriangle.substr(0, kStlTriangle.find("endfacet")), 8, 1,
       "expected endfacet, found the end"},
      {"cut off within endfacet", kStlTriangle.substr(0, kStlTriangle.find("facet\nends")), 8, 4,
       "expected facet, found the end"},
      {"cut off within endsolid", kStlTriangle.substr(0, kStlTriangle.find("lid one\n", 10)), 9, 1,
       "facet or endsolid, found 'endso'"},
      {"the end of something else", with("endloop", "end facet"), 7, 5, "expected loop"},
      {"another word", with("facet normal", "face normal"), 2, 1, "'face'"},
      {"four numbers of a normal", with("normal 0 0 -1", "normal 0 0 -1 0"), 2, 21,
       "expected outer, found '0'"},
      {"no outer", with("outer loop", "loop"), 3, 1, "expected outer, found 'loop'"},
      {"no loop", with("outer loop", "outer"), 4, 1, "expected loop"},
      {"four corners", with("vertex 0 1 0\n", "vertex 0 1 0\nvertex 2 2 2\n"), 7, 1,
       "expected endloop"},
      {"two coordinates", with("vertex 0 1 0", "vertex 0 1"), 6, 1, "expected a number"},
      {"four coordinates", with("vertex 0 1 0", "vertex 0 1 0 1"), 5, 14, "expected vertex"},
      {"nan", with("vertex 0 1 0", "vertex 0 nan 0"), 5, 10, "'nan'"},
      {"inf", with("vertex 0 1 0", "vertex 0 inf 0"), 5, 10, "'inf'"},
      {"1/0", with("vertex 0 1 0", "vertex 0 1/0 0"), 5, 12, "denominator is 0"},
      {"1e39 is fine, 1e400 is not", with("vertex 0 1 0", "vertex 1e39 1e400 0"), 5, 13,
       "largest double"},
      {"1e999999999", with("vertex 0 1 0", "vertex 0 1e999999999 0"), 5, 10, "largest double"},
      {"10^6 digits", with("vertex 0 1 0", "vertex 0 " + million + " 0"), 5, 10,
       "1000000 characters"},
      {"more after the end", kStlTriangle + "triangle\n", 10, 1, "expected solid"},
      {"a vertex in a solid", with("endsolid one\n", "vertex 0 0 0\n"), 9, 1, "facet or endsolid"},
      {"binary cut short", bytes_with_nul("solid\0\0\0\0x", 10), 0, 0, "byte 5 is no character"},
      {"a lone carriage return", with("vertex 0 1 0", "vertex 0\r1 0"), 5, 9, "carriage return"},
  };
}

inline const std::string kPlyHeader =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty double x\nproperty double y\n"
    "property double z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n";
inline const std::string kPlyTetrahedron =
    kPlyHeader + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";

inline std::vector<HostileText> hostile_ply() {
  const std::string million(1'000'000, '7');
  const auto with = [](const std::string& from, const std::string& to) {
    // Counts may lie a little without the file being too short for them.
    return changed(kPlyTetrahedron, from, to) + "# ...................................\n";
  };
  return {
      {"empty", "", 1, 1, "'ply'"},
      {"another format", "OFF\n", 1, 1, "'ply'"},
      {"a comment first", "# x\nply\n", 2, 1, "'ply'"},
      {"upper case", with("ply", "PLY"), 1, 1, "'ply'"},
      {"more in the first line", with("ply\n", "ply 1\n"), 1, 5, "'1'"},
      {"nothing else", "ply\n", 2, 1, "end_header is missing"},
      {"a cut header", kPlyHeader.substr(0, kPlyHeader.size() - 11), 9, 1, "end_header is missing"},
      {"no format", with("format ascii 1.0\n", ""), 8, 11, "names no format"},
      {"two formats", with("format ascii 1.0\n", "format ascii 1.0\nformat ascii 1.0\n"), 3, 1,
       "a second format"},
      {"another encoding", with("format ascii", "format utf8"), 2, 8, "'utf8'"},
      {"another version", with("1.0", "1.1"), 2, 14, "version '1.1'"},
      {"another keyword", with("element face", "elements face"), 7, 1, "'elements'"},
      {"a property without element", with("element vertex 4\n", ""), 3, 1, "before any element"},
      {"an element without count", with("element vertex 4", "element vertex"), 3, 15,
       "the number of elements"},
      {"an element of negative count", with("vertex 4", "vertex -4"), 3, 16, "'-4'"},
      {"two elements of vertices", with("element face 4", "element vertex 4"), 7, 9,
       "a second element vertex"},
      {"another type", with("double x", "long x"), 4, 10, "'long'"},
      {"a property without name", with("double x", "double"), 4, 16, "the name of a property"},
      {"two names", with("double x", "double x y"), 4, 19, "'y'"},
      {"two properties x", with("double y", "double x"), 5, 17, "a second property 'x'"},
      {"no z", with("property double z\n", ""), 8, 11, "lack one of x, y and z"},
      {"a list of z", with("double z", "list uchar double z"), 9, 11, "lack one of"},
      {"a line that is none of a header", with("element face", "\x01 face"), 7, 1, "byte 0x01"},
      {"no end of the header", with("end_header\n", ""), 9, 1, "end_header, found '0'"},
      {"a misspelled end of the header", with("end_header", "endheader"), 9, 1, "'endheader'"},
      {"a fractional length", with("3 0 2 1", "3.5 0 2 1"), 14, 1,
       "number of corners, found '3.5'"},
      {"a negative length", with("3 0 2 1", "-3 0 2 1"), 14, 1, "number of corners, found '-3'"},
      {"a fractional vertex", with("3 0 2 1", "3 0 2.5 1"), 14, 5, "vertex '2.5'"},
      {"a vertex that is a fraction", with("3 0 2 1", "3 0 1/3 1"), 14, 5, "vertex '1/3'"},
      {"faces without corners", with("vertex_indices", "corners"), 9, 11, "no list vertex_indices"},
      {"strips without vertices", changed(with("vertex_indices", "x"), "face", "tristrips"), 9, 11,
       "the strips have no list"},
      {"two lists of corners", with("indices\n", "indices\nproperty list uchar int vertex_index\n"),
       9, 25, "a second property 'vertex_index'"},
      {"corners that are no list", with("list uchar int", "int"), 9, 11, "no list vertex_indices"},
      {"no vertices", "ply\nformat ascii 1.0\nend_header\n", 3, 11, "names no vertices"},
      {"2^31 vertices", with("vertex 4", "vertex 2147483648"), 9, 1, "too short"},
      {"2^32 - 2 faces", with("face 4", "face 4294967294"), 9, 1, "too short"},
      {"2^32 faces", with("face 4", "face 4294967296"), 7, 14, "at most"},
      {"more vertices claimed", with("vertex 4", "vertex 5"), 14, 7, "properties of vertex 5"},
      {"fewer vertices claimed", with("vertex 4", "vertex 3"), 13, 3, "properties of face 1"},
      {"more faces claimed", with("face 4", "face 5"), 19, 1, "face 5 of 5"},
      {"fewer faces claimed", with("face 4", "face 3"), 17, 1, "after the last element"},
      {"two coordinates", with("\n1 0 0\n", "\n1 0\n"), 11, 4, "vertex 2 needs more properties"},
      {"four coordinates", with("\n1 0 0\n", "\n1 0 0 0\n"), 11, 7, "of vertex 2"},
      {"nan in a vertex of a face", with("\n1 0 0\n", "\nnan 0 0\n"), 14, 7,
       "face 1 uses vertex 1, which is not finite"},
      {"inf in a vertex of a strip",
       changed(with("\n1 0 0\n", "\n1 0 -inf\n"), "element face", "element tristrips"), 14, 7,
       "tristrips 1 uses vertex 1, which is not finite"},
      {"a word in a vertex", with("\n1 0 0\n", "\n1 x 0\n"), 11, 3, "a number, found 'x'"},
      {"1/0", with("\n1 0 0\n", "\n1/0 0 0\n"), 11, 3, "denominator is 0"},
      {"1e999999999", with("\n1 0 0\n", "\n1e999999999 0 0\n"), 11, 1, "largest double"},
      {"10^6 digits", with("\n1 0 0\n", "\n" + million + " 0 0\n"), 11, 1, "1000000 characters"},
      {"corners missing", with("3 0 2 1", "4 0 2 1"), 14, 8, "the number of a vertex"},
      {"2^32 - 2 corners", with("3 0 2 1", "4294967294 0 2 1"), 14, 17, "the number of a vertex"},
      {"more corners than counted", with("3 0 2 1", "3 0 2 1 3"), 14, 9, "'3'"},
      {"a vertex beyond the last", with("3 0 2 1", "3 0 2 4"), 14, 7, "ids run from 0 to 3"},
      {"a negative vertex", with("3 0 2 1", "3 0 -2 1"), 14, 5, "ids run from 0 to 3"},
      {"a face after the end", with("3 1 2 3\n", "3 1 2 3\n3 1 2 3\n"), 18, 1,
       "after the last element"},
      {"a strip with a vertex beyond the last",
       changed(with("3 0 2 1", "3 0 2 4"), "element face", "element tristrips"), 14, 7,
       "ids run from 0 to 3"},
      {"a strip with a negative vertex",
       changed(with("3 0 2 1", "3 0 -2 1"), "element face", "element tristrips"), 14, 5,
       "ids run from 0 to 3"},
      {"all on one line, a number too few",
       kPlyHeader + "0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2", 10, 54,
       "face 4 needs the number of a vertex"},
      {"all on one line, a number too many",
       kPlyHeader + "0 0 0 1 0 0 0 1 0 0 0 1 3 0 2 1 3 0 1 3 3 0 3 2 3 1 2 3 4", 10, 57,
       "after the last element"},
      {"two vertices on a line", with("\n0 0 0\n1", "\n0 0 0 1"), 10, 7, "of vertex 1"},
      {"faces before a vertex of nan",
       "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
       "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
       "3 0 1 2\n0 0 0\n1 nan 0\n0 1 0\n",
       12, 3, "vertex 2 is not finite, but a face uses it"},
      {"a lone carriage return", with("end_header\n", "end_header\r"), 9, 11, "carriage return"},
  };
}

}  // namespace plumb::testing
