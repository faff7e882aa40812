// The reader of programs that begin with %@MACRO: IF THEN ELSEIF, CASE, WHILE, FOR, REPEAT, and the
// blocks of words between them.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/iso/block.hpp"

namespace cncsub::syntec {

class StructuredReader {
 public:
  explicit StructuredReader(Builder& to, const IsoVariant& variant)
      : to_(to), blocks_(to, variant) {}

  /// Let parts of a file with this text come next.
  void begin_text(std::string_view written);
  /// Read the statements of a part of the text into the open program. `line`: that of its first
  /// character.
  void read(std::size_t from, std::size_t to, std::uint32_t line);
  /// Lead jumps to their blocks, and refuse the structures without an end. The program has ended.
  void end_program(const Program& program);

 private:
  friend bool is_statement(std::string_view word);
  using Kind = std::array<char, 2>;  // of a fault
  enum class Structure : std::uint8_t { If, Case, While, For, Repeat };

  /// A value of a CASE, and the block that it leads to.
  struct Alternative {
    std::uint32_t expression;
    Address to;
    std::uint32_t at;
  };

  struct Open {
    Structure kind;
    Address head;
    std::uint32_t at, width;
    Address branch = kNowhere;        // the IF, WHILE or FOR whose other way is still to come
    bool otherwise = false;           // its ELSE was read
    std::uint32_t expression = 0;     // of a CASE
    Address rest = kNowhere;          // of a CASE: the block after ELSE
    Address wrong = kNowhere;         // of a CASE: the block of values that are no values
    std::vector<Address> ways = {};   // the blocks that go on at its end
    std::vector<Address> exits = {};  // the EXIT that go on after its end
    std::vector<Alternative> alternatives = {};
    Statement count = {};       // of a FOR: the assignment that counts
    bool counts_apart = false;  // a FOR that is an assignment and a WHILE
  };

  /// What the head of a FOR says.
  struct Counting {
    Scanner counter;  // where the assignment stands
    Block first;      // which it is as a block
    Statement begin;  // and as a statement
    Scanner last_at;  // where the last value stands
    std::uint32_t last;
    std::optional<Scanner> step;  // where the step stands
    bool rising;                  // the step is a number above 0
  };

  /// A word that begins a statement.
  struct Word {
    std::string_view name;
    void (StructuredReader::*read)(Scanner& s, Block& block);
  };
  static const Word kWords[];

  void statement(Scanner& s);
  bool keyword(Scanner& s, Block& block);
  bool case_label(Scanner& s, Block& block);
  void words(const Scanner& from, Scanner& s, Block& block);

  void if_head(Scanner& s, Block& block);
  void else_if(Scanner& s, Block& block);
  void else_head(Scanner& s, Block& block);
  void end_if(Scanner& s, Block& block);
  void case_head(Scanner& s, Block& block);
  void end_case(Scanner& s, Block& block);
  void choose(const Open& open, Address end);
  void while_head(Scanner& s, Block& block);
  void end_while(Scanner& s, Block& block);
  void close_loop(Address end);
  void for_head(Scanner& s, Block& block);
  bool first_value(Scanner& s, Block& block, Counting& of);
  bool last_value(Scanner& s, Block& block, Counting& of);
  void count_either_way(Scanner& s, Block& block, const Counting& of);
  bool wrong_for(Block& block, const char* detail);
  void end_for(Scanner& s, Block& block);
  void repeat_head(Scanner& s, Block& block);
  void until(Scanner& s, Block& block);
  void exit(Scanner& s, Block& block);
  void jump(Scanner& s, Block& block);
  void alarm(Scanner& s, Block& block);
  void message(Scanner& s, Block& block);
  void no_words(Scanner& s, Block& block);
  void dropped(Scanner& s, Block& block);

  bool condition(Scanner& s, std::string_view behind, Statement& statement, Block& block,
                 Cause cause, Kind kind);
  void push(Structure kind);
  Open* innermost(Structure kind, Block& block, Cause cause, Kind missing);
  void way_to_end(Open& open, Block& block);
  void print(Scanner& s, Block& block, bool alarms);
  bool refuse(Block& block, Cause cause, std::uint32_t at, std::uint32_t width, std::string detail,
              Kind kind = {});
  void append(const Scanner& s, Block& block);
  void learn_type(const Block& block);
  Statement& statement_of(Address address) { return to_.record<Statement>(to_.block(address).aux); }
  Statement at_keyword() const;
  std::uint32_t line_of(std::size_t at);

  Builder& to_;
  BlockReader blocks_;
  std::string text_;  // what the readers of blocks see
  std::string_view written_;
  std::size_t counted_ = 0;  // lines are counted up to here
  std::uint32_t line_ = 1;
  std::uint32_t keyword_at_ = 0, keyword_width_ = 0;
  std::vector<Open> open_;
  std::vector<Address> jumps_;
  std::unordered_map<std::int64_t, bool> types_;  // of variables at this place: whole or real
};

/// Return whether a word begins a statement of the language.
bool is_statement(std::string_view word);

}  // namespace cncsub::syntec
