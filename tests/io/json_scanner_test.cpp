// JsonScanner against the events and the tree that the JSON library makes of the same text.
#include "plumb/io/text/json_scanner.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "plumb/testing/dice.h"

namespace plumb::json_scanner_test {
namespace {

using Json = nlohmann::json;
using testing::Dice;
using Tokens = std::vector<std::pair<JsonToken, std::string>>;

/// A number as the library writes it.
std::string written(std::string_view number) {
  return Json::accept(number) ? Json::parse(number).dump() : std::string(number);
}

/// The tokens of a text, with names, strings and words.
Tokens scanned(const std::string& text) {
  Context context;
  JsonScanner scanner(text, "some.file", context);
  Tokens tokens;
  for (JsonToken token = scanner.next(); token != JsonToken::End; token = scanner.next()) {
    const bool is_quoted = token == JsonToken::Name || token == JsonToken::String;
    const std::string_view text_of_token = is_quoted ? scanner.string_text() : scanner.token_text();
    tokens.emplace_back(
        token, token == JsonToken::Number ? written(text_of_token) : std::string(text_of_token));
  }
  return tokens;
}

/// The same tokens as the library reports them; numbers as it writes them.
class Listener : public nlohmann::json_sax<Json> {
 public:
  Tokens tokens;

  bool null() override { return add(JsonToken::Null, "null"); }
  bool boolean(bool value) override { return add(JsonToken::Word, value ? "true" : "false"); }
  bool number_integer(number_integer_t value) override { return add_number(value); }
  bool number_unsigned(number_unsigned_t value) override { return add_number(value); }
  bool number_float(number_float_t value, const string_t&) override { return add_number(value); }
  bool string(string_t& value) override { return add(JsonToken::String, value); }
  bool key(string_t& value) override { return add(JsonToken::Name, value); }
  bool binary(binary_t&) override { return false; }
  bool start_object(std::size_t) override { return add(JsonToken::BeginObject, "{"); }
  bool end_object() override { return add(JsonToken::EndObject, "}"); }
  bool start_array(std::size_t) override { return add(JsonToken::BeginArray, "["); }
  bool end_array() override { return add(JsonToken::EndArray, "]"); }
  bool parse_error(std::size_t, const std::string&, const Json::exception&) override {
    return false;
  }

 private:
  bool add(JsonToken token, std::string text) {
    tokens.emplace_back(token, std::move(text));
    return true;
  }
  template <class Number>
  bool add_number(Number value) {
    return add(JsonToken::Number, Json(value).dump());
  }
};

Json random_json(Dice& dice, int depth) {
  static const std::vector<Json> kLeaves{nullptr,  true,       false,  0,     -7,   1.5,
                                         1e300,    "",         "a b",  "\"",  "\\", "\\\"]",
                                         "{[:,]}", "\xC3\xA9", "\t\n", "null"};
  const auto leaves = static_cast<int>(kLeaves.size());
  const auto kind = dice.between(0, depth > 0 ? 3 : 1);
  if (kind < 2) return kLeaves[static_cast<std::size_t>(dice.between(0, leaves - 1))];
  Json value = kind == 2 ? Json::array() : Json::object();
  for (auto i = dice.between(0, 4); i > 0; --i) {
    Json item = random_json(dice, depth - 1);
    if (kind == 2) {
      value.push_back(std::move(item));
    } else {
      value["\"\\" + std::to_string(i)] = std::move(item);
    }
  }
  return value;
}

TEST(JsonScanner, finds_the_tokens_that_the_library_finds) {
  Dice dice(7);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 4000 && !::testing::Test::HasFailure(); ++i) {
    std::string text = random_json(dice, 5).dump(static_cast<int>(dice.between(-1, 2)));
    if (dice.between(0, 1) == 0) {
      const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(text.size()) - 1));
      text[at] = "{}[],:\"1\\"[dice.between(0, 8)];
    }
    SCOPED_TRACE(text);
    Listener listener;
    const bool is_json = Json::sax_parse(text, &listener);
    (is_json ? accepted : refused) += 1;
    try {
      const Tokens tokens = scanned(text);
      if (is_json) {
        EXPECT_EQ(tokens, listener.tokens);
      }
    } catch (const Error& error) {
      EXPECT_FALSE(is_json) << error.what();
      EXPECT_EQ(error.code(), ErrorCode::Syntax);
      EXPECT_TRUE(error.message().starts_with("not JSON: ")) << error.what();
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 500);
}

TEST(JsonScanner, skips_exactly_the_value_of_a_name) {
  Dice dice(8);
  Context context;
  for (int i = 0; i < 1000 && !::testing::Test::HasFailure(); ++i) {
    Json tree = Json::object();
    for (int member = 0; member < 3; ++member) {
      tree[std::to_string(member)] = random_json(dice, 4);
    }
    const std::string text = tree.dump(static_cast<int>(dice.between(-1, 2)));
    SCOPED_TRACE(text);
    JsonScanner scanner(text, "some.file", context);
    ASSERT_EQ(scanner.next(), JsonToken::BeginObject);
    for (int member = 0; member < 3; ++member) {
      ASSERT_EQ(scanner.next(), JsonToken::Name);
      const std::string name(scanner.string_text());
      EXPECT_EQ(Json::parse(scanner.skip_value()), tree[name]);
    }
    EXPECT_EQ(scanner.next(), JsonToken::EndObject);
    EXPECT_EQ(scanner.next(), JsonToken::End);
  }
}

TEST(JsonScanner, finds_the_values_of_a_sequence) {
  const Tokens one = scanned(R"({"a":[1]})");
  for (const std::string between : {"", " ", "\n", "\r\n\r\n", "\n\x1e", "\x1e\x1e\n"}) {
    const Tokens two = scanned(R"({"a":[1]})" + between + R"({"a":[1]})" + between);
    ASSERT_EQ(two.size(), 2 * one.size()) << between;
    for (std::size_t i = 0; i < two.size(); ++i) EXPECT_EQ(two[i], one[i % one.size()]) << between;
  }
}

TEST(JsonScanner, stops_when_it_is_told_to) {
  std::stop_source source;
  source.request_stop();
  Context context({}, source.get_token());
  const std::string text = R"({"a":[[[[1]]]]})";
  JsonScanner scanner(text, "some.file", context);
  EXPECT_THROW(scanner.next(), Error);
}

}  // namespace
}  // namespace plumb::json_scanner_test
