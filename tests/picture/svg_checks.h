// What every picture has to be: well-formed, finite, and within its page.
#pragma once

#include <gtest/gtest.h>

#include <boost/property_tree/xml_parser.hpp>
#include <cmath>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/predicates/point.h"

namespace plumb::testing {

using Xml = boost::property_tree::ptree;

inline Xml parsed(const std::string& svg) {
  std::istringstream in(svg);
  Xml tree;
  EXPECT_NO_THROW(boost::property_tree::read_xml(in, tree)) << svg.substr(0, 2000);
  return tree;
}

inline void visit(const Xml& tree, const std::function<void(const std::string&, const Xml&)>& see) {
  for (const auto& [name, child] : tree) {
    see(name, child);
    visit(child, see);
  }
}

inline std::string attribute(const Xml& element, const char* name) {
  return element.get(std::string("<xmlattr>.") + name, "");
}

/// All numbers of the attributes that hold coordinates.
inline std::vector<double> coordinates(const Xml& tree) {
  std::vector<double> numbers;
  visit(tree, [&numbers](const std::string&, const Xml& element) {
    for (const char* name : {"x", "y", "width", "height", "cx", "cy", "r", "points", "d"}) {
      std::string text = attribute(element, name);
      for (char& c : text) {
        if (std::string_view("0123456789.-").find(c) == std::string_view::npos) c = ' ';
      }
      for (std::size_t i = 1; i < text.size(); ++i) {
        if (text[i] == '-' && text[i - 1] != ' ') text.insert(i++, " ");
      }
      std::istringstream in(text);
      for (double x = 0; in >> x;) numbers.push_back(x);
      EXPECT_TRUE(in.eof()) << name << " " << attribute(element, name);
    }
  });
  return numbers;
}

inline void expect_sound(const std::string& svg) {
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf\""), std::string::npos);
  const auto numbers = coordinates(parsed(svg));
  EXPECT_GT(numbers.size(), 10U);
  for (const double x : numbers) {
    EXPECT_TRUE(std::isfinite(x));
    EXPECT_LE(std::abs(x), 100000) << "far outside the picture";
  }
}

/// Follows the relative moves of PathData as a viewer does; a list of points for each subpath.
inline std::vector<std::vector<Point2>> read_path(const std::string& data) {
  std::vector<std::vector<Point2>> paths;
  double x = 0, y = 0, start_x = 0, start_y = 0;
  for (std::size_t i = 0; i < data.size();) {
    const char command = data[i++];
    if (command == 'z') {
      x = start_x;
      y = start_y;
      continue;
    }
    const char* begin = data.c_str() + i;
    char* end = nullptr;
    x += std::strtod(begin, &end);
    y += std::strtod(end, &end);
    i = static_cast<std::size_t>(end - data.c_str());
    if (command == 'm') {
      paths.emplace_back();
      start_x = x;
      start_y = y;
    }
    paths.back().push_back({x / 10, y / 10});
  }
  return paths;
}

}  // namespace plumb::testing
