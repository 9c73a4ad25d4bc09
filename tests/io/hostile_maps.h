// Malformed maps as data: shared by the reader's test and the program's.
#pragma once

#include <string>
#include <vector>

#include "hostile_text.h"

namespace plumb::testing {

/// A valid triangle with both its faces; cases below break one thing each.
inline const std::string kTriangle = "3 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n";

inline std::vector<HostileText> hostile_maps() {
  const std::string million(1'000'000, '7');
  return {
      {"empty", "", 1, 1, "no content"},
      {"only blank lines and comments", "\n  \n# nothing\n", 4, 1, "no content"},
      {"binary with zero bytes", bytes_with_nul("\0\0\0\1\2", 5), 1, 1, "byte 0x00"},
      {"an ELF file",
       "\x7F"
       "ELF\x02\x01\x01 x\n",
       1, 1, "byte 0x7f"},
      {"control character in a comment", "# \x1B[2J\n" + kTriangle, 1, 3, "byte 0x1b"},
      {"a word for a count", "three 2\n", 1, 1, "'three'"},
      {"UTF-8 for a number", "3 2\n\xCF\x80 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1,
       "expected a number"},
      {"one count", "3\n0 0\n", 1, 2, "number of faces"},
      {"three counts", "3 2 1\n", 1, 5, "'1'"},
      {"negative vertices", "-3 2\n", 1, 1, "'-3'"},
      {"negative faces", "3 -2\n", 1, 3, "'-2'"},
      {"a count with a point", "3.0 2\n", 1, 1, "'3.0'"},
      {"2^31 vertices", "2147483648 2\n0 0\n", 1, 1, "too short"},
      {"2^32 - 2 faces", "3 4294967294\n0 0\n1 0\n0 1\n1 2 3\n", 1, 1, "too short"},
      {"2^32 vertices", "4294967296 2\n0 0\n", 1, 1, "at most"},
      {"10^30 vertices", "1000000000000000000000000000000 2\n", 1, 1, "at most"},
      {"counts claim more vertices", "4 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n# and so on\n", 5, 5,
       "'3'"},
      {"counts claim fewer vertices", "2 2\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 4, 1, "vertex '0'"},
      {"counts claim more faces", "3 3\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n\n#\n\n", 10, 1,
       "face 3 of 3"},
      {"counts claim fewer faces", "3 1\n0 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 6, 1,
       "after the last face"},
      {"truncated in the vertices", "3 1\n0 0\n1 0          ", 3, 14, "vertex 3 of 3"},
      {"truncated in a vertex", "3 1\n0 0\n1 0\n       0", 4, 9, "needs two numbers"},
      {"text after the last face", kTriangle + "\n# fine\n  end\n", 9, 3, "after the last face"},
      {"one coordinate", "3 2\n0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 2, "needs two numbers"},
      {"three coordinates", "3 2\n0 0 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 5, "after the two numbers"},
      {"a comment behind numbers", "3 2\n0 0 # o\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 5, "'#'"},
      {"a lone carriage return", "3 2\n0\r0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 2, "carriage return"},
      {"nan", "3 2\nnan 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "'nan'"},
      {"-inf", "3 2\n0 -inf\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3, "'-inf'"},
      {"infinity", "3 2\n0 infinity\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3, "'infinity'"},
      {"hexadecimal", "3 2\n0x1p3 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "'0x1p3'"},
      {"two signs", "3 2\n+-1 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "'+-1'"},
      {"a sign alone", "3 2\n- 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "'-'"},
      {"a point alone", "3 2\n. 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "'.'"},
      {"an exponent alone", "3 2\n1e 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "'1e'"},
      {"a decimal comma", "3 2\n1,5 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "'1,5'"},
      {"1/0", "3 2\n0 1/0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 5, "denominator is 0"},
      {"1/000", "3 2\n0 1/000\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 5, "denominator is 0"},
      {"1/", "3 2\n0 1/\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3, "'1/'"},
      {"1/-2", "3 2\n0 1/-2\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3, "'1/-2'"},
      {"1/2/3", "3 2\n0 1/2/3\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3, "'1/2/3'"},
      {"1e999999999", "3 2\n1e999999999 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1, "largest double"},
      {"1e400", "3 2\n0 -1e400\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3, "largest double"},
      {"exponent of 30 digits", "3 2\n1e100000000000000000000000000000 0\n1 0\n0 1\n1 2 3\n3 2 1\n",
       2, 1, "largest double"},
      {"10^6 digits", "3 2\n0 " + million + "\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3,
       "1000000 characters"},
      {"10^6 digits of a denominator", "3 2\n0 1/" + million + "\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 3,
       "1000002 characters"},
      {"10^6 digits after the point", "3 2\n0." + million + " 0\n1 0\n0 1\n1 2 3\n3 2 1\n", 2, 1,
       "1000002 characters"},
      {"10^6 digits of an id", "3 2\n0 0\n1 0\n0 1\n1 2 " + million + "\n3 2 1\n", 5, 5, "ids run"},
      {"id 0", "3 2\n0 0\n1 0\n0 1\n0 2 3\n3 2 1\n", 5, 1, "'0'"},
      {"id beyond n", "3 2\n0 0\n1 0\n0 1\n1 2 4\n3 2 1\n", 5, 5, "'4'"},
      {"negative id", "3 2\n0 0\n1 0\n0 1\n1 -2 3\n3 2 1\n", 5, 3, "'-2'"},
      {"id 2^32 + 1", "3 2\n0 0\n1 0\n0 1\n1 4294967297 3\n3 2 1\n", 5, 3, "'4294967297'"},
      {"an id with a point", "3 2\n0 0\n1 0\n0 1\n1 2.0 3\n3 2 1\n", 5, 3, "a vertex id"},
      {"an id with a plus", "3 2\n0 0\n1 0\n0 1\n1 +2 3\n3 2 1\n", 5, 3, "a vertex id"},
      {"a face of one vertex", "3 2\n0 0\n1 0\n0 1\n1            \n3 2 1\n", 5, 1, "has 1 vertex;"},
      {"a face of two vertices", "3 2\n0 0\n1 0\n0 1\n1 2       \n3 2 1\n", 5, 1, "has 2 vertices"},
      {"a repeated vertex", "3 2\n0 0\n1 0\n0 1\n1 2 2 3\n3 2 1\n", 5, 5, "twice in a row"},
      {"the first vertex again", "3 2\n0 0\n1 0\n0 1\n1 2 3 1\n3 2 1\n", 5, 7,
       "close by themselves"},
      {"a face on one line", "3 1\n0 0\n1 1\n2 2\n1 2 3\n", 5, 1, "on one line"},
      {"a face on one line, exactly",
       "3 1\n1/3 1/3\n2/3 2/3\n9007199254740993 9007199254740993\n1 2 3\n", 5, 1, "on one line"},
      {"a face at one point", "3 1\n5 5\n5 5\n5 5\n  1 2 3\n", 5, 3, "on one line"},
      {"there and back on one line", "4 1\n0 0\n0 0\n1 0\n2 0\n1 3 4 2\n", 6, 1, "on one line"},
  };
}

}  // namespace plumb::testing
