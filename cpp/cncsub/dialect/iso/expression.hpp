// Expressions of the ISO family, compiled into instructions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

struct FunctionName;
struct PlainExpression;
struct OperatorName;

/// Compiles what stands in brackets, behind an equals sign or behind an address.
class ExpressionReader {
 public:
  ExpressionReader(Builder& to, Scanner& scanner) : to_(to), code_(to.code()), s_(scanner) {}

  /// An expression that gives a number; nothing where it is faulty (see `fault`). Reads as far as
  /// the expression goes.
  std::optional<std::uint32_t> number();
  /// The value behind an address: `#1`, `-#1`, `[...]`, `-[...]`. In a word, ROUND rounds to the
  /// address's increment.
  std::optional<std::uint32_t> word_value(char address);
  /// The condition of IF and WHILE, brackets included.
  std::optional<std::uint32_t> condition();
  /// What stands behind the # of a variable, which is at `hash`: its number, or an expression that
  /// gives it.
  struct Variable {
    std::int64_t number = -1;
    std::uint32_t expression = 0;
  };
  std::optional<Variable> variable(std::uint32_t hash);

  const Fault& fault() const { return fault_; }

 private:
  static constexpr int kDeepest = 200;  // values on the stack, whatever the control allows

  enum class Type { Number, Condition };
  struct Value {
    Type type = Type::Number;
    std::int64_t raw = -1;  // the instruction, where it is one variable and may still be vacant
  };

  struct Waiting {  // for its right value
    Value left;
    const OperatorName* of = nullptr;
    std::uint32_t at = 0;
    int level = 0;
  };

  std::optional<Value> operand();
  std::optional<Value> sign();
  std::optional<Value> constant();
  std::nullopt_t no_operand();
  std::optional<Value> bracket();
  bool open();
  bool close();

  std::optional<Value> variable_value();
  std::optional<std::int64_t> variable_number(std::uint32_t at);
  std::optional<std::int64_t> written_number();
  void load(std::int64_t number, std::uint32_t at);
  bool takes(VariableForm form) const;
  std::optional<Value> take(const std::optional<PlainExpression>& plain);
  /// The value of the last instruction, which may be vacant.
  Value last() const { return {Type::Number, std::int64_t{to_.expressions().next()} - 1}; }

  // ---- operators.cpp ----
  std::optional<Value> expression();
  const OperatorName* operator_here();
  bool binds(const OperatorName& of, int level, const Value& value, bool compared) const;
  std::optional<Value> apply(const Waiting& waiting, Value right);
  std::optional<Value> compare(const Waiting& waiting, Value right);

  // ---- functions.cpp ----
  std::optional<Value> word();
  bool has(Function function) const;
  const FunctionName* find_function(std::string_view word) const;
  std::optional<Value> function(const FunctionName& of, std::uint32_t at);
  std::optional<Value> arc_tangent(std::uint32_t at);
  std::optional<Value> programmed(std::uint32_t at);
  std::optional<Value> negated(std::uint32_t at);
  bool argument();
  bool comma();

  // ---- what all of them use ----
  bool is_number(Value& value) const;
  bool arithmetic(Value& value);
  bool room();
  void emit(Ins op, std::uint32_t at, double value = 0);
  std::nullopt_t refuse(Cause cause, std::uint32_t at, std::string detail = {});
  std::uint32_t finish(std::uint32_t first, std::uint32_t at, std::uint32_t width);

  Builder& to_;
  const Code& code_;
  Scanner& s_;
  Fault fault_;
  bool failed_ = false;
  char address_ = 0;  // of the word the expression stands in
  int brackets_ = 0;
  int depth_ = 0;  // values on the stack
  int nots_ = 0;   // NOT before NOT
};

}  // namespace cncsub
