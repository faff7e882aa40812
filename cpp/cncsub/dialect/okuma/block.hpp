// The compiler of a block: words, assignments, statements and calls.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "cncsub/dialect/okuma/expression.hpp"

namespace cncsub::okuma {

inline constexpr std::size_t kLongestProgram = 4;  // after O [OKA 2207]

/// The name of a block as a jump names it, with its N.
struct JumpTarget {
  std::string name;
  std::uint32_t at = 0, width = 1;
};

/// A jump, whose target is found when its program is read.
struct Jump {
  bool is = false;
  bool conditional = false;
  JumpTarget target;
};

class BlockReader {
 public:
  explicit BlockReader(Builder& to) : to_(to), expression_(to, line_) {}

  /// Compile a block, whose text and line are set. `name` becomes its own name, with its N. Return
  /// false if nothing stands in it.
  bool read(std::string_view text, Block& block, std::string& name, Jump& jump);

 private:
  struct Words {
    WordList list;
    std::vector<Statement> statements;
    std::vector<Drop> drops;
    std::uint32_t given = 0;             // the addresses so far
    std::array<std::uint32_t, 26> at{};  // where each stands
    bool selects = false;                // G15 stands among them
    std::uint32_t selects_at = 0;
    bool any = false;
    bool ends = false;
  };

  bool refuse(Block& block, Cause cause, std::string detail, std::uint32_t at, Kind kind = {});
  bool refuse(Block& block);
  bool not_computed(Block& block, std::string_view what, std::uint32_t at);
  bool skip_and_name(Block& block, std::string& name);
  bool read_own_name(Block& block, std::string& name);
  bool end_of_statement(Block& block);
  void closed(Block& block);
  bool takes_variable(std::string_view name, std::string_view index);

  bool item(Block& block, Words& words);
  bool word(Block& block, Words& words);
  bool value_of_word(Block& block, Value& value);
  bool g_code(Block& block, Words& words, const Value& value);
  bool m_code(Block& block, Words& words, const Value& value);
  bool assignment(Block& block, Words& words);
  bool named(Block& block, Words& words, const std::string& name);
  bool work_system(Block& block, const Words& words);
  void write(Block& block, Words& words);

  bool statement(Block& block, Jump& jump, const std::string& word);
  bool call(Block& block, const std::string& word, std::uint32_t at);
  bool called_name(Block& block, CallRecord& call);
  bool count(Block& block, CallRecord& call);
  bool arguments(Block& block, CallRecord& call);
  bool jump_if(Block& block, Jump& jump, std::uint32_t at);
  bool jump_to(Block& block, Jump& jump, std::uint32_t at);
  bool target(Block& block, Jump& jump, std::uint32_t at);
  bool user_alarm(Block& block, std::uint32_t at);
  bool alarm_text(Block& block, std::uint32_t at);
  std::int32_t text_of_alarm();

  Builder& to_;
  Line line_;
  ExpressionReader expression_;
};

/// How a word of two letters or more is treated that is no variable.
/// What becomes of a word. Those of `Value` stand in expressions, and begin nothing.
enum class Treatment : std::uint8_t { Statement, PassedOver, NotComputed, Value };
struct KnownWord {
  std::string_view word;
  Treatment treatment;
  std::string_view does;
};
/// Return what is known of a word, in capitals; null where it is the name of a variable.
const KnownWord* find_word(std::string_view word);
std::span<const KnownWord> known_words();
/// Return whether the text from DEF to END draws: the control passes it over in a run.
bool begins_drawing(std::string_view text);
bool ends_drawing(std::string_view text);

}  // namespace cncsub::okuma
