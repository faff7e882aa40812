// The compiler of a line: words, assignments and comments, or a flow word.
#pragma once

#include <array>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cncsub/dialect/grblhal/expression.hpp"
#include "cncsub/dialect/grblhal/use_of_words.hpp"

namespace cncsub::grblhal {

/// A flow word, as far as the search for its partners needs it.
struct Flow {
  enum class Kind : std::uint8_t {
    None,
    If,
    ElseIf,
    Else,
    EndIf,
    Do,
    While,
    EndWhile,
    Repeat,
    EndRepeat,
    Break,
    Continue,
    Sub,
    EndSub,
    Return,
    Call
  } kind = Kind::None;
  bool wall = false;  // the line is refused where it is passed over, too
  std::string label = {};
  bool named = false;  // <name>
  Statement statement = {};
  std::uint32_t call = 0;  // of a call: into Code::calls
  std::uint32_t at = 0, width = 1;
};

class BlockReader {
 public:
  explicit BlockReader(Builder& to) : to_(to), expression_(to, line_) {}

  /// Compile a line into `block`, whose text and line are set. Return false if the line is empty.
  bool read(std::string_view text, Block& block, Flow& flow);

 private:
  struct Words {
    WordList list;
    std::vector<Statement> statements;
    std::vector<Statement> named;     // those of named variables
    bool machine = false;             // G53
    std::vector<std::uint32_t> lost;  // where assignments stand that a call loses
    std::vector<std::uint32_t> lost_width;
    std::optional<Print> print;
    LineWords line;
    std::array<Value, 26> values{};
    std::set<int> groups;
    bool claimed = false;  // a code takes the axis words
    bool any = false;
    bool bad_value = false;  // the last word has no value
    bool ends = false;
    Role role = Role::None;  // Call, Return: of an M code
    int macro = -1;          // the G65 of the line, in tenths
  };

  /// What calls hand on.
  struct Locals {
    std::uint32_t file = ~0u;  // in which they stand
    std::array<std::uint32_t, kLastLocal + 1> expressions{};
    std::optional<std::uint32_t> arguments = {};  // of calls without arguments of their own
  };

  bool refuse(Block& block, Cause cause, std::string detail, std::uint32_t at, Kind kind = {});
  bool refuse(Block& block);
  bool words(Block& block, Words& words, Flow& flow);
  bool item(Block& block, Words& words);
  bool word(Block& block, Words& words, char letter);
  std::optional<int> known_g(Block& block, const Value& value);
  bool g_code(Block& block, Words& words, const Value& value);
  bool m_code(Block& block, Words& words, const Value& value);
  bool group(Block& block, Words& words, int group, const Value& value);
  bool assignment(Block& block, Words& words);
  bool comment(Block& block, Words& words);
  void message(std::string_view text, std::uint32_t at, Print& print);
  bool refuse_wrong(Block& block, const LineWords& line);
  void write(Block& block, Words& words);
  bool program_of_call(Block& block, Words& words, CallRecord& call);
  void call_98(Block& block, Words& words);
  void call_65(Block& block, Words& words);
  void back_99(Block& block, Words& words);

  bool flow_word(Block& block, Flow& flow);
  bool flow_label(Block& block, Flow& flow);
  bool flow_statement(Block& block, Flow& flow);
  bool flow_call(Block& block, Flow& flow);
  bool condition(Block& block, Flow& flow);
  bool give_back(Block& block, const Flow& flow);
  std::uint32_t number(double value, const Flow& flow);
  Statement returned(int place, std::uint32_t expression, const Flow& flow);
  void forget_and(Block& block, const Flow& flow, const Block& call,
                  std::vector<Statement> statements);
  const Locals& locals(const Flow& flow);
  void pass(CallRecord& call, std::vector<Argument> arguments, const Flow& flow);
  void hand_on_locals(std::vector<Argument>& arguments, const Flow& flow, std::int16_t first);

  Builder& to_;
  BareLine line_;
  ExpressionReader expression_;
  Locals locals_;
};

}  // namespace cncsub::grblhal
