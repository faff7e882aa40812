// The machine's calls: M98 and its family, macro calls, modal calls, and what refuses them.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "cncsub/machine.hpp"
#include "cncsub/motion_state.hpp"

namespace cncsub {

namespace {

constexpr std::uint32_t kManyArguments = 1 << 16;  // work for a millisecond

}  // namespace

bool Machine::computed(const Operand& operand, double& value) {
  if (!evaluate(operand.expression, value)) return false;
  if (std::fabs(value) > kLargest)  // a vacant value compares false
    return alarm({Cause::Overflow, operand.at, operand.width, "the result is too large"});
  return true;
}

/// The form of the call, before anything of the block is executed.
bool Machine::decode_target(const CallRecord& record, Target& target) {
  if (record.constant) {
    target = record.target;
    return true;
  }
  CallOperands values;
  if (!operand(record.p, values.p) || !operand(record.l, values.l) ||
      !operand(record.start, values.start) || !operand(record.device, values.device))
    return false;
  if (auto fault = decode_call(*code_, record, values, frame().program, target))
    return alarm(*fault);
  return true;
}

bool Machine::find(const CallRecord& record, Target& target) {
  if (record.constant) return true;
  if (auto fault = find_target(*code_, record, target)) return alarm(*fault);
  return true;
}

/// Calls that the state refuses, whatever is called.
std::optional<Fault> Machine::refused_here(const CallRecord& record) const {
  const Control& control = *code_->control;
  const auto fault = [&](Cause cause, std::string detail) {
    return Fault{cause, record.at, record.width, std::move(detail)};
  };
  if (options_.mdi) {
    const bool refused = control.mdi_calls.value == MdiCalls::Refused ||
                         (control.mdi_calls.value == MdiCalls::OneLevel && stack_.size() > 1);
    if (refused)
      return fault(Cause::CallInMdi, stack_.size() > 1 ? "a call inside a program called from MDI"
                                                       : "a call from MDI");
  }
  const bool by_name = record.kind == CallKind::M98 || record.kind == CallKind::M198 ||
                       record.kind == CallKind::M97 || record.kind == CallKind::G65 ||
                       record.kind == CallKind::G66 || record.kind == CallKind::G661;
  if (!modals_.empty() && by_name) {
    switch (control.calls_in_modal.value) {
      case CallsInModal::Allowed:
        break;
      case CallsInModal::EndModal:
        if (!record.macro)
          return fault(Cause::CallInModalCall, "M98 while a modal macro call is active");
        break;
      case CallsInModal::Refused:
        if (modals_.back().program == frame().program)
          return fault(Cause::CallInModalCall,
                       "a call while a modal macro call of this program is active");
        break;
    }
  }
  return std::nullopt;
}

std::optional<Fault> Machine::refused(const CallRecord& record, const Target& target) const {
  const Control& control = *code_->control;
  const auto fault = [&](Cause cause, std::string detail) {
    return Fault{cause, record.at, record.width, std::move(detail)};
  };
  const bool started = target.start_n >= 0;
  if (target.program == frame().program) {
    const bool bad = control.self_call.value == SelfCall::Refused ||
                     (control.self_call.value == SelfCall::WithStart && !started);
    if (bad) return fault(Cause::ProgramCallsItself, "the program calls itself");
  } else if (control.caller_call.value != CallerCall::Allowed) {
    const CallerCall rule = control.caller_call.value;
    for (std::size_t i = 0; i + 1 < stack_.size(); ++i) {
      if (stack_[i].program != target.program) continue;
      if (rule == CallerCall::MainRefused && i > 0) continue;
      if (rule == CallerCall::WithStart && started) continue;
      return fault(Cause::ProgramCallsCaller,
                   code_->name_of(code_->programs[static_cast<std::size_t>(target.program)]) +
                       " is open already");
    }
  }
  const int macros = macros_ + (record.macro ? 1 : 0);
  const int subprograms = subprograms_ + (record.macro ? 0 : 1);
  const int counted = control.nesting_counts_macros.value ? macros + subprograms : subprograms;
  const auto deep = [](int most, const char* what) {
    return "the control allows " + std::to_string(most) + " " + what;
  };
  if (record.macro && macros > control.max_macro_nesting.value)
    return fault(Cause::MacroNestingTooDeep,
                 deep(control.max_macro_nesting.value, "levels of macro calls"));
  if (counted > control.max_nesting.value)
    return fault(Cause::NestingTooDeep, deep(control.max_nesting.value, "levels of calls"));
  if (control.max_total_nesting.value > 0 && macros + subprograms > control.max_total_nesting.value)
    return fault(Cause::NestingTooDeep,
                 deep(control.max_total_nesting.value, "levels of calls of both kinds"));
  return std::nullopt;
}

bool Machine::call(const Block& block) {
  const CallRecord& record = code_->calls[block.aux];
  if (auto fault = refused_here(record)) return alarm(*fault);
  Target target;
  if (!decode_target(record, target)) return false;
  const bool passes = record.arguments > 0 || code_->control->call_passes_words.value;
  if (passes && !evaluate_arguments(record)) return false;
  const bool other_words = block.mask != 0 || block.g_count != 0 || block.m_count != 0;
  if (other_words && motion_.in_cycle() && !code_->control->words_with_call_in_cycle.value)
    return alarm({Cause::CallWithWordsInCycle, record.at, record.width,
                  "M98 shares its block with words in a canned cycle"});
  if (!words(block)) return false;
  if (target.skipped) return after_words(outcome_);
  if (modal_after(outcome_) >= 0) {
    Waiting waiting{Op::Call, block.aux, pc_, executed_, target, 0, 0, {}, {}};
    if (passes) waiting.arguments = scratch_, waiting.programmed = scratch_programmed_;
    return do_behind_modal(std::move(waiting));
  }
  return call_now(block.aux, target);
}

/// What is left of a call's block when its words are executed.
bool Machine::call_now(std::uint32_t aux, Target& target) {
  const CallRecord& record = code_->calls[aux];
  if (target.external && frame().external)
    return alarm({Cause::ExternalCallNested, record.at, record.width,
                  "a program of the external device calls another one"});
  if (!find(record, target)) return false;
  if (target.jump) {
    const Program& program = code_->programs[static_cast<std::size_t>(target.program)];
    record_block();
    if (stack_.size() == 1 && target.start == program.first) return restart_main();
    pc_ = target.start;
    return true;
  }
  return enter(aux, target, -1);
}

bool Machine::macro_call(const Block& block) {
  const CallRecord& record = code_->calls[block.aux];
  if (auto fault = refused_here(record)) return alarm(*fault);
  Target target;
  if (!decode_target(record, target) || !evaluate_arguments(record)) return false;
  if (!words(block)) return false;
  const bool ends_modal = record.kind == CallKind::G65 &&
                          code_->control->calls_in_modal.value == CallsInModal::EndModal;
  if (target.skipped) {
    if (ends_modal) modals_.clear();
    return after_words(outcome_);
  }
  if (ends_modal) {
    if (!call_now(block.aux, target)) return false;
    modals_.clear();
    return true;
  }
  if (modal_after(outcome_) >= 0)
    return do_behind_modal(
        {Op::Call, block.aux, pc_, executed_, target, 0, 0, scratch_, scratch_programmed_});
  return call_now(block.aux, target);
}

/// G66 only declares. What it calls is looked up at the first call.
bool Machine::modal_call(const Block& block) {
  const CallRecord& record = code_->calls[block.aux];
  if (auto fault = refused_here(record)) return alarm(*fault);
  Modal modal;
  if (!decode_target(record, modal.target) || !evaluate_arguments(record)) return false;
  const bool stacks = code_->control->modal_calls_stack.value;
  const int most = code_->control->max_modal_calls.value;
  if ((stacks ? modals_.size() : 0) >= static_cast<std::size_t>(most))
    return alarm({Cause::ModalCallsTooMany, record.at, record.width,
                  "the control takes " + std::to_string(most) + " modal calls"});
  if (!words(block)) return false;
  if (!stacks) modals_.clear();
  modal.record = block.aux;
  modal.locals = scratch_;
  modal.program = frame().program;
  modal.every_block = record.code_kind == CodeCallKind::ModalEveryBlock;
  modals_.push_back(std::move(modal));
  ++changes_;
  record_step();
  return go_to(next_);
}

bool Machine::cancel_modal(const Block& block) {
  if (modals_.empty() && code_->control->cancel_alone.value == CancelAlone::Alarm)
    return alarm({.cause = Cause::ModalCallMissing,
                  .detail = "no modal macro call is active",
                  .address = 'G',
                  .code = 670});
  if (!words(block)) return false;
  if (!modals_.empty() && frame().modal < 0) modals_.pop_back();
  ++changes_;
  record_step();
  return go_to(next_);
}

/// G66.1: the words of the block are the arguments.
bool Machine::every_block(const Block& block) {
  const bool plain =
      is_words(block.op) && (block.mask != 0 || block.g_count != 0 || block.m_count != 0);
  if (!plain) {
    const bool kept = modals_.back().every_block;
    modals_.back().every_block = false;
    const std::size_t count = modals_.size();
    const bool runs = branch(block);
    if (modals_.size() >= count) modals_[count - 1].every_block = kept;
    return runs;
  }
  NcWords words;
  if (!decode(block, words)) return false;
  scratch_.assign(static_cast<std::size_t>(code_->locals), kVacant);
  static constexpr int kVariables[26] = {1,  2,  3,  7,  8,  9,  10, 11, 4,  5,  6,  12, 13,
                                         14, 15, 16, 17, 18, 19, 20, 21, 22, 23, 24, 25, 26};
  for (int i = 0; i < 26; ++i)
    if ((words.mask & (1u << i)) != 0) {
      const double value = words.value[static_cast<std::size_t>(i)];
      const bool whole = (words.whole & (1u << i)) != 0;
      scratch_[static_cast<std::size_t>(kVariables[i])] =
          whole ? motion_.scaled(static_cast<char>('A' + i), value) : value;
    }
  if (words.g_count > 0) scratch_[10] = words.g[static_cast<std::size_t>(words.g_count - 1)] / 10.0;
  if (words.m_count > 0) scratch_[13] = words.m[static_cast<std::size_t>(words.m_count - 1)];
  Modal& modal = modals_.back();
  const CallRecord& record = code_->calls[modal.record];
  if (modal.target.start == kNowhere && !find(record, modal.target)) return false;
  const Target target = modal.target;
  return enter(modal.record, target, static_cast<std::int32_t>(modals_.size()) - 1);
}

/// The arguments of a call, evaluated at the caller's level, into the locals of the level to come.
bool Machine::evaluate_arguments(const CallRecord& record) {
  scratch_.assign(static_cast<std::size_t>(code_->locals), kVacant);
  const bool told = code_->control->call_passes_words.value;
  if (told) scratch_programmed_.assign(scratch_.size(), 0);
  const Argument* argument = code_->arguments.data() + record.first_argument;
  for (std::uint32_t i = 0; i < record.arguments; ++i, ++argument) {
    double value = 0;
    if (i % kManyArguments == kManyArguments - 1 && breaks_off()) return false;
    if (!operand(argument->operand, value)) return false;
    if (argument->operand.whole && argument->operand.kind == Operand::Kind::Constant)
      value = motion_.scaled(argument->address, value);
    scratch_[static_cast<std::size_t>(argument->variable)] = value;
    if (told)
      scratch_programmed_[static_cast<std::size_t>(argument->variable)] =
          motion_.modal_code(3) == 91 ? 91 : 90;
  }
  return true;
}

void Machine::open_level() {
  ++level_;
  const auto first = static_cast<std::size_t>(level_) * static_cast<std::size_t>(code_->locals);
  const std::size_t end = first + static_cast<std::size_t>(code_->locals);
  if (locals_.size() < end) {
    locals_.resize(end, kVacant);
    if (!programmed_.empty()) programmed_.resize(end, 0);
  }
  std::copy(scratch_.begin(), scratch_.end(), locals_.begin() + static_cast<std::ptrdiff_t>(first));
  if (code_->control->call_passes_words.value)
    std::copy(scratch_programmed_.begin(), scratch_programmed_.end(),
              programmed_.begin() + static_cast<std::ptrdiff_t>(first));
}

/// Opens a frame for what `target` says; the arguments lie in scratch_. The block is recorded as a
/// step of the caller.
bool Machine::enter(std::uint32_t index, const Target& target, std::int32_t modal) {
  const CallRecord& record = code_->calls[index];
  if (auto fault = refused(record, target)) return alarm(*fault);
  if (record.variable > 0)
    if (auto fault = write(record.variable, record.code)) {
      fault->at = record.at;
      fault->width = record.width;
      return alarm(*fault);
    }
  const bool by_move = modal >= 0 && !modals_[static_cast<std::size_t>(modal)].every_block;
  const Address called_at = by_move ? jumped_after_ : pc_;
  if (!by_move) {
    record_block();
    jumped_after_ = pc_;
  }
  ++changes_;
  Open open;
  open.program = target.program;
  open.repeats = target.repeats;
  open.return_to = by_move ? pc_ : next_;
  open.called_at = called_at;
  open.restart = target.start;
  open.kind = record.kind;
  open.macro = record.macro;
  open.own_locals = record.macro || code_->control->call_passes_words.value;
  open.external = frame().external || target.external;
  open.code_letter = frame().code_letter;
  switch (record.kind) {
    case CallKind::GCode:
      open.code_letter = 'G';
      break;
    case CallKind::MCode:
    case CallKind::TCode:
    case CallKind::SCode:
    case CallKind::BCode:
    case CallKind::Ascii:
      open.code_letter = 'M';
      break;
    default:
      break;
  }
  open.modal = modal;
  open.modal_limit = modal >= 0 ? modal : frame().modal_limit;
  open.loops = static_cast<std::uint32_t>(loops_.size());
  if (open.own_locals) open_level();
  (record.macro ? macros_ : subprograms_) += 1;
  if (trace_.depth != Trace::Depth::None) {
    CallRow row;
    row.parent = frame().call;
    row.program = target.program;
    row.start_n = target.start_n;
    row.repeats = target.repeats;
    row.level = level_;
    row.depth = static_cast<std::int32_t>(stack_.size());
    row.record = index;
    row.kind = record.kind;
    row.caller_step = block_is_step_ && !by_move ? waited_at_ : executed_ - 1;
    row.first_step = executed_;
    row.last_step = -1;  // until it ends
    row.first_argument = static_cast<std::uint32_t>(trace_.arguments.size());
    if (open.own_locals)
      for (std::size_t i = 0; i < scratch_.size(); ++i)
        if (!is_vacant(scratch_[i]))
          trace_.arguments.push({static_cast<std::int32_t>(i), scratch_[i]});
    row.arguments = static_cast<std::uint32_t>(trace_.arguments.size()) - row.first_argument;
    open.call = trace_.call_number(trace_.calls.size());
    trace_.calls.push(row);
    if (open.call == std::numeric_limits<std::int32_t>::max() - 1) end(Stop::Limit);
  }
  stack_.push_back(open);
  if (stack_.size() > kLongText) look_soon();  // each call looks at all of them
  pc_ = target.start;
  return true;
}

/// The modal call that follows the move of a block, -1 where none does.
std::int32_t Machine::modal_of_move(const Motion::Outcome& outcome) const {
  const bool triggers =
      code_->control->modal_trigger.value == ModalTrigger::Move ? outcome.moved : outcome.axis_word;
  const auto top =
      std::min<std::int32_t>(static_cast<std::int32_t>(modals_.size()), frame().modal_limit);
  if (!triggers || top <= 0 || modals_[static_cast<std::size_t>(top - 1)].every_block) return -1;
  return modals_[static_cast<std::size_t>(top - 1)].target.skipped ? -1 : top - 1;
}

bool Machine::call_after_move(const Motion::Outcome& outcome) {
  const std::int32_t modal = modal_after(outcome);
  return modal < 0 || enter_modal(modal);
}

/// The modal macro of a block's move comes before the block's own call, return or jump, and from
/// the same frame. The block is a step when the macro begins.
bool Machine::do_behind_modal(Waiting waiting) {
  record_step();
  jumped_after_ = pc_;
  if (!enter_modal(modal_after(outcome_))) return false;
  frame().interrupts = true;
  waiting_.push_back(std::move(waiting));
  return true;
}

/// Behind a modal macro the block that waited goes on; it may return behind another one.
bool Machine::go_on() {
  bool runs = true;
  while (wakes_ && runs) {
    wakes_ = false;
    Waiting waiting = std::move(waiting_.back());
    waiting_.pop_back();
    pc_ = waiting.at;
    next_ = pc_ + 1;
    waited_at_ = waiting.step;
    words_done_ = false;
    scratch_ = std::move(waiting.arguments);
    scratch_programmed_ = std::move(waiting.programmed);
    block_is_step_ = true;
    if (waiting.op == Op::Return)
      runs = return_now(code_->calls[waiting.aux], waiting.p, waiting.l);
    else if (waiting.op == Op::Jump)
      runs = jump_now(code_->statements[waiting.aux], waiting.p);
    else
      runs = call_now(waiting.aux, waiting.target);
    block_is_step_ = false;
  }
  return runs;
}

/// The macro of a modal call, behind a block that moved. The block is a step already.
bool Machine::enter_modal(std::int32_t modal_index) {
  Modal& modal = modals_[static_cast<std::size_t>(modal_index)];
  const CallRecord& record = code_->calls[modal.record];
  words_done_ = false;
  if (modal.target.skipped) return true;
  const Address behind = pc_;
  pc_ = jumped_after_;
  if (modal.target.start == kNowhere && !find(record, modal.target)) return false;
  if (auto fault = refused(record, modal.target)) return alarm(*fault);
  pc_ = behind;
  scratch_ = modal.locals;
  if (code_->control->call_passes_words.value) scratch_programmed_.assign(scratch_.size(), 0);
  const Target target = modal.target;
  return enter(modal.record, target, modal_index);
}

/// Closes the frame and goes on in the caller: with what its block waited with, where it `goes_on`.
bool Machine::leave(Address to, bool goes_on) {
  const Open open = frame();
  if (open.modal >= 0 && code_->control->modal_locals.value == ModalLocals::Kept &&
      open.modal < static_cast<std::int32_t>(modals_.size())) {
    const auto first = locals_.begin() + static_cast<std::ptrdiff_t>(level_) * code_->locals;
    modals_[static_cast<std::size_t>(open.modal)].locals.assign(first, first + code_->locals);
  }
  if (open.call >= 0) trace_.calls.at(trace_.call_row(open.call)).last_step = executed_ - 1;
  if (open.own_locals) --level_;
  (open.macro ? macros_ : subprograms_) -= 1;
  loops_.resize(open.loops);
  stack_.pop_back();
  if (open.interrupts) {
    wakes_ = goes_on;
    if (!goes_on) waiting_.pop_back();
  }
  return go_to(to);
}

/// The profile from N(ns) to N(nf) of the running program. Of several it is the one that stands
/// next behind the cycle, on every control: programs that use the same numbers again write it so.
std::optional<Fault> Machine::profile(std::int64_t ns, std::int64_t nf, Profile& found) {
  const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
  if (options_.mdi) return Fault{Cause::ProfileInMdi, pc_, 1, {}};
  const auto missing = [&](char word, std::int64_t n) {
    return Fault{.cause = Cause::PqNotFound,
                 .at = pc_,
                 .detail = "there is no N" + std::to_string(n) + " in " + code_->name_of(program),
                 .address = word};
  };
  Address first = code_->next_of(program, ns, pc_);
  if (first == kNowhere) first = code_->first_of(program, ns);
  if (first == kNowhere) return missing('P', ns);
  const Address last = code_->first_from(program, nf, first);
  if (last == kNowhere) return missing('Q', nf);
  const auto passed = [&](Address a) { return (code_->blocks[a].skip & options_.skips) != 0; };
  Address next = pc_ + 1;
  while (next < first && passed(next)) ++next;
  found.right_behind = first == next;
  found.behind = last + 1;
  for (Address a = first; a <= last; ++a) {
    if (!passed(a))
      if (auto wrong = profile_block(a, found.blocks)) return wrong;
    in_block_ = found.blocks.size() * (sizeof(NcWords) + sizeof(Piece));
    if (a % kLongText == 0 && breaks_off()) return missing('Q', nf);
  }
  if (found.blocks.size() > kLongText) look_soon();
  return std::nullopt;
}

std::optional<Fault> Machine::profile_block(Address a, std::vector<NcWords>& blocks) {
  const Block& block = code_->blocks[a];
  switch (block.op) {
    case Op::Words:
    case Op::Linear:
    case Op::Round:
      break;
    case Op::Call:
    case Op::MacroCall:
    case Op::ModalCall:
    case Op::Return:
    case Op::Choose:
      return Fault{Cause::ProfileCall, a, 1, "a call inside the blocks of the profile"};
    default:
      return Fault{Cause::ProfileMacro, a, 1, "a macro statement inside the blocks of the profile"};
  }
  NcWords words;
  const Address cycle = std::exchange(pc_, a);
  const bool read = decode(block, words);
  pc_ = cycle;
  if (!read) return Fault{Cause::ProfileMacro, a, 1, {}};  // it has alarmed itself
  blocks.push_back(words);
  return std::nullopt;
}

}  // namespace cncsub
