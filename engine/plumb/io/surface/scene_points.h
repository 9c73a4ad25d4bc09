// Points of scenes as they are written: [face, u, v]; and what becomes of decimals
// (scene_reader.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "plumb/base/context.h"
#include "plumb/io/read_options.h"
#include "plumb/io/surface/scene_parser.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/number_reader.h"

namespace plumb {

class ScenePointReader {
 public:
  /// `places` has to outlive it.
  ScenePointReader(std::string_view text, const ReadOptions& options, JsonPlaces& places,
                   Context& context);

  /// At its opening bracket.
  void begin(std::size_t place);
  bool needs_face() const { return numbers_ == 0; }
  void set_face(std::uint32_t face);
  /// A token of the text.
  void read_weight(std::string_view token);
  /// At its closing bracket.
  void end(ScenePoints& to);

 private:
  void add_near_side(const std::array<Rational, 2>& weights, bool is_decimal, ScenePoints& to);

  const char* text_;
  JsonPlaces& places_;
  NumberReader nearest_, exact_;
  bool exact_decimals_;
  Context& context_;
  std::size_t numbers_ = 0;
  std::size_t place_ = 0;
  std::uint32_t face_ = 0;
  std::array<std::string_view, 2> tokens_;
  std::array<ReadNumber, 2> weights_;
};

}  // namespace plumb
