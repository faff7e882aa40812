// The interpreter: one run of one program, whole or block by block.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "cncsub/call.hpp"
#include "cncsub/code.hpp"
#include "cncsub/motion.hpp"
#include "cncsub/trace.hpp"

namespace cncsub {

enum class Stop : std::uint8_t { Running, End, Alarm, Cycles, Limit, Waiting, Interrupted };
std::string_view to_string(Stop stop);

/// What the world outside answers, scripted.
struct Inputs {
  std::map<std::int32_t, double> signals;  // #1000 and the like
  double clock_ms = 0;                     // #3001 when the run starts
  double date = 20000101;                  // #3011, YYYYMMDD
  double time = 0;                         // #3012, HHMMSS
  std::vector<bool>
      operator_starts;  // at M00, M01, #3006: cycle start, or not; all start when empty
  bool operator_given = false;
  std::vector<std::map<std::int32_t, double>>
      writes;  // variables another program writes, each time the run waits
  // Of each block that watches a signal, in order, whichever it watches (the first list), or those
  // of one signal; behind them the workpiece decides.
  std::array<std::vector<SkipSignal>, kSkipSignals> skips;
  std::shared_ptr<const Workpiece> workpiece;
  // What the machine's signals become when it is sent a code: 'M' 117.
  std::map<std::pair<char, std::int64_t>, std::map<std::int32_t, double>> answers;
};

struct Options {
  bool mdi = false;
  std::int64_t start = -1;
  std::map<std::int32_t, double> variables;
  std::uint16_t skips = 0;  // bit k: block-skip switch k is on
  bool optional_stop = false;
  std::int64_t max_cycles = 1;
  std::int64_t max_blocks = 10'000'000;
  double max_seconds = 0;                             // 0 = any
  std::uint64_t max_memory = std::uint64_t{4} << 30;  // bytes of what is recorded
  Trace::Depth trace = Trace::Depth::Moves;
  Inputs inputs;
  Setup setup;
};

class Machine {
 public:
  Machine(std::shared_ptr<const Code> code, std::int32_t main, Options options);

  /// Executes one block. False where the run has stopped before one was executed, or where
  /// `interrupted`, which a block of very many moves asks now and then, said so: then that block
  /// did nothing.
  bool step(const std::function<bool()>& interrupted = {});
  /// Runs until the run stops, or until `pause` says so (asked before each block when it is given).
  void run(const std::function<bool()>& interrupted,
           const std::function<bool(const Machine&)>& pause = {}) {
    run(interrupted, pause, std::numeric_limits<std::int64_t>::max());
  }
  /// Runs on for about this many blocks: fewer where they made very many moves.
  void run(const std::function<bool()>& interrupted, std::int64_t blocks) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() - 1;
    run(interrupted, {}, executed_ + std::min(blocks, kMost - executed_));
  }
  /// Stops the run as Ctrl-C does.
  void interrupt() {
    if (stop_ == Stop::Running) end(Stop::Interrupted);
  }
  /// Gives away what was recorded so far; the run goes on with empty tables. Calls that are still
  /// open come with a later part.
  Trace take();
  /// The axes that the programs in memory name, X Y Z first, before any of them moves.
  std::string axes() const;
  /// Bytes of what was recorded.
  std::uint64_t memory() const;

  const Code& code() const { return *code_; }
  std::shared_ptr<const Code> shared_code() const { return code_; }
  Stop stop() const { return stop_; }
  const std::optional<Alarm>& alarm() const { return alarm_; }
  const std::string& waiting_for() const { return waiting_for_; }
  const Trace& trace() const { return trace_; }
  const Motion& motion() const { return motion_; }
  std::vector<Frame> frames() const;
  int depth() const { return static_cast<int>(stack_.size()) - 1; }
  int level() const { return level_; }
  Address address() const { return pc_; }
  std::int64_t blocks() const { return executed_; }
  /// What the reset key, M02 and M30 do: calls, modal calls and loops are gone, the variables that
  /// the control clears are vacant, and the main program is at its head again. What was recorded
  /// stays.
  void reset();
  /// Whether a reset makes a variable vacant.
  bool cleared_by_reset(std::int64_t number) const;
  /// Every variable that is not vacant or was ever written: commons and the locals of a level.
  std::map<std::int32_t, double> variables(int level) const;
  std::optional<Fault> read(std::int64_t number, double& value);
  std::optional<Fault> write(std::int64_t number, double value);
  std::optional<Fault> read_at(std::int64_t number, int level, double& value) const;
  std::optional<Fault> write_at(std::int64_t number, int level, double value);
  /// Why nobody can give a value to a variable, or nothing.
  std::optional<Fault> unwritable(std::int64_t number) const;
  /// Whether a variable may hold no value: a local or a common.
  bool can_be_vacant(std::int64_t number) const;
  /// Whether a variable is set by the machine, from outside.
  bool is_signal(std::int64_t number) const;
  void set_from_outside(std::int32_t number, double value);
  /// The signals that were set so far.
  const std::map<std::int32_t, double>& signals() const { return options_.inputs.signals; }

 private:
  struct Open {  // a frame
    std::int32_t program = 0;
    std::int32_t call = -1;  // the row in the trace, -1 for the main program
    std::int32_t repeat = 1, repeats = 1;
    Address return_to = 0;
    Address called_at = 0;
    Address restart = 0;
    CallKind kind = CallKind::M98;
    bool macro = false;
    bool own_locals = false;
    bool external = false;
    char code_letter = 0;     // the code that called this program or one below it
    std::int32_t modal = -1;  // the modal call this frame runs
    std::int32_t modal_limit =
        0;                    // only the modal calls below this one follow the moves of this frame
    std::uint32_t loops = 0;  // the loops of the frames below
    bool interrupts = false;  // behind it the caller's block makes the call that it waits with
  };
  /// The call, return or jump of a block whose move is followed by a modal macro first.
  struct Waiting {
    Op op = Op::Call;       // a call, Op::Return or Op::Jump
    std::uint32_t aux = 0;  // of its block
    Address at = 0;
    std::int64_t step = 0;
    Target target;                    // of a call
    double p = kVacant, l = kVacant;  // of a return or a jump
    std::vector<double> arguments;
    std::vector<std::uint8_t> programmed;
  };
  struct Modal {
    std::uint32_t record = 0;
    Target target;
    std::vector<double> locals;
    std::int32_t program = 0;  // where it was declared
    bool every_block = false;
  };

  struct Places {  // where the locals of the level and the commons lie, as a Load and a target tell
    std::array<double*, 3> of;
    double load(const Expression::Load& from) const {
      const double value = from.from == Expression::Load::From::Constant
                               ? from.value
                               : of[static_cast<std::size_t>(from.from)][from.index];
      return from.raw || !is_vacant(value) ? value : 0.0;
    }
  };
  struct Trap {  // why an expression has no value
    Cause cause;
    std::uint32_t at;
    const char* detail;
    std::int64_t variable = kNoVariable;  // the one that cannot be read
    static constexpr std::int64_t kNoVariable = std::numeric_limits<std::int64_t>::min();
  };

  /// The machine is at work for as long as this lives: its time counts, and it asks `interrupted`.
  struct AtWork {
    AtWork(Machine& of, const std::function<bool()>& interrupted);
    AtWork(const AtWork&) = delete;
    AtWork& operator=(const AtWork&) = delete;
    ~AtWork();
    Machine& machine;
  };

  // Blocks. Each returns false where the run stopped.
  bool execute(const Block& block, bool one);
  bool statements(bool one);
  bool alarm(const Fault& fault);
  Fault of_motion(Fault fault) const;
  bool choose(const Block& block);
  bool words(const Block& block) {
    outcome_ = {};
    const bool any = block.mask != 0 || block.g_count != 0 || block.m_count != 0;
    return any ? carry_out(block) : no_words(block);
  }
  bool carry_out(const Block& block);
  bool no_words(const Block& block) {
    if (block.n >= 0) last_n_ = block.n;
    if (!is_words(block.op)) return true;
    record_step();
    pc_ = next_;
    return true;
  }
  bool linear(const Block& block);
  bool round(const Block& block);
  bool decode(const Block& block, NcWords& words);
  bool auxiliary(const NcWords& words, const Block& block);
  void keep_skip(SkipMove skip);
  void answer(char address, std::int64_t code);
  /// Whether the run waits for the operator at an M code.
  bool waits_at(int m) const { return m == 0 || (m == 1 && options_.optional_stop); }
  bool wait_for_operator(const std::string& what);
  bool after_words(const Motion::Outcome& outcome);
  // Where a block goes on, besides the addresses of blocks: an M code of it starts the main program
  // over, or M#1 ends it.
  static constexpr Address kRestart = kNowhere, kEnd = kNowhere - 1;
  bool go_to(Address next);
  std::int32_t modal_after(const Motion::Outcome& outcome) const {
    return modals_.empty() ? -1 : modal_of_move(outcome);
  }
  std::int32_t modal_of_move(const Motion::Outcome& outcome) const;
  bool call_after_move(const Motion::Outcome& outcome);
  bool do_behind_modal(Waiting waiting);
  bool wake() { return !wakes_ || go_on(); }
  bool go_on();
  bool call_now(std::uint32_t aux, Target& target);
  static std::int64_t number_of(double value);
  Fault no_block(Cause cause, const Operand& word, double value, const Program& program) const;
  bool return_now(const CallRecord& back, double p, double l);
  bool jump_now(const Statement& statement, double p);
  /// To be called before the clock, a random number or a skip signal is taken.
  void take_from_outside() {
    if (taken_.block != executed_) taken_ = {executed_, clock_ms_, next_skip_, random_};
  }
  void give_back();
  SkipsTold take_skips(SignalMask signals);
  void record_block() {
    if (!block_is_step_) record_step();
  }
  bool call(const Block& block);
  bool macro_call(const Block& block);
  bool modal_call(const Block& block);
  bool cancel_modal(const Block& block);
  bool every_block(const Block& block);
  bool return_from_call(const Block& block);
  bool go_on_at(const CallRecord& back, double p);
  bool return_from_main(const CallRecord& back, double p);
  bool jump(const Block& block);
  bool end_program(const Block& block);
  bool end_of_record();
  bool restart_main();
  bool assign(const Statement& statement);
  bool assign(const Statement& statement, const Places& places, double value);
  /// GOTO, WHILE and DO alarm in the main program of MDI where the control says so.
  bool may_jump(const Statement& s) {
    return !jumps_refused_ || stack_.size() > 1 ||
           alarm({Cause::JumpInMdi, s.at, s.width, "a jump or a loop in MDI"});
  }
  bool go_to(const Statement& statement);
  bool branch(const Block& block);
  bool loop(const Statement& statement, bool holds);
  bool open_loop(const Statement& statement);
  bool end_loop(const Statement& statement);
  bool h_code(const Statement& h);
  bool h_jump(const Statement& statement, std::int64_t n);
  bool h_alarm(const Statement& h);
  bool h_variable(const Operand& operand, std::int64_t& number);
  std::optional<Cause> h_result(int code, double q, double r, std::int64_t target, double& result);
  bool print(const Print& print);
  bool name_variables(const Statement& statement);
  /// A message for the operator, or what is printed.
  void say(std::string text) {
    if (text.size() > kLongText) look_soon();
    trace_.say(std::move(text));
    ++changes_;
  }
  bool user_alarm(double n, const Statement& statement);
  bool store(const Statement& statement, double value);
  bool store_number(std::int64_t number, double value, const Statement& statement);

  // Calls.
  bool operand(const Operand& operand, double& value) {
    if (operand.kind == Operand::Kind::Expression) return computed(operand, value);
    value = operand.kind == Operand::Kind::Absent ? kVacant : operand.value;
    return true;
  }
  bool computed(const Operand& operand, double& value);
  bool decode_target(const CallRecord& record, Target& target);
  std::optional<Fault> refused_here(const CallRecord& record) const;
  std::optional<Fault> refused(const CallRecord& record, const Target& target) const;
  bool find(const CallRecord& record, Target& target);
  bool enter(std::uint32_t index, const Target& target, std::int32_t modal);
  bool evaluate_arguments(const CallRecord& record);
  void open_level();
  /// The place of a local variable of a level.
  std::size_t local_at(int level, std::int32_t index) const {
    return static_cast<std::size_t>(level) * static_cast<std::size_t>(code_->locals) +
           static_cast<std::size_t>(index);
  }
  bool enter_modal(std::int32_t modal_index);
  bool leave(Address to, bool goes_on = true);

  bool jump_to(Address to);
  void leave_loops(Address to);
  bool waits();
  bool waits_for(std::uint32_t condition);
  Places places() { return {{nullptr, locals_.data() + local_at(level_, 0), commons_.data()}}; }
  bool evaluate(std::uint32_t expression, double& value) {
    return evaluate(code_->expressions[expression], places(), value);
  }
  bool evaluate(const Expression& expression, const Places& places, double& value);
  bool evaluate_long(const Expression& expression, const Places& places, double& value);
  bool condition(std::uint32_t expression, bool& holds);
  bool compute(const Instruction* at, const Places& places, double& result, Trap& trap);
  std::optional<Fault> read_at(const VariablePlace& place, std::int64_t number, int level,
                               double& value) const;
  double chosen_parameter() const;
  std::optional<Fault> system_read(const VariablePlace& place, std::int64_t number,
                                   double& value) const;
  std::optional<Fault> system_write(const VariablePlace& place, std::int64_t number, double value);
  void record_step();
  /// A block that did the work of many: time, memory and Ctrl-C are asked about soon.
  void look_soon() { look_at_ = 0; }
  void look_later(std::int64_t last);
  /// Why the run is to stop now, if it is: asked between blocks, and inside those that take long.
  Stop stops();
  /// Whether to break off the running block, which then has done nothing.
  bool breaks_off();
  static constexpr std::uint32_t kLongText = 1000;  // of a block or an expression that takes long
  void run(const std::function<bool()>& interrupted,
           const std::function<bool(const Machine&)>& pause, std::int64_t until);
  bool passes(const Block& block);
  void finish();
  bool end(Stop stop);
  const Open& frame() const { return stack_.back(); }
  Open& frame() { return stack_.back(); }
  Moves* recorded_moves() { return trace_.depth == Trace::Depth::Moves ? &trace_.moves : nullptr; }
  Outside outside();
  std::optional<Fault> profile(std::int64_t ns, std::int64_t nf, Profile& found);
  std::optional<Fault> profile_block(Address a, std::vector<NcWords>& blocks);

  std::shared_ptr<const Code> code_;
  Options options_;
  using Clock = std::chrono::steady_clock;
  const std::function<bool()>* interrupted_ = nullptr;  // while it runs: whether to stop
  Stop broken_off_ = Stop::Running;                     // why a block was, in the middle
  Clock::time_point begun_;                             // while it runs: when it began to
  double spent_ = 0, asked_ = 0;  // seconds at work before, and until it asked `interrupted`
  std::uint64_t in_block_ = 0;    // bytes that the running block takes besides what it records
  std::int64_t look_moves_ = 0;   // when that many moves are made the run looks around
  Trace trace_;
  Motion motion_;

  Address pc_ = 0;
  Address next_ = 0;  // where the run goes on behind the block that is being executed
  std::vector<Open> stack_;
  std::vector<double> locals_;            // level after level
  std::vector<std::uint8_t> programmed_;  // how an argument was programmed, for AR[]
  int level_ = 0;
  std::vector<double> commons_;
  std::map<std::int64_t, double> system_;  // what was written to system variables
  std::map<std::string, std::int64_t> names_;
  std::vector<Address> loops_;  // the DO blocks entered
  std::vector<Modal> modals_;
  int subprograms_ = 0, macros_ = 0;
  std::int64_t executed_ = 0;
  std::int64_t look_at_ = 0;  // when that many blocks are executed the run looks around
  std::int64_t skipped_ = 0, skipped_behind_ = -1;  // by block skip, since that many were executed
  std::int64_t moves_ = 0;                          // since the run looked around
  std::int64_t cycles_ = 0;
  std::int64_t last_m_ = -1, last_n_ = -1;
  bool words_done_ = false;
  Motion::Outcome outcome_;      // of the words of the running block
  std::vector<double> scratch_;  // the locals of a level that is about to open
  std::vector<std::uint8_t> scratch_programmed_;
  Stop stop_ = Stop::Running;
  std::optional<Alarm> alarm_;
  std::string waiting_for_;

  // Waiting is a loop that changes nothing.
  std::uint64_t changes_ = 0, changes_at_jump_ = ~0ULL;
  Address jumped_from_ = kNowhere;
  bool jumps_refused_ = false;    // in the main program, which was typed in MDI
  Address jumped_after_ = 0;      // the block whose move a modal call follows
  std::vector<Waiting> waiting_;  // of the frames that interrupt, outermost first
  bool wakes_ = false;            // the last of them goes on now
  bool block_is_step_ = false;    // the running block, which waited, is a step already
  std::int64_t waited_at_ = 0;    // which one
  double largest_word_ = 0;       // no computed word of a block reaches it
  std::uint32_t last_condition_ = kNowhere;
  std::size_t next_write_ = 0, next_answer_ = 0;
  std::array<std::size_t, kSkipSignals> next_skip_{};
  struct Taken {  // what a block may take from outside before it alarms, as it was before
    std::int64_t block = -1;  // the number of blocks executed before it
    double clock_ms = 0;
    std::array<std::size_t, kSkipSignals> next_skip{};
    std::minstd_rand random;
  } taken_;
  void tell_dropped(const Block& block, const NcWords& words);
  double clock_ms_ = 0;
  std::minstd_rand random_{1};
};

/// The number whose digits to the base `to` are those of a whole value to the base `from`: BIN,
/// BCD, H24, H25. False where these are not one to eight decimal digits.
bool read_digits(double value, int from, int to, double& result);

[[gnu::always_inline]] inline void Machine::record_step() {
  if (trace_.depth >= Trace::Depth::Blocks) trace_.steps.push({pc_, frame().call, frame().repeat});
  ++executed_;
}

/// One value, or one operation on two, at once; what is longer or has no finite result goes the
/// long way.
[[gnu::always_inline]] inline bool Machine::evaluate(const Expression& e, const Places& places,
                                                     double& value) {
  if (e.form == Expression::Form::Long) return evaluate_long(e, places, value);
  const double a = places.load(e.loads[0]);
  if (e.form == Expression::Form::One) {
    value = a;
    return true;
  }
  const double b = places.load(e.loads[1]);
  const auto same = [&] { return a == b || (is_vacant(a) && is_vacant(b)); };
  switch (e.op) {
    case Ins::Add:
      value = a + b;
      return std::isfinite(value) || evaluate_long(e, places, value);
    case Ins::Subtract:
      value = a - b;
      return std::isfinite(value) || evaluate_long(e, places, value);
    case Ins::Multiply:
      value = a * b;
      return std::isfinite(value) || evaluate_long(e, places, value);
    case Ins::Equal:
      value = same() ? 1 : 0;
      return true;
    case Ins::NotEqual:
      value = same() ? 0 : 1;
      return true;
    case Ins::Greater:
      value = a > b ? 1 : 0;
      return true;
    case Ins::Less:
      value = a < b ? 1 : 0;
      return true;
    case Ins::GreaterEqual:
      value = a >= b ? 1 : 0;
      return true;
    default:
      value = a <= b ? 1 : 0;
      return true;
  }
}

}  // namespace cncsub
