// The compiler of a line: words, assignments and comments, or an O-word.
#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/dialect/linuxcnc/expression.hpp"
#include "cncsub/dialect/linuxcnc/use_of_words.hpp"

namespace cncsub::linuxcnc {

/// The facts of a line that a search for a label needs.
struct Label {
  std::uint32_t label = OWord::kNone;
  std::optional<OWordKind> kind;  // none: the line is no such statement, or it is faulty
  bool unreadable = false;        // no search passes over this line: its fault is reported at once
  bool unknown = false;           // likewise, but the search for a definition's end passes it
  bool computed = false;          // an M98 with values that are read even where it is passed over

  bool is_head() const { return kind && *kind <= OWordKind::Head; }
};

class BlockReader {
 public:
  explicit BlockReader(Builder& to) : to_(to), expression_(to, line_) {}

  /// Compile a line into `block`, whose text and line are set. Return false if the line is empty.
  bool read(std::string_view text, Block& block, Label& label);

 private:
  struct Words {
    WordList list;
    std::vector<Statement> statements;
    std::optional<Print> print;
    LineWords line;
    std::bitset<32> g_groups, m_groups;  // the modal groups of its codes
    bool any = false;
    bool ends = false;
  };

  bool refuse(Block& block, Cause cause, std::string text, std::uint32_t at);
  bool refuse(Block& block);
  bool number(Block& block);

  bool words(Block& block);
  bool item(Block& block, Words& words);
  bool word(Block& block, Words& words, char letter);
  bool polar_word(Block& block, Words& words, char sign);
  bool g_code(Block& block, Words& words, const Value& value);
  bool m_code(Block& block, Words& words, const Value& value);
  bool assignment(Block& block, Words& words);
  bool comment(Block& block, Words& words);
  void message(std::string_view text, std::uint32_t at, Print& print);
  bool refuse_wrong(Block& block, const LineWords& line);
  void write(Block& block, Words& words);

  bool o_word(Block& block, Label& label);
  bool o_label(Block& block, OWord& own);
  bool statement(Block& block, OWord& own, std::string_view word);
  bool o_call(Block& block, OWord& own);
  bool condition(Block& block, OWord& own, std::string_view word);
  bool arguments(Block& block, CallRecord& call);
  bool end_of_o_word(Block& block);
  bool words_of_98(Block& block, CallRecord& call, Words& words);
  bool call_98(Block& block, int m, Label& label);
  void back_99(Block& block, int m, Label& label);

  Builder& to_;
  Line line_;
  ExpressionReader expression_;
};

}  // namespace cncsub::linuxcnc
