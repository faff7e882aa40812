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
  for (const Met& met : links_) {
    if (to_.interrupt().requested(InterruptCheck::kBlock)) return;
    match(met);
  }
  for (const Open& open : open_) {
    if (open.kind == Link::Kind::If)
      refuse(open.address, Cause::IfWithoutEnd, "this IF has no ENDIF");
    else
      refuse(open.address, Cause::MissingEnd, "this loop has no end");
  }
}

void Structure::match(const Met& met) {
  using enum Link::Kind;
  switch (met.link.kind) {
    case If:
    case While:
    case Loop:
    case Repeat:
      open_.push_back({met.address, met.link.kind});
      return;
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
    case Jump:
      return resolve(met);
    case None:
      return;
  }
}

void Structure::match_else(Address address) {
  if (open_.empty() || open_.back().kind != Link::Kind::If || open_.back().other != kNowhere)
    return refuse(address, Cause::IfWithoutEnd, "this ELSE has no IF");
  open_.back().other = address;
  if (runs(open_.back().address, Op::If)) statement(open_.back().address).to = address + 1;
}

void Structure::close(const Met& met, Link::Kind opener) {
  const Address end = met.address;
  const bool branch = opener == Link::Kind::If;
  if (open_.empty() || open_.back().kind != opener)
    return refuse(end, branch ? Cause::IfWithoutEnd : Cause::MissingDo,
                  "this end has no beginning, or another structure is open in between");
  const Open open = open_.back();
  open_.pop_back();
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

/// The nearest block of the label, or of the number, in the direction of the search; `other` is one
/// more that has it, where there is one. [NCI labels]
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
  if (to != kNowhere) {
    statement(met.address).to = to;
    statement(met.address).end = other;
    return;
  }
  // A jump that finds nothing is told when it is made; GOTOC goes on instead.
  Block instead = block;
  instead.op = Op::Words;
  instead.data = 0;
  if (met.link.direction != 'C')
    to_.refuse(instead, {Cause::JumpTargetNotFound, met.link.at, met.link.width,
                         "no such block in the direction of the search"});
  if (!met.link.conditional) {
    block = instead;
    return;
  }
  Statement condition = statement(met.address);
  condition.then = to_.keep(instead);
  to_.become(block, Op::IfThen, condition);
}

}  // namespace cncsub::sinumerik
