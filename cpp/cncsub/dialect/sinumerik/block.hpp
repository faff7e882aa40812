// The compiler of a block of words, assignments and a message, of a call or of a statement.
#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/dialect/sinumerik/declarations.hpp"
#include "cncsub/dialect/sinumerik/expression.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/dialect/sinumerik/link.hpp"

namespace cncsub::sinumerik {

class BlockReader {
 public:
  explicit BlockReader(Builder& to)
      : to_(to),
        expression_(to, line_, definitions_),
        declarations_(to, line_, expression_, definitions_) {}

  /// Forget the variables of the program before.
  void begin_program() { definitions_.clear(); }

  /// Compile a line into `block`, whose text and line are set, and set its label, in capitals.
  /// Return false if the line is empty.
  bool read(std::string_view text, Block& block, std::string& label, Link& link);

 private:
  struct Words {
    WordList list;
    std::vector<Statement> statements;
    std::optional<Print> print;
    std::vector<Drop> drops;
    std::optional<CallRecord> call;
    std::optional<std::uint32_t> modal;  // where MCALL stands
    std::optional<std::uint32_t> back;   // where M17 or RET stands
    std::bitset<kCodeGroups> groups;     // of the codes so far
    // X1=0: which axes G74 and G75 move.
    std::vector<std::pair<char, WordValue>> machine_axes;
    bool any = false;
    bool ends = false;

    /// Take the group of a code; return false if a code of it stands in the block already.
    bool take_group(int group);
  };

  /// A jump of a block that has several: its condition, or the value that leads to it.
  struct Alternative {
    Statement choice;
    JumpTarget target;
  };

  bool refuse(Block& block, Cause cause, std::string detail, std::uint32_t at);
  bool refuse(Block& block);
  bool not_computed(Block& block, std::string_view what, std::uint32_t at);

  void skip_level(Block& block);
  bool number(Block& block);
  void take_label(std::string& label);

  bool item(Block& block, Words& words);
  bool address(Block& block, Words& words);
  bool word(Block& block, Words& words, char letter, std::uint32_t at);
  bool put(Block& block, Words& words, int place, const Value& value);
  bool form(Block& block, std::uint32_t at, int place, WordForms& forms, Value& value);
  bool numbered(Block& block, Words& words, std::string_view name, std::uint32_t at);
  bool long_address(Block& block, Words& words, std::string_view name, std::uint32_t at);
  bool axis_by_index(Block& block, Words& words, std::uint32_t at);
  bool report(Block& block, Words& words, std::string_view name, std::uint32_t at);
  bool code_word(Block& block, Words& words, int code, std::string_view name, std::uint32_t at);
  bool tool_by_name(Words& words, std::uint32_t at);
  void name_machine_axes(Words& words) const;
  bool report_call(Block& block, Words& words, std::string_view name, std::uint32_t at);
  bool off_at_zero(Block& block, Words& words, std::string_view name, std::uint32_t at);
  bool axis_beyond(Block& block, Words& words, std::uint32_t at);
  bool g_code(Block& block, Words& words, const Value& value);
  bool m_code(Block& block, Words& words, const Value& value);
  bool assignment(Block& block, Words& words);
  bool named(Block& block, Words& words);
  bool message(Block& block, Words& words, std::uint32_t at);
  bool call(Block& block, Words& words, std::string_view name);
  bool given_values(Block& block, std::vector<ActualParameter>& given);
  bool write(Block& block, Words& words);
  bool write_call(Block& block, const Words& words, CallRecord call);
  bool modal_call(Block& block, Words& words, std::uint32_t at);
  bool write_modal_call(Block& block, const Words& words);
  bool write_return(Block& block, const Words& words, std::uint32_t at);
  void write_beside(Block& block, const Words& words);

  /// Return whether a statement stands here; `read_it`: without a fault.
  bool statement(Block& block, Link& link, bool& read_it);
  bool jumps_later();
  bool conditional(Block& block, Link& link);
  bool jump(Block& block, Link& link, std::string_view word, Statement jump);
  bool jump_target(Block& block, std::string_view word, JumpTarget& target);
  bool condition_jumps(Block& block, Link& link, Statement first);
  bool case_of(Block& block, Link& link, Statement choice);
  bool one_case(Block& block, Alternative& one);
  bool write_switch(Block& block, Link& link, Statement choice,
                    std::vector<Alternative>& alternatives);
  bool count_loop(Block& block, Link& link, Statement loop);
  bool repeat(Block& block, Link& link, std::uint32_t at);
  bool part(Block& block, Link& link, CallKind kind, std::uint32_t at, const Operand& count);
  bool pass_count(Block& block, Operand& count);
  bool other_call(Block& block, Link& link, const std::string& word, std::uint32_t at);
  bool call_by_text(Block& block, Link& link, std::uint32_t at);
  bool call_block(Block& block, Link& link, std::uint32_t at);
  bool call_by_path(Block& block, std::uint32_t at);
  bool external_call(Block& block, std::uint32_t at);
  bool user_alarm(Block& block, std::uint32_t at);
  bool return_by_values(Block& block, std::uint32_t at);
  bool return_value(Block& block, Operand& operand);
  bool text_here(Block& block, std::string& text);
  bool named_call(Block& block, std::string_view path, std::uint32_t at,
                  std::vector<ActualParameter> given);
  bool end_of_statement(Block& block);

  Builder& to_;
  Line line_;
  Definitions definitions_;
  ExpressionReader expression_;
  DeclarationReader declarations_;
  std::uint32_t marked_at_ = 0, marked_width_ = 1;  // the slash, or the label, of the block
};

}  // namespace cncsub::sinumerik
