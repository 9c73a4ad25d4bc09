// Members of properties are lists of a name and a source: the piece of JSON that stands in the
// file. Names are compared with escapes resolved, and written as JSON again.
//
// Tested by tests/io/layer_properties_test.cpp.
#include "plumb/io/layer_properties.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "plumb/base/internal/message_text.h"
#include "plumb/io/layer_io.h"
#include "plumb/io/text/json_reader.h"
#include "plumb/io/text/text_output.h"
#include "plumb/predicates/arithmetic/rational_sum.h"
#include "plumb/predicates/error.h"
#include "plumb/predicates/rounding.h"

namespace plumb {
namespace {

constexpr std::size_t kFeaturesPerCheckpoint = 256;

/// A member of properties.
struct Member {
  std::string name;
  std::string_view source;
};
using Members = std::vector<Member>;

JsonValues values_of(std::string_view text, std::size_t feature, Context& context) {
  const std::string name = "feature " + std::to_string(feature + 1);
  return JsonValues(
      text, name,
      [name](std::size_t, ErrorCode code, const std::string& what) {
        throw Error(code, what, {name});
      },
      context);
}

/// Returns the properties of a feature. If a name occurs twice, its last value counts.
Members members_of(const Layer& layer, std::size_t feature, Context& context) {
  Members members;
  const std::string_view text = layer.properties(feature);
  if (text.empty()) return members;
  const JsonValues json = values_of(text, feature, context);
  if (!json.is_object(JsonValues::kDocument)) return members;
  std::unordered_map<std::string, std::size_t> at;
  bool is_name = true;
  std::string name;
  for (const JsonValues::Id value : json.items(JsonValues::kDocument)) {
    if (is_name) {
      name = json.text(value);
    } else {
      const auto [known, is_new] = at.try_emplace(name, members.size());
      if (is_new) {
        members.push_back({name, json.source(value)});
      } else {
        members[known->second].source = json.source(value);
      }
    }
    is_name = !is_name;
  }
  return members;
}

std::string as_json(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Returns a text that is equal for equal values.
std::string key_of(std::string_view source, std::size_t feature, Context& context) {
  if (source.empty() || source.front() != '"') return std::string(source);
  return '"' + values_of(source, feature, context).text(JsonValues::kDocument);
}

bool is_same_value(std::string_view a, std::string_view b, std::size_t feature, Context& context) {
  return a == b || key_of(a, feature, context) == key_of(b, feature, context);
}

/// Writes an object of members one by one.
class ObjectText {
 public:
  void add(const std::string& name, std::string_view source) {
    text_ += text_.empty() ? "{" : ",";
    text_ += as_json(name);
    text_ += ':';
    text_ += source;
  }
  std::string take() { return text_.empty() ? "{}" : std::move(text_) + '}'; }

 private:
  std::string text_;
};

/// Returns the layer without ids and properties.
Layer without_json(Layer layer) {
  layer.json.clear();
  layer.json_begin = {0};
  return layer;
}

/// Appends the texts of a feature. Their memory remains charged.
void append_json(Layer& layer, std::string_view id, std::string_view properties, Context& context) {
  constexpr std::uint64_t kOffsetBytes = 16;
  context.charge_memory(2 * (id.size() + properties.size()) + kOffsetBytes, "the properties");
  for (const std::string_view text : {id, properties}) {
    layer.json += text;
    layer.json_begin.push_back(layer.json.size());
  }
}

// ---------------------------------------------------------------- sums

/// The sum of numbers that are given as JSON.
class NumberSum {
 public:
  void add(std::string_view source) {
    has_number_ = true;
    if (source.find_first_of(".eE") == source.npos) {
      sum_.add(Rational(std::string(source)));
      return;
    }
    is_integer_ = false;
    sum_.add(Rational(nlohmann::json::parse(source).get<double>()));
  }
  std::string text() const {
    if (!has_number_) return "null";
    return is_integer_ ? format_exact(sum_.total()) : format_double(nearest_double(sum_.total()));
  }

 private:
  RationalSum sum_;
  bool is_integer_ = true;
  bool has_number_ = false;
};

bool is_number(std::string_view source) {
  return !source.empty() &&
         (source.front() == '-' || (source.front() >= '0' && source.front() <= '9'));
}

// ---------------------------------------------------------------- groups

/// The properties that all features of a group so far have in common.
struct GroupText {
  bool is_new = true;
  std::string_view id;
  Members members;
  std::map<std::string, NumberSum> sums;
};

void keep_common(GroupText& group, const Members& members, std::string_view id, std::size_t feature,
                 Context& context) {
  if (group.is_new) {
    group.is_new = false;
    group.id = id;
    group.members = members;
    return;
  }
  if (!is_same_value(group.id, id, feature, context)) group.id = {};
  std::unordered_map<std::string_view, std::string_view> source;
  for (const Member& member : members) source.emplace(member.name, member.source);
  std::erase_if(group.members, [&](const Member& kept) {
    const auto same = source.find(kept.name);
    return same == source.end() || !is_same_value(same->second, kept.source, feature, context);
  });
}

/// Removes the properties that are summed from the members, and adds them to the sums.
void add_sums(GroupText& group, Members& members, std::span<const std::string> sums,
              std::set<std::string>& found, std::size_t feature) {
  std::erase_if(members, [&](const Member& member) {
    if (std::find(sums.begin(), sums.end(), member.name) == sums.end()) return false;
    found.insert(member.name);
    if (is_number(member.source)) {
      group.sums[member.name].add(member.source);
    } else if (member.source != "null") {
      throw Error(ErrorCode::BadArgument, "feature " + std::to_string(feature + 1) + ": property " +
                                              plumb::quoted(member.name) +
                                              " is no number, so it has no sum");
    }
    return true;
  });
}

}  // namespace

FeatureGroups group_features(const Layer& layer, const std::string& property, Context& context) {
  FeatureGroups groups;
  std::map<std::string, std::uint32_t> number;
  bool is_found = false;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f % kFeaturesPerCheckpoint == 0) context.checkpoint("groups", f, layer.feature_count());
    std::string key;
    for (const Member& member : members_of(layer, f, context)) {
      if (member.name != property) continue;
      key = key_of(member.source, f, context);
      is_found = true;
    }
    const auto next = static_cast<std::uint32_t>(number.size());
    groups.group.push_back(number.try_emplace(key, next).first->second);
  }
  if (!is_found && layer.feature_count() > 0) {
    throw Error(ErrorCode::BadArgument, "no feature has a property " + plumb::quoted(property));
  }
  groups.count = number.size();
  return groups;
}

std::vector<std::uint32_t> id_ranks(const Layer& layer) {
  enum class Sort : std::uint8_t { Number, Text, None };
  struct Key {
    Sort sort;
    nlohmann::json id;
  };
  std::vector<Key> keys;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    nlohmann::json id;
    if (!layer.id(f).empty()) id = nlohmann::json::parse(layer.id(f));
    const Sort sort = id.is_number() ? Sort::Number : id.is_string() ? Sort::Text : Sort::None;
    keys.push_back({sort, sort == Sort::None ? nlohmann::json() : std::move(id)});
  }
  std::vector<std::uint32_t> order(keys.size()), rank(keys.size());
  for (std::uint32_t f = 0; f < order.size(); ++f) order[f] = f;
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return keys[a].sort != keys[b].sort ? keys[a].sort < keys[b].sort : keys[a].id < keys[b].id;
  });
  for (std::uint32_t r = 0; r < order.size(); ++r) rank[order[r]] = r;
  return rank;
}

namespace {

/// Returns the features with a name, as `name_of_feature` says.
template <class Name>
std::vector<std::uint32_t> features_named(const Layer& layer, const std::string& text,
                                          const Name& name_of_feature) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t f = 0; f < layer.feature_count(); ++f) {
    if (name_of_feature(f) == text) found.push_back(f);
  }
  return found;
}

}  // namespace

std::uint32_t feature_called(const Layer& layer, const std::string& text) {
  std::vector<std::uint32_t> found = features_named(layer, text, [&](std::uint32_t f) {
    if (layer.id(f).empty()) return std::string();
    const nlohmann::json id = nlohmann::json::parse(layer.id(f));
    return id.is_string() ? id.get<std::string>() : id.dump();
  });
  if (found.empty()) {
    found = features_named(layer, text, [&](std::uint32_t f) {
      return feature_name(layer, f).value_or(std::string());
    });
  }
  const std::string what = "the id or the name " + plumb::quoted(text);
  if (found.empty()) throw Error(ErrorCode::BadArgument, "no feature has " + what);
  if (found.size() > 1) {
    throw Error(ErrorCode::BadArgument, std::to_string(found.size()) + " features have " + what);
  }
  return found.front();
}

FeatureGroups one_group(const Layer& layer) {
  return {std::vector<std::uint32_t>(layer.feature_count(), 0),
          layer.feature_count() > 0 ? 1U : 0U};
}

Layer with_group_properties(Layer shapes, const Layer& layer, const FeatureGroups& groups,
                            std::span<const std::string> sums, Context& context) {
  std::vector<GroupText> texts(groups.count);
  std::set<std::string> found;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f % kFeaturesPerCheckpoint == 0) context.checkpoint("properties", f, layer.feature_count());
    GroupText& group = texts[groups.group[f]];
    Members members = members_of(layer, f, context);
    add_sums(group, members, sums, found, f);
    keep_common(group, members, layer.id(f), f, context);
  }
  for (const std::string& name : sums) {
    if (layer.feature_count() > 0 && found.count(name) == 0) {
      throw Error(ErrorCode::BadArgument, "no feature has a property " + plumb::quoted(name));
    }
  }
  Layer result = without_json(std::move(shapes));
  for (GroupText& group : texts) {
    ObjectText object;
    for (const Member& member : group.members) object.add(member.name, member.source);
    for (const std::string& name : sums) object.add(name, group.sums[name].text());
    append_json(result, group.id, object.take(), context);
  }
  return result;
}

// ---------------------------------------------------------------- pairs

namespace {

/// The properties of a layer under the names that they get in an overlay.
struct NamedLayer {
  std::vector<Members> members;  // For each feature.
  std::set<std::string> names;
  std::map<std::string, std::string> renamed;
};

NamedLayer named_layer(const Layer& layer, Context& context) {
  NamedLayer named;
  for (std::size_t f = 0; f < layer.feature_count(); ++f) {
    if (f % kFeaturesPerCheckpoint == 0) context.checkpoint("properties", f, layer.feature_count());
    named.members.push_back(members_of(layer, f, context));
    for (const Member& member : named.members.back()) named.names.insert(member.name);
  }
  return named;
}

std::string free_name(std::string name, std::set<std::string>& taken) {
  while (!taken.insert(name).second) name += '_';
  return name;
}

void rename(NamedLayer& named, const std::set<std::string>& others, const std::string& ending,
            std::set<std::string>& taken) {
  for (const std::string& name : named.names) {
    const bool is_common = others.count(name) != 0;
    named.renamed[name] = is_common ? free_name(name + ending, taken) : name;
  }
}

}  // namespace

Layer with_pair_properties(LayerOverlay overlay, const Layer& first, const Layer& second,
                           Context& context) {
  NamedLayer a = named_layer(first, context), b = named_layer(second, context);
  std::set<std::string> taken = a.names;
  taken.insert(b.names.begin(), b.names.end());
  rename(a, b.names, "_1", taken);
  rename(b, a.names, "_2", taken);
  const std::string first_id = free_name("id_1", taken), second_id = free_name("id_2", taken);
  const std::string area = free_name("area", taken);
  Layer result = without_json(std::move(overlay.layer));
  for (std::size_t i = 0; i < overlay.pairs.size(); ++i) {
    if (i % kFeaturesPerCheckpoint == 0) context.checkpoint("properties", i, overlay.pairs.size());
    const auto [f, g] = overlay.pairs[i];
    ObjectText object;
    const auto add_members = [&](const NamedLayer& named, std::uint32_t feature) {
      if (feature == LayerRegion::kNobody) return;
      for (const Member& m : named.members[feature]) object.add(named.renamed.at(m.name), m.source);
    };
    const auto add_id = [&](const Layer& layer, std::uint32_t feature, const std::string& name) {
      if (feature == LayerRegion::kNobody || layer.id(feature).empty()) return;
      object.add(name, layer.id(feature));
    };
    add_members(a, f);
    add_members(b, g);
    add_id(first, f, first_id);
    add_id(second, g, second_id);
    if (!overlay.area.empty()) object.add(area, format_double(nearest_double(overlay.area[i])));
    append_json(result, "", object.take(), context);
  }
  return result;
}

}  // namespace plumb
