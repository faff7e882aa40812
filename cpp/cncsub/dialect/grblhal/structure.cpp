#include "cncsub/dialect/grblhal/structure.hpp"

#include <algorithm>

#include "cncsub/code/loop_end.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub::grblhal {

namespace {

using FlowKind = Flow::Kind;

constexpr std::size_t kMostOpen = 20;  // branches, loops and calls [gHf, NGC_STACK_DEPTH]

}  // namespace

void Structure::begin(std::uint32_t file) {
  file_ = file;
  program_ = static_cast<std::int32_t>(to_.code().programs.size()) - 1;
  endsub_ = 0;
  part_end_ = kNowhere;
  lines_.clear();
  open_.clear();
  walls_.clear();
  subs_.clear();
}

void Structure::add(const Flow& flow) {
  if (flow.wall) walls_.push_back(to_.next_address());
  if (flow.kind == FlowKind::None) return;
  lines_.push_back({to_.next_address(), flow});
}

void Structure::refuse(const Met& met, Cause cause, const char* detail) {
  Block& block = to_.block(met.address);
  if (block.op != Op::Fault) to_.refuse(block, {cause, met.flow.at, met.flow.width, detail});
}

void Structure::become(const Met& met, Op op) {
  Block& block = to_.block(met.address);
  if (block.op != Op::Fault) to_.become(block, op, met.flow.statement);
}

void Structure::go_to(Address from, Address to) {
  Block& block = to_.block(from);
  if (block.op == Op::Fault) return;
  Statement jump;
  jump.to = to;
  jump.at = block.text;
  to_.become(block, Op::Goto, jump);
}

/// Return where passing over the blocks from one to another leads: to the first that is refused all
/// the same, if there is one.
Address Structure::passing(Address from, Address to) const {
  const auto wall = std::upper_bound(walls_.begin(), walls_.end(), from);
  return wall == walls_.end() ? to : std::min(*wall, to);
}

void Structure::match() {
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    if (to_.interrupt().requested(InterruptCheck::kBlock)) return;
    match(i);
  }
  for (const Open& open : open_) {
    for (const std::size_t leave : open.leaves)
      refuse(lines_[leave], Cause::MissingEnd, "the end of its loop is missing");
    refuse(lines_[open.met], Cause::MissingEnd, "its end is missing");
  }
}

void Structure::match(std::size_t met) {
  switch (lines_[met].flow.kind) {
    case FlowKind::If:
      become(lines_[met], Op::If);
      open(met);
      return;
    case FlowKind::ElseIf:
    case FlowKind::Else:
      return branch(met);
    case FlowKind::EndIf:
      return end_branch(met);
    case FlowKind::Repeat:
      if (!open(met)) return;
      count(lines_[met].flow);
      return become(lines_[met], Op::For);
    case FlowKind::While:
      if (!open_.empty() && lines_[open_.back().met].flow.kind == FlowKind::Do &&
          lines_[open_.back().met].flow.label == lines_[met].flow.label)
        return end_do(lines_[met]);
      become(lines_[met], Op::While);
      open(met);
      return;
    case FlowKind::Do:
      open(met);
      return;
    case FlowKind::EndWhile:
    case FlowKind::EndRepeat:
      return end_loop(met);
    case FlowKind::Break:
    case FlowKind::Continue:
      return leave_loop(met);
    case FlowKind::Sub:
      return sub(met);
    case FlowKind::Call:
      return call(met);
    case FlowKind::EndSub:
    case FlowKind::Return:
    case FlowKind::None:
      return;
  }
}

/// Open a structure. One too many is refused, and what stands in it belongs to the one around it.
bool Structure::open(std::size_t met) {
  if (open_.size() < kMostOpen) {
    open_.push_back({met, lines_[met].address});
    return true;
  }
  refuse(lines_[met], Cause::NestingTooDeep,
         "the control allows 20 branches and loops inside each other");
  return false;
}

/// Count the passes of a repeat by a variable that no program names: from 1 - n to 0. M98 shares
/// the locals of its caller, so that each file has counters of its own.
void Structure::count(Flow& flow) {
  ExpressionWriter& write = to_.expressions();
  const std::uint32_t at = flow.at;
  const std::string name = "repeat " + std::to_string(file_) + " " + std::to_string(open_.size());
  const auto counter = static_cast<std::uint32_t>(to_.names().hidden(name, 1));
  Statement first;
  first.target = Statement::Target::Local;
  first.index = static_cast<std::int32_t>(counter);
  first.at = at;
  Statement next = first;
  first.expression = write.changed(flow.statement.expression, Ins::Round);
  first.expression = write.changed(first.expression, Ins::Negate);
  write.begin();
  write.emit({Ins::Local, 0, counter, 0});
  write.emit({Ins::AddConstant, 0, at, 1});
  next.expression = write.end(at, flow.width);
  flow.statement.expression = write.one({Ins::Constant, 0, at, -1}, at, flow.width);
  flow.statement.then = to_.keep(first);
  flow.statement.number = static_cast<std::int32_t>(to_.keep(next));
}

/// Return the innermost structure if it is of one of these kinds and has the label of a word. A
/// word of another label does nothing; one in a structure of another kind is refused.
Structure::Open* Structure::innermost(FlowKind a, FlowKind b, const Met& met) {
  const FlowKind kind = open_.empty() ? FlowKind::None : lines_[open_.back().met].flow.kind;
  if (kind != a && kind != b) {
    refuse(met, Cause::LabelNotFound, "no structure that it belongs to is open");
    return nullptr;
  }
  return lines_[open_.back().met].flow.label == met.flow.label ? &open_.back() : nullptr;
}

void Structure::branch(std::size_t met) {
  const Met& word = lines_[met];
  Open* const open = innermost(FlowKind::If, FlowKind::If, word);
  if (open == nullptr) return;
  const bool otherwise = word.flow.kind == FlowKind::Else;
  // Where a branch has run, elseif goes to the end from the block before its condition.
  const Address leave = otherwise ? word.address : word.address - 1;
  if (open->last != kNowhere && to_.block(open->last).op == Op::If)
    statement(open->last).to = passing(open->last, word.address + (otherwise ? 1 : 0));
  open->ends.push_back(leave);
  open->last = otherwise ? kNowhere : word.address;
  if (!otherwise) become(word, Op::If);
}

void Structure::end_branch(std::size_t met) {
  const Met& word = lines_[met];
  Open* const open = innermost(FlowKind::If, FlowKind::If, word);
  if (open == nullptr) return;
  if (open->last != kNowhere && to_.block(open->last).op == Op::If)
    statement(open->last).to = passing(open->last, word.address);
  for (const Address end : open->ends) {
    Block& block = to_.block(end);
    if (block.op == Op::Fault) continue;
    Statement otherwise;
    otherwise.to = passing(end, word.address);
    otherwise.at = block.text;
    to_.become(block, Op::Else, otherwise);
  }
  become(word, Op::EndIf);
  open_.pop_back();
}

/// Let continue go on with a while whose condition holds. Where it does not hold any more, the
/// control goes on after continue with the loop closed, and refuses its end. [gHf, ngc_flowctrl]
void Structure::next_pass(const Met& word, Address head, Address end) {
  Block& block = to_.block(word.address);
  if (block.op == Op::Fault || to_.block(head).op != Op::While) return;
  Block instead = block;
  to_.refuse(instead, {Cause::CodeNotComputed, word.flow.at, word.flow.width,
                       "the condition no longer holds: the control runs the rest of the loop, and "
                       "refuses its endwhile"});
  Statement over = word.flow.statement;
  over.expression = to_.expressions().changed(statement(head).expression, Ins::Not);
  over.then = to_.keep(instead);
  to_.become(to_.block(word.address), Op::IfThen, over);
  go_to(word.address + 1, end);
}

/// Let break and continue go where they lead.
void Structure::jumps_of(const Open& open, Address end, Address next) {
  const Met& head = lines_[open.met];
  for (const std::size_t leave : open.leaves) {
    const Met& word = lines_[leave];
    if (word.flow.kind == FlowKind::Break)
      go_to(word.address, passing(word.address, end));
    else if (head.flow.kind == FlowKind::While)
      next_pass(word, head.address, next);
    else
      go_to(word.address, next);
  }
}

void Structure::end_loop(std::size_t met) {
  const Met& word = lines_[met];
  const FlowKind wanted = word.flow.kind == FlowKind::EndWhile ? FlowKind::While : FlowKind::Repeat;
  Open* const open = innermost(wanted, wanted, word);
  if (open == nullptr) return;
  const Address head = lines_[open->met].address;
  if (to_.block(head).op != Op::Fault) {
    statement(head).to = passing(head, word.address + 1);
    statement(head).end = word.address;
    Met last = word;
    last.flow.statement.to = head;
    if (wanted == FlowKind::Repeat)
      last.flow.statement.then = static_cast<std::uint32_t>(statement(head).number);
    become(last, wanted == FlowKind::Repeat ? Op::EndFor : Op::EndDo);
  }
  jumps_of(*open, word.address + 1, word.address);
  open_.pop_back();
}

void Structure::end_do(const Met& word) {
  Met last = word;
  const Address head = lines_[open_.back().met].address;
  last.flow.statement.to = head + 1;
  end_loop_by(last.flow.statement, LoopEnd::BehindHead);
  become(last, Op::IfGoto);
  jumps_of(open_.back(), word.address + 1, head + 1);
  open_.pop_back();
}

void Structure::leave_loop(std::size_t met) {
  const Met& word = lines_[met];
  for (auto open = open_.rbegin(); open != open_.rend(); ++open) {
    const Flow& of = lines_[open->met].flow;
    if (of.label != word.flow.label) continue;
    if (of.kind == FlowKind::If) break;
    open->leaves.push_back(met);
    return;
  }
  refuse(word, Cause::LabelNotFound, "no loop of its label is open");
}

/// Return the next endsub from a line on, of whatever label; null if there is none. Lines are asked
/// for in their order.
const Structure::Met* Structure::endsub(std::size_t from) {
  endsub_ = std::max(endsub_, from);
  while (endsub_ < lines_.size() && lines_[endsub_].flow.kind != FlowKind::EndSub) ++endsub_;
  return endsub_ < lines_.size() ? &lines_[endsub_] : nullptr;
}

/// Let a definition go to the block after the next endsub. One without it goes to the end of the
/// file: the control passes over every line after it. Of those that share an endsub the first is a
/// part, and holds the others.
void Structure::sub(std::size_t met) {
  const Met& word = lines_[met];
  if (word.flow.named) {
    if (!same_letters(word.flow.label, to_.code().files[file_].stem))
      refuse(word, Cause::LabelNotFound, "a subprogram with a name has a file of its own");
    return;
  }
  const Met* const end = endsub(met);
  const Address after = end == nullptr ? to_.next_address() - 1 : end->address + 1;
  go_to(word.address, passing(word.address, after));
  if (subs_.contains(word.flow.label)) return;  // the first of a label counts
  std::int32_t program = program_;
  if (end != nullptr)
    program = after == part_end_ ? static_cast<std::int32_t>(to_.code().programs.size()) - 1
                                 : part(word, after);
  subs_[word.flow.label] = {end == nullptr ? after : word.address + 1, program};
}

/// Add a subprogram as a part of the file; return its number.
std::int32_t Structure::part(const Met& word, Address end) {
  const Block& block = to_.block(word.address);
  Program part;
  part.file = file_;
  part.line = block.line;
  part.inside = program_;
  part.first = word.address + 1;
  part.last = end;
  part.text = word.flow.at;
  part.text_end = to_.block(end).text;
  part.name_at = word.flow.at + 1;
  part.name_length = static_cast<std::uint32_t>(word.flow.label.size());
  to_.part(part);
  part_end_ = end;
  return static_cast<std::int32_t>(to_.code().programs.size()) - 1;
}

void Structure::call(std::size_t met) {
  const Met& word = lines_[met];
  if (word.flow.named) return;
  const auto found = subs_.find(word.flow.label);
  if (found == subs_.end())
    return refuse(word, Cause::LabelNotFound, "no subprogram of this label stands before the call");
  CallRecord& call = to_.record<CallRecord>(word.flow.call);
  call.constant = true;
  call.target.start = found->second.first;
  call.target.program = found->second.second;
}

}  // namespace cncsub::grblhal
