// Finds the word of its block that a fault of the motion is about.
#include "cncsub/code/fault_words.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "cncsub/text/scan.hpp"
#include "cncsub/text/words.hpp"

namespace cncsub {
namespace {

constexpr std::pair<std::string_view, std::array<Group, 3>> kGroupNames[] = {
    {"oneshot", {Group::OneShot, Group::OneShot, Group::OneShot}},
    {"motion", {Group::Motion, Group::Motion, Group::Motion}},
    {"cycle", {Group::Cycle, Group::Cycle, Group::Cycle}},
    {"plane", {Group::Plane, Group::Plane, Group::Plane}},
    {"stroke", {Group::Stroke, Group::Stroke, Group::Stroke}},
    {"units", {Group::Units, Group::Units, Group::Units}},
    {"radius", {Group::Radius, Group::Radius, Group::Radius}},
    {"length", {Group::Length, Group::Length, Group::Length}},
    {"work", {Group::Work, Group::Work, Group::Work}},
    {"macro", {Group::Macro, Group::Macro, Group::Macro}},
    {"turn", {Group::Rotation, Group::Scaling, Group::Mirror}},
    {"mirror", {Group::Mirror, Group::Mirror, Group::Mirror}},
};

struct Finder {
  const std::vector<WrittenWord>& words;
  const GCodes& codes;

  const WrittenWord* address(std::string_view name) const {
    for (const WrittenWord& word : words)
      if (word.address == name) return &word;
    return nullptr;
  }
  const WrittenWord* axis() const {
    for (const WrittenWord& word : words)
      if (word.address.size() == 1 &&
          std::string_view("XYZUVWABCH").find(word.address[0]) != std::string_view::npos)
        return &word;
    return nullptr;
  }
  const WrittenWord* code(int tenfold) const {
    for (const WrittenWord& word : words)
      if (word.address == "G" && (!word.known || std::lround(word.value * 10) == tenfold))
        return &word;
    return nullptr;
  }
  const WrittenWord* group(const std::array<Group, 3>& groups) const {
    for (const WrittenWord& word : words) {
      if (word.address != "G" || !word.known || std::fabs(word.value) > 1000) continue;
      const GCode found = codes.find(static_cast<int>(std::lround(word.value * 10)));
      if (found.meaning <= Meaning::Uncomputed || found.meaning == Meaning::Unknown) continue;
      for (const Group of : groups)
        if (found.group == of) return &word;
    }
    return nullptr;
  }
  /// Find a word by a name as CauseInfo::words has them.
  const WrittenWord* named(std::string_view name) const {
    if (name == "axis") return axis();
    for (const auto& [text, groups] : kGroupNames)
      if (text == name) return group(groups);
    return address(name);
  }
  /// Find the word of an address. A comma may stand before it, and increments have letters of their
  /// own.
  const WrittenWord* address_or_like(char name) const {
    if (const WrittenWord* word = address({&name, 1})) return word;
    if (const WrittenWord* word = address(std::string(",") + name)) return word;
    constexpr std::string_view kAxes = "XYZC", kIncrements = "UVWH";
    const std::size_t axis = kAxes.find(name);
    return axis == std::string_view::npos ? nullptr : address(kIncrements.substr(axis, 1));
  }
  /// Return a G code, or what stands first.
  const WrittenWord* first() const {
    if (const WrittenWord* g = address("G")) return g;
    for (const WrittenWord& word : words)
      if (word.address != "N" && word.address != "/" && word.address != "O") return &word;
    return nullptr;
  }
};

}  // namespace

void point_at_word(const GCodes& codes, const std::vector<WrittenWord>& words, std::uint32_t text,
                   Fault& fault) {
  const Finder find{words, codes};
  const WrittenWord* word = fault.code >= 0      ? find.code(fault.code)
                            : fault.address != 0 ? find.address_or_like(fault.address)
                                                 : nullptr;
  std::string_view rest = info(fault.cause).words;
  while (!rest.empty() && word == nullptr) {
    const std::size_t blank = std::min(rest.find(' '), rest.size());
    word = find.named(rest.substr(0, blank));
    rest.remove_prefix(std::min(blank + 1, rest.size()));
  }
  if (word == nullptr) word = find.first();
  fault.at = text + (word == nullptr ? 0 : word->at);
  const std::uint32_t all = words.empty() ? 1 : words.back().at + words.back().width;
  fault.width = word == nullptr ? all : word->width;
}

std::vector<std::string_view> causes_with_words() {
  std::vector<std::string_view> slugs;
  for (const CauseInfo& cause : all_causes())
    if (!cause.words.empty()) slugs.push_back(cause.slug);
  return slugs;
}

}  // namespace cncsub
