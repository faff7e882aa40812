// Statements that a label tells apart, as O-words are: subprograms, branches and loops. A branch or
// loop that is not entered is skipped from one statement of its label to the next one after it,
// whatever stands between.
#pragma once

#include <cstdint>
#include <string>

namespace cncsub {

enum class OWordKind : std::uint8_t {
  Sub,        // o1 sub: the head of a subprogram; met in the main program it is skipped
  Head,       // O1: the head of a subprogram that M98 calls; met otherwise it is nothing
  EndSub,     // o1 endsub, o1 endsub [value]
  Return,     // o1 return, o1 return [value]
  Back,       // M99
  Call,       // o1 call [value] ...
  Call98,     // M98 P1 L1
  FileEnd,    // the % after a program: skipping comes no farther
  If,         // o1 if [value]
  ElseIf,     // o1 elseif [value]
  Else,       // o1 else
  EndIf,      // o1 endif
  While,      // o1 while [value]: the head of a loop, or the end of a DO
  EndWhile,   // o1 endwhile
  Do,         // o1 do
  Repeat,     // o1 repeat [count]
  EndRepeat,  // o1 endrepeat
  Break,      // o1 break
  Continue    // o1 continue
};

struct OWord {
  static constexpr std::uint32_t kNone = 0xffffffff;

  OWordKind kind = OWordKind::Sub;
  std::uint32_t label = 0;      // into Code::labels; kNone: the call's P gives it
  std::uint32_t value = kNone;  // the expression of a condition, a count, a returned value
  std::uint32_t next = kNone;   // the address that skipping leads to
  std::uint32_t call = kNone;   // of a call: into Code::calls
  // The place in Code::faults: of M99, of the fault that it is in a call; of endsub, of the fault
  // that it is outside of one after another call came back.
  std::uint32_t refused = kNone;
  // The text of the control where a subprogram is called, or ended, as one of another kind; at the
  // end of a tape, the text that what was looked for is not there.
  const char* of_another_kind = "";
  std::uint32_t at = 0, width = 1;
  std::uint32_t beside = 0;  // the letters beside M98 that only the mode in force may use
};

/// The head of a subprogram that a call finds by its label; with the label `kReadOnTheWay`, a block
/// that is read although it is skipped.
struct LabelledHead {
  static constexpr std::uint32_t kReadOnTheWay = 0xfffffffe;

  std::uint32_t label = 0;
  std::uint32_t address = 0;
};

/// A variable with a name, and the place it has: among the locals of a level, or the commons.
struct NamedVariable {
  std::string name;
  bool common = false;
  std::int32_t index = 0;
};

/// The actions of a block besides its words: assignments, then a message, then the words, all with
/// the values from before.
struct ParallelAssign {
  std::uint32_t first_statement = 0, statements = 0;
  std::uint32_t print = OWord::kNone;  // into Code::prints
  std::uint32_t words = OWord::kNone;  // into Code::variants
};

}  // namespace cncsub
