#include "cncsub/machine/calls/o_word_nesting.hpp"

#include <algorithm>
#include <vector>

namespace cncsub {

namespace {

/// A branch or a loop around a block.
struct Around {
  std::uint32_t label = 0;
  OWordKind kind = OWordKind::If;
  Address head = 0;
  Address branch = 0;  // the if, elseif or else that the block stands after

  bool operator==(const Around&) const = default;
};

/// Take the innermost of a label away, with those inside it, and return whether there was one.
bool close(std::vector<Around>& open, std::uint32_t label) {
  const auto found = std::find_if(open.rbegin(), open.rend(),
                                  [label](const Around& of) { return of.label == label; });
  if (found == open.rend()) return false;
  open.erase(std::prev(found.base()), open.end());
  return true;
}

void pass(std::vector<Around>& open, const OWord& own, Address at) {
  const auto same = [&own](const Around& of) { return of.label == own.label; };
  switch (own.kind) {
    case OWordKind::While: {
      const auto met = std::find_if(open.rbegin(), open.rend(), same);
      if (met != open.rend() && met->kind == OWordKind::Do) {
        close(open, own.label);
        return;
      }
      [[fallthrough]];
    }
    case OWordKind::If:
    case OWordKind::Do:
    case OWordKind::Repeat:
      open.push_back({own.label, own.kind, at, at});
      return;
    case OWordKind::ElseIf:
    case OWordKind::Else:
      if (const auto met = std::find_if(open.rbegin(), open.rend(), same); met != open.rend())
        met->branch = at;
      return;
    case OWordKind::EndIf:
    case OWordKind::EndWhile:
    case OWordKind::EndRepeat:
      close(open, own.label);
      return;
    default:  // subprograms, calls, break and continue
      return;
  }
}

/// Return what is around a block, the outermost first. The block that ends a branch stands in it.
std::vector<Around> around(const Code& code, Address block) {
  std::vector<Around> open;
  const std::int32_t program = code.program_at(block);
  if (code.o_words.empty() || program < 0) return open;
  for (Address at = code.programs[static_cast<std::size_t>(program)].first; at < block; ++at)
    if (code.blocks[at].op == Op::OWord && code.program_at(at) == program)
      pass(open, code.o_words[code.blocks[at].aux], at);
  return open;
}

}  // namespace

Address entered_by_jump(const Code& code, Address from, Address to) {
  const std::vector<Around> before = around(code, from), then = around(code, to);
  for (std::size_t i = 0; i < then.size(); ++i)
    if (i >= before.size() || before[i] != then[i]) return then[i].head;
  return kNowhere;
}

void leave_o_words(Run& run, Address to) {
  Labels& labels = run.state.labels;
  if (labels.met.empty()) return;
  const std::vector<Around> holds = around(*run.code, to);
  for (auto& [key, met] : labels.met) {
    const Address head = met.address;
    const bool own = key >> 32 == run.frame().label && met.kind == OWordKind::Repeat;
    const bool held = head == to || std::any_of(holds.begin(), holds.end(),
                                                [head](auto& of) { return of.head == head; });
    if (own && !held) met.repeats = -1;
  }
  labels.skipping = labels.breaks = labels.continues = false;
  labels.entered = true;  // the branch that holds the block, where one does, is executed
}

}  // namespace cncsub
