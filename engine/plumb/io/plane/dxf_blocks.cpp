// Placing of the blocks of drawings. Blocks share their corners and knots: a placed curve is a copy
// of a few numbers with another transform.
#include "plumb/io/plane/dxf_blocks.h"

#include <algorithm>
#include <utility>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

class BlockPlacer {
 public:
  BlockPlacer(const DxfContent& content, std::string_view only_layer, const std::string& name,
              MemoryCharge& charge, Context& context)
      : content_(content),
        only_layer_(only_layer),
        name_(name),
        charge_(charge),
        context_(context) {}

  std::vector<DxfCurve> place() {
    place_curves(content_.drawing, {}, "0");
    place_inserts(content_.drawing, {}, "0");
    std::stable_sort(
        placed_.begin(), placed_.end(),
        [](const DxfCurve& one, const DxfCurve& other) { return one.where < other.where; });
    return std::move(placed_);
  }

 private:
  void place_curves(const DxfBlock& block, const SvgTransform& transform, std::string_view layer) {
    last_area_ = 0;
    for (std::uint32_t c = block.first_curve; c < block.end_curve; ++c) {
      DxfCurve curve = content_.curves.curves[c];
      // The entities of the drawing itself are bounded by its text.
      if (!open_.empty()) count_step();
      if (curve.layer == "0") curve.layer = layer;
      if (!only_layer_.empty() && curve.layer != only_layer_) continue;
      curve.transform = product(transform, curve.transform);
      curve.area = placed_area(curve.area);
      charge_.add(2 * sizeof(DxfCurve), "the drawing");
      placed_.push_back(curve);
    }
  }

  /// Returns the number of an area. Each placement of a hatch is a separate area. The curves of a
  /// hatch are consecutive.
  std::uint32_t placed_area(std::uint32_t area) {
    if (area != 0 && area != last_area_) ++areas_;
    last_area_ = area;
    return area == 0 ? 0 : areas_;
  }

  void place_inserts(const DxfBlock& block, const SvgTransform& transform, std::string_view layer) {
    for (std::uint32_t i = block.first_insert; i < block.end_insert; ++i) {
      const DxfInsert& insert = content_.inserts[i];
      const auto found = content_.blocks.find(insert.block);
      if (found == content_.blocks.end()) continue;
      open_.push_back(&found->second);
      insert_ = &insert;
      require_nesting();
      place_array(insert, found->second, transform, insert.layer == "0" ? layer : insert.layer);
      open_.pop_back();
    }
  }

  void place_array(const DxfInsert& insert, const DxfBlock& block, const SvgTransform& transform,
                   std::string_view layer) {
    const SvgTransform placing = product(transform, insert.placing);
    const Point2 s = insert.scale;
    for (std::uint32_t row = 0; row < insert.rows; ++row) {
      for (std::uint32_t column = 0; column < insert.columns; ++column) {
        insert_ = &insert;
        count_step();
        const SvgTransform cell{s.x,
                                0,
                                0,
                                s.y,
                                column * insert.spacing.x - s.x * block.base.x,
                                row * insert.spacing.y - s.y * block.base.y};
        const SvgTransform whole = product(placing, cell);
        place_curves(block, whole, layer);
        place_inserts(block, whole, layer);
      }
    }
  }

  /// Refuses a block that contains itself, and blocks that are nested too deeply.
  void require_nesting() const {
    constexpr std::size_t kDeepest = 64;
    if (std::count(open_.begin(), open_.end(), open_.back()) > 1) {
      fail(ErrorCode::BadShape, "the block '" + std::string(insert_->block.substr(0, 64)) +
                                    "' contains an insert of itself");
    }
    if (open_.size() > kDeepest) {
      fail(ErrorCode::ResourceLimit, "more than 64 blocks are nested in one another");
    }
  }

  /// Limits the work, because nested inserts of blocks can double it with every few lines of text.
  void count_step() {
    constexpr std::size_t kMost = std::size_t{1} << 20, kStepsPerCheckpoint = 4096;
    if (++steps_ > kMost) {
      fail(ErrorCode::ResourceLimit, "the inserts place more than 2^20 entities");
    }
    if (steps_ % kStepsPerCheckpoint == 0) context_.checkpoint("insert", steps_, 0);
  }

  [[noreturn]] void fail(ErrorCode code, const std::string& message) const {
    throw Error(code, message, {name_, insert_->line, 1});
  }

  const DxfContent& content_;
  std::string_view only_layer_;
  const std::string& name_;
  MemoryCharge& charge_;
  Context& context_;
  // The blocks that are being placed. The outermost block is first.
  std::vector<const DxfBlock*> open_;
  const DxfInsert* insert_ = nullptr;
  std::size_t steps_ = 0;
  std::uint32_t areas_ = 0;      // The number of hatches that have been placed.
  std::uint32_t last_area_ = 0;  // The area of the last curve, in its block.
  std::vector<DxfCurve> placed_;
};

}  // namespace

bool DxfNameOrder::operator()(std::string_view a, std::string_view b) const {
  const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(),
                                      [&](char x, char y) { return small(x) < small(y); });
}

std::vector<DxfCurve> placed_curves(const DxfContent& content, std::string_view only_layer,
                                    const std::string& name, MemoryCharge& charge,
                                    Context& context) {
  return BlockPlacer(content, only_layer, name, charge, context).place();
}

}  // namespace plumb
