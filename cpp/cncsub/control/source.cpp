#include "cncsub/control/source.hpp"

#include <algorithm>
#include <array>

#include "cncsub/text/scan.hpp"

namespace cncsub {

std::string_view to_string(Evidence evidence) {
  switch (evidence) {
    case Evidence::SourceDocument:
      return "source document";
    case Evidence::Manual:
      return "maker's manual";
    case Evidence::Secondary:
      return "secondary";
    case Evidence::Inferred:
      return "inferred";
  }
  return "";
}

namespace {

/// Return whether a word begins at this place.
bool begins(std::string_view text, std::size_t place) {
  const char before = place == 0 ? ' ' : text[place - 1];
  return !is_digit(before) && !is_letter(before) && before != '-';
}

/// Return whether a key stands at this beginning of a word, as a word of its own. A number of the
/// chapter or of the alarm may follow at once: TA27.
bool stands_at(std::string_view text, std::size_t place, std::string_view key) {
  if (text.substr(place, key.size()) != key) return false;
  const std::size_t end = place + key.size();
  const char after = end == text.size() ? ' ' : text[end];
  if (is_digit(key.back())) return !is_digit(after) && !is_letter(after);
  return !is_letter(after) && after != '-';
}

/// Return whether a part of a text begins here that cites nothing, whatever words it has: general
/// knowledge of the ISO mode is not the source ISO.
bool is_knowledge(std::string_view text, std::size_t place) {
  const bool first = place == 0 || text.substr(0, place).ends_with("; ");
  return first && text.substr(place).starts_with("general knowledge of ");
}

bool has_word(std::string_view list, std::string_view word) {
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t to = std::min(list.find(' ', from), list.size());
    if (list.substr(from, to - from) == word) return true;
    from = to + 1;
  }
  return false;
}

using Sources = std::array<std::vector<const Source*>, 256>;

/// Return the sources by the first character of their keys.
const Sources& sources_by_first() {
  static const Sources sources = [] {
    Sources all;
    for (const Source& source : all_sources())
      all[static_cast<unsigned char>(source.key.front())].push_back(&source);
    return all;
  }();
  return sources;
}

}  // namespace

Evidence Source::on(std::string_view control) const {
  return has_word(about, control) ? evidence : std::max(evidence, Evidence::Secondary);
}

std::vector<const Source*> cited(std::string_view text) {
  std::vector<const Source*> found;
  for (std::size_t place = 0; place < text.size(); ++place) {
    if (!begins(text, place)) continue;
    if (is_knowledge(text, place)) {
      place = std::min(text.find(';', place), text.size());
      continue;
    }
    const Source* longest = nullptr;
    for (const Source* source : sources_by_first()[static_cast<unsigned char>(text[place])])
      if ((longest == nullptr || source->key.size() > longest->key.size()) &&
          stands_at(text, place, source->key))
        longest = source;
    if (longest != nullptr && std::find(found.begin(), found.end(), longest) == found.end())
      found.push_back(longest);
  }
  return found;
}

Evidence strongest(std::string_view text, std::string_view control) {
  Evidence best = Evidence::Inferred;
  for (const Source* source : cited(text)) best = std::min(best, source->on(control));
  return best;
}

}  // namespace cncsub
