// Types and sizes of image files.
//
// PNG: the size is in the chunk IHDR, which comes first. JPEG: a file consists of segments, each
// with a marker and a length; the size is in the segment that starts a frame (SOF0 to SOF15,
// without DHT, JPG and DAC). Formats: PNG Specification (W3C), 11.2.2; ITU-T T.81, B.1 and B.2.
// Tested by tests/picture/space_scene_test.cpp.
#include "plumb/picture/texture_image.h"

#include <string_view>
#include <utility>

#include "plumb/predicates/error.h"

namespace plumb {
namespace {

struct ImageSize {
  std::uint32_t width;
  std::uint32_t height;
};

[[noreturn]] void fail(const std::string& what) { throw Error(ErrorCode::BadArgument, what); }

/// Returns `count` bytes at an offset as a number whose first byte is the highest.
std::uint32_t number_at(std::string_view bytes, std::size_t at, std::size_t count) {
  std::uint32_t number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    number = number << 8U | static_cast<unsigned char>(bytes[at + i]);
  }
  return number;
}

ImageSize size_of_png(std::string_view bytes) {
  constexpr std::size_t kName = 12, kWidth = 16, kHeight = 20, kEnd = 24;
  if (bytes.size() < kEnd || bytes.substr(kName, 4) != "IHDR") fail("it is a damaged PNG file");
  return {number_at(bytes, kWidth, 4), number_at(bytes, kHeight, 4)};
}

ImageSize size_of_jpeg(std::string_view bytes) {
  constexpr std::uint32_t kTables = 0xc4, kExtension = 0xc8, kArithmetic = 0xcc;
  constexpr std::size_t kHeight = 5, kWidth = 7, kFrame = 9;
  std::size_t at = 2;  // The position after the marker of the start.
  while (at + 4 <= bytes.size() && number_at(bytes, at, 1) == 0xff) {
    const std::uint32_t marker = number_at(bytes, at + 1, 1);
    if (marker == 0xff) {  // Fill bytes may precede a marker.
      ++at;
      continue;
    }
    const bool is_frame = marker >= 0xc0 && marker <= 0xcf && marker != kTables &&
                          marker != kExtension && marker != kArithmetic;
    if (is_frame && at + kFrame <= bytes.size()) {
      return {number_at(bytes, at + kWidth, 2), number_at(bytes, at + kHeight, 2)};
    }
    at += 2 + number_at(bytes, at + 2, 2);
  }
  fail("it is a damaged JPEG file");
}

}  // namespace

TextureImage texture_image(std::string bytes) {
  if (bytes.size() > TextureImage::kMostBytes) fail("it has more than 64 MiB");
  const std::string_view seen = bytes;
  const bool is_png = seen.starts_with("\x89PNG\r\n\x1a\n");
  if (!is_png && !seen.starts_with("\xff\xd8\xff")) fail("it is neither a PNG nor a JPEG file");
  const ImageSize size = is_png ? size_of_png(seen) : size_of_jpeg(seen);
  if (size.width == 0 || size.height == 0) fail("it has no pixels");
  if (size.width > TextureImage::kMostPixels || size.height > TextureImage::kMostPixels) {
    fail("it is wider or higher than 16384 pixels");
  }
  return {is_png ? "image/png" : "image/jpeg", std::move(bytes)};
}

}  // namespace plumb
