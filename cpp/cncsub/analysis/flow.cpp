#include "cncsub/analysis/flow.hpp"

#include <algorithm>
#include <utility>

#include "cncsub/code/target.hpp"

namespace cncsub {

std::string_view to_string(ExitKind kind) {
  switch (kind) {
    case ExitKind::Jump:
      return "jump";
    case ExitKind::Computed:
      return "computed";
    case ExitKind::Returned:
      return "returned";
    default:
      return "next";
  }
}

bool is_computed(const CallRecord& record) {
  for (const Operand* of :
       {&record.p, &record.l, &record.start(), &record.device(), &record.name_text()})
    if (of->kind == Operand::Kind::Expression) return true;
  return false;
}

/// Records where the program may go on after a block.
class FlowReader {
 public:
  explicit FlowReader(ProgramFlow& to)
      : to_(to), code_(to.code_), program_(code_.programs[static_cast<std::size_t>(to.program_)]) {}

  void read(Address at);

 private:
  void variant(const Block& block);
  void next() { exit(at_ + 1, ExitKind::Next); }
  void exit(Address to, ExitKind kind);
  void mark(std::uint8_t mark) { marks_ = static_cast<std::uint8_t>(marks_ | mark); }
  void jump(const Operand& number);
  void go_to(const Statement& statement);
  void back(const CallRecord& record);
  void back_by_name(const CallRecord& record);
  void call(const Block& block);
  void part(const CallRecord& record);
  void h_code(const HCode& h);
  void o_word(const Block& block, const OWord& own);
  void call_label(const Block& block, const OWord& own);
  bool passes_over(const OWord& own);
  void alternatives(const Statement& choice);
  void select(const Select& choice);
  void words_call_or_assignment(const Block& block);
  void words(const Block& block);
  bool raises_alarm(const Statement& statement) const;

  ProgramFlow& to_;
  const Code& code_;
  const Program& program_;
  Address at_ = 0;
  std::uint8_t marks_ = 0;
  std::vector<Exit> found_;
};

void FlowReader::exit(Address to, ExitKind kind) {
  if (to == kNowhere || to < to_.first_ || to > to_.anywhere()) return;
  const bool known = std::any_of(found_.begin(), found_.end(),
                                 [&](const Exit& of) { return of.to == to && of.kind <= kind; });
  if (!known) found_.push_back({to, kind});
}

/// Add the exit of a jump: to the block of a number, or to any block that a jump can name where the
/// number is computed.
void FlowReader::jump(const Operand& number) {
  if (number.kind != Operand::Kind::Expression) {
    exit(code_.jump_target(program_, to_whole<std::int64_t>(number.value), at_), ExitKind::Jump);
    return;
  }
  exit(to_.anywhere(), ExitKind::Computed);
}

void FlowReader::go_to(const Statement& statement) {
  if (statement.number >= 0 || statement.to != kNowhere) {
    exit(statement.to, ExitKind::Jump);
    return;
  }
  Operand computed;
  computed.kind = Operand::Kind::Expression;
  jump(computed);
}

void FlowReader::back(const CallRecord& record) {
  const bool own = code_.control->calls.return_with_p.value == ReturnWithP::OwnProgram;
  if (!record.p.present()) {
    mark(ProgramFlow::kReturns);
    return back_by_name(record);
  }
  if (own) {
    jump(record.p);
    return;
  }
  mark(ProgramFlow::kReturns);
  const bool computed = record.p.kind == Operand::Kind::Expression;
  to_.return_numbers_.push_back({at_, computed ? -1 : to_whole<std::int64_t>(record.p.value),
                                 TextPlace{record.p.at, record.p.width}});
}

/// Record the block that a return with values names: RET("N10", 1, 2).
void FlowReader::back_by_name(const CallRecord& record) {
  const CallExtras& to = record.extras.get();
  const bool computed = to.by_values && to.name_text.present();
  if (record.name().empty() && !computed) return;
  const auto is_more_than = [](const Operand& of, double value) {
    return of.kind == Operand::Kind::Expression || (of.present() && of.value > value);
  };
  to_.return_numbers_.push_back({at_,
                                 -1,
                                 {to.name_at, to.name_width},
                                 computed ? std::string_view() : record.name(),
                                 is_more_than(to.levels, 1),
                                 is_more_than(to.after, 0)});
}

void FlowReader::call(const Block& block) {
  const CallRecord& record = code_.calls[block.aux];
  if (!record.constant) {
    if (!is_computed(record)) return next();  // it leads nowhere
    mark(ProgramFlow::kCallsComputed);
    if (record.start().present() || record.kind == CallKind::Local)
      mark(ProgramFlow::kStartsComputed);
    return next();
  }
  const Target& target = record.target;
  if (target.skipped) return next();
  if (target.jump) return exit(target.start, ExitKind::Jump);
  next();
  const std::int32_t whole = code_.programs[static_cast<std::size_t>(target.program)].inside;
  if (target.program == to_.program_ || whole == to_.program_) to_.entries_.push_back(target.start);
  if (code_.program_at(at_) != to_.program_) return;  // the call of a part, which has its own flow
  to_.calls_.push_back({at_, to_.program_, target.program, block.aux, target.start, record.macro});
}

/// Read the call of a part: of the own program, or of another one, which is found as it runs.
void FlowReader::part(const CallRecord& record) {
  if (!record.extras.get().first_text.present()) return exit(record.target.start, ExitKind::Jump);
  if (record.target.program == to_.program_) return exit(to_.anywhere(), ExitKind::Computed);
  mark(ProgramFlow::kCallsComputed);
  mark(ProgramFlow::kStartsComputed);
}

/// G65 H80 to H86 jump to N(P), H99 raises an alarm; the others compute.
void FlowReader::h_code(const HCode& h) {
  constexpr int kJumpAlways = 80, kLastJump = 86, kAlarm = 99;
  if (h.number == kAlarm) return;
  if (h.number >= kJumpAlways && h.number <= kLastJump) jump(h.p);
  if (h.number != kJumpAlways) next();
}

/// Record a call of a subprogram that has a label, or of a file of that name. The blocks of a
/// subprogram belong to its own flow.
void FlowReader::call_label(const Block& block, const OWord& own) {
  mark(ProgramFlow::kCallsComputed);
  if (code_.program_at(at_) != to_.program_) return;
  for (const CallReference& call : references_of(code_, block, to_.program_).calls)
    if (call.found != kNoProgram && !call.computed_program)
      to_.calls_.push_back({at_, to_.program_, call.found, own.call,
                            code_.programs[static_cast<std::size_t>(call.found)].first, true});
}

/// Pass over a subprogram from its head in the program that contains it; return false where its end
/// is unknown.
bool FlowReader::passes_over(const OWord& own) {
  if (code_.program_at(at_) == to_.program_) return false;
  const OWord* at = &own;
  Address end = at_;
  while (at->kind != OWordKind::EndSub) {  // go past each return
    if (at->next == OWord::kNone || at->next >= to_.last_ || at->next <= end) return false;
    end = at->next;
    if (code_.blocks[end].op != Op::OWord) return false;
    at = &code_.o_words[code_.blocks[end].aux];
  }
  to_.entries_.push_back(at_ + 1);
  exit(end + 1, ExitKind::Jump);
  return true;
}

/// Add both exits of an O word: the block that its label leads to is found at run time.
void FlowReader::o_word(const Block& block, const OWord& own) {
  mark(ProgramFlow::kLabels);
  switch (own.kind) {
    case OWordKind::Sub:
      if (passes_over(own)) return;
      to_.entries_.push_back(at_);
      break;
    case OWordKind::Head:  // any call may lead here
      to_.entries_.push_back(at_);
      break;
    case OWordKind::EndSub:
      return mark(ProgramFlow::kReturns);
    case OWordKind::Return:
    case OWordKind::Back:
      mark(ProgramFlow::kReturns);
      break;
    case OWordKind::Call:
    case OWordKind::Call98:
      call_label(block, own);
      break;
    default:
      break;
  }
  next();
  // The program that begins with this head is entered there and does not pass over it.
  const bool entered =
      own.kind == OWordKind::Sub && at_ == to_.first_ && code_.program_at(at_) == to_.program_;
  const bool known = own.next != OWord::kNone && own.next < to_.last_;
  if (known && !entered) exit(own.next, ExitKind::Jump);
}

// A line for each case: shorter would be harder to read.
// NOLINTNEXTLINE(readability-function-size,readability-function-cognitive-complexity)
void FlowReader::variant(const Block& block) {
  const auto statement = [&]() -> const Statement& { return code_.statements[block.aux]; };
  switch (block.op) {
    case Op::Return:
      return back(code_.calls[block.aux]);
    case Op::EndProgram:
      if (code_.control->calls.end_in_subprogram.value == EndInSubprogram::Returns)
        mark(ProgramFlow::kReturns);
      return mark(ProgramFlow::kEnds);
    case Op::Goto:
      return go_to(statement());
    case Op::IfGoto:
      next();
      return go_to(statement());
    case Op::If:
    case Op::While:
      next();
      return exit(statement().to, ExitKind::Jump);
    case Op::Else:
    case Op::EndDo:
      return exit(statement().to, ExitKind::Jump);
    case Op::IfThen:
      next();
      return variant(code_.variants[statement().then]);
    case Op::Switch:
      return alternatives(statement());
    case Op::For:
      next();
      return exit(statement().to, ExitKind::Jump);
    case Op::EndFor:
      next();
      return exit(statement().to + 1, ExitKind::Jump);
    case Op::RepeatPart:
      next();
      return part(code_.calls[block.aux]);
    case Op::Jump:
      if (code_.jumps[block.aux].reads_input) next();
      return jump(code_.jumps[block.aux].p);
    case Op::HCode:
      return h_code(code_.h_codes[block.aux]);
    case Op::Select:
      return select(code_.selects[block.aux]);
    case Op::ParallelAssign:
      if (code_.parallel_assigns[block.aux].words == OWord::kNone) return next();
      return variant(code_.variants[code_.parallel_assigns[block.aux].words]);
    default:
      return words_call_or_assignment(block);
  }
}

/// Read the blocks that a CASE or several IF GOTO may be.
void FlowReader::alternatives(const Statement& choice) {
  bool always = false;
  for (const Statement& of : alternatives_of(choice)) {
    always = always || of.index == Statement::kAlways;
    variant(code_.variants[of.then]);
  }
  if (!always) next();
}

/// Read the two blocks that one block may be. A block that calls by a code is a fault only where no
/// code calls. There it might not have been a call of another program.
void FlowReader::select(const Select& choice) {
  variant(code_.variants[choice.first]);
  if (choice.of_called) return;  // the other one alarms
  const Block& second = code_.variants[choice.second];
  if (choice.address != 0 && second.op == Op::Fault) return next();
  variant(second);
}

void FlowReader::words_call_or_assignment(const Block& block) {
  switch (block.op) {
    case Op::Call:
    case Op::MacroCall:
    case Op::ModalCall:
      return call(block);
    case Op::OWord:
      return o_word(block, code_.o_words[block.aux]);
    case Op::Fault:  // the blocks after it still count, and it might have called
      mark(ProgramFlow::kCallsComputed);
      return next();
    case Op::Set:
    case Op::Assign:  // #3000 raises an alarm: no block follows it
      if (!raises_alarm(assignment_of(code_, block))) next();
      return;
    case Op::Words:
      return words(block);
    default:
      return next();
  }
}

bool FlowReader::raises_alarm(const Statement& statement) const {
  if (statement.target != Statement::Target::Variable) return false;
  const VariablePlace place = code_.place(statement.index);
  return place.range != nullptr && place.kind == VariableKind::UserAlarm;
}

/// Read a block of words; an M code in it may start the program over.
void FlowReader::words(const Block& block) {
  const Roles& roles = code_.control->calls.roles.value;
  const CodeList codes = block.m_count > 0 ? code_.codes_of(block) : CodeList{};
  for (const int code : codes.m())
    if (roles.of_m(code) == Role::StartOver) return exit(to_.first_, ExitKind::Jump);
  next();
}

void FlowReader::read(Address at) {
  at_ = at;
  marks_ = 0;
  found_.clear();
  const Block& block = code_.blocks[at];
  if (block.can_be_skipped()) next();
  variant(block);
  to_.exits_.insert(to_.exits_.end(), found_.begin(), found_.end());
  to_.marks_.push_back(marks_);
  to_.all_marks_ = static_cast<std::uint8_t>(to_.all_marks_ | marks_);
}

ProgramFlow::ProgramFlow(const Code& code, std::int32_t program,
                         const std::vector<Address>& labelled, InterruptCheck& interrupt)
    : code_(code), program_(program) {
  const Program& own = code.programs[static_cast<std::size_t>(program)];
  first_ = own.first;
  last_ = interrupt.requested(0) ? own.first : own.last;
  FlowReader reader(*this);
  places_.reserve(last_ - first_ + 2);
  exits_.reserve(last_ - first_);
  for (Address at = first_; at < last_; ++at) {
    places_.push_back(static_cast<std::uint32_t>(exits_.size()));
    reader.read(at);
    if (interrupt.requested(InterruptCheck::kBlock)) last_ = at + 1;
  }
  places_.push_back(static_cast<std::uint32_t>(exits_.size()));  // the end leads nowhere
  places_.push_back(static_cast<std::uint32_t>(exits_.size()));
  for (std::uint32_t i = own.first_entry; i < own.last_entry; ++i)
    if (code.sequence[i].address < last_)
      exits_.push_back({code.sequence[i].address, ExitKind::Computed});
  for (auto of = std::lower_bound(labelled.begin(), labelled.end(), first_);
       of != labelled.end() && *of < last_; ++of)
    exits_.push_back({*of, ExitKind::Computed});
  places_.push_back(static_cast<std::uint32_t>(exits_.size()));
  marks_.insert(marks_.end(), 2, 0);
}

void ProgramFlow::close() {
  if (added_.empty()) return;
  std::stable_sort(added_.begin(), added_.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Exit> exits;
  std::vector<std::uint32_t> places;
  auto more = added_.begin();
  for (Address at = first_; at <= anywhere(); ++at) {
    places.push_back(static_cast<std::uint32_t>(exits.size()));
    exits.insert(exits.end(), begin(at), end(at));
    for (; more != added_.end() && more->first == at; ++more) exits.push_back(more->second);
  }
  places.push_back(static_cast<std::uint32_t>(exits.size()));
  exits_ = std::move(exits);
  places_ = std::move(places);
  added_.clear();
}

}  // namespace cncsub
