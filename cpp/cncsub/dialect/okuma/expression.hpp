// Values: 10.5, PX, V5, VZOFX[2], [1 + 2], SIN[30], compiled into instructions.
#pragma once

#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/code/operators.hpp"
#include "cncsub/dialect/okuma/line.hpp"
#include "cncsub/dialect/okuma/system_variables.hpp"

namespace cncsub::okuma {

/// The operators of values, and the comparisons, which stand in conditions alone.
extern const std::span<const OperatorRow> kOperators;

using Value = ValueRead;

/// Marks of faults of one cause that have different numbers on the control: Fault::kind.
using Kind = std::array<char, 2>;
inline constexpr Kind kPoints{'P', 'T'};        // a number with two points
inline constexpr Kind kNoTarget{'N', 'T'};      // a jump without a name
inline constexpr Kind kNoBracket{'N', 'B'};     // no bracket after IF
inline constexpr Kind kNoComparison{'N', 'C'};  // no comparison in it
inline constexpr Kind kTooLong{'T', 'L'};       // a name of too many characters
inline constexpr Kind kOtherName{'O', 'N'};     // the head of another program
inline constexpr Kind kSystem{'S', 'V'};        // a system variable

/// A function of one value, or of two.
struct Function {
  std::string_view name;
  Ins op;
  int values = 1;
  bool thousandths = false;  // of the value in thousandths
};
const Function* find_function(std::string_view name);

class ExpressionReader {
 public:
  ExpressionReader(Builder& to, Line& line) : to_(to), line_(line) {}

  /// Forget what the block before has assigned.
  void begin_block() { assigned_.clear(); }
  /// Read a number with its sign, as it stands after an address.
  bool number(Value& value);
  /// Read the expression after =.
  bool value(Value& value);
  /// Read a condition in brackets.
  bool condition(std::uint32_t& expression);
  /// Read the variable before the = of an assignment.
  bool left_side(Statement& statement);
  /// Note that the block gives a variable its value: what comes after in it does not read that.
  void note_assigned(const std::string& name) { assigned_.insert(name); }
  /// Refuse what is read.
  bool wrong(Cause cause, std::string detail, std::uint32_t at, Kind kind = {});

  std::optional<Fault> fault;  // why the last reading failed

 private:
  friend class Operators;
  bool read_value(int depth);
  bool read_signed(int depth, char sign);
  bool read_operators_in(int depth);
  bool read_bracket(int depth);
  bool read_number();
  bool read_name(int depth);
  bool read_function(const Function& function, int depth);
  bool read_variable(const std::string& name, int depth);
  bool read_system(const std::string& name, int depth);
  bool read_local(const std::string& name, std::uint32_t at);
  bool common_number(const std::string& name, std::uint32_t at, std::int32_t& number);
  bool read_index(const SystemVariable& of, int depth);
  bool asks_existence(bool& is);
  bool is_local(const std::string& name, std::uint32_t at);
  bool is_assigned_here(const std::string& name, std::uint32_t at);
  bool finish(Value& value, std::uint32_t at);
  void emit(Ins op, double value = 0);

  Builder& to_;
  Line& line_;
  std::set<std::string> assigned_;  // by the block so far
  std::optional<double> constant_;  // the last value was this number and nothing else
  bool in_condition_ = false, compared_ = false;
};

/// Return the name of the variable at the head of a text: V13 of V13V5.
std::string_view variable_in(std::string_view text);
/// Return the name of a common with its number, V5 or VC5; empty where this is another name.
std::string_view digits_of_common(std::string_view name);

}  // namespace cncsub::okuma
