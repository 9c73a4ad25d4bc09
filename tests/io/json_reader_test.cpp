// JsonValues against the tree that the JSON library makes of the same text.
#include "plumb/io/text/json_reader.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "plumb/io/text/lenient_json.h"
#include "plumb/predicates/error.h"
#include "plumb/testing/dice.h"

namespace plumb::json_reader_test {
namespace {

using Json = nlohmann::json;
using testing::Dice;

std::string random_text(Dice& dice) {
  static const std::string kBytes = "ab\"\\\n\t{}[],:";
  std::string text;
  for (auto i = dice.between(0, 5); i > 0; --i) {
    text += kBytes[static_cast<std::size_t>(dice.between(0, static_cast<int>(kBytes.size()) - 1))];
  }
  return text;
}

Json random_json(Dice& dice, int depth) {
  switch (dice.between(0, depth > 0 ? 7 : 5)) {
    case 0:
      return nullptr;
    case 1:
      return dice.between(0, 1) == 0;
    case 2:
      return dice.between(-1000, 1000);
    case 3:
      return static_cast<double>(dice.between(-100000, 100000)) / 7;
    case 4:
      return 1ULL << dice.between(0, 63);
    case 5:
      return random_text(dice);
    case 6: {
      Json list = Json::array();
      for (auto i = dice.between(0, 4); i > 0; --i) list.push_back(random_json(dice, depth - 1));
      return list;
    }
    default: {
      Json object = Json::object();
      for (auto i = dice.between(0, 4); i > 0; --i) {
        object[random_text(dice)] = random_json(dice, depth - 1);
      }
      return object;
    }
  }
}

void fail_at(std::size_t byte, ErrorCode code, const std::string& what) {
  throw Error(code, "at " + std::to_string(byte) + ": " + what);
}

void expect_same(const JsonValues& values, JsonValues::Id id, const Json& tree) {
  EXPECT_EQ(values.is_object(id), tree.is_object());
  EXPECT_EQ(values.is_list(id), tree.is_array());
  EXPECT_EQ(values.is_text(id), tree.is_string());
  ASSERT_EQ(values.is_number(id), tree.is_number());
  EXPECT_EQ(values.count(id).has_value(), tree.is_number_unsigned());
  if (tree.is_number_unsigned()) {
    EXPECT_EQ(values.count(id), tree.get<std::uint64_t>());
  }
  if (tree.is_number()) {
    EXPECT_EQ(values.number(id), tree.get<double>());
  }
  if (tree.is_string()) {
    const auto text = tree.get<std::string>();
    EXPECT_EQ(values.text(id), text);
    EXPECT_EQ(values.plain_text(id).value_or(text), text);
  }
  if (tree.is_array()) {
    ASSERT_EQ(values.items(id).size(), tree.size());
    std::size_t i = 0;
    for (const JsonValues::Id item : values.items(id)) expect_same(values, item, tree[i++]);
  }
  if (!tree.is_object()) return;
  EXPECT_FALSE(values.find(id, "not there"));
  for (const auto& [name, member] : tree.items()) {
    const auto found = values.find(id, name);
    ASSERT_TRUE(found) << name;
    expect_same(values, *found, member);
  }
}

TEST(JsonValues, SayWhatTheTreeSays) {
  Dice dice(3);
  Context context;
  int accepted = 0, refused = 0;
  for (int i = 0; i < 3000 && !::testing::Test::HasFailure(); ++i) {
    std::string text = random_json(dice, 5).dump(static_cast<int>(dice.between(-1, 2)));
    if (dice.between(0, 1) == 0) {
      const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(text.size()) - 1));
      text[at] = "{}[],:\"1a"[dice.between(0, 8)];
    }
    SCOPED_TRACE(text);
    if (Json::accept(text)) {
      expect_same(JsonValues(text, "file", fail_at, context), 0, Json::parse(text));
      ++accepted;
    } else {
      EXPECT_THROW(JsonValues(text, "file", fail_at, context), Error);
      ++refused;
    }
  }
  EXPECT_GT(accepted, 1000);
  EXPECT_GT(refused, 500);
}

/// Whether JsonValues reads a text.
bool is_read(const std::string& text) {
  Context context;
  try {
    const JsonValues values(text, "a.json", fail_at, context);
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(JsonValues, ReadsATextIfAndOnlyIfTheLibraryDoes) {
  static const std::string kBytes =
      "0123456789+-.eE\"\\/u{}[],: \t\r\ntrufalsn\x01\x7f\xc3\xa9\xed";
  std::size_t read = 0;
  constexpr std::uint64_t kTexts = 4000;
  for (std::uint64_t seed = 0; seed < kTexts; ++seed) {
    Dice dice(seed);
    std::string text = random_json(dice, 4).dump(static_cast<int>(dice.between(-1, 1)), ' ',
                                                 dice.between(0, 1) == 0);
    for (auto i = dice.between(0, 3); i > 0; --i) {
      const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(text.size())));
      const char byte =
          kBytes[static_cast<std::size_t>(dice.between(0, static_cast<int>(kBytes.size()) - 1))];
      if (dice.between(0, 1) == 0 && at < text.size()) {
        text[at] = byte;
      } else {
        text.insert(at, 1, byte);
      }
    }
    EXPECT_EQ(is_read(text), Json::accept(text)) << text;
    read += is_read(text) ? 1 : 0;
  }
  EXPECT_GT(read, kTexts / 8);
  EXPECT_LT(read, kTexts * 7 / 8);
}

TEST(JsonValues, ReadsEscapesAndCharactersAsTheLibraryDoes) {
  for (const char* const text : {R"("\u00e9")",
                                 R"("\ud83d\ude00")",
                                 R"("\ud83d")",
                                 R"("\ude00")",
                                 R"("\u12")",
                                 R"("\x")",
                                 R"("\"\\\/\b\f\n\r\t")",
                                 "\"\xc3\xa9\"",
                                 "\"\xc3\"",
                                 "\"\xed\xa0\x80\"",
                                 "\"\xf0\x9f\x98\x80\"",
                                 "1e99",
                                 "1e308",
                                 "1e309",
                                 "1e-400",
                                 "-0",
                                 "01",
                                 "1.",
                                 ".5",
                                 "+1",
                                 "-",
                                 "1e",
                                 "\"",
                                 "[",
                                 "{",
                                 "[1,]",
                                 "{\"a\":1,}",
                                 "{\"a\"}",
                                 "{1:2}",
                                 "[1 2]",
                                 "[]]",
                                 "",
                                 " ",
                                 "nul",
                                 "nulls",
                                 "[1}"}) {
    EXPECT_EQ(is_read(text), Json::accept(text)) << text;
  }
}

TEST(JsonValues, ReadsEveryKindOfNumber) {
  Context context;
  for (const std::string text :
       {"0", "-0", "-1", "1e3", "1E-3", "1.5", "18446744073709551615", "18446744073709551616",
        "1e-400", "4e-324", "123456789012345678901234567890"}) {
    expect_same(JsonValues(text, "file", fail_at, context), 0, Json::parse(text));
  }
  EXPECT_THROW(JsonValues("1e999", "file", fail_at, context), Error);
}

TEST(JsonValues, FindsTheLastOfMembersOfOneNameWhateverItsSpelling) {
  Context context;
  const JsonValues values(R"({"a": 1, "b": [2, {"a": 3}], "\u0061": 4})", "file", fail_at, context);
  EXPECT_EQ(values.count(*values.find(0, "a")), 4U);
}

TEST(JsonValues, TakesNoMoreThanJsonOfThatSizeNeeds) {
  Limits limits;
  for (const std::string unit : {"[", "{", "[{", ",", "[,", R"({"":)", "0,", "]["}) {
    std::string text;
    while (text.size() < 10000) text += unit;
    limits.max_memory_bytes = 8 * (text.size() / 2 + 1) + 5 * text.size();
    Context context(limits);
    try {
      JsonValues(text, "file", fail_at, context);
      ADD_FAILURE() << unit;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::Syntax) << unit;
    }
  }
}

/// 8 bytes for a value; if the library parses the text, 5 for a byte while it does.
TEST(JsonValues, ChargesWhatItTakes) {
  for (const std::string first : {"0", R"("\ud83d\ude00")"}) {
    std::string text = "[" + first;
    for (int i = 0; i < 10000; ++i) text += ",0";
    text += "]";
    Limits limits;
    limits.max_memory_bytes = 8 * 10002 + (first == "0" ? 0 : 5 * text.size());
    Context enough(limits);
    EXPECT_EQ(JsonValues(text, "file", fail_at, enough).items(0).size(), 10001U);
    --limits.max_memory_bytes;
    Context little(limits);
    EXPECT_THROW(JsonValues(text, "file", fail_at, little), Error);
  }
}

TEST(LenientJson, replaces_what_is_not_json) {
  const auto read = [](const std::string& text) {
    Context context;
    const LenientJson json(text, "some.file", fail_at, context);
    return std::string(json.values().source(JsonValues::kDocument));
  };
  for (const auto& [text, expected] : std::vector<std::pair<std::string, std::string>>{
           {"[1, NaN]", "[1, null]"},
           {"[-inf,1.#QNAN,+Infinity,None]", "[null,null,null,null]"},
           {"[True,False,true]", "[true,false,true]"},
           {"[\"NaN\"]", "[\"NaN\"]"},
           {"[\"a\tb\"]", "[\"a\\u0009b\"]"},
           {"[\"caf\xE9\"]", "[\"caf\xEF\xBF\xBD\"]"},
           {"[\"caf\xC3\xA9\", nan]", "[\"caf\xC3\xA9\", null]"},
           {"[\"C:\\maps\\new\"]", "[\"C:\\\\maps\\new\"]"},
           {"[\"\\ud800\", \"\\ud83d\\ude00\"]", "[\"\xEF\xBF\xBD\", \"\\ud83d\\ude00\"]"},
           {"[\"\xED\xA0\x80\"]", "[\"\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\"]"}}) {
    EXPECT_EQ(read(text), expected);
  }
  // What is not JSON for another reason keeps its error, and places are those of the text.
  Context context;
  for (const std::string text : {"[NaN 1]", "{NaN:1}", "[\"\xE9\"", "[1,]", "// [1]"}) {
    std::string strict, lenient;
    try {
      const JsonValues values(text, "some.file", fail_at, context);
    } catch (const Error& error) {
      strict = error.message();
    }
    try {
      const LenientJson values(text, "some.file", fail_at, context);
    } catch (const Error& error) {
      lenient = error.message();
    }
    EXPECT_FALSE(strict.empty()) << text;
    EXPECT_EQ(lenient, strict) << text;
  }
  const std::string text = "[NaN, \"\xE9\", 7, inf, 8]";
  const LenientJson json(text, "some.file", fail_at, context);
  std::string found;
  for (const JsonValues::Id value : json.values().items(JsonValues::kDocument)) {
    found += text[json.byte(value)];
  }
  EXPECT_EQ(found, "N\"7i8");
  EXPECT_EQ(json.replaced().note(),
            "not JSON, replaced: words such as NaN by null (2), characters of texts (1)");
}

// A text with random bytes is read or refused, and what is read is JSON.
TEST(LenientJson, makes_json_of_random_texts) {
  Dice dice(71);
  std::size_t read = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string text = random_json(dice, 3).dump();
    for (auto changes = dice.between(1, 3); changes > 0; --changes) {
      const auto at = static_cast<std::size_t>(dice.between(0, static_cast<int>(text.size()) - 1));
      text[at] = static_cast<char>(dice.between(0, 255));
    }
    Context context;
    try {
      const LenientJson json(text, "some.file", fail_at, context);
      const std::string source(json.values().source(JsonValues::kDocument));
      EXPECT_TRUE(Json::accept(source)) << text;
      EXPECT_LT(json.byte(JsonValues::kDocument), text.size());
      ++read;
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == ErrorCode::Syntax || error.code() == ErrorCode::NumberOutOfRange)
          << text;
    }
  }
  EXPECT_GT(read, 300U);
}

}  // namespace
}  // namespace plumb::json_reader_test
