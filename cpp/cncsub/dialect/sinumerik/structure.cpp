#include "cncsub/dialect/sinumerik/structure.hpp"

#include <algorithm>

namespace cncsub::sinumerik {

void Structure::add(const std::string& label, const Link& link) {
  const Address address = to_.next_address();
  if (!label.empty()) labels_[label].push_back(address);
  if (link.kind != Link::Kind::None) links_.push_back({address, link});
}

void Structure::refuse(Address address, Cause cause, const char* detail) {
  Block& block = to_.block(address);
  if (block.op != Op::Fault) to_.refuse(block, {cause, block.text, 0, detail});
}

void Structure::match() {
  open_.clear();
  spans_.clear();
  marks_.clear();
  for (const Met& met : links_) {
    if (to_.interrupt().requested(InterruptCheck::kBlock)) return;
    match(met);
  }
  for (const Met& met : links_)
    if (met.link.kind == Link::Kind::Jump) resolve(met);
  for (const Open& open : open_) leave_open(open);
}

/// Let a structure without an end run, up to where its end is searched for. The control does not
/// look at structures as a whole. [840Dsl p.107]
void Structure::leave_open(const Open& open) {
  constexpr const char* kNoEndif = "no ENDIF follows";
  if (open.kind == Link::Kind::If) {
    if (open.other != kNowhere) return refuse(open.other, Cause::IfWithoutEnd, kNoEndif);
    return refuse_otherwise(open.address, Cause::IfWithoutEnd, kNoEndif);
  }
  if (open.kind == Link::Kind::While)
    return refuse_otherwise(open.address, Cause::MissingEnd, "no ENDWHILE follows");
  Block& block = to_.block(open.address);
  if (block.op == Op::Fault) return;
  block.op = Op::Words;
  block.data = block.aux = 0;
}

/// Refuse a block where its condition does not hold.
void Structure::refuse_otherwise(Address address, Cause cause, const char* detail) {
  Block& block = to_.block(address);
  if (block.op == Op::Fault) return;
  Statement condition = statement(address);
  Block instead = block;
  to_.refuse(instead, {cause, block.text, 0, detail});
  condition.then = to_.keep(instead);
  const Expression of = to_.code().expression(condition.expression);
  std::vector<Instruction> instructions;
  for (const Instruction each : of) instructions.push_back(each);
  const std::uint32_t at = of.at(), width = of.width();
  to_.expressions().begin();
  for (const Instruction& each : instructions)
    if (each.op != Ins::End) to_.expressions().emit(each);
  to_.expressions().emit({Ins::Not, 0, at, 0});
  condition.expression = to_.expressions().end(at, width);
  to_.become(block, Op::IfThen, condition);
}

void Structure::match(const Met& met) {
  using enum Link::Kind;
  switch (met.link.kind) {
    case If:
    case While:
    case Loop:
    case Repeat:
      return open(met);
    case Else:
      return match_else(met.address);
    case EndIf:
      return close(met, If);
    case EndWhile:
      return close(met, While);
    case EndLoop:
      return close(met, Loop);
    case Until:
      return close(met, Repeat);
    case Jump:  // resolved when the structures are known
    case None:
      return;
  }
}

void Structure::open(const Met& met) {
  const std::size_t around = open_.empty() ? 0 : open_.back().span;
  spans_.push_back({met.address, kNowhere, around});
  marks_.push_back({met.address + 1, spans_.size()});
  open_.push_back({met.address, met.link.kind, kNowhere, spans_.size()});
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

void Structure::match_else(Address address) {
  if (open_.empty() || open_.back().kind != Link::Kind::If || open_.back().other != kNowhere)
    return refuse(address, Cause::IfWithoutEnd, "this ELSE has no IF");
  open_.back().other = address;
  // An ELSE that is refused alarms when its IF leads there.
  const Address otherwise = runs(address, Op::Else) ? address + 1 : address;
  if (runs(open_.back().address, Op::If)) statement(open_.back().address).to = otherwise;
}

void Structure::close(const Met& met, Link::Kind opener) {
  const Address end = met.address;
  const bool branch = opener == Link::Kind::If;
  if (open_.empty() || open_.back().kind != opener)
    return refuse(end, branch ? Cause::IfWithoutEnd : Cause::MissingDo,
                  "this end has no beginning, or another structure is open in between");
  const Open open = open_.back();
  open_.pop_back();
  Span& span = spans_[open.span - 1];
  span.last = end;
  marks_.push_back({end + 1, span.around});
  if (branch) {
    if (open.other != kNowhere && runs(open.other, Op::Else)) statement(open.other).to = end;
    if (open.other == kNowhere && runs(open.address, Op::If)) statement(open.address).to = end;
    return;
  }
  if (runs(open.address, Op::While) || runs(open.address, Op::Do)) {
    statement(open.address).end = end;
    statement(open.address).to = end + 1;
  }
  if (runs(end, Op::EndDo) || runs(end, Op::IfGoto)) statement(end).to = open.address;
}

/// Return the nearest block of the label, or of the number, in the direction of the search. `other`
/// becomes one more block that has it, if there is one. [NCI labels]
Address Structure::target(const Met& met, Address& other) {
  const Link& link = met.link;
  std::vector<Address> blocks;
  if (link.target.empty()) {
    const Program& program = to_.program();
    for (Address a = to_.code().first_of(program, link.number); a != kNowhere;
         a = to_.code().next_of(program, link.number, a))
      blocks.push_back(a);
  }
  const auto found = labels_.find(link.target);
  const std::vector<Address>& of =
      !link.target.empty() && found != labels_.end() ? found->second : blocks;
  const auto behind = std::upper_bound(of.begin(), of.end(), met.address);
  const bool forward = link.direction != 'B';
  Address found_at = kNowhere;
  if (forward && behind != of.end())
    found_at = *behind;
  else if (link.direction != 'F' && behind != of.begin())  // backwards a block may name itself
    found_at = *std::prev(behind);
  if (of.size() > 1) other = of.front() == found_at ? of.back() : of.front();
  return found_at;
}

void Structure::resolve(const Met& met) {
  Address other = kNowhere;
  const Address to = target(met, other);
  Block& block = to_.block(met.address);
  const bool inside = to != kNowhere && leads_inside(met.address, to);
  if (to != kNowhere && !inside) {
    statement(met.address).to = to;
    statement(met.address).end = other;
    return;
  }
  // A jump that finds nothing is reported when it is made; GOTOC goes on instead.
  Block instead = block;
  instead.op = Op::Words;
  instead.data = 0;
  if (met.link.direction != 'C')
    to_.refuse(instead,
               {Cause::JumpTargetNotFound, met.link.at, met.link.width,
                inside ? "the block is inside a control structure, and the jump is outside it"
                       : "no such block in the direction of the search"});
  if (!met.link.conditional) {
    block = instead;
    return;
  }
  Statement condition = statement(met.address);
  condition.then = to_.keep(instead);
  to_.become(block, Op::IfThen, condition);
}

}  // namespace cncsub::sinumerik
