// Reading of the settings of slicers. Only settings that exclude a volume from the shape are read.
//
// Elements: object (id) > volume (firstid, lastid) > metadata (key, value) in the files of
// PrusaSlicer, and object (id) > part (id, subtype) in the files of Bambu Studio. Everything else
// is skipped. Tested by tests/io/threemf_test.cpp.
#include "plumb/io/mesh/threemf_settings.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <system_error>

#include "plumb/io/mesh/threemf_model.h"
#include "plumb/io/mesh/threemf_xml.h"
#include "plumb/io/text/input_cursors.h"

namespace plumb {
namespace {

constexpr std::array<const char*, 2> kSettingsFiles{"Metadata/Slic3r_PE_model.config",
                                                    "Metadata/model_settings.config"};

/// Returns the name of a kind of volume, or an empty text if the volume is a part of the shape.
std::string_view called_by_slicers(std::string_view kind) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kKinds{{
      {"NegativeVolume", "negative volumes"},
      {"negative_part", "negative volumes"},
      {"ParameterModifier", "modifier volumes"},
      {"modifier_part", "modifier volumes"},
      {"SupportBlocker", "support blockers"},
      {"support_blocker", "support blockers"},
      {"SupportEnforcer", "support enforcers"},
      {"support_enforcer", "support enforcers"},
  }};
  const auto* const found = std::find_if(kKinds.begin(), kKinds.end(),
                                         [&](const auto& each) { return each.first == kind; });
  return found == kKinds.end() ? std::string_view() : found->second;
}

class SettingsReader3mf : public XmlListener {
 public:
  SettingsReader3mf(const std::string& file, const char* part, ThreeMfSettings& settings,
                    MemoryCharge& charge)
      : settings_(settings), charge_(charge), stream_(threemf_text_name(file, part), *this) {}

  void read(ZipArchive& archive, std::uint64_t entry) {
    archive.read(entry, [this](std::string_view block) { stream_.feed(block); });
    stream_.finish();
  }

  void start(const XmlTag& tag) override {
    ++depth_;
    if (tag.name == "object" && depth_ == 2) {
      object_ = whole_number(tag, "id");
    } else if (tag.name == "volume" && depth_ == 3) {
      volume_ = ThreeMfSettings::Range{
          object_, whole_number(tag, "firstid"), whole_number(tag, "lastid"), {}};
    } else if (tag.name == "part" && depth_ == 3) {
      add_part(tag);
    } else if (tag.name == "metadata" && depth_ == 4 && volume_) {
      read_kind(tag);
    }
  }

  void end() override {
    constexpr std::uint64_t kRangeBytes = 2 * sizeof(ThreeMfSettings::Range);
    if (--depth_ != 2) return;
    if (volume_ && !volume_->called.empty()) {
      charge_.add(kRangeBytes, "the settings of a slicer");
      settings_.ranges.push_back(*volume_);
    }
    volume_.reset();
  }

 private:
  void read_kind(const XmlTag& tag) {
    const std::string_view key = tag.attribute("key").value_or("");
    const std::string_view value = tag.attribute("value").value_or("");
    if (key == "volume_type") volume_->called = called_by_slicers(value);
    if (key == "modifier" && value == "1" && volume_->called.empty()) {
      volume_->called = called_by_slicers("ParameterModifier");
    }
  }

  void add_part(const XmlTag& tag) {
    constexpr std::uint64_t kEntryBytes = 96;
    const std::string_view called = called_by_slicers(tag.attribute("subtype").value_or(""));
    if (called.empty()) return;
    charge_.add(kEntryBytes, "the settings of a slicer");
    settings_.components.emplace(std::pair(object_, whole_number(tag, "id")), called);
  }

  std::uint32_t whole_number(const XmlTag& tag, const char* name) {
    const std::string_view text = tag.attribute(name).value_or("");
    std::uint32_t value = 0;
    const char* const last = text.data() + text.size();
    const auto [end, code] = std::from_chars(text.data(), last, value);
    if (code != std::errc() || end != last) {
      stream_.fail(ErrorCode::Syntax,
                   std::string(name) + " is " + quoted(text) + ", not a whole number");
    }
    return value;
  }

  ThreeMfSettings& settings_;
  MemoryCharge& charge_;
  XmlStream stream_;
  std::size_t depth_ = 0;
  std::uint32_t object_ = 0;
  std::optional<ThreeMfSettings::Range> volume_;
};

}  // namespace

ThreeMfSettings read_threemf_settings(ZipArchive& archive, const std::string& file,
                                      MemoryCharge& charge) {
  ThreeMfSettings settings;
  for (const char* const part : kSettingsFiles) {
    if (const auto entry = archive.find(part)) {
      SettingsReader3mf(file, part, settings, charge).read(archive, *entry);
    }
  }
  return settings;
}

}  // namespace plumb
