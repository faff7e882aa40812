#include "cncsub/analysis/nesting_depth.hpp"

#include <algorithm>

#include "cncsub/code/loop_end.hpp"

namespace cncsub {

NestingDepth::NestingDepth(const Code& code, const Program& program) : code_(code) {
  for (Address at = program.first; at < program.last; ++at) {
    const Block& block = code.blocks[at];
    if (block.op != Op::IfGoto) continue;
    if (const auto head = head_of_loop(code.statements[block.aux])) ends_[*head] = at;
  }
}

/// Return whether a statement ends the innermost one that is open, or is another branch of it.
bool NestingDepth::ends(const OWord& word) const {
  if (open_.empty() || open_.back().label != word.label) return false;
  const OWordKind kind = open_.back().kind;
  switch (word.kind) {
    case OWordKind::EndSub:
      return kind == OWordKind::Sub;
    case OWordKind::ElseIf:
    case OWordKind::Else:
    case OWordKind::EndIf:
      return kind == OWordKind::If;
    case OWordKind::While:
      return kind == OWordKind::Do;
    case OWordKind::EndWhile:
      return kind == OWordKind::While;
    case OWordKind::EndRepeat:
      return kind == OWordKind::Repeat;
    default:
      return false;
  }
}

int NestingDepth::of_o_word(const OWord& word) {
  if (ends(word)) {
    const bool branch = word.kind == OWordKind::ElseIf || word.kind == OWordKind::Else;
    const int its = depth() - 1;
    if (!branch) open_.pop_back();
    return its;
  }
  const int its = depth();
  const bool begins = word.kind == OWordKind::Sub || word.kind == OWordKind::If ||
                      word.kind == OWordKind::While || word.kind == OWordKind::Do ||
                      word.kind == OWordKind::Repeat;
  if (begins) open_.push_back({kNowhere, word.kind, word.label});
  return its;
}

bool NestingDepth::is_second(Address at) const {
  return at > 0 && code_.blocks[at].length > 0 &&
         code_.blocks[at - 1].line == code_.blocks[at].line &&
         code_.blocks[at - 1].text == code_.blocks[at].text;
}

int NestingDepth::of(Address at) {
  const Block& block = code_.blocks[at];
  if (!open_.empty() && open_.back().end == at) {
    open_.pop_back();
    return depth();
  }
  const int its = depth();
  if (const auto loop = ends_.find(at); loop != ends_.end()) open_.push_back({loop->second});
  switch (block.op) {
    case Op::OWord:
      return of_o_word(code_.o_words[block.aux]);
    case Op::While:
    case Op::Do:
    case Op::For: {
      const Address end = code_.statements[block.aux].end;
      if (end != kNowhere && end > at && (open_.empty() || open_.back().end >= end))
        open_.push_back({end});
      return its;
    }
    case Op::If:
      if (is_second(at)) return std::max(0, its - 1);  // ELSEIF: an ELSE and an IF
      open_.push_back({kNowhere});
      return its;
    case Op::Switch:  // CASE with its branches after it
      if (code_.blocks[at + 1].op == Op::Else) open_.push_back({kNowhere});
      return its;
    case Op::Else:
      return std::max(0, its - 1);
    case Op::EndIf:
      if (!open_.empty() && open_.back().end == kNowhere) open_.pop_back();
      return depth();
    default:
      return its;
  }
}

}  // namespace cncsub
