// The scanner that reads the words of a block one by one, whatever they mean together.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/block_rules.hpp"
#include "cncsub/dialect/iso/expression.hpp"
#include "cncsub/dialect/iso/lexeme.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// A lexeme with its value: a number, an expression or a name.
struct Token {
  char letter = 0;        // '/' for a block-skip slash, '<' for a name
  bool comma = false;     // ,C
  std::uint8_t axis = 0;  // X1=
  std::uint16_t skip = 0;
  Operand operand;
  std::string_view name;    // <NAME>, P[NAME]
  bool trailing_n = false;  // an N after other words
  bool bad_number = false;  // a sign, a point or digits that only an argument may have
  Cause wrong{};
};
using Tokens = std::vector<Token>;

inline Fault fault_of(const Token& token, Cause cause, std::string detail) {
  return {cause, token.operand.at, token.operand.width, std::move(detail)};
}
/// Return the fault of a word whose number is odd.
Fault bad_word(const Control& control, const Token& token);
/// Return ten times a written code, as an index into the sets of codes; 10000 if it is none.
inline std::size_t code_index(const Operand& operand) {
  const bool known =
      operand.kind == Operand::Kind::Constant && operand.value >= 0 && operand.value < 1000;
  return known ? to_whole<std::size_t>(operand.value * 10 + 0.5) : std::size_t{10000};
}

/// The scanner of one block. A function that returns false has refused the block, or was
/// interrupted.
class WordScanner {
 public:
  WordScanner(Builder& to, const BlockRules& rules, ExpressionReader& expressions, Scanner& scanner,
              Block& block)
      : to_(to),
        rules_(rules),
        control_(rules.control),
        expressions_(expressions),
        s_(scanner),
        block_(block) {}

  /// Read the block-skip slashes and the sequence number at the head of the block.
  bool head();
  /// Read the words up to the end of the block.
  bool words(Tokens& tokens);

 private:
  bool ends_here() const;
  bool lexeme(const Lexeme& read, Tokens& tokens);
  bool other(const Lexeme& read, Tokens& tokens);
  bool sequence_number(const Lexeme& read);
  bool late_sequence_number(const Lexeme& read, Tokens& tokens);
  bool skip(const Lexeme& read, Tokens& tokens);
  bool word(const Lexeme& read, Tokens& tokens);
  Token& add(const Lexeme& read, Tokens& tokens);
  bool value(const Lexeme& read, Token& token);
  bool number(Token& token, const Number& number);
  bool check(Token& token, const Number& number);
  bool computed(Token& token);
  bool arithmetic(Token& token, const char* from);
  std::string no_value_text(const Token& token) const;
  bool no_value(Token& token, const char* letter);
  std::optional<Fault> other_statement(const char* letter) const;
  std::optional<Fault> statement_at(const char* letter) const;
  bool name(Token& token, char close);
  std::string wrong_name(std::string_view name) const;
  bool is_name_here() const;
  bool calls_by_name();
  bool stray(const char* from);
  std::uint32_t offset(const Lexeme& read) const {
    return static_cast<std::uint32_t>(read.at - s_.file);
  }
  bool refuse(Fault fault) {
    to_.refuse(block_, std::move(fault));
    return false;
  }

  Builder& to_;
  const BlockRules& rules_;
  const Control& control_;
  ExpressionReader& expressions_;
  Scanner& s_;
  Block& block_;
  const bool axes_ = control_.macros.numbered_axis_arguments.value;
  std::uint16_t slashes_ = 0;       // switches whose slash was read
  std::optional<bool> names_call_;  // whether a code of the block calls by name
};

}  // namespace cncsub
