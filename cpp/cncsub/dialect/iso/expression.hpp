// Expressions of the ISO family, compiled into instructions.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/value_writer.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Compiles what stands in brackets, behind an equals sign or behind an address.
class ExpressionReader {
 public:
  ExpressionReader(Builder& to, const ExpressionRules& rules, Scanner& scanner)
      : rules_(rules), names_(to.names()), out_(to, rules), s_(scanner) {}

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

  const Fault& fault() const { return out_.fault(); }

 private:
  Value operand();
  Value operand_here();
  Value sign();
  Value constant();
  Value other_constant();
  Refused no_operand();
  Value bracket();
  bool open();
  bool close();

  Value variable_value();
  std::optional<std::int64_t> variable_number(std::uint32_t at);
  std::optional<std::int64_t> written_number();

  Value expression();

  // ---- functions.cpp ----
  Value word();
  Value function(const FunctionName& of, std::uint32_t at);
  Value arc_tangent(std::uint32_t at);
  Value programmed(std::uint32_t at);
  Value negated(std::uint32_t at);
  bool argument();

  const ExpressionRules& rules_;
  Names& names_;
  ValueWriter out_;
  Scanner& s_;
  int brackets_ = 0;
  int nots_ = 0;  // NOT before NOT
};

}  // namespace cncsub
