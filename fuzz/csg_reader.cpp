// The reader of OpenSCAD's models on arbitrary bytes.
//
// Either the reader throws an Error that names the file, a line and a column inside it, or a tree
// whose ranges are nested and whose indices are in range; what it takes is in proportion to the
// file. The tree, written as a model with all parameters, is read again as the same tree. Files are
// not imported.

#include "plumb/io/csg_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "plumb/base/internal/message_text.h"
#include "plumb/testing/oracle_reached.h"
#include "reader_laws.h"

namespace {

using namespace plumb;
using namespace plumb::fuzz;

/// What a model may be charged for each byte: `[` is a value of 40 bytes in a list that doubles.
constexpr std::size_t kBytesPerByte = 400;

std::optional<CsgTree> tree_of(std::string_view text) {
  Limits limits;
  limits.max_memory_bytes = kBytesPerByte * text.size() + (std::size_t{1} << 16U);
  Context context(limits);
  try {
    return read_csg(kFileName, text, {CsgImports::None, false}, context).tree;
  } catch (const Error& error) {
    require(error.code() != ErrorCode::ResourceLimit,
            "memory charged is in proportion to the input");
    require_place(error, text);
    return {};
  }
}

void require_valid(const CsgTree& tree) {
  std::vector<std::uint32_t> ends;
  require(tree.nodes[0].end == tree.nodes.size(), "the root has all nodes");
  for (std::uint32_t i = 0; i < tree.nodes.size(); ++i) {
    const CsgTree::Node& node = tree.nodes[i];
    while (!ends.empty() && ends.back() <= i) ends.pop_back();
    require(node.end > i && (ends.empty() || node.end <= ends.back()), "subtrees are nested");
    ends.push_back(node.end);
    require(node.first_number + node.number_count <= tree.numbers.size(), "numbers exist");
    require(node.first_index + node.index_count <= tree.indices.size(), "indices exist");
    for (const double x : tree.numbers_of(node)) require(std::isfinite(x), "numbers are finite");
    if (node.kind != CsgKind::Polyhedron && node.kind != CsgKind::Polygon) continue;
    const auto indices = tree.indices_of(node);
    const std::size_t points = node.number_count / (node.kind == CsgKind::Polygon ? 2 : 3);
    std::size_t corners = 0;
    for (const std::uint32_t size : indices.subspan(1, indices[0])) corners += size;
    require(indices.size() == 1 + indices[0] + corners, "faces have all corners");
    for (const std::uint32_t corner : indices.subspan(1 + indices[0])) {
      require(corner < points, "corners are points");
    }
  }
}

/// Writes the tree as a model with every parameter.
class ModelWriter {
 public:
  explicit ModelWriter(const CsgTree& tree) : tree_(tree) {}

  std::string run() {
    std::vector<std::uint32_t> ends;
    for (std::uint32_t i = 1; i < tree_.nodes.size(); ++i) {
      close_before(i, ends);
      text_ += std::string(name_of(tree_.nodes[i].kind)) + "(";
      write_parameters(tree_.nodes[i]);
      text_ += ") {";
      ends.push_back(tree_.nodes[i].end);
    }
    close_before(static_cast<std::uint32_t>(tree_.nodes.size()), ends);
    return std::move(text_);
  }

 private:
  void close_before(std::uint32_t i, std::vector<std::uint32_t>& ends) {
    while (!ends.empty() && ends.back() <= i) {
      text_ += "}\n";
      ends.pop_back();
    }
  }
  double number(std::size_t i) const { return numbers_[i]; }
  void put(const char* name, std::size_t i) {
    text_ += std::string(name) + "=" + format_double(number(i)) + ",";
  }
  void put_vector(const char* name, std::size_t from, std::size_t count) {
    text_ += std::string(name) + "=";
    put_list(from, count);
  }
  void put_list(std::size_t from, std::size_t count) {
    text_ += "[";
    for (std::size_t i = 0; i < count; ++i) text_ += format_double(number(from + i)) + ",";
    text_ += "],";
  }
  void put_division(std::size_t from) {
    put("$fn", from);
    put("$fa", from + 1);
    put("$fs", from + 2);
  }
  void put_points(const CsgTree::Node& node, std::size_t axes, const char* lists) {
    text_ += "points=[";
    for (std::size_t i = 0; i < numbers_.size(); i += axes) put_list(i, axes);
    text_ += std::string("],") + lists + "=[";
    const auto indices = tree_.indices_of(node);
    std::size_t corner = 1 + indices[0];
    for (const std::uint32_t size : indices.subspan(1, indices[0])) {
      text_ += "[";
      for (std::uint32_t k = 0; k < size; ++k) text_ += std::to_string(indices[corner++]) + ",";
      text_ += "],";
    }
    text_ += "]";
  }
  void write_parameters(const CsgTree::Node& node) {
    numbers_ = tree_.numbers_of(node);
    switch (node.kind) {
      case CsgKind::Color:
        if (!numbers_.empty()) put_list(0, 4);
        break;
      case CsgKind::Multmatrix:
        text_ += "[";
        for (std::size_t row = 0; row < 3; ++row) put_list(4 * row, 4);
        text_ += "[0,0,0,1]]";
        break;
      case CsgKind::Resize:
        put_vector("newsize", 0, 3);
        put_vector("auto", 3, 3);
        break;
      case CsgKind::Offset:
        put(number(1) == 0 ? "r" : "delta", 0);
        text_ += number(1) == 2 ? "chamfer=true," : "chamfer=false,";
        put_division(2);
        break;
      case CsgKind::Projection:
        put("cut", 0);
        break;
      case CsgKind::LinearExtrude:
        put("height", 0);
        put("center", 1);
        put("twist", 2);
        put("slices", 3);
        put_vector("scale", 4, 2);
        put_division(6);
        break;
      case CsgKind::RotateExtrude:
        put("angle", 0);
        put_division(1);
        break;
      case CsgKind::Cube:
      case CsgKind::Square:
        put_vector("size", 0, numbers_.size() - 1);
        put("center", numbers_.size() - 1);
        break;
      case CsgKind::Sphere:
      case CsgKind::Circle:
        put("r", 0);
        put_division(1);
        break;
      case CsgKind::Cylinder:
        put("h", 0);
        put("r1", 1);
        put("r2", 2);
        put("center", 3);
        put_division(4);
        break;
      case CsgKind::Polyhedron:
        put_points(node, 3, "faces");
        break;
      case CsgKind::Polygon:
        put_points(node, 2, "paths");
        break;
      default:
        break;
    }
  }

  const CsgTree& tree_;
  std::span<const double> numbers_;
  std::string text_;
};

bool is_same(const CsgTree& a, const CsgTree& b) {
  const auto is_same_node = [&](const CsgTree::Node& m, const CsgTree::Node& n) {
    const auto p = a.numbers_of(m), q = b.numbers_of(n);
    const auto r = a.indices_of(m), s = b.indices_of(n);
    return m.kind == n.kind && m.end == n.end &&
           std::equal(p.begin(), p.end(), q.begin(), q.end()) &&
           std::equal(r.begin(), r.end(), s.begin(), s.end());
  };
  return std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), is_same_node);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  begin_input();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const std::optional<CsgTree> tree = tree_of(text);
  if (!tree) return 0;
  oracle_reached();
  require_valid(*tree);
  const std::optional<CsgTree> again = tree_of(ModelWriter(*tree).run());
  require(again && is_same(*tree, *again), "a model is read as it is written");
  return 0;
}
