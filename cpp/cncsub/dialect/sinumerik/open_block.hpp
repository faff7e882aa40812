// The parts of a block, each read by a function into the block that is open. Each returns false
// where the block is refused.
#pragma once

#include <bitset>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cncsub/dialect/sinumerik/expression.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/dialect/sinumerik/link.hpp"

namespace cncsub::sinumerik {

/// POS[X]=10, where an axis beside the path goes.
struct Position {
  char letter;
  WordValue value;
  std::uint32_t at;
};

/// FA[X]=500, the feed of an axis beside the path.
struct AxisFeed {
  char letter;
  WordValue value;
  Drop written;
};

/// The words of a block, and what stands beside them.
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
  std::vector<Position> positions;
  std::vector<AxisFeed> axis_feeds;
  std::vector<Line> indexed;  // where the index of each AX[...]=... stands
  char indexed_form = '=';    // their form: '=' for none, 'A' for AC, 'I' for IC
  bool any = false;
  bool acts = false;  // by a code that says alone what is done with the words
  bool ends = false;
  std::optional<bool> iso_mode;  // after G290 and G291: whether the ISO mode follows
  std::uint32_t iso_mode_at = 0, iso_mode_width = 1;

  /// Return whether nothing stands beside a call, which has a block of its own.
  bool is_call_alone() const { return !any && statements.empty() && !print && !back; }
  /// Take the group of a code; return false if a code of it stands in the block already.
  bool take_group(int group);
};

/// The line that is being read, what it may name, and where it is compiled to.
struct OpenBlock {
  explicit OpenBlock(Builder& builder) : to(builder), expression(builder, line, definitions) {}
  OpenBlock(const OpenBlock&) = delete;
  OpenBlock& operator=(const OpenBlock&) = delete;
  ~OpenBlock() = default;

  Builder& to;
  Line line;
  Definitions definitions;
  ExpressionReader expression;
  bool iso_mode = false;  // of the blocks that follow
  std::vector<std::string> called_in_iso_mode;

  bool refuse(Block& block, Cause cause, std::string detail, std::uint32_t at);
  /// Refuse the block for what its expression was refused.
  bool refuse(Block& block);
  bool not_computed(Block& block, std::string_view what, std::uint32_t at);
  bool end_of_statement(Block& block);
};

// ---- words (addresses.cpp, block.cpp) ----

/// Read a value after =, perhaps in one of the forms; `place`: of its address in the mask.
bool form(OpenBlock& open, Block& block, std::uint32_t at, int place, WordForms& forms,
          Value& value);
/// Give an address its value, which stands once in a block.
bool put(OpenBlock& open, Block& block, Words& words, int place, const Value& value);
/// Add a G code, of which one of a group stands in a block.
bool add_code(OpenBlock& open, Block& block, Words& words, int group, int code, std::uint32_t at);
/// Report the word that was read, which begins at `at` and changes nothing here.
bool reported(OpenBlock& open, Words& words, std::uint32_t at);
/// Read CR=5 or I1=IC(5), whose name is passed.
bool long_address(OpenBlock& open, Block& block, Words& words, std::string_view name,
                  std::uint32_t at);
/// Read X1=5, M2=3, S2=500 or T1=5, whose name is passed with its =. The first spindle is the one
/// of the words without a number; what moves or turns elsewhere is reported.
bool numbered(OpenBlock& open, Block& block, Words& words, std::string_view name, std::uint32_t at);
/// Read the value of an axis that no column of the moves holds, E=5, whose = is passed: it is
/// reported.
bool axis_beyond(OpenBlock& open, Block& block, Words& words, std::uint32_t at);
/// Read AX[X]=5, or AX[AXIS]=5, whose name stands here.
bool axis_by_index(OpenBlock& open, Block& block, Words& words, std::uint32_t at);
/// Give each axis the values of AX[AXIS]=5 whose index it is when the block runs.
bool put_indexed(OpenBlock& open, Block& block, Words& words);
/// Read a word with a value that no path depends on: FA[X]=500, LIMS=3000, SPOS=DC(90).
bool report(OpenBlock& open, Block& block, Words& words, std::string_view name, std::uint32_t at);
/// Read POS[X]=10, whose name stands here.
bool position(OpenBlock& open, Block& block, Words& words, std::uint32_t at);
/// Let the words of POS move the axes, and those of FA give them their feeds, which stay in force.
bool move_beside_path(OpenBlock& open, Block& block, Words& words);
/// Read a call that no path depends on: WAITP(X), GROUP_BEGIN(0,"a",0,0).
bool report_call(OpenBlock& open, Block& block, Words& words, std::string_view name,
                 std::uint32_t at);
/// Read FINEA[X] or FINEA=X, how exactly an axis beside the path comes to its end.
bool axis_end(OpenBlock& open, Block& block, Words& words, std::string_view name, std::uint32_t at);
/// Read TOFFL=0: what begins with another value is not computed.
bool off_at_zero(OpenBlock& open, Block& block, Words& words, std::string_view name,
                 std::uint32_t at);
/// Read a G code that is written as a word.
bool code_word(OpenBlock& open, Block& block, Words& words, int code, std::string_view name,
               std::uint32_t at);
/// Read G[8]=2, M[1]=5 or S[SPINDLE]=500, whose letter is passed. What another spindle than the
/// first does is reported.
bool indexed(OpenBlock& open, Block& block, Words& words, char letter, std::uint32_t at);
/// Read the value of an M or S after its =: 5, or QU(5), which the machine takes without waiting.
bool value_of_code(OpenBlock& open, Block& block, std::uint32_t at, Value& value);
/// Let T be the tool of a name, a text. Where no tool has it, the word is reported.
bool tool_by_name(OpenBlock& open, Block& block, Words& words, const Value& name, std::uint32_t at);
/// Return a call of the program of this name, which was read from `at` on.
CallRecord call_of(const OpenBlock& open, std::string_view name, std::uint32_t at);
/// Read MEAS=1 or MEAS=-1, a line that ends where the first probe switches.
bool measure(OpenBlock& open, Block& block, Words& words, std::uint32_t at);
/// Read $TC_DP3[5,1]=120 where it stands here; return false where another variable does.
bool system_assignment(OpenBlock& open, Block& block, Words& words, std::uint32_t at);
/// Read a text that a message or an alarm shows.
bool text_field(OpenBlock& open, Block& block, PrintField& field);
/// Add an M code to the words, or what it does in the program.
bool m_code(OpenBlock& open, Block& block, Words& words, const Value& value);

// ---- calls (calls.cpp, modal_calls.cpp) ----

/// Read L100, SUB or SUB(), and a P with the count.
bool call(OpenBlock& open, Block& block, Words& words, std::string_view name);
/// Write a call, which has a block of its own.
bool write_call(OpenBlock& open, Block& block, const Words& words, CallRecord call);
/// Read CALL, PCALL, EXTCALL, ISOCALL or SETAL, whose word is passed.
bool other_call(OpenBlock& open, Block& block, Link& link, const std::string& word,
                std::uint32_t at);
/// Read a text between quotes that is the whole of a value.
bool text_here(OpenBlock& open, Block& block, std::string& text);
/// Read RET("N10", 1, 2): the block to return to, whether the one after it is meant, and how many
/// levels. A fourth value counts in ISO mode alone. [general knowledge]
bool return_by_values(OpenBlock& open, Block& block, std::uint32_t at);
/// Read REPEAT FIRST, REPEAT FIRST LAST or REPEATB FIRST, and a P with the count; or the REPEAT of
/// a loop, alone in its block.
bool repeat(OpenBlock& open, Block& block, Link& link, std::uint32_t at);
/// Read MCALL SUB(5), or MCALL, which ends the modal call. [PGZ p.2-48, modal call]
bool modal_call(OpenBlock& open, Block& block, Words& words, std::uint32_t at);
/// Make the block a modal call, or the end of one.
bool write_modal_call(OpenBlock& open, Block& block, const Words& words);

// ---- statements (statements.cpp) ----

/// Return whether a statement stands here; `read_it`: without a fault.
bool statement(OpenBlock& open, Block& block, Link& link, bool& read_it);
/// Read a label or a block number.
bool jump_target(OpenBlock& open, Block& block, std::string_view word, JumpTarget& target);

}  // namespace cncsub::sinumerik
