#include "folder_listing.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <utility>

#include "cncsub/system/folder.hpp"
#include "cncsub/text/utf8.hpp"

namespace cncsub::bindings {

namespace {

using Kind = system::EntryKind;

constexpr std::size_t kEntryBytes = 64;  // the work of an entry, in bytes for the interrupt

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Return whether a name has control characters or is no text.
bool is_strange(std::string_view name) {
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (c < 0x20 || c == 0x7f) return true;
    if (c == 0xc2 && i + 1 < name.size() && static_cast<unsigned char>(name[i + 1]) < 0xa0)
      return true;
  }
  return !is_ascii(name) && !is_utf8(name, [](std::size_t) { return false; });
}

bool has_ending_of(std::string_view name, const std::unordered_set<std::string>& endings) {
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return false;
  std::string ending(name.substr(dot));
  std::transform(ending.begin(), ending.end(), ending.begin(), lower);
  // Python decides what small letters are beyond ASCII.
  return !is_ascii(ending) || endings.contains(ending);
}

/// Return the sort key of a name as bytes: its texts in small letters, each with a NUL after it,
/// and its numbers by their count of digits and then by these.
std::string key_of(std::string_view name) {
  std::string key;
  key.reserve(name.size() + 8);
  for (std::size_t i = 0; i < name.size();) {
    for (; i < name.size() && !is_digit(name[i]); ++i) key += lower(name[i]);
    key += '\0';
    if (i == name.size()) return key;
    std::size_t end = i;
    while (end < name.size() && is_digit(name[end])) ++end;
    while (i < end && name[i] == '0') ++i;
    key += static_cast<char>(std::min<std::size_t>(end - i, 255));
    key += name.substr(i, end - i);
    i = end;
  }
  key += '\0';
  return key;
}

/// Return the first bytes of a sort key, in which most keys differ.
std::uint64_t head_of(std::string_view key) {
  std::uint64_t head = 0;
  for (std::size_t i = 0; i < sizeof head; ++i)
    head = head << 8 | (i < key.size() ? static_cast<unsigned char>(key[i]) : 0U);
  return head;
}

void put_in_order(std::vector<std::string>& names) {
  struct Placed {
    std::uint64_t head;
    std::size_t name;
  };
  std::vector<std::string> keys;
  std::vector<Placed> placed;
  keys.reserve(names.size());
  placed.reserve(names.size());
  for (const std::string& name : names) {
    keys.push_back(key_of(name));
    placed.push_back({head_of(keys.back()), placed.size()});
  }
  std::sort(placed.begin(), placed.end(), [&](const Placed& a, const Placed& b) {
    if (a.head != b.head) return a.head < b.head;
    if (const int order = keys[a.name].compare(keys[b.name]); order != 0) return order < 0;
    return names[a.name] < names[b.name];
  });
  std::vector<std::string> ordered;
  ordered.reserve(names.size());
  for (const Placed& place : placed) ordered.push_back(std::move(names[place.name]));
  names = std::move(ordered);
}

void add(FolderListing& listing, std::string name, Kind kind,
         const std::unordered_set<std::string>& endings) {
  listing.ordered = listing.ordered && is_ascii(name);
  const bool plain = kind != Kind::Other && name[0] != '.' && !is_strange(name);
  if (plain && kind == Kind::Folder)
    listing.folders.push_back(std::move(name));
  else if (plain && !has_ending_of(name, endings))
    listing.files.push_back(std::move(name));
  else
    listing.others.push_back(std::move(name));
}

}  // namespace

FolderListing list_folder(const std::string& path, const std::unordered_set<std::string>& endings,
                          InterruptCheck& interrupt) {
  FolderListing listing;
  listing.error = system::each_entry(path, [&](std::string name, Kind kind) {
    add(listing, std::move(name), kind, endings);
    return !interrupt.requested(kEntryBytes);
  });
  if (listing.error != 0 || !listing.ordered) return listing;
  for (auto* names : {&listing.files, &listing.folders, &listing.others}) put_in_order(*names);
  return listing;
}

}  // namespace cncsub::bindings
