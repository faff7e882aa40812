#include "cncsub/dialect/iso/structured_words.hpp"

#include <algorithm>
#include <iterator>

namespace cncsub {

namespace {

constexpr std::string_view kNotComputed[] = {
#define NOT_COMPUTED(name, gives) name,
#include "cncsub/dialect/iso/not_computed.def"
#undef NOT_COMPUTED
};

/// Return the place after the comment that begins at `at`; `at` itself where none does.
std::size_t behind_comment(std::string_view text, std::size_t at) {
  const std::string_view rest = text.substr(at);
  if (rest.starts_with("//")) return std::min(text.find('\n', at), text.size());
  if (!rest.starts_with("(*")) return at;
  const std::size_t end = text.find("*)", at + 2);
  return end == std::string_view::npos ? text.size() : end + 2;
}

char translated(char c) {
  switch (c) {
    case '(':
      return '[';
    case ')':
      return ']';
    case '@':
      return '#';
    case '\n':
    case '\r':
      return ' ';
    default:
      return c;
  }
}

}  // namespace

bool heads_structured(std::string_view line) {
  const std::string_view said = trimmed(line);
  constexpr std::string_view kHead = "%@MACRO";
  return said.size() >= kHead.size() && same_letters(said.substr(0, kHead.size()), kHead) &&
         (said.size() == kHead.size() || !is_letter(said[kHead.size()]));
}

bool is_program_head(std::string_view line) {
  const std::string_view said = trimmed(line);
  if (said.size() < 2 || upper(said[0]) != 'O' || !is_digit(said[1])) return false;
  const std::size_t behind = std::min(said.find_first_not_of("0123456789", 1), said.size());
  const std::string_view rest = trimmed(said.substr(behind));
  return rest.empty() || rest[0] == '(' || rest.starts_with("//") || rest == ";";
}

void translate_structured(std::string& text, std::size_t from, std::size_t to) {
  const std::string_view part = std::string_view(text).substr(0, to);
  bool quoted = false;
  while (from < to) {
    const std::size_t behind = quoted ? from : behind_comment(part, from);
    if (behind != from) {
      std::fill(text.begin() + static_cast<std::ptrdiff_t>(from),
                text.begin() + static_cast<std::ptrdiff_t>(behind), ' ');
      from = behind;
      continue;
    }
    char& c = text[from];
    if (c == '"' || c == '\n') quoted = c == '"' && !quoted;
    if (quoted && c == ';') c = ',';
    if (c == ':' && from + 1 < to && text[from + 1] == '=') c = ' ';
    if (!quoted) c = translated(c);
    ++from;
  }
}

std::string name_of_word(Scanner& s) {
  std::string name;
  for (; s.at != s.end && (is_letter(*s.at) || is_digit(*s.at) || *s.at == '_'); ++s.at)
    name += upper(*s.at);
  return name;
}

bool is_not_computed(std::string_view name) {
  return std::find(std::begin(kNotComputed), std::end(kNotComputed), name) !=
         std::end(kNotComputed);
}

}  // namespace cncsub
