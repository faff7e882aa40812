#include "cncsub/dialect/sinumerik/structure.hpp"

#include <algorithm>

#include "cncsub/code/loop_end.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr std::size_t kMostOpen = 16;  // control structures of a level [general knowledge]

}  // namespace

void Structure::add(const std::string& label, const Link& link) {
  const Address address = to_.next_address();
  if (!label.empty()) {
    labels_[label].push_back(address);
    to_.names().head(to_.names().label(label), address);  // a return may name it
  }
  if (link.kind != Link::Kind::None) links_.push_back({address, link});
}

void Structure::refuse(const Word& word, Cause cause, const char* detail) {
  Block& block = to_.block(word.block);
  if (block.op != Op::Fault) to_.refuse(block, {cause, word.at, word.width, detail});
}

void Structure::match() {
  open_.clear();
  spans_.clear();
  marks_.clear();
  computed_ = false;
  for (const Met& met : links_) {
    if (to_.interrupt().requested(InterruptCheck::kBlock)) return;
    match(met);
  }
  for (const Met& met : links_) {
    if (met.link.kind == Link::Kind::Jump) resolve(met);
    if (met.link.kind == Link::Kind::Switch)
      for (const AlternativeJump& one : met.link.alternatives) resolve(met.address, one);
    if (met.link.kind == Link::Kind::Part) resolve_part(met);
  }
  for (const Open& open : open_) leave_open(open);
  if (computed_) keep_structures();
}

/// Keep the structures for jumps that are searched for when they are made.
void Structure::keep_structures() {
  std::vector<StructureMark> marks;
  const auto around = [this](std::size_t span) {
    return span == 0 ? Span{kNowhere} : spans_[span - 1];
  };
  for (const Mark& mark : marks_) {
    const Span of = around(mark.span);
    marks.push_back({mark.from, mark.span == 0 ? kNowhere : of.first, of.last});
  }
  marks.push_back({to_.next_address()});
  to_.structures(marks);
}

/// Let a structure without an end run, up to where its end is searched for. The control does not
/// look at structures as a whole. [840Dsl p.107]
void Structure::leave_open(const Open& open) {
  constexpr const char* kNoEndif = "no ENDIF follows";
  if (open.kind == Link::Kind::If) {
    if (open.other.block != kNowhere) return refuse(open.other, Cause::IfWithoutEnd, kNoEndif);
    return refuse_otherwise(open.word, Cause::IfWithoutEnd, kNoEndif);
  }
  if (open.kind == Link::Kind::For) return;  // where it does not begin, its end is searched for
  if (open.kind == Link::Kind::While)
    return refuse_otherwise(open.word, Cause::MissingEnd, "no ENDWHILE follows");
  Block& block = to_.block(open.word.block);
  if (block.op == Op::Fault) return;
  block.op = Op::Words;
  block.data = block.aux = 0;
}

/// Refuse a block where its condition does not hold.
void Structure::refuse_otherwise(const Word& word, Cause cause, const char* detail) {
  Block& block = to_.block(word.block);
  if (block.op == Op::Fault) return;
  Statement condition = statement(word.block);
  Block instead = block;
  to_.refuse(instead, {cause, word.at, word.width, detail});
  condition.then = to_.keep(instead);
  condition.expression = to_.expressions().changed(condition.expression, Ins::Not);
  to_.become(block, Op::IfThen, condition);
}

void Structure::match(const Met& met) {
  using enum Link::Kind;
  switch (met.link.kind) {
    case If:
    case While:
    case Loop:
    case For:
    case Repeat:
      return open(met);
    case Else:
      return match_else(word_of(met));
    case EndIf:
      return close(met, If);
    case EndWhile:
      return close(met, While);
    case EndLoop:
      return close(met, Loop);
    case EndFor:
      return close(met, For);
    case Until:
      return close(met, Repeat);
    case Jump:  // resolved when the structures are known
    case Switch:
    case Part:
    case None:
      return;
  }
}

void Structure::open(const Met& met) {
  const std::size_t around = open_.empty() ? 0 : open_.back().span;
  if (open_.size() >= kMostOpen) {
    const bool branch = met.link.kind == Link::Kind::If;
    refuse(word_of(met), branch ? Cause::IfTooDeep : Cause::LoopsTooDeep,
           "the control allows 16 control structures inside each other");
  }
  spans_.push_back({met.address, kNowhere, around});
  marks_.push_back({met.address + 1, spans_.size()});
  open_.push_back({word_of(met), met.link.kind, {}, spans_.size()});
}

/// Return whether a jump leads into a structure that it does not stand in. The innermost structure
/// around the target decides: if it holds the jump, all structures around it do.
bool Structure::leads_inside(Address from, Address to) const {
  const auto behind = std::upper_bound(marks_.begin(), marks_.end(), to,
                                       [](Address at, const Mark& of) { return at < of.from; });
  if (behind == marks_.begin()) return false;
  const std::size_t span = std::prev(behind)->span;
  return span != 0 && !spans_[span - 1].holds(from);
}

void Structure::match_else(const Word& word) {
  if (open_.empty() || open_.back().kind != Link::Kind::If || open_.back().other.block != kNowhere)
    return refuse(word, Cause::IfWithoutEnd, "this ELSE has no IF");
  open_.back().other = word;
  // An ELSE that is refused alarms when its IF leads there.
  const Address otherwise = runs(word.block, Op::Else) ? word.block + 1 : word.block;
  const Address branch = open_.back().word.block;
  if (runs(branch, Op::If)) statement(branch).to = otherwise;
}

void Structure::close(const Met& met, Link::Kind opener) {
  const Address end = met.address;
  const bool branch = opener == Link::Kind::If;
  if (open_.empty() || open_.back().kind != opener)
    return refuse(word_of(met), branch ? Cause::IfWithoutEnd : Cause::MissingDo,
                  "this end has no beginning, or another structure is open in between");
  const Open open = open_.back();
  open_.pop_back();
  Span& span = spans_[open.span - 1];
  span.last = end;
  marks_.push_back({end + 1, span.around});
  const Address begin = open.word.block, other = open.other.block;
  if (branch) {
    if (other != kNowhere && runs(other, Op::Else)) statement(other).to = end;
    if (other == kNowhere && runs(begin, Op::If)) statement(begin).to = end;
    return;
  }
  const bool counts = runs(begin, Op::For);
  if (counts || runs(begin, Op::While) || runs(begin, Op::Do)) {
    statement(begin).end = end;
    statement(begin).to = end + 1;
  }
  if (runs(end, Op::EndDo) || runs(end, Op::EndFor) || runs(end, Op::IfGoto))
    statement(end).to = begin;
  if (runs(end, Op::IfGoto)) end_loop_by(statement(end), LoopEnd::ToHead);
  if (counts && runs(end, Op::EndFor))
    statement(end).then = static_cast<std::uint32_t>(statement(begin).number);
}

/// Return the blocks of a label, or of a block number, in their order.
const std::vector<Address>& Structure::blocks_of(const JumpTarget& target) {
  static const std::vector<Address> kNone;
  if (!target.label.empty()) {
    const auto found = labels_.find(target.label);
    return found != labels_.end() ? found->second : kNone;
  }
  const auto [found, is_new] = numbered_.try_emplace(target.number);
  if (!is_new) return found->second;
  const Code& code = to_.code();
  const Program& program = code.programs.back();
  for (Address a = code.first_of(program, target.number); a != kNowhere;
       a = code.next_of(program, target.number, a))
    found->second.push_back(a);
  return found->second;
}

/// Return the nearest block of the label, or of the number, in the direction of the search. `other`
/// becomes one more block that has it, if there is one. [NCI labels]
Address Structure::target(Address from, const JumpTarget& sought, Address& other) {
  const std::vector<Address>& of = blocks_of(sought);
  const auto behind = std::upper_bound(of.begin(), of.end(), from);
  Address found_at = kNowhere;
  if (sought.direction != 'B' && behind != of.end())
    found_at = *behind;
  else if (sought.direction != 'F' && behind != of.begin())  // backwards a block may name itself
    found_at = *std::prev(behind);
  if (of.size() > 1) other = of.front() == found_at ? of.back() : of.front();
  return found_at;
}

/// Make a block the fault of a jump that finds nothing; GOTOC goes on instead.
void Structure::refuse_jump(Block& block, const JumpTarget& target, bool inside) {
  block.op = Op::Words;
  block.data = 0;
  if (target.direction == 'C') return;
  to_.refuse(block, {Cause::JumpTargetNotFound, target.at, target.width,
                     inside ? "the block is inside a control structure, and the jump is outside it"
                            : "no such block in the direction of the search"});
}

/// Refuse a jump to a block that is read in another mode: the control would read it in the mode of
/// the jump.
bool Structure::refuse_other_mode(Block& block, Address from, Address to,
                                  const JumpTarget& target) {
  const auto changes = [this](Address at) {
    return std::upper_bound(modes_.begin(), modes_.end(), at) - modes_.begin();
  };
  if (modes_.empty() || to == kNowhere || (changes(from) - changes(to)) % 2 == 0) return false;
  to_.refuse(block, {Cause::CodeNotComputed, target.at, target.width,
                     "cncsub does not compute a jump between the ISO mode and the own language"});
  return true;
}

void Structure::resolve(const Met& met) {
  const JumpTarget& sought = met.link.target;
  computed_ = computed_ || sought.computed;
  if (sought.computed) return;
  Address other = kNowhere;
  const Address to = target(met.address, sought, other);
  if (refuse_other_mode(to_.block(met.address), met.address, to, sought)) return;
  const bool inside = to != kNowhere && leads_inside(met.address, to);
  if (to != kNowhere && !inside) {
    statement(met.address).to = to;
    statement(met.address).end = other;
    return;
  }
  // It is reported when the jump is made.
  Block& block = to_.block(met.address);
  Block instead = block;
  refuse_jump(instead, sought, inside);
  if (!met.link.conditional) {
    block = instead;
    return;
  }
  Statement condition = statement(met.address);
  condition.then = to_.keep(instead);
  to_.become(block, Op::IfThen, condition);
}

/// Resolve one of several jumps of a block.
void Structure::resolve(Address from, const AlternativeJump& one) {
  computed_ = computed_ || one.target.computed;
  if (one.target.computed) return;
  Address other = kNowhere;
  const Address to = target(from, one.target, other);
  if (refuse_other_mode(to_.record<Block>(one.variant), from, to, one.target)) return;
  const bool inside = to != kNowhere && leads_inside(from, to);
  Block& block = to_.record<Block>(one.variant);
  if (to == kNowhere || inside) return refuse_jump(block, one.target, inside);
  Statement& jump = to_.record<Statement>(block.aux);
  jump.to = to;
  jump.end = other;
}

/// Return the block after a part that begins at `first`; kNowhere where the part has no end.
Address Structure::part_end(const Met& met, Address first) {
  const auto behind = [&](const JumpTarget& label) {
    const std::vector<Address>& of = blocks_of(label);
    const auto found = std::lower_bound(of.begin(), of.end(), first);
    return found == of.end() ? kNowhere : *found + 1;
  };
  if (met.link.part_end == Link::PartEnd::Block) return first + 1;
  JumpTarget last = met.link.last;
  if (met.link.part_end == Link::PartEnd::Here) last.label = "ENDLABEL";
  const Address end = behind(last);
  if (met.link.part_end == Link::PartEnd::Called) return end;
  // Where its end does not stand before the repeating block, that block ends it.
  return first < met.address && (end == kNowhere || end > met.address) ? met.address : end;
}

/// Find the blocks of a part: its first one is searched for before the repeating block, then after
/// it. [general knowledge]
void Structure::resolve_part(const Met& met) {
  Block& block = to_.block(met.address);
  const std::vector<Address>& of = blocks_of(met.link.target);
  const auto behind = std::lower_bound(of.begin(), of.end(), met.address);
  Address first = kNowhere;
  if (behind != of.begin())
    first = *std::prev(behind);
  else if (behind != of.end() && *behind != met.address)
    first = *behind;
  const Address end = first == kNowhere ? kNowhere : part_end(met, first);
  if (end == kNowhere) {
    const JumpTarget& missing =
        first == kNowhere || met.link.last.at == 0 ? met.link.target : met.link.last;
    return to_.refuse(
        block, {Cause::PartIncomplete, missing.at, missing.width,
                first == kNowhere ? "no block has this label" : "no block with its end follows"});
  }
  CallRecord& call = to_.record<CallRecord>(block.aux);
  call.target.start = first;
  call.extras.make().part_end = end;
  to_.block(end).skip |= Block::kPartEnd;
}

}  // namespace cncsub::sinumerik
