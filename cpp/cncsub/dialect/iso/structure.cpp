#include "cncsub/dialect/iso/structure.hpp"

#include <vector>

namespace cncsub {

namespace {

class Structure {
 public:
  Structure(Builder& to, const Program& program) : to_(to), program_(program) {}

  void match() {
    for (Address a = first(); a < program_.last && !over(); ++a) match(a);
    for (const Open& open : loops_)
      fault_at(open.address, Cause::MissingEnd, "this loop has no end");
    for (const Open& open : ifs_) {
      if (open.other != kNowhere)
        fault_at(open.other, Cause::IfWithoutEnd, "this ELSE has no ENDIF");
      if (op_at(open.address) == Op::If)
        fault_at(open.address, Cause::IfWithoutEnd, "this IF has no ENDIF");
    }
    for (Address a = first(); a < program_.last && !over(); ++a) resolve_jump(a, to_.block(a));
  }

 private:
  struct Open {
    Address address;
    std::int32_t number;
    Address other = kNowhere;  // of an IF: its ELSE
  };

  Address first() const { return program_.first; }
  bool over() { return to_.interrupt().requested(InterruptCheck::kBlock); }
  bool numbered() const { return to_.control().macros.loop_form.value == LoopForm::DoEnd; }

  void match(Address a) {
    switch (op_at(a)) {
      case Op::While:
      case Op::Do:
        return open_loop(a);
      case Op::EndDo:
        return close_loop(a);
      case Op::If:
        return open_if(a);
      case Op::Else:
        return match_else(a);
      case Op::EndIf:
        return match_end_if(a);
      default:
        return;
    }
  }

  void open_if(Address a) {
    ifs_.push_back({a, 0});
    if (ifs_.size() > static_cast<std::size_t>(to_.control().macros.max_ifs.value))
      fault_at(a, Cause::IfTooDeep, "more IF blocks inside each other than the control allows");
  }

  void resolve_jump(Address address, const Block& block) {
    if (block.op == Op::Goto || block.op == Op::IfGoto) {
      Statement& jump = to_.record<Statement>(block.aux);
      if (jump.number >= 0) jump.to = to_.code().jump_target(program_, jump.number, address);
    } else if (block.op == Op::IfThen) {
      resolve_jump(address, to_.record<Block>(to_.record<Statement>(block.aux).then));
    }
  }

  Op op_at(Address address) { return to_.block(address).op; }
  Statement& statement_at(Address address) { return to_.record<Statement>(to_.block(address).aux); }

  void fault_at(Address address, Cause cause, const char* detail) {
    const Statement& statement = statement_at(address);
    to_.refuse(to_.block(address), {cause, statement.at, statement.width, detail});
  }

  void open_loop(Address a) {
    const std::int32_t number = statement_at(a).number;
    if (numbered())
      for (const Open& open : loops_)
        if (open.number == number)
          return fault_at(a, Cause::MissingEnd, "a loop with this DO number is already open");
    if (loops_.size() >= static_cast<std::size_t>(to_.control().macros.max_loops.value))
      return fault_at(a, Cause::LoopsTooDeep,
                      "more loops inside each other than the control allows");
    loops_.push_back({a, number});
  }

  void close_loop(Address a) {
    const std::int32_t number = statement_at(a).number;
    std::size_t at = loops_.size();
    while (at > 0 && numbered() && loops_[at - 1].number != number) --at;
    if (at == 0) return fault_at(a, Cause::MissingDo, "no loop is open that this could end");
    for (std::size_t i = at; i < loops_.size(); ++i)
      fault_at(loops_[i].address, Cause::MissingEnd, "this loop crosses another");
    const Address start = loops_[at - 1].address;
    loops_.resize(at - 1);
    statement_at(start).end = a;
    statement_at(start).to = a + 1;
    statement_at(a).to = start;
  }

  void match_else(Address a) {
    if (ifs_.empty() || ifs_.back().other != kNowhere)
      return fault_at(a, Cause::IfWithoutEnd, "this ELSE has no IF");
    ifs_.back().other = a;
    if (op_at(ifs_.back().address) == Op::If) statement_at(ifs_.back().address).to = a + 1;
  }

  void match_end_if(Address a) {
    if (ifs_.empty()) return fault_at(a, Cause::IfWithoutEnd, "this ENDIF has no IF");
    const Open open = ifs_.back();
    ifs_.pop_back();
    if (open.other != kNowhere)
      statement_at(open.other).to = a;
    else if (op_at(open.address) == Op::If)
      statement_at(open.address).to = a;
  }

  Builder& to_;
  const Program& program_;
  std::vector<Open> loops_, ifs_;
};

}  // namespace

void match_structure(Builder& to, const Program& program) { Structure(to, program).match(); }

}  // namespace cncsub
