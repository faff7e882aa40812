// Breakpoints: where a run pauses, and after which events.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/code/expression_list.hpp"
#include "cncsub/machine/state/context.hpp"

namespace cncsub {

/// A place before which a run pauses, or an event after whose block it does.
struct Breakpoint {
  enum class Kind : std::uint8_t {
    Block,   // one of `blocks` comes next
    Depth,   // no more than `number` calls are open
    Call,    // a program was called: that of `number`, or any (-1)
    Return,  // a program was left
    Alarm,   // the run stopped with an alarm: of the number or the cause `name`, or any
    Code,    // an M, T or S code of `letter` was sent: `number`, or any (-1)
    Value,   // the value of `expression` changed
    Axis,    // a move passed or reached `value` on the axis `letter`
    Mode,    // the code of the group `name`, or of any group, changed
  };
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  Kind kind = Kind::Block;
  std::vector<Address> blocks{};
  std::int64_t number = -1;
  char letter = 0;
  double value = 0;
  std::string name{};
  std::uint32_t expression = kNone;  // in the list of expressions
  std::uint32_t condition = kNone;   // the same: it counts only where this holds
  std::int64_t hits = 1;             // it pauses from this time on that it is met

  /// Return whether the block in question is the next one, and not the one before it: a block that
  /// alarmed is not executed.
  bool is_next() const { return kind == Kind::Block || kind == Kind::Depth || kind == Kind::Alarm; }
};

/// The breakpoints of a run, and what of it they compare with.
class Breakpoints {
 public:
  /// `present`: the level of locals that watched values are those of. `on_opening`: whether these
  /// count as changed when that level opens.
  Breakpoints(std::vector<Breakpoint> list, ExpressionList expressions, const Run& present,
              bool on_opening = false);

  /// Compare with the present state from now on. `here`: whether the place where the run stands
  /// counts before a block was executed.
  void begin(Run& run, bool here = false);
  /// Leave the run as it is without breakpoints.
  void end(Run& run);
  /// Return whether the run pauses here. It is asked before each block that is marked, or before
  /// every block where none is, and at the end.
  bool pauses(Run& run);
  /// Return the marks of blocks by address; null where every block is to be asked about.
  const std::uint8_t* marked() const { return each_ ? nullptr : marked_.data(); }

  /// Return which breakpoints made the run pause, by their place in the list.
  const std::vector<std::size_t>& reached() const { return reached_; }
  /// Return the breakpoint whose condition or expression has no value here, and the alarm that this
  /// would be in a program.
  const std::optional<std::pair<std::size_t, Alarm>>& faulty() const { return faulty_; }
  /// Return the step before which what was reached shows the block in question.
  std::int64_t step_of_reached(const Run& run) const;

 private:
  /// What a breakpoint compares with.
  struct Seen {
    bool open = false;  // the level of the value is open
    double value = kVacant;
    std::vector<std::pair<std::string, std::string>> modes{};
  };
  bool watches_axis() const;
  bool meets(Run& run, std::size_t index, bool moved);
  bool holds(Run& run, std::size_t index);
  void look(Run& run);
  Seen seen_now(Run& run, std::size_t index);
  bool value_of(Run& run, std::size_t index, std::uint32_t expression, double& value);
  bool is_level_open(const Run& run) const;
  bool called(const Run& run, std::int64_t program) const;
  bool returned(const Run& run, std::int64_t program) const;
  bool sent(const Run& run, const Breakpoint& of) const;
  bool passed(const Run& run, const Breakpoint& of, double& from) const;
  bool changed(Run& run, std::size_t index);

  std::vector<Breakpoint> list_;
  ExpressionList expressions_;
  std::vector<bool> of_level_;  // of each expression: it reads locals
  std::vector<std::uint8_t> marked_;
  bool each_ = false, on_opening_ = false;
  int level_ = 0;                // that was open in the present state,
  std::int32_t opened_by_ = -1;  // and the call that opened it

  // As it was before the last block, as far as events need it.
  std::int64_t begun_ = 0;
  std::size_t calls_ = 0, codes_ = 0, rows_ = 0;
  std::vector<std::pair<std::int32_t, std::int32_t>> frames_;  // call and program of each
  std::vector<Seen> seen_;

  std::vector<std::size_t> reached_;
  std::vector<std::int64_t> met_;  // how often each was since `begin`
  std::optional<std::pair<std::size_t, Alarm>> faulty_;
};

}  // namespace cncsub
