// Calls of libpng.
//
// The library reports errors by longjmp(), so the functions that call it after setjmp() have no
// objects with destructors. All images are expanded to three bytes for each pixel, as in OpenSCAD.
// Of 16 bits, the lower eight bits are dropped, and so is opacity.
//
// Without PLUMB_WITH_PNG this file has only the message of its error.
// Tested by tests/io/surface_file_test.cpp.
#include "plumb/io/csg/height_image.h"

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <vector>

#include "plumb/predicates/error.h"

#ifdef PLUMB_WITH_PNG
#include <png.h>
#endif

namespace plumb {

bool is_png(std::string_view bytes) { return bytes.starts_with("\x89PNG\r\n\x1a\n"); }

#ifdef PLUMB_WITH_PNG

namespace {

/// An image that is read from memory.
class PngImage {
 public:
  explicit PngImage(std::string_view bytes) : rest_(bytes) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, &keep_message, &ignore_warning);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;
  ~PngImage() { png_destroy_read_struct(&png_, &info_, nullptr); }

  /// Reads what precedes the pixels. Returns false if there is an error.
  bool begin() {
    if (info_ == nullptr) return false;
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_set_read_fn(png_, this, &take_bytes);
    png_read_info(png_, info_);
    png_set_expand(png_);
    png_set_strip_16(png_);
    png_set_gray_to_rgb(png_);
    png_set_strip_alpha(png_);
    passes_ = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return true;
  }
  /// Reads the next `count` rows of a pass to `rows`. Returns false if there is an error.
  bool read_rows(png_bytepp rows, std::size_t count) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    png_read_rows(png_, rows, nullptr, static_cast<png_uint_32>(count));
    return true;
  }

  std::size_t width() const { return png_get_image_width(png_, info_); }
  std::size_t height() const { return png_get_image_height(png_, info_); }
  /// Returns how many times all rows have to be read; several times if the image is interlaced.
  int passes() const { return passes_; }
  std::size_t row_bytes() const { return png_get_rowbytes(png_, info_); }
  std::string message() const { return message_.data(); }

 private:
  [[noreturn]] static void keep_message(png_structp png, png_const_charp message) {
    auto* const image = static_cast<PngImage*>(png_get_error_ptr(png));
    std::strncpy(image->message_.data(), message, image->message_.size() - 1);
    png_longjmp(png, 1);
  }
  static void ignore_warning(png_structp, png_const_charp) {}
  static void take_bytes(png_structp png, png_bytep to, std::size_t count) {
    auto* const image = static_cast<PngImage*>(png_get_io_ptr(png));
    if (image->rest_.size() < count) png_error(png, "the file ends early");
    std::memcpy(to, image->rest_.data(), count);
    image->rest_.remove_prefix(count);
  }

  std::string_view rest_;
  std::array<char, 128> message_{};
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int passes_ = 1;
};

/// Reads all rows of an image. Returns false if there is an error.
bool read_pixels(PngImage& image, std::vector<png_bytep>& rows, Context& context) {
  constexpr std::size_t kBytesPerCheckpoint = std::size_t{1} << 20U;
  const std::size_t step = std::max<std::size_t>(1, kBytesPerCheckpoint / image.row_bytes());
  for (int pass = 0; pass < image.passes(); ++pass) {
    for (std::size_t row = 0; row < rows.size(); row += step) {
      context.checkpoint("read", row, rows.size());
      if (!image.read_rows(&rows[row], std::min(step, rows.size() - row))) return false;
    }
  }
  return true;
}

HeightGrid heights_of(const std::vector<png_byte>& pixels, std::size_t rows, std::size_t columns,
                      bool is_inverted) {
  HeightGrid grid;
  grid.rows = rows;
  grid.columns = columns;
  grid.heights.resize(rows * columns);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      const png_byte* const p = &pixels[3 * (row * columns + column)];
      const double value = 0.2126 * p[0] + 0.7152 * p[1] + 0.0722 * p[2];
      grid.heights[(rows - 1 - row) * columns + column] =
          100.0 / 255 * (is_inverted ? 1 - value : value);
    }
  }
  return grid;
}

}  // namespace

HeightGrid read_height_image(std::string_view bytes, const std::string& name, bool is_inverted,
                             MemoryCharge& charge, Context& context) {
  PngImage image(bytes);
  const auto fail = [&](ErrorCode code, const std::string& message) {
    throw Error(code, "the image " + message, {name, 1, 1});
  };
  if (!image.begin()) fail(ErrorCode::BadShape, "cannot be read: " + image.message());
  const std::size_t rows = image.height(), columns = image.width();
  if (rows > kMostHeights / columns) {
    fail(ErrorCode::ResourceLimit, "has more than 2^24 pixels");
  }
  require_room_for_solid(rows, columns, context);
  constexpr std::uint64_t kPixelBytes = 3 + sizeof(double);
  charge.add(rows * (columns * kPixelBytes + sizeof(png_bytep)), "a surface");
  if (image.row_bytes() != 3 * columns) fail(ErrorCode::BadShape, "has pixels of an unknown kind");
  std::vector<png_byte> pixels(3 * rows * columns);
  std::vector<png_bytep> starts(rows);
  for (std::size_t row = 0; row < rows; ++row) starts[row] = &pixels[3 * row * columns];
  if (!read_pixels(image, starts, context))
    fail(ErrorCode::BadShape, "cannot be read: " + image.message());
  return heights_of(pixels, rows, columns, is_inverted);
}

#else

HeightGrid read_height_image(std::string_view, const std::string& name, bool, MemoryCharge&,
                             Context&) {
  throw Error(ErrorCode::UnknownFormat,
              "images are not read, because plumb was built without libpng", {name, 1, 1});
}

#endif

}  // namespace plumb
