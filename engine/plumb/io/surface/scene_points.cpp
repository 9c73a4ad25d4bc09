#include "plumb/io/surface/scene_points.h"

#include <string>

#include "plumb/io/text/input_cursors.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr double kClear = 0x1p-40;  // so far from the sides rounding a weight changes nothing
constexpr std::uint64_t kBytesPerPoint = 2 * (sizeof(Point2) + 2 * sizeof(std::size_t));

const Rational& tiny() {
  static const Rational value = exact_rational(0x1p-52);
  return value;
}

}  // namespace

ScenePointReader::ScenePointReader(std::string_view text, const ReadOptions& options,
                                   JsonPlaces& places, Context& context)
    : text_(text.data()),
      places_(places),
      nearest_(context.limits(), options.exact_decimals, text.size()),
      exact_(context.limits(), true, text.size()),
      exact_decimals_(options.exact_decimals),
      context_(context) {}

void ScenePointReader::begin(std::size_t place) {
  place_ = place;
  numbers_ = 0;
}

void ScenePointReader::set_face(std::uint32_t face) {
  face_ = face;
  numbers_ = 1;
}

void ScenePointReader::read_weight(std::string_view token) {
  if (numbers_ > 2) {
    places_.fail(ErrorCode::Syntax, "a point is [face, u, v]: too many numbers", places_.token());
  }
  nearest_.read(places_.cursor_at_token(), token, weights_[numbers_ - 1]);
  tokens_[numbers_ - 1] = token;
  ++numbers_;
}

void ScenePointReader::end(ScenePoints& to) {
  if (numbers_ < 3) {
    places_.fail(ErrorCode::Syntax, "a point is [face, u, v]: too few numbers", places_.token());
  }
  with_place(places_.cursor_at_token(), [&] {
    context_.charge_memory(kBytesPerPoint + exact_bytes(weights_[0], weights_[1]), "the scene");
  });
  to.face.push_back(face_);
  to.place.push_back(place_);
  const auto any_has = [this](const char* characters) {
    return tokens_[0].find_first_of(characters) != std::string_view::npos ||
           tokens_[1].find_first_of(characters) != std::string_view::npos;
  };
  // A fraction means itself: a decimal beside it is rounded by itself, then, whatever it adds up
  // to.
  const bool is_fraction = any_has("/"), is_decimal = !exact_decimals_ && any_has(".eE");
  to.rounds.push_back(is_decimal && !is_fraction ? 1 : 0);
  if (weights_[0].is_double() && weights_[1].is_double()) {
    const double u = weights_[0].as_double(), v = weights_[1].as_double();
    if (u > kClear && v > kClear && u + v < 1 - kClear) {
      to.weights.push_back({u, v});
      return;
    }
  }
  std::array<Rational, 2> weights;
  for (std::size_t i = 0; i < 2; ++i) {
    // What the nearest double is zero of is zero, however small it is.
    const bool is_zero = weights_[i].is_double() && weights_[i].as_double() == 0;
    if (!is_fraction && !is_zero) {
      exact_.read(places_.cursor_at_token(), tokens_[i], weights_[i]);
    }
    weights[i] = weights_[i].exact();
  }
  add_near_side(weights, is_decimal, to);
}

/// On a side or near one: exactly as written, but for what decimals may be rounded to.
void ScenePointReader::add_near_side(const std::array<Rational, 2>& weights, bool is_decimal,
                                     ScenePoints& to) {
  auto [u, v] = weights;
  const Rational rest = 1 - u - v;
  if (u < -tiny() || v < -tiny() || rest < -tiny()) {
    places_.fail(ErrorCode::BadShape, "a point outside its face: u, v and 1 - u - v are weights",
                 text_ + place_);
  }
  if (u < 0) u = 0;
  if (v < 0) v = 0;
  if (u + v > 1 || (is_decimal && rest <= tiny())) {
    u = u > 1 ? Rational(1) : u;
    v = 1 - u;
  }
  if (to.rounds.back() != 0 && u > 0 && v > 0 && u + v < 1) {
    const double x = nearest_double(u), y = nearest_double(v);
    if (x > 0 && y > 0 && exact_rational(x) + exact_rational(y) < 1) {
      to.weights.push_back({x, y});
      return;
    }
  }
  to.weights.push_back(u, v);
}

}  // namespace plumb
