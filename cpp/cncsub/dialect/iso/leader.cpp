#include "cncsub/dialect/iso/leader.hpp"

#include <algorithm>

namespace cncsub {

bool heads(const Code& code, ProgramHead head) {
  return code.control->reading.program_heads.value.has(head);
}

namespace {

/// Return whether a line that starts with % is the head of a program.
bool percent_head(const Code& code, Scanner line) {
  ++line.at;
  return heads(code, ProgramHead::Percent) && is_digit(line.peek());
}

/// Return whether another mark makes a line the head of a program.
bool other_head(const Code& code, Scanner line) {
  const char c = line.peek();
  ++line.at;
  if (c == 'O' || c == ':') return is_digit(line.peek());
  return c == '<' && heads(code, ProgramHead::Name);
}

/// Return whether a tape begins with this %: a program's head follows, or blocks that another %
/// ends. The text after it may belong to a piece whose line ends another thread is unifying.
bool file_begins(Builder& to, std::string_view text, const Scanner& percent) {
  const char* const end = text.data() + text.size();
  bool blocks = false;
  for (const char* at = percent.at; at < end;) {
    const char* line_end = std::find_if(at, end, [](char c) { return c == '\n' || c == '\r'; });
    if (to.interrupt().requested(static_cast<std::size_t>(line_end + 1 - at))) return false;
    Scanner line{at, line_end, percent.file};
    at = line_end + 1;
    const char c = line.peek();
    if (c == '\0') continue;
    if (c == '%' ? blocks || percent_head(to.code(), line) : !blocks && other_head(to.code(), line))
      return true;
    blocks = blocks || c != '%';
  }
  return false;
}

/// Return whether a block belongs to a program and not to a title. It does if it has a sequence
/// number, or if the control can read it and it has a G or an M code, moves, or is a macro
/// statement. T12 and S355 may be titles.
bool could_run(const Code& code, const Block& block) {
  if (block.n >= 0) return true;
  if (block.op == Op::Select) return could_run(code, code.variants[code.selects[block.aux].first]);
  if (is_words(block.op)) return block.has_codes() || (block.mask & kEndWords) != 0;
  return block.op != Op::Fault;
}

}  // namespace

bool is_leader(Builder& to, std::string_view text, const Scanner& percent) {
  const Code& code = to.code();
  for (Address a = code.programs.back().first; a < to.next_address(); ++a) {
    if (to.interrupt().requested(InterruptCheck::kBlock)) return false;
    if (could_run(code, code.blocks[a])) return false;
  }
  return file_begins(to, text, percent);
}

}  // namespace cncsub
