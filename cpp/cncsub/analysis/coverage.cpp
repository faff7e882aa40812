#include "cncsub/analysis/coverage.hpp"

#include <map>
#include <tuple>
#include <utility>

#include "cncsub/code/references.hpp"

namespace cncsub {

std::string_view to_string(Branch branch) {
  switch (branch) {
    case Branch::None:
      return "";
    case Branch::IfGoto:
      return "if-goto";
    case Branch::IfThen:
      return "if-then";
    case Branch::If:
      return "if";
    case Branch::ElseIf:
      return "elseif";
    case Branch::DoWhile:
      return "do-while";
    case Branch::HJump:
      return "h-jump";
    case Branch::Input:
      return "input-jump";
    case Branch::While:
      return "while";
    case Branch::Repeat:
      return "repeat";
    case Branch::For:
      return "for";
    case Branch::Case:
      return "case";
  }
  return "";
}

namespace {

Branch branch_of(const Code& code, const Block& block) {
  switch (block.op) {
    case Op::IfGoto:
      return Branch::IfGoto;
    case Op::IfThen:
      return Branch::IfThen;
    case Op::If:
      return Branch::If;
    case Op::While:
      return Branch::While;
    case Op::EndFor:
      return Branch::For;
    case Op::Switch:
      return Branch::Case;
    case Op::HCode: {
      const int number = code.h_codes[block.aux].number;
      return number >= 81 && number <= 86 ? Branch::HJump : Branch::None;
    }
    case Op::Jump:
      return code.jumps[block.aux].reads_input ? Branch::Input : Branch::None;
    default:
      return Branch::None;
  }
}

/// The labels that are open in one program: those of loops, and those of do whose while stands at
/// its end.
struct OpenLabels {
  std::unordered_map<std::uint32_t, Address> loops;
  std::unordered_map<std::uint32_t, Address> dos;

  Branch meet(const OWord& own, Address at, std::unordered_map<Address, Address>& ends) {
    switch (own.kind) {
      case OWordKind::If:
        return Branch::If;
      case OWordKind::ElseIf:
        return Branch::ElseIf;
      case OWordKind::Do:
        dos[own.label] = at;
        return Branch::None;
      case OWordKind::While:
        if (dos.erase(own.label) != 0) return Branch::DoWhile;
        loops[own.label] = at;
        return Branch::While;
      case OWordKind::Repeat:
        loops[own.label] = at;
        return Branch::Repeat;
      case OWordKind::EndWhile:
      case OWordKind::EndRepeat:
        if (const auto found = loops.find(own.label); found != loops.end())
          ends[found->second] = at;
        return Branch::None;
      case OWordKind::Sub:
      case OWordKind::Head:
        *this = {};
        return Branch::None;
      default:
        return Branch::None;
    }
  }
};

/// Counts the passes of loops. A loop that a jump or a return leaves ends with the first step
/// outside it.
class Loops {
 public:
  Loops(const Code& code, const Branches& branches, Coverage& to)
      : code_(code), branches_(branches), to_(to) {}

  bool open() const { return !open_.empty(); }
  void follow(const Trace::Step& step) {
    while (!open_.empty() && !stays_open(open_.back(), step)) close();
    const Branch branch = branches_.of[step.address];
    if (is_loop(branch)) return head(step);
    if (code_.blocks[step.address].op == Op::Return)
      while (!open_.empty() && open_.back().call == step.call) close();
  }
  void close_all() {
    while (!open_.empty()) close();
  }

 private:
  struct Open {
    Address start, end;
    std::int32_t call, repeat;
    std::int64_t passes;
  };

  /// A call has a higher number than the one that made it.
  static bool stays_open(const Open& loop, const Trace::Step& step) {
    if (step.call != loop.call) return step.call > loop.call;
    return step.repeat == loop.repeat && step.address >= loop.start && step.address <= loop.end;
  }
  void head(const Trace::Step& step) {
    const bool inside =
        !open_.empty() && open_.back().call == step.call && open_.back().start == step.address;
    if (step.failed == 0 && inside) {
      ++open_.back().passes;
    } else if (step.failed == 0) {
      const auto end = branches_.ends.find(step.address);
      open_.push_back({step.address, end == branches_.ends.end() ? kNowhere : end->second,
                       step.call, step.repeat, 1});
    } else if (inside) {
      close();
    } else {
      ++to_.loops[step.address][0];
    }
  }
  void close() {
    ++to_.loops[open_.back().start][open_.back().passes > 1 ? 2 : 1];
    open_.pop_back();
  }

  const Code& code_;
  const Branches& branches_;
  Coverage& to_;
  std::vector<Open> open_;
};

/// Counts the blocks that a switch passed over: blocks with a skip mark between the place where the
/// block before led and the block that was executed.
class Skips {
 public:
  Skips(const Code& code, const Branches& branches, std::int64_t* skipped)
      : code_(code), branches_(branches), skipped_(skipped) {
    for (const Block& block : code.blocks) any_ = any_ || block.can_be_skipped();
  }

  bool any() const { return any_; }
  void follow(const Trace::Step& step) {
    if (step.address > 0 && code_.blocks[step.address - 1].can_be_skipped()) {
      Address from = arrival(step);
      if (!all_marked(from, step.address)) from = step.address;
      for (Address a = from; a < step.address; ++a) ++skipped_[a];
    }
    last_ = step;
    begun_ = true;
  }

 private:
  /// Return where the step before led; the step itself where that is unknown.
  Address arrival(const Trace::Step& step) const {
    const Program& program =
        code_.programs[static_cast<std::size_t>(code_.program_at(step.address))];
    if (!begun_ || step.call > last_.call) return program.first;
    if (step.call < last_.call || step.repeat != last_.repeat) return behind_call(step, program);
    const Block& block = code_.blocks[last_.address];
    switch (block.op) {
      case Op::Goto:
      case Op::IfGoto:
        if (last_.failed != 0) return last_.address + 1;
        return or_itself(code_.statements[block.aux].to, step);
      case Op::While:
        if (last_.failed == 0) return last_.address + 1;
        return or_itself(code_.statements[block.aux].end + 1, step);
      case Op::Return:  // the main program starts over, at its head or at a block that it names
        return code_.calls[block.aux].p.kind == Operand::Kind::Absent ? program.first
                                                                      : step.address;
      case Op::HCode:
      case Op::Jump:
        return branches_.of[last_.address] != Branch::None && last_.failed != 0 ? last_.address + 1
                                                                                : step.address;
      case Op::If:
      case Op::Else:
      case Op::For:
      case Op::EndFor:
      case Op::EndDo:
      case Op::OWord:
      case Op::IfThen:
      case Op::Switch:
      case Op::RepeatPart:
      case Op::Select:
      case Op::ParallelAssign:
        return last_.address < step.address ? last_.address + 1 : step.address;
      default:
        return last_.address + 1;
    }
  }
  static Address or_itself(Address to, const Trace::Step& step) {
    return to == kNowhere ? step.address : to;
  }
  /// Return where a call or a pass leads when it is over: after the block that called, or at the
  /// head of the program for another pass.
  Address behind_call(const Trace::Step& step, const Program& program) const {
    if (step.call == last_.call) return program.first;
    Address from = step.address;
    while (from > program.first && code_.blocks[from - 1].can_be_skipped()) --from;
    if (from == program.first) return step.address;
    return may_call(code_.blocks[from - 1].op) ? from : step.address;
  }
  /// Return whether all blocks from `from` up to the step have a skip mark.
  bool all_marked(Address from, Address step) const {
    Address a = step;
    while (a > from && code_.blocks[a - 1].can_be_skipped()) --a;
    return a == from;
  }

  const Code& code_;
  const Branches& branches_;
  std::int64_t* skipped_;
  bool any_ = false, begun_ = false;
  Trace::Step last_{};
};

void count_calls(const Trace& trace, Coverage& to, InterruptCheck& interrupt) {
  std::map<std::tuple<Address, CallKind, std::int32_t>, std::int64_t> calls;
  std::map<std::pair<std::int32_t, std::int32_t>, std::int64_t> given;
  const auto steps = static_cast<std::int64_t>(trace.steps.size());
  auto last = calls.end();
  for (std::size_t row = 0; row < trace.calls.size(); ++row) {
    if (interrupt.requested(sizeof(CallRow))) return;
    const CallRow& call = trace.calls[row];
    const std::int64_t caller = call.caller_step - trace.first_step;
    for (std::uint32_t i = 0; i < call.arguments; ++i)
      ++given[{call.program, trace.arguments[call.first_argument + i].variable}];
    // A block that alarmed as it called may be no step.
    if (caller < 0 || caller >= steps) continue;
    const std::tuple key{trace.steps[static_cast<std::size_t>(caller)].address + 0U, call.kind,
                         call.program};
    if (last == calls.end() || last->first != key) last = calls.try_emplace(key, 0).first;
    ++last->second;
  }
  for (const auto& [key, count] : calls)
    to.calls.push_back({std::get<0>(key), std::get<1>(key), std::get<2>(key), count});
  for (const auto& [key, count] : given) to.arguments.push_back({key.first, key.second, count});
}

}  // namespace

Branches::Branches(const Code& code) : of(code.blocks.size(), Branch::None) {
  OpenLabels labels;
  for (Address a = 0; a < code.blocks.size(); ++a) {
    const Block* block = &code.blocks[a];
    // Words after a skip mark inside the block make it no other statement.
    if (block->op == Op::Select) block = &code.variants[code.selects[block->aux].first];
    if (block->op == Op::OWord) {
      of[a] = labels.meet(code.o_words[block->aux], a, ends);
    } else {
      of[a] = branch_of(code, *block);
      if (block->op == Op::While) ends[a] = code.statements[block->aux].end;
    }
  }
}

Coverage coverage_of(const Code& code, const Trace& trace, const BlockCounts& counts,
                     InterruptCheck& interrupt) {
  Coverage found;
  const Branches branches(code);
  Loops loops(code, branches, found);
  Skips skips(code, branches, counts.skipped);
  trace.steps.for_each_run(0, trace.steps.size(), [&](const Trace::Step* rows, std::size_t count) {
    if (interrupt.requested(count * sizeof(Trace::Step))) return;
    for (std::size_t i = 0; i < count; ++i) {
      const Trace::Step& step = rows[i];
      ++(step.failed != 0 ? counts.failed : counts.held)[step.address];
      if (skips.any()) skips.follow(step);
      if (loops.open() || is_loop(branches.of[step.address])) loops.follow(step);
    }
  });
  loops.close_all();
  count_calls(trace, found, interrupt);
  return found;
}

}  // namespace cncsub
