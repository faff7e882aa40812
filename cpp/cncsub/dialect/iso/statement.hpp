// The compiler of the macro statements of a block.
#pragma once

#include <optional>
#include <string_view>

#include "cncsub/dialect/iso/expression.hpp"

namespace cncsub {

/// The reader that compiles a macro statement into `block`. `read` returns false if no statement
/// begins here: the block is then one of words.
class StatementReader {
 public:
  /// `thens`: how many THEN of the block stand before the statement.
  StatementReader(Builder& to, ExpressionReader& expressions, Scanner& scanner, Block& block,
                  int thens = 0)
      : to_(to),
        expressions_(expressions),
        code_(to.code()),
        s_(scanner),
        block_(block),
        thens_(thens) {}
  bool read();
  /// Read the assignment that begins here with a #.
  void assign() {
    if (!lacks(StatementKind::Variables, s_.offset())) assignment(false);
  }
  /// Return the IF whose condition was read and whose words, which begin here, were not.
  const std::optional<Statement>& before_words() const { return before_words_; }
  /// Return the assignment that stands between that condition and the words.
  const std::optional<Statement>& assigned() const { return assigned_; }

 private:
  /// A word that begins a statement.
  struct Keyword {
    std::string_view word;
    void (StatementReader::*read)(const Keyword& keyword, Statement& statement);
    Op op = Op::Goto;
    std::optional<StatementKind> kind;  // the kind, if a control may lack it
  };
  static const Keyword kKeywords[];

  bool has(const Keyword& keyword) const;
  bool keyword(std::string_view word);
  bool lacks(StatementKind kind, std::uint32_t at, std::string_view name = {}) {
    return code_.lacking.test(static_cast<std::size_t>(kind)) && refuses(kind, at, name);
  }
  bool refuses(StatementKind kind, std::uint32_t at, std::string_view name);
  bool named_assignment();
  void assignment(bool bracketed);
  bool takes_words();

  // Each reads the text after a keyword; `statement` has the keyword's place.
  void bare(const Keyword& keyword, Statement& statement);
  void device(const Keyword& keyword, Statement& statement);
  void loop(const Keyword& keyword, Statement& statement);
  void jump(const Keyword& keyword, Statement& statement);
  void if_statement(const Keyword& keyword, Statement& statement);
  void while_statement(const Keyword& keyword, Statement& statement);
  void print(const Keyword& keyword, Statement& statement);
  void name_variables(const Keyword& keyword, Statement& statement);

  bool condition(Statement& statement, Cause format);
  void then_statement(Statement& statement);
  bool print_field(Print& print);
  bool at_end(Cause otherwise) { return s_.at == s_.end || ends(otherwise); }
  bool ends(Cause otherwise);
  void refuse(Fault fault);
  void refuse(Cause cause, std::uint32_t at, std::uint32_t width = 1, std::string detail = {});

  Builder& to_;
  ExpressionReader& expressions_;
  const Code& code_;
  Scanner& s_;
  Block& block_;
  int thens_;
  std::optional<Statement> before_words_, assigned_;
};

}  // namespace cncsub
