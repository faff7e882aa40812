// The folders in which a call looks for a program: `SPF.DIR CALLPATH CUS.DIR=cycles`.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "cncsub/control/list.hpp"

namespace cncsub {

/// A folder of a search path: its name on the control and, where it has another one, that of the
/// folder on the disk. CALLPATH stands for the one that a program adds.
struct SearchFolder {
  struct Entry {
    std::array<char, 16> name{};
    std::array<char, 48> disk{};
    constexpr std::string_view on_control() const { return view(name); }
    constexpr std::string_view on_disk() const { return view(disk); }
    bool operator==(const Entry&) const = default;

   private:
    template <std::size_t Size>
    static constexpr std::string_view view(const std::array<char, Size>& text) {
      return {text.data(),
              static_cast<std::size_t>(std::find(text.begin(), text.end(), '\0') - text.begin())};
    }
  };
  static constexpr std::size_t kMost = 12;
  static constexpr std::string_view kAdded = "CALLPATH";
  static constexpr std::optional<Entry> read(std::string_view text) {
    const std::size_t equals = std::min(text.find('='), text.size());
    const std::string_view name = text.substr(0, equals);
    const std::string_view disk = text.substr(std::min(equals + 1, text.size()));
    Entry entry;
    if (name.empty() || name.size() >= entry.name.size() || disk.size() >= entry.disk.size())
      return std::nullopt;
    for (const char c : name)
      if (c >= 'a' && c <= 'z') return std::nullopt;
    std::copy(name.begin(), name.end(), entry.name.begin());
    std::copy(disk.begin(), disk.end(), entry.disk.begin());
    return entry;
  }
  static constexpr bool same(const Entry& a, const Entry& b) { return a.name == b.name; }
  static std::string text(const Entry& entry) {
    const std::string_view disk = entry.on_disk();
    return std::string(entry.on_control()) + (disk.empty() ? "" : "=" + std::string(disk));
  }
  static std::string wrong(std::string_view text);
};
using SearchPath = List<SearchFolder>;

}  // namespace cncsub
