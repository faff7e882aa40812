// Macro statements and expressions of a block, compiled.
#pragma once

#include <optional>

#include "cncsub/code.hpp"
#include "cncsub/scan.hpp"

namespace cncsub {

/// Compiles what stands in brackets, behind an equals sign or behind an address.
class ExpressionReader {
 public:
  ExpressionReader(Code& code, Scanner& scanner) : code_(code), s_(scanner) {}

  /// An expression that gives a number; nothing where it is faulty (see `fault`). Reads as far as
  /// the expression goes.
  std::optional<std::uint32_t> number();
  /// The value behind an address: `#1`, `-#1`, `[...]`, `-[...]`. In a word, ROUND rounds to the
  /// address's increment.
  std::optional<std::uint32_t> word_value(char address);
  /// The condition of IF and WHILE, brackets included.
  std::optional<std::uint32_t> condition();
  /// A variable behind its `#`: the number where it is written, or an expression that gives it.
  struct Variable {
    std::int64_t number = -1;
    std::uint32_t expression = 0;
  };
  std::optional<Variable> variable();

  const Fault& fault() const { return fault_; }

 private:
  enum class Type { Number, Condition };
  struct Value {
    Type type = Type::Number;
    std::int64_t raw =
        -1;  // the instruction, where the value is one variable and may still be vacant
  };

  std::optional<Value> expression();
  std::optional<Value> operand();
  std::optional<Value> function();
  std::optional<Value> arc_tangent(std::uint32_t at);
  std::optional<Value> bracket();
  std::optional<Value> variable_value();
  std::optional<Value> apply(Ins op, std::uint32_t at, Value left, Value right);
  std::optional<Ins> take_operator(int level, bool of_number, bool compared);
  bool condition_behind(std::string_view logic) const;
  bool is_number(Value& value) const;
  bool arithmetic(Value& value);
  bool open();
  bool close();
  bool comma();
  bool grow();
  void shorten(Expression& expression) const;
  void emit(Ins op, std::uint32_t at, double value = 0);
  std::nullopt_t refuse(Cause cause, std::uint32_t at, std::string detail = {});
  std::uint32_t finish(std::uint32_t first, std::uint32_t at);

  Code& code_;
  Scanner& s_;
  Fault fault_;
  bool failed_ = false;
  char address_ = 0;  // of the word the expression stands in
  int brackets_ = 0;
  int depth_ = 0;  // values on the stack
  int nots_ = 0;   // NOT before NOT
};

/// Compiles a macro statement into `block`. False where no statement stands here and the block is
/// one of words.
class StatementReader {
 public:
  /// `thens`: behind how many THEN of the block the statement stands.
  StatementReader(Code& code, Scanner& scanner, Block& block, int thens = 0)
      : code_(code), s_(scanner), block_(block), thens_(thens) {}
  bool read();

 private:
  bool keyword(std::string_view word);
  /// `name`: what of the kind is written, where that is not what the kind is called.
  bool lacks(StatementKind kind, std::uint32_t at, std::string_view name = {});
  void assignment(bool bracketed);
  void if_statement();
  void then_statement(Statement& statement);
  void while_statement();
  void loop(Op op, Statement statement);
  void jump(Op op, Statement statement);
  void print(bool binary);
  bool print_field(Print& print);
  void name_variables(Statement statement);
  void finish(Op op, Statement statement);
  bool starts_assignment() const;
  bool at_end(Cause otherwise);
  void refuse(Fault fault);
  void refuse(Cause cause, std::uint32_t at, std::uint32_t width = 1, std::string detail = {});

  Code& code_;
  Scanner& s_;
  Block& block_;
  int thens_;
};

}  // namespace cncsub
