// Does a JSON value fit a schema? The part of JSON Schema (2020-12) that docs/schema uses; a
// keyword beyond it is reported, so that none is taken for checked.
#pragma once

#include <algorithm>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <string>

namespace plumb::testing {

class JsonSchema {
 public:
  explicit JsonSchema(nlohmann::json root) : root_(std::move(root)) {}

  /// Empty if `value` fits; else where it does not and why.
  std::string misfit(const nlohmann::json& value) const { return misfit(value, root_, "$"); }

 private:
  using Json = nlohmann::json;

  std::string misfit(const Json& value, const Json& schema, const std::string& at) const {
    static const std::set<std::string> kComments{"$schema", "$defs", "title", "description"};
    for (const auto& [keyword, rule] : schema.items()) {
      if (kComments.contains(keyword)) continue;
      std::string found = misfit_of(keyword, value, rule, schema, at);
      if (!found.empty()) return found;
    }
    return {};
  }

  std::string misfit_of(const std::string& keyword, const Json& value, const Json& rule,
                        const Json& schema, const std::string& at) const {
    const auto unless = [&](bool is_fit) { return is_fit ? "" : at + ": " + keyword; };
    if (keyword == "$ref") return misfit(value, target(rule), at);
    if (keyword == "type") return unless(has_type(value, rule));
    if (keyword == "enum") return unless(std::find(rule.begin(), rule.end(), value) != rule.end());
    if (keyword == "const") return unless(value == rule);
    if (keyword == "oneOf") {
      return unless(std::count_if(rule.begin(), rule.end(), [&](const Json& one) {
                      return misfit(value, one, at).empty();
                    }) == 1);
    }
    if (keyword == "minimum") return unless(!value.is_number() || value >= rule);
    if (keyword == "minItems") return unless(!value.is_array() || value.size() >= rule);
    if (keyword == "maxItems") return unless(!value.is_array() || value.size() <= rule);
    if (keyword == "pattern") {
      return unless(!value.is_string() || matches(value.get<std::string>(), rule));
    }
    if (keyword == "required") {
      for (const Json& name : rule) {
        if (!value.contains(name.get<std::string>())) return at + ": lacks " + name.dump();
      }
      return {};
    }
    if (keyword == "items") return misfit_of_items(value, rule, at);
    if (keyword == "properties") return misfit_of_members(value, rule, at);
    if (keyword == "additionalProperties" && rule == false) {
      for (const auto& [name, member] : value.items()) {
        if (!schema.at("properties").contains(name)) return at + ": has " + name;
      }
      return {};
    }
    return "the schema says '" + keyword + "', which this checker does not know";
  }

  std::string misfit_of_items(const Json& value, const Json& rule, const std::string& at) const {
    std::string found;
    for (std::size_t i = 0; value.is_array() && i < value.size() && found.empty(); ++i) {
      found = misfit(value[i], rule, at + '[' + std::to_string(i) + ']');
    }
    return found;
  }

  std::string misfit_of_members(const Json& value, const Json& rule, const std::string& at) const {
    std::string found;
    for (const auto& [name, schema] : rule.items()) {
      if (!found.empty() || !value.is_object() || !value.contains(name)) continue;
      found = misfit(value[name], schema, at + '.' + name);
    }
    return found;
  }

  /// Only of this document: "#/$defs/NAME".
  const Json& target(const Json& reference) const {
    return root_.at(Json::json_pointer(reference.get<std::string>().substr(1)));
  }

  static bool has_type(const Json& value, const std::string& type) {
    return (type == "object" && value.is_object()) || (type == "array" && value.is_array()) ||
           (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
           (type == "null" && value.is_null()) || (type == "number" && value.is_number()) ||
           (type == "integer" && value.is_number_integer());
  }

  /// std::regex recurses at every character: it is not asked about numbers of thousands of digits.
  static bool matches(const std::string& text, const std::string& pattern) {
    constexpr std::size_t kLongest = 4096;
    return text.size() > kLongest || std::regex_search(text, std::regex(pattern));
  }

  Json root_;
};

}  // namespace plumb::testing
