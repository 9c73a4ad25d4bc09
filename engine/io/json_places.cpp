#include "plumb/io/json_places.h"

#include <utility>

#include "plumb/base/error.h"

namespace plumb {
namespace {

constexpr std::size_t kTokensPerCheckpoint = 4096;

}  // namespace

JsonPlaces::JsonPlaces(std::string_view text, std::string name, Context& context)
    : text_(text),
      name_(std::move(name)),
      cursor_(text, name_),
      context_(context),
      read_to_(cursor_.position()),
      token_end_(cursor_.position()) {}

void JsonPlaces::find_token() {
  constexpr std::string_view kBetween = " \t\r\n,:";
  token_ =
      std::find_if(token_end_, read_to_, [&](char c) { return kBetween.find(c) == kBetween.npos; });
  token_end_ = read_to_;
  if (tokens_++ % kTokensPerCheckpoint == 0) {
    context_.checkpoint("read", static_cast<std::size_t>(token_ - text_.data()), text_.size());
  }
}

void JsonPlaces::find_number() {
  constexpr std::string_view kNumber = "+-.0123456789Ee";
  find_token();
  token_end_ =
      std::find_if(token_, read_to_, [&](char c) { return kNumber.find(c) == kNumber.npos; });
}

const char* JsonPlaces::early_end() const {
  constexpr std::string_view kNothing(" \t\r\n\0", 5);
  const std::string_view rest = text_.substr(static_cast<std::size_t>(read_to_ - text_.data()));
  return rest.find_first_not_of(kNothing) == rest.npos ? nullptr : read_to_ - 1;
}

void JsonPlaces::require_end() const {
  if (const char* const at = early_end()) fail(ErrorCode::Syntax, "not JSON: byte 0x00", at);
}

void JsonPlaces::fail(ErrorCode code, const std::string& message, const char* where) const {
  TextCursor cursor(text_, name_);
  if (where > cursor.position()) cursor.move_to(where);
  cursor.fail(code, message);
}

void JsonPlaces::fail_syntax(std::size_t position, int id, std::string_view what) const {
  constexpr int kOverflow = 406;
  const std::size_t last = std::min(position - std::min<std::size_t>(position, 1), text_.size());
  if (id == kOverflow) {
    fail(ErrorCode::NumberOutOfRange, "a number too large to be read", text_.data() + last);
  }
  // "[..] parse error at line 1, column 2: syntax error while parsing value - WHY; last read: '..';
  // expected .."
  const std::size_t start = what.find(" - ");
  std::string why(what.substr(start == what.npos ? 0 : start + 3));
  if (const std::size_t read = why.find("; last read: '"); read != why.npos) {
    const std::size_t end = why.rfind("'; expected");
    why.erase(read, end == why.npos ? end : end + 1 - read);
  }
  fail(ErrorCode::Syntax, "not JSON: " + why, text_.data() + last);
}

}  // namespace plumb
