// Values: numbers, #5, #<name>, [1 + 2], SIN[30], compiled into instructions.
#pragma once

#include <optional>
#include <string>
#include <unordered_map>

#include "cncsub/dialect/ngc_values.hpp"

namespace cncsub::grblhal {

/// The last variable that programs write, and the last number that a variable has. [gHp]
inline constexpr std::int64_t kLastWritten = 5060, kLastVariable = 5599;

/// Return a written number as the control has it. It reads nine digits as a whole number, and
/// scales that by steps of 32 bits. [gHn, read_float]
double single_of(std::string_view digits);

using Value = ValueRead;

/// Marks of faults of one cause that have different numbers on the control: Fault::kind.
using Kind = std::array<char, 2>;
inline constexpr Kind kBadNumber{'N', 'F'};  // what stands there is no number
inline constexpr Kind kNotWhole{'F', 'R'};   // a code that has no fraction
inline constexpr Kind kNoAxis{'A', 'X'};     // a code without the axes that it needs

/// A variable that is assigned to. A name of the control's own takes no value.
struct Place {
  Statement::Target target = Statement::Target::None;
  std::int32_t index = 0;
  std::uint32_t number = 0;  // Indirect: the expression of its number
  std::string name;          // of a named one
};

class ExpressionReader {
 public:
  ExpressionReader(Builder& to, BareLine& line) : to_(to), line_(line) {}

  /// Forget what was read on the line before.
  void begin_line() { set_here_.clear(); }
  /// Read the value that stands here; return false if there is none: then `fault` says why.
  bool value(Value& value);
  /// Read a whole value, of which eight bits are kept where it is computed.
  bool eight_bits(Value& value);
  /// Read a value in brackets.
  bool bracketed(Value& value);
  /// Read the variable after the # of an assignment.
  bool place(Place& place);
  /// Record that the line has given a named variable a value: it is read with it at once.
  void set_here(const std::string& name, const Value& value) { set_here_[name] = value; }
  /// Read a value in brackets with the numbered variables of the caller.
  bool of_caller(Value& value);
  /// Read the variable of a message. Its value is vacant if it is not set.
  bool shown(Value& value);

  std::optional<Fault> fault;

 private:
  friend class NgcOperators<ExpressionReader>;
  bool read_value(int depth);
  bool read_signed(int depth, char sign);
  bool read_bracket(int depth);
  bool read_number();
  bool read_variable(int depth);
  bool read_named();
  bool read_function(int depth);
  bool read_arctangent(int depth);
  bool read_exists();
  bool read_setting(int depth);
  bool read_name(std::string& name);
  bool named_place(Place& place);
  bool wrong(Cause cause, std::string detail, std::size_t place, Kind kind = {});
  bool finish(Value& value, std::uint32_t at);
  void emit(Ins op, double value = 0, std::uint32_t index = 0);
  bool push_built_in(const std::string& name);
  void push_load(std::int64_t number);

  Builder& to_;
  BareLine& line_;
  std::unordered_map<std::string, Value> set_here_;
  bool of_caller_ = false;          // the locals of the caller are read
  std::optional<double> constant_;  // the last value was this number and nothing else
};

/// The last local variable of a level.
inline constexpr std::int16_t kLastLocal = 30;
/// Return the local that holds #0 of the caller; #1 and on follow it.
std::int32_t callers_locals(Builder& to);
/// Return whether a variable can be read.
bool has_variable(std::int64_t number);

}  // namespace cncsub::grblhal
