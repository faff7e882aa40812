#include "cncsub/analysis/ignored.hpp"

#include <algorithm>

#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

bool is_of_name(char c) { return is_letter(c) || is_digit(c) || c == '-' || c == '_'; }

bool is_like(std::string_view text, std::size_t at, std::string_view capitals) {
  if (at > text.size() || text.size() - at < capitals.size()) return false;
  for (std::size_t i = 0; i < capitals.size(); ++i)
    if (upper(text[at + i]) != capitals[i]) return false;
  return true;
}

/// Return where the names begin after `cncsub: ignore`; npos where that does not stand around a
/// colon.
std::size_t names_behind(std::string_view text, std::size_t colon) {
  constexpr std::string_view kWho = "CNCSUB", kWhat = "IGNORE";
  if (colon < kWho.size() || !is_like(text, colon - kWho.size(), kWho))
    return std::string_view::npos;
  std::size_t at = colon + 1;
  while (at < text.size() && is_blank(text[at])) ++at;
  if (!is_like(text, at, kWhat)) return std::string_view::npos;
  at += kWhat.size();
  return at < text.size() && (is_of_name(text[at]) && text[at] != '-') ? std::string_view::npos
                                                                       : at;
}

std::vector<std::string> names_from(std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_letter(text[i])) continue;
    std::size_t end = i;
    while (end < text.size() && is_of_name(text[end])) ++end;
    names.emplace_back(text.substr(i, end - i));
    i = end;
  }
  return names;
}

}  // namespace

IgnoredLines::IgnoredLines(std::string_view text) {
  for (std::size_t at = text.find(':'); at != std::string_view::npos; at = text.find(':', at + 1)) {
    const std::size_t from = names_behind(text, at);
    if (from == std::string_view::npos) continue;
    const std::size_t before = text.rfind('\n', at);
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::size_t to = std::min(text.find_first_of("()", from), end);
    const std::size_t first = before == std::string_view::npos ? 0 : before + 1;
    if (lines_.empty() || lines_.back().from != first)
      lines_.push_back({first, end, names_from(text.substr(from, to - from))});
    at = end - 1;
  }
}

bool IgnoredLines::holds(Check check, std::size_t at) const {
  const auto behind =
      std::upper_bound(lines_.begin(), lines_.end(), at,
                       [](std::size_t of, const Line& line) { return of < line.from; });
  if (behind == lines_.begin() || at > (behind - 1)->to) return false;
  const std::vector<std::string>& names = (behind - 1)->names;
  const CheckInfo& rule = info(check);
  return names.empty() || std::any_of(names.begin(), names.end(), [&](const std::string& name) {
           return name == rule.slug ||
                  (name.size() == rule.number.size() && is_like(name, 0, rule.number));
         });
}

}  // namespace cncsub
