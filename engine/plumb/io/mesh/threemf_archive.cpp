// Calls of libzip.
//
// The library reads from and writes to memory. It checks offsets and sizes of the directory against
// the archive, and the checksum of an entry at its end. An entry may claim any size.
// Handle::count_bytes() counts the bytes that come out, and bounds them by the size of the archive.
// So a small archive cannot keep a reader busy for long. The library keeps a record of each entry,
// which is charged when the archive has been opened.
//
// Without PLUMB_WITH_3MF this file has only the messages of its errors.
// Tested by tests/io/threemf_test.cpp.
#include "plumb/io/mesh/threemf_archive.h"

#include <array>
#include <ostream>

#include "plumb/predicates/error.h"

#ifdef PLUMB_WITH_3MF
#include <zip.h>
#endif

namespace plumb {

#ifdef PLUMB_WITH_3MF

namespace {

constexpr std::uint64_t kRatio = 256;
constexpr std::uint64_t kAlwaysRead = std::uint64_t{64} << 20U;
constexpr std::uint64_t kEntryBytes = 512;  // The memory of a record of libzip and its name.

std::string reason_of(zip_error_t* error) {
  std::string text = zip_error_strerror(error);
  zip_error_fini(error);
  return text;
}

[[noreturn]] void fail_archive(ErrorCode code, const std::string& reason) {
  throw Error(code, "the ZIP archive: " + reason);
}

/// Closes an entry when its reading ends or fails.
struct EntryCloser {
  void operator()(zip_file_t* file) const { zip_fclose(file); }
};
using OpenEntry = std::unique_ptr<zip_file_t, EntryCloser>;

}  // namespace

bool has_threemf() { return true; }

struct ZipArchive::Handle {
  Handle(std::uint64_t bytes, Context& c) : archive_bytes(bytes), context(c), charge(c) {}
  Handle(const Handle&) = delete;
  Handle& operator=(const Handle&) = delete;
  ~Handle() {
    if (zip != nullptr) zip_discard(zip);
  }

  void count_bytes(std::size_t bytes) {
    bytes_out += bytes;
    context.checkpoint("read", bytes_out, 0);
    if (bytes_out <= kAlwaysRead || bytes_out / kRatio <= archive_bytes) return;
    throw Error(ErrorCode::ResourceLimit,
                "the archive holds more than " + std::to_string(kRatio) + " times its own size");
  }

  zip_t* zip = nullptr;
  std::uint64_t archive_bytes;
  std::uint64_t bytes_out = 0;
  Context& context;
  MemoryCharge charge;
};

ZipArchive::ZipArchive(std::string_view bytes, Context& context)
    : handle_(std::make_unique<Handle>(bytes.size(), context)) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* const source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  if (source == nullptr) fail_archive(ErrorCode::UnknownFormat, reason_of(&error));
  handle_->zip = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (handle_->zip == nullptr) {
    zip_source_free(source);
    fail_archive(ErrorCode::UnknownFormat, reason_of(&error));
  }
  zip_error_fini(&error);
  const auto entries = static_cast<std::uint64_t>(zip_get_num_entries(handle_->zip, 0));
  handle_->charge.add(entries * kEntryBytes, "the directory of the archive");
}

ZipArchive::~ZipArchive() = default;

std::vector<std::string> ZipArchive::names() const {
  std::vector<std::string> all;
  const auto entries = static_cast<std::uint64_t>(zip_get_num_entries(handle_->zip, 0));
  all.reserve(entries);
  for (std::uint64_t i = 0; i < entries; ++i) {
    const char* const name = zip_get_name(handle_->zip, i, 0);
    if (name != nullptr) all.emplace_back(name);
  }
  return all;
}

std::optional<std::uint64_t> ZipArchive::find(const std::string& name) const {
  for (const zip_flags_t flags : {zip_flags_t{0}, zip_flags_t{ZIP_FL_NOCASE}}) {
    const zip_int64_t found = zip_name_locate(handle_->zip, name.c_str(), flags);
    if (found >= 0) return static_cast<std::uint64_t>(found);
  }
  return {};
}

void ZipArchive::read(std::uint64_t entry, const std::function<void(std::string_view)>& take) {
  constexpr std::size_t kBlock = std::size_t{1} << 16U;
  const OpenEntry file(zip_fopen_index(handle_->zip, entry, 0));
  if (file == nullptr) fail_archive(ErrorCode::UnknownFormat, zip_strerror(handle_->zip));
  std::vector<char> block(kBlock);
  for (;;) {
    const zip_int64_t bytes = zip_fread(file.get(), block.data(), block.size());
    if (bytes < 0) fail_archive(ErrorCode::Syntax, zip_file_strerror(file.get()));
    if (bytes == 0) return;
    handle_->count_bytes(static_cast<std::size_t>(bytes));
    take({block.data(), static_cast<std::size_t>(bytes)});
  }
}

namespace {

/// An archive that is being written to memory.
class ZipWriter {
 public:
  ZipWriter() {
    zip_error_t error;
    zip_error_init(&error);
    source_ = zip_source_buffer_create(nullptr, 0, 0, &error);
    zip_ = source_ == nullptr ? nullptr : zip_open_from_source(source_, ZIP_TRUNCATE, &error);
    if (zip_ == nullptr) {
      if (source_ != nullptr) zip_source_free(source_);
      fail_archive(ErrorCode::CannotWrite, reason_of(&error));
    }
    zip_error_fini(&error);
    zip_source_keep(source_);  // zip_close() releases its own reference.
  }
  ~ZipWriter() {
    if (zip_ != nullptr) zip_discard(zip_);
    zip_source_free(source_);
  }
  ZipWriter(const ZipWriter&) = delete;
  ZipWriter& operator=(const ZipWriter&) = delete;

  void add(const ZipEntry& entry) {
    // 1980-01-01 00:00, the first time that an archive can state.
    constexpr zip_uint16_t kNoTime = 0, kFirstDate = (1U << 5U) + 1;
    zip_source_t* const data = zip_source_buffer(zip_, entry.data.data(), entry.data.size(), 0);
    const zip_int64_t added =
        data == nullptr ? -1 : zip_file_add(zip_, entry.name.c_str(), data, ZIP_FL_ENC_UTF_8);
    if (added < 0 && data != nullptr) zip_source_free(data);
    if (added < 0) fail_archive(ErrorCode::CannotWrite, zip_strerror(zip_));
    const auto index = static_cast<zip_uint64_t>(added);
    zip_set_file_compression(zip_, index, ZIP_CM_DEFLATE, 6);
    zip_file_set_dostime(zip_, index, kNoTime, kFirstDate, 0);
  }

  void finish(std::ostream& out) {
    if (zip_close(zip_) != 0) fail_archive(ErrorCode::CannotWrite, zip_strerror(zip_));
    zip_ = nullptr;
    if (zip_source_open(source_) != 0) fail_source();
    std::array<char, std::size_t{1} << 14U> block{};
    zip_int64_t bytes = 0;
    while ((bytes = zip_source_read(source_, block.data(), block.size())) > 0) {
      out.write(block.data(), bytes);
    }
    zip_source_close(source_);
    if (bytes < 0) fail_source();
  }

 private:
  [[noreturn]] void fail_source() {
    fail_archive(ErrorCode::CannotWrite, zip_error_strerror(zip_source_error(source_)));
  }

  zip_source_t* source_ = nullptr;
  zip_t* zip_ = nullptr;
};

}  // namespace

void write_zip(std::ostream& out, std::span<const ZipEntry> entries) {
  ZipWriter writer;
  for (const ZipEntry& entry : entries) writer.add(entry);
  writer.finish(out);
}

#else

namespace {

[[noreturn]] void refuse_without_libraries() {
  throw Error(ErrorCode::UnknownFormat,
              "3MF needs libzip and expat; install libzip-dev and libexpat1-dev and build plumb "
              "again");
}

}  // namespace

bool has_threemf() { return false; }

struct ZipArchive::Handle {};

ZipArchive::ZipArchive(std::string_view /*bytes*/, Context& /*context*/) {
  refuse_without_libraries();
}
ZipArchive::~ZipArchive() = default;
std::vector<std::string> ZipArchive::names() const { return {}; }
std::optional<std::uint64_t> ZipArchive::find(const std::string& /*name*/) const { return {}; }
void ZipArchive::read(std::uint64_t /*entry*/,
                      const std::function<void(std::string_view)>& /*take*/) {}
void write_zip(std::ostream& /*out*/, std::span<const ZipEntry> /*entries*/) {
  refuse_without_libraries();
}

#endif

}  // namespace plumb
