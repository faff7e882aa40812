// The parts of a block that concern other blocks of its program. They are resolved when all of them
// are known.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace cncsub::sinumerik {

/// A label or a block number as a jump names it.
struct JumpTarget {
  char direction = '\0';  // F, B, C, S of GOTOF and the like, or none
  std::string label;      // in capitals; empty: the number
  std::int32_t number = -1;
  std::uint32_t at = 0, width = 1;
  bool computed = false;   // its name is the text of an expression
  std::uint32_t text = 0;  // this expression
};

/// One of several jumps of a block: the block that jumps, among Code::variants, and its target.
struct AlternativeJump {
  std::uint32_t variant = 0;
  JumpTarget target;
};

struct Link {
  enum class Kind : std::uint8_t {
    None,
    Jump,    // GOTOF, GOTOB, GOTO, GOTOC, after a condition or not
    Switch,  // CASE OF, several IF GOTO
    Part,    // REPEAT LABEL, REPEATB LABEL, CALL BLOCK FIRST TO LAST
    If,      // control structures from here on
    Else,
    EndIf,
    While,
    EndWhile,
    Loop,
    EndLoop,
    For,
    EndFor,
    Repeat,
    Until
  } kind = Kind::None;
  /// The end of a part that is repeated or called.
  enum class PartEnd : std::uint8_t {
    Here,   // REPEAT LABEL: the repeating block, or an ENDLABEL before it
    Block,  // REPEATB LABEL: the block of the label
    Label,  // REPEAT FIRST LAST
    Called  // CALL BLOCK FIRST TO LAST
  } part_end = PartEnd::Here;
  std::uint32_t at = 0, width = 1;  // the word of a control structure
  bool conditional = false;         // of a jump: IF stands before it
  JumpTarget target;                // of a jump; of a part: its first block
  JumpTarget last;                  // of a part
  std::vector<AlternativeJump> alternatives;

  bool is_structure() const { return kind >= Kind::If; }
};

}  // namespace cncsub::sinumerik
