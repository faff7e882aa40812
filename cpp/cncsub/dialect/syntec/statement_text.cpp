#include "cncsub/dialect/syntec/statement_text.hpp"

#include <algorithm>

#include "cncsub/dialect/iso/structured_words.hpp"

namespace cncsub::syntec {

bool take_whole(Scanner& s, std::string_view word) {
  Scanner ahead = s;
  ahead.blanks();
  if (name_of_word(ahead) != word) return false;
  s = ahead;
  return true;
}

void go_behind(Scanner& s, std::string_view word) {
  while (s.at != s.end && *s.at != ';' && !take_whole(s, word)) ++s.at;
}

const char* end_of_statement(const Scanner& s) { return std::find(s.at, s.end, ';'); }

std::uint32_t width_to(const Scanner& s, std::uint32_t from) {
  return std::max(1u, s.offset() - from);
}

std::optional<double> constant_of(const Expression& of) {
  auto at = of.begin();
  const Instruction only = *at;
  if (only.op != Ins::Constant || !(++at == Expression::end())) return std::nullopt;
  return only.value;
}

}  // namespace cncsub::syntec
