#include "cncsub/machine.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "cncsub/scan.hpp"

namespace cncsub {

namespace {

constexpr std::int64_t kLookSkipped = 1 << 20;  // blocks passed over between two looks around
constexpr std::size_t kPartMoves = 1 << 20;     // a part of a run that has more ends early
constexpr std::size_t kManySkipped = 1'000'000;
constexpr std::int32_t kManyRepeats = std::numeric_limits<std::int32_t>::max();
constexpr std::int64_t kHeldPieces =
    8;  // that are kept for a block to be undone: as long as a move
constexpr Op kFirstStatement = Op::Assign, kLastStatement = Op::EndDo;

}  // namespace

std::string_view to_string(Stop stop) {
  switch (stop) {
    case Stop::Running:
      return "running";
    case Stop::End:
      return "end";
    case Stop::Alarm:
      return "alarm";
    case Stop::Cycles:
      return "cycles";
    case Stop::Limit:
      return "limit";
    case Stop::Waiting:
      return "waiting";
    case Stop::Interrupted:
      return "interrupted";
  }
  return "";
}

Machine::Machine(std::shared_ptr<const Code> code, std::int32_t main, Options options)
    : code_(std::move(code)),
      options_(std::move(options)),
      motion_(code_->control, options_.setup) {
  if (options_.inputs.workpiece)  // it stays where it is, whatever the program does to zero points
    options_.inputs.workpiece =
        std::make_shared<const Workpiece>(motion_.placed(*options_.inputs.workpiece));
  trace_.depth = options_.trace;
  locals_.assign(static_cast<std::size_t>(code_->locals), kVacant);
  if (code_->control->call_passes_words.value) programmed_.assign(locals_.size(), 0);
  commons_.assign(static_cast<std::size_t>(code_->commons), kVacant);
  clock_ms_ = options_.inputs.clock_ms;
  largest_word_ = kPowersOfTen[most_digits(*code_->control)];
  jumps_refused_ = options_.mdi && !code_->control->jumps_in_mdi.value;
  const Program& program = code_->programs[static_cast<std::size_t>(main)];
  Open open;
  open.program = main;
  open.restart = program.first;
  open.modal_limit = 1 << 20;
  stack_.push_back(open);
  pc_ = program.first;
  for (const auto& [number, value] : options_.variables) write(number, value);
  if (options_.start >= 0) {
    const Address start = code_->first_of(program, options_.start);
    if (start != kNowhere) pc_ = start;
  }
  // A faulty main program number is told even where the run starts further on.
  next_ = pc_;
}

bool Machine::end(Stop stop) {
  finish();
  stop_ = stop;
  return false;
}

void Machine::finish() {
  for (const Open& open : stack_)
    if (open.call >= 0) trace_.calls.at(trace_.call_row(open.call)).last_step = executed_ - 1;
}

bool Machine::alarm(const Fault& fault) {
  alarm_ = alarm_of(*code_, fault.block != kNowhere ? fault.block : pc_, fault);
  alarm_->frames = frames();
  if (words_done_)
    record_step();
  else
    give_back();
  return end(Stop::Alarm);
}

/// A fault of the motion, which knows the block it stands in and no text.
Fault Machine::of_motion(Fault fault) const {
  fault.block = fault.at;
  const Program& program =
      code_->programs[static_cast<std::size_t>(code_->program_at(fault.block))];
  const Block& block = code_->blocks[fault.block];
  motion_.point_at_word(code_->text_of(block, program), block.text, fault);
  return fault;
}

/// A block that alarms, or that is broken off to be run again, has taken nothing.
void Machine::give_back() {
  if (taken_.block != executed_) return;
  clock_ms_ = taken_.clock_ms;
  next_skip_ = taken_.next_skip;
  random_ = taken_.random;
  taken_.block = -1;
}

std::vector<Frame> Machine::frames() const {
  std::vector<Frame> list;
  for (std::size_t i = stack_.size(); i-- > 1;) {
    const Open& open = stack_[i];
    const Program& caller = code_->programs[static_cast<std::size_t>(stack_[i - 1].program)];
    const Block& block = code_->blocks[open.called_at];
    Frame frame;
    frame.program = code_->name_of(caller);
    frame.n = block.n;
    frame.line = block.line;
    frame.file = code_->files[caller.file].name;
    frame.kind = std::string(to_string(open.kind));
    frame.called = code_->name_of(code_->programs[static_cast<std::size_t>(open.program)]);
    frame.repeat = open.repeat;
    frame.repeats = open.repeats;
    list.push_back(std::move(frame));
  }
  return list;
}

/// Executes the block at pc_ and records it. What it decides is where the run goes on (`next_`).
/// Of macro statements those behind it are executed too, but where `one` block is asked for.
inline bool Machine::execute(const Block& block, bool one) {
  next_ = pc_ + 1;
  words_done_ = false;
  if (modals_.empty()) {
    if (block.op == Op::Linear) return linear(block);
    if (block.op == Op::Round) return round(block);
    if (block.op >= kFirstStatement && block.op <= kLastStatement) return statements(one);
  }
  return branch(block);
}

/// Whether a block-skip switch passes over the block at pc_. A program of nothing but such blocks
/// that starts over and over is stopped: no limit counts it.
bool Machine::passes(const Block& block) {
  if ((block.skip & options_.skips) == 0) return false;
  if (skipped_behind_ != executed_) skipped_ = 0;
  skipped_behind_ = executed_;
  if (static_cast<std::size_t>(++skipped_) > code_->blocks.size() + kManySkipped) end(Stop::Limit);
  ++pc_;
  return true;
}

bool Machine::step(const std::function<bool()>& interrupted) {
  if (stop_ == Stop::Interrupted) stop_ = Stop::Running;
  if (stop_ != Stop::Running) return false;
  const AtWork at_work(*this, interrupted);
  const std::int64_t before = executed_;
  while (stop_ == Stop::Running && executed_ == before && broken_off_ == Stop::Running) {
    if (executed_ >= options_.max_blocks) return end(Stop::Limit);
    const Block& block = code_->blocks[pc_];
    if (!passes(block)) execute(block, true);
  }
  const bool limited = broken_off_ == Stop::Limit || stops() == Stop::Limit;
  if (stop_ == Stop::Running && limited) end(Stop::Limit);
  return executed_ != before;
}

std::string Machine::axes() const {
  std::uint32_t mask = 0;
  for (const auto* blocks : {&code_->blocks, &code_->variants})
    for (const Block& block : *blocks) mask |= block.mask;
  return motion_.axes_of(mask);
}

void Machine::run(const std::function<bool()>& interrupted,
                  const std::function<bool(const Machine&)>& pause, std::int64_t until) {
  if (stop_ == Stop::Interrupted) stop_ = Stop::Running;
  const Block* blocks = code_->blocks.data();
  std::int64_t passed = 0;
  const std::int64_t last = std::min(until, options_.max_blocks);
  const bool in_parts = until != std::numeric_limits<std::int64_t>::max();
  const AtWork at_work(*this, interrupted);
  if (stop_ == Stop::Running && stops() == Stop::Limit) end(Stop::Limit);
  while (stop_ == Stop::Running) {
    // Between two looks at the clock, the memory and Ctrl-C nothing but blocks.
    look_later(last);
    while (executed_ < look_at_ && stop_ == Stop::Running) {
      const Block& block = blocks[pc_];
      if ((block.skip & options_.skips) != 0) [[unlikely]] {
        passes(block);
        if (++passed % kLookSkipped == 0) look_soon();
        continue;
      }
      if (pause && pause(*this)) return;
      execute(block, static_cast<bool>(pause));
    }
    if (stop_ != Stop::Running) return;
    const Stop why = broken_off_ != Stop::Running ? broken_off_ : stops();
    if (why != Stop::Running)
      end(why);
    else if (executed_ >= options_.max_blocks)
      end(Stop::Limit);
    else if (executed_ >= until || (in_parts && trace_.moves.size() > kPartMoves))
      return;
  }
}

Trace Machine::take() {
  std::vector<std::int32_t> open;
  for (const Open& frame : stack_)
    if (frame.call >= 0) open.push_back(frame.call);
  motion_.forget_table();
  return trace_.take(open, stop_ != Stop::Running, executed_);
}

bool Machine::branch(const Block& block) {
  if (block.length > kLongText) look_soon();
  if (!modals_.empty() && modals_.back().every_block && frame().modal < 0)
    return every_block(block);
  switch (block.op) {
    case Op::Linear:
      return linear(block);
    case Op::Round:
      return modals_.empty() ? round(block) : words(block);
    case Op::Words:
      return words(block);
    case Op::Call:
      return call(block);
    case Op::MacroCall:
      return macro_call(block);
    case Op::ModalCall:
      return modal_call(block);
    case Op::CancelModal:
      return cancel_modal(block);
    case Op::Return:
      return return_from_call(block);
    case Op::Jump:
      return jump(block);
    case Op::EndProgram:
      return end_program(block);
    case Op::Choose:
      return choose(block);
    case Op::Fault:
      return alarm(code_->faults[block.aux]);
    case Op::EndOfRecord:
      return end_of_record();
    case Op::Assign:
      if (!assign(code_->statements[block.aux])) return false;
      break;
    case Op::IfGoto:
    case Op::While:
    case Op::Do:
    case Op::EndDo:
      return statements(true);
    case Op::Goto:
      if (!go_to(code_->statements[block.aux])) return false;
      break;
    case Op::IfThen:
    case Op::If: {
      const Statement& statement = code_->statements[block.aux];
      bool holds = false;
      if (!condition(statement.expression, holds)) return false;
      if (holds && block.op == Op::IfThen) return branch(code_->variants[statement.then]);
      if (!holds && block.op == Op::If) next_ = statement.to;
      break;
    }
    case Op::Else:
      next_ = code_->statements[block.aux].to;
      break;
    case Op::HCode:
      if (!h_code(code_->statements[block.aux])) return false;
      break;
    case Op::Print:
      if (!print(code_->prints[block.aux])) return false;
      break;
    case Op::NameVariables:
      if (!name_variables(code_->statements[block.aux])) return false;
      break;
    case Op::EndIf:
    case Op::OpenOutput:
    case Op::CloseOutput:
      break;
  }
  record_step();
  pc_ = next_;
  return true;
}

bool Machine::choose(const Block& block) {
  const Variant& variant = code_->choices[block.aux];
  bool second = (variant.skip & options_.skips) != 0;
  if (variant.address != 0 && frame().code_letter != 0) {
    const bool g = variant.address == 'G';
    switch (code_->control->code_cascade.value) {
      case CodeCascade::None:
        second = true;
        break;
      case CodeCascade::OtherKind:
        second = g == (frame().code_letter == 'G');
        break;
      case CodeCascade::All:
        break;
    }
  }
  return branch(code_->variants[second ? variant.second : variant.first]);
}

// ---- words ----

bool Machine::linear(const Block& block) {
  bool moved = false;
  const int g = (block.flags & Block::kNoG) != 0       ? -1
                : (block.flags & Block::kSecondG) != 0 ? 1
                                                       : 0;
  const Cell* values = code_->cells.data() + block.data + block.g_count;
  if (!motion_.linear(block.mask, values, g, static_cast<std::uint32_t>(executed_),
                      recorded_moves(), moved))
    return words(block);
  changes_ += moved ? 1 : 0;
  last_n_ = block.n >= 0 ? block.n : last_n_;
  if (modals_.empty()) {
    record_step();
    pc_ = next_;
    return true;
  }
  constexpr std::uint32_t kAxes = bit('X') | bit('Y') | bit('Z');
  outcome_ = {};
  outcome_.moved = moved;
  outcome_.axis_word = (block.mask & kAxes) != 0;
  return after_words(outcome_);
}

bool Machine::round(const Block& block) {
  const int g = (block.flags & Block::kNoG) != 0       ? -1
                : (block.flags & Block::kSecondG) != 0 ? 3
                                                       : 2;
  const Cell* values = code_->cells.data() + block.data + block.g_count;
  if (!motion_.round(block.mask, values, g, static_cast<std::uint32_t>(executed_),
                     recorded_moves()))
    return words(block);
  ++changes_;
  last_n_ = block.n >= 0 ? block.n : last_n_;
  record_step();
  pc_ = next_;
  return true;
}

/// The words of a block with their values. A vacant variable's word is left out, or counts as 0, as
/// the control does.
bool Machine::decode(const Block& block, NcWords& words) {
  const Cell* cell = code_->cells.data() + block.data;
  std::uint32_t expressions = 0;
  if ((block.flags & Block::kHasExtra) != 0) {
    expressions = cell->extra.expressions;
    words.whole = cell->extra.whole;
    ++cell;
  }
  words.at = pc_;
  const auto code = [&](double factor, int& result) {
    double value = (cell++)->value;
    std::uint32_t at = block.text, width = block.length;
    if (value < 0) {
      const auto expression = to_whole<std::uint32_t>(-1.0 - value);
      if (!evaluate(expression, value)) return false;
      if (is_vacant(value)) {
        result = -1;
        return true;
      }
      value = std::round(value * factor);
      at = code_->expressions[expression].at;
      width = code_->expressions[expression].width;
    }
    if (value < 0 || value > kLargestCode)
      return alarm({Cause::ValueOutOfRange, at, width, "the code is out of range"});
    result = to_whole<int>(value);
    return true;
  };
  for (int i = 0; i < block.g_count; ++i) {
    int g = 0;
    if (!code(10, g)) return false;
    if (g > 10000 || (g >= 0 && !code_->g_codes.test(static_cast<std::size_t>(g))))
      return alarm({.cause = Cause::GCodeNotAvailable,
                    .detail = "the control has no such G code",
                    .address = 'G',
                    .code = g});
    if (g >= 0) words.g[static_cast<std::size_t>(words.g_count++)] = g;
  }
  for (int i = 0; i < block.m_count; ++i) {
    int m = 0;
    if (!code(1, m)) return false;
    if (m >= 0) words.m[static_cast<std::size_t>(words.m_count++)] = m;
  }
  words.mask = block.mask;
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const auto place = static_cast<std::size_t>(__builtin_ctz(left));
    const std::uint32_t mark = 1u << place;
    if ((expressions & mark) == 0) {
      words.value[place] = cell->value;
      continue;
    }
    double value = 0;
    const auto expression = static_cast<std::uint32_t>(cell->expression);
    if (!evaluate(expression, value)) return false;
    if (std::fabs(value) >= largest_word_) {  // a vacant value compares false
      const Expression& e = code_->expressions[expression];
      if (std::fabs(value) > kLargest)
        return alarm({Cause::Overflow, e.at, e.width, "the result is too large"});
      return alarm(
          {Cause::ValueOutOfRange, e.at, e.width,
           "the value has more than " + std::to_string(most_digits(*code_->control)) + " digits"});
    }
    if (is_vacant(value)) {
      if (code_->control->vacant_address.value == VacantAddress::Ignored) words.mask &= ~mark;
      value = 0;
    }
    words.value[place] = value;
    words.computed |= mark;
  }
  return true;
}

/// Decodes the words of a block, and does what they say.
bool Machine::carry_out(const Block& block) {
  NcWords words;
  if (!decode(block, words)) return false;
  Motion::Outcome& outcome = outcome_;
  words.ends = block.op == Op::EndProgram;
  words.stops = words.ends;
  for (int i = 0; i < words.m_count; ++i) {
    const int m = words.m[static_cast<std::size_t>(i)];
    words.stops = words.stops || waits_at(m) || m == 2 || m == 30;
  }
  Outside around = outside();
  if (auto fault = motion_.execute(words, static_cast<std::uint32_t>(executed_), recorded_moves(),
                                   outcome, around)) {
    if (stop_ != Stop::Running) return false;  // a word of a profile has alarmed
    if (broken_off_ == Stop::Running) return alarm(of_motion(*fault));
    return false;
  }
  in_block_ = 0;
  if (outcome.skip != SkipMove::No) keep_skip(outcome.skip);
  moves_ += outcome.moves + motion_.held_pieces() / kHeldPieces;
  if (moves_ > look_moves_) look_soon();
  if (!auxiliary(words, block)) return false;
  if ((block.flags & Block::kDrops) != 0 || (outcome.dropped | outcome.dropped_codes) != 0)
    tell_dropped(block, words);
  words_done_ = true;
  if (block.n >= 0) last_n_ = block.n;
  if (outcome.moved || words.m_count > 0 || words.has('T') || words.g_count > 0) ++changes_;
  if (is_words(block.op)) return after_words(outcome);
  if (next_ != kEnd) return true;
  record_step();  // M#1 beside a call, a return or a jump ends the program before it
  return end(Stop::End);
}

/// What a G31 leaves: its position, in the variables of a control that keeps it among the commons
/// (X Z Y and the fourth and the fifth axis of a lathe [TDi p.94]); or that nothing was met.
void Machine::keep_skip(SkipMove skip) {
  if (skip == SkipMove::Missed) {
    trace_.missed_skips.push({executed_, pc_});
    return;
  }
  const int first = code_->control->skip_variables.value;
  if (first <= 0) return;
  for (int axis = 0; axis < kSkipAxes; ++axis) write(first + axis, motion_.skip_position(axis));
}

/// M and T codes go to the machine; M00 and M01 wait for the operator.
bool Machine::auxiliary(const NcWords& words, const Block& block) {
  if (words.has('T') && trace_.depth != Trace::Depth::None)
    trace_.t_codes.push(to_whole<std::int64_t>(std::round(words['T'])));
  if (words.has('T')) answer('T', to_whole<std::int64_t>(std::round(words['T'])));
  for (int i = 0; i < words.m_count; ++i) {
    const int m = words.m[static_cast<std::size_t>(i)];
    if (trace_.depth != Trace::Depth::None) trace_.m_codes.push(m);
    last_m_ = m;
    answer('M', m);
    if (waits_at(m) && !wait_for_operator(m == 0 ? "M00" : "M01")) return false;
    if (m != 0 && m == code_->control->restart_m_code.value && stack_.size() == 1) next_ = kRestart;
    if ((m == 2 || m == 30) && block.op != Op::EndProgram) next_ = kEnd;
  }
  return true;
}

/// What the machine does about a code it was sent: its signals change, and variables that it
/// writes.
void Machine::answer(char address, std::int64_t code) {
  if (options_.inputs.answers.empty()) return;
  const auto found = options_.inputs.answers.find({address, code});
  if (found == options_.inputs.answers.end()) return;
  for (const auto& [number, value] : found->second) set_from_outside(number, value);
  ++changes_;
}

bool Machine::wait_for_operator(const std::string& what) {
  if (!options_.inputs.operator_given) return true;
  const std::size_t answer = next_answer_++;
  if (answer < options_.inputs.operator_starts.size() && options_.inputs.operator_starts[answer])
    return true;
  waiting_for_ = "cycle start after " + what;
  record_step();
  return go_to(next_) && end(Stop::Waiting);
}

bool Machine::after_words(const Motion::Outcome& outcome) {
  record_step();
  jumped_after_ = pc_;
  if (next_ == kRestart || next_ == kEnd) return go_to(next_);
  if (outcome.behind != kNowhere) {
    leave_loops(outcome.behind);
    next_ = outcome.behind;
  }
  pc_ = next_;
  return call_after_move(outcome);
}

/// The block that is executed next, or what an M code of the block makes of it.
bool Machine::go_to(Address next) {
  if (next == kRestart) return restart_main();
  if (next == kEnd) return end(Stop::End);
  pc_ = next;
  return true;
}

bool Machine::end_program(const Block& block) {
  if (!words(block)) return false;
  // Where the block has no words of its own nothing has ended the moves that wait.
  if (auto fault = motion_.finish(static_cast<std::uint32_t>(executed_), recorded_moves()))
    return alarm(of_motion(*fault));
  record_step();
  return end(Stop::End);
}

bool Machine::end_of_record() {
  const bool typed = options_.mdi && stack_.size() == 1;  // what is typed in MDI needs no end
  if (typed || code_->control->missing_end.value == MissingEnd::Ends) return end(Stop::End);
  const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
  return alarm({Cause::EndOfRecord, program.text_end, 1,
                code_->name_of(program) + " ends without M02, M30 or M99"});
}

// ---- M99, M97 ----

bool Machine::return_from_call(const Block& block) {
  const CallRecord& back = code_->calls[block.aux];
  double p = kVacant, l = kVacant;
  if (!operand(back.p, p) || !operand(back.l, l)) return false;
  const Control& control = *code_->control;
  const bool modal_active = !modals_.empty() && frame().modal < 0;
  if (modal_active && !is_vacant(p) && control.calls_in_modal.value == CallsInModal::EndModal)
    return alarm(
        {Cause::CallInModalCall, back.at, back.width, "M99 P while a modal macro call is active"});
  if (!is_vacant(p) && motion_.compensating() && !control.jumps_in_compensation.value)
    return alarm({Cause::ReturnInCompensation, back.p.at, back.p.width,
                  "M99 P while the radius offset is on"});
  const bool other_words = block.mask != 0 || block.g_count != 0 || block.m_count != 0;
  if (!modals_.empty() && other_words && control.return_alone_in_modal.value)
    return alarm({Cause::IllegalWordWithReturn, back.at, back.width,
                  "M99 with other words while a modal macro call is active"});
  if (!words(block)) return false;
  if (modal_after(outcome_) >= 0)
    return do_behind_modal({Op::Return, block.aux, pc_, executed_, {}, p, l, {}, {}});
  return return_now(back, p, l) && wake();
}

/// A computed sequence number; -1, which no block has, where the value is none.
std::int64_t Machine::number_of(double value) {
  const double n = is_vacant(value) ? -1 : std::round(value);
  return to_whole<std::int64_t>(std::clamp(n, -1.0, 2e9));
}

Fault Machine::no_block(Cause cause, const Operand& word, double value,
                        const Program& program) const {
  const double n = is_vacant(value) ? -1 : std::clamp(std::round(value), -1e9, 2e9);
  return {cause, word.at, word.width,
          "there is no N" + std::to_string(to_whole<std::int64_t>(n)) + " in " +
              code_->name_of(program)};
}

/// What is left of a return's block when its words are executed.
bool Machine::return_now(const CallRecord& back, double p, double l) {
  const Control& control = *code_->control;
  if (!is_vacant(p) && control.return_with_p.value == ReturnWithP::OwnProgram)
    return go_on_at(back, p);
  if (stack_.size() == 1) return return_from_main(back, p);
  Open& open = frame();
  std::int32_t repeats = open.repeats;
  if (!is_vacant(l) && control.return_with_l.value == ReturnWithL::ReplacesCount)
    repeats = open.repeat + to_whole<std::int32_t>(std::clamp(std::round(l), 0.0, 1e6));
  const bool rewritten = open.modal >= 0 && control.modal_locals.value == ModalLocals::Rewritten &&
                         open.modal < static_cast<std::int32_t>(modals_.size());
  const bool leaves = !is_vacant(p) && control.return_with_p.value == ReturnWithP::AtOnce;
  if (!leaves && open.repeat < repeats) {
    record_block();
    open.repeats = repeats;
    ++open.repeat;
    ++changes_;
    loops_.resize(open.loops);
    pc_ = open.restart;
    if (rewritten) {
      const std::vector<double>& again = modals_[static_cast<std::size_t>(open.modal)].locals;
      std::copy(again.begin(), again.end(),
                locals_.begin() + static_cast<std::ptrdiff_t>(level_) * code_->locals);
    }
    return true;
  }
  Address to = open.return_to;
  if (!is_vacant(p)) {
    const Program& caller =
        code_->programs[static_cast<std::size_t>(stack_[stack_.size() - 2].program)];
    to = code_->return_target(caller, number_of(p), open.called_at);
    if (to == kNowhere) return alarm(no_block(Cause::ReturnTargetNotFound, back.p, p, caller));
  }
  record_block();
  return leave(to, is_vacant(p));
}

bool Machine::return_from_main(const CallRecord& back, double p) {
  switch (code_->control->main_return.value) {
    case MainReturn::Alarm:
      return alarm(
          {Cause::ReturnInMainProgram, back.at, back.width, "M99 stands in the main program"});
    case MainReturn::Ends:
      record_block();
      return end(Stop::End);
    case MainReturn::Restarts:
      break;
  }
  if (!is_vacant(p)) return go_on_at(back, p);
  record_block();
  return restart_main();
}

/// M99 P in the main program, and wherever it names a block of its own program.
bool Machine::go_on_at(const CallRecord& back, double p) {
  const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
  const Address to = code_->first_of(program, number_of(p));
  if (to == kNowhere) return alarm(no_block(Cause::ReturnTargetNotFound, back.p, p, program));
  record_block();
  leave_loops(to);
  pc_ = to;
  return true;
}

/// The main program starts over; a cycle is done.
bool Machine::restart_main() {
  if (++cycles_ >= options_.max_cycles) return end(Stop::Cycles);
  ++changes_;
  loops_.resize(frame().loops);
  frame().repeat += frame().repeat < kManyRepeats ? 1 : 0;
  pc_ = frame().restart;
  return true;
}

bool Machine::jump(const Block& block) {
  const Statement& statement = code_->statements[block.aux];
  double p = 0;
  if (!operand(statement.p, p)) return false;
  if (!words(block)) return false;
  if (modal_after(outcome_) >= 0)
    return do_behind_modal({Op::Jump, block.aux, pc_, executed_, {}, p, 0, {}, {}});
  return jump_now(statement, p);
}

bool Machine::jump_now(const Statement& statement, double p) {
  const Program& program = code_->programs[static_cast<std::size_t>(frame().program)];
  const Address to = code_->first_of(program, number_of(p));
  if (to == kNowhere) return alarm(no_block(Cause::JumpTargetNotFound, statement.p, p, program));
  record_block();
  leave_loops(to);
  pc_ = to;
  return true;
}

/// The next that is told of these signals. What is told of any signal comes first.
SkipsTold Machine::take_skips(SignalMask signals) {
  SkipsTold taken{{}, signals};
  take_from_outside();
  for (std::size_t i = 0; i < next_skip_.size() && taken.open != 0; ++i) {
    const SignalMask of = i == 0 ? signals : signal_bit(static_cast<int>(i)) & signals;
    const auto& list = options_.inputs.skips[i];
    if (of == 0 || next_skip_[i] >= list.size()) continue;
    taken.told.push_back(list[next_skip_[i]++]);
    taken.open &= ~of;
  }
  return taken;
}

Outside Machine::outside() {
  Outside around;
  around.profile = [this](std::int64_t ns, std::int64_t nf, Profile& found) {
    return profile(ns, nf, found);
  };
  around.skips = [this](SignalMask signals) { return take_skips(signals); };
  around.workpiece = options_.inputs.workpiece.get();
  in_block_ = 0;
  around.interrupted = [this] { return breaks_off(); };
  return around;
}

}  // namespace cncsub
