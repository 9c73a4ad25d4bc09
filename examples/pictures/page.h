// The beginning and the end of an SVG file, and numbers in it.
#pragma once

#include <cstdio>

/// Texts of 14 units on white; `style` are further CSS rules.
inline void begin_page(int width, int height, const char* title, const char* style) {
  std::printf(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" "
      "role=\"img\">\n<title>%s</title>\n<style>\n"
      "text{font-family:Helvetica,Arial,\"Liberation Sans\",\"DejaVu Sans\",sans-serif;"
      "font-size:14px;fill:#1f2933}\n.middle{text-anchor:middle}\n%s</style>\n"
      "<rect width=\"%d\" height=\"%d\" fill=\"#ffffff\"/>\n",
      width, height, width, height, title, style, width, height);
}

inline void text(double x, double y, const char* classes, const char* words) {
  std::printf("<text class=\"%s\" x=\"%.1f\" y=\"%.1f\">%s</text>\n", classes, x, y, words);
}

inline void end_page() { std::printf("</svg>\n"); }
