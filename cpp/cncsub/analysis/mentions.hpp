// The mentions of blocks, programs and variables: each piece of text that names one, with its place
// and with what it names. They say what has to change where one of them gets another number or
// name.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/code/references.hpp"
#include "cncsub/control/control.hpp"
#include "cncsub/text/interrupt_check.hpp"

namespace cncsub {

struct Mention {
  enum class Kind : std::uint8_t { Number, Label, Program, Variable } kind = Kind::Number;
  bool defines = false;    // it gives the block, the program or the variable its name
  bool computed = false;   // what it names is known only when its block runs
  bool in_caller = false;  // it names a block of the program that called
  bool fixed = false;      // no other number or name can be written in its place
  std::int32_t program = kNoProgram;
  Address block = kNowhere;  // kNowhere: the head of the program
  TextPlace place;           // the digits or the name alone; of one that is fixed, the word
  TextPlace word{0, 0};      // of a block's own number: its word and the blanks after it; no width
                             // where the block has no other word
  std::int64_t number = -1;  // of Kind::Number, and of variables and programs that have one
  std::string name;          // of the others
  std::int32_t to_program = kNoProgram;
  Address to = kNowhere;  // of Kind::Number and Label: the block, where there is one
};

struct MentionsAsked {
  bool blocks = true;  // numbers and labels
  bool programs = true, variables = true;
  bool unnumbered = false;  // the first character of the first word of each block without a number,
                            // as a mention that defines none

  /// A part of a file, both ends included: only what stands there is returned.
  struct Part {
    std::uint32_t file = 0, from = 0, to = 0;
  };
  std::optional<Part> part{};

  /// A program, a block of a program (`block`), or a variable by its number or its name in
  /// capitals: only what names it is returned, and nothing that is computed.
  struct Named {
    std::int32_t program = kNoProgram;
    Address block = kNowhere;
    std::int64_t number = -1;
    std::string name{};
  };
  std::optional<Named> named{};
};

/// A block that the control refuses when it is reached: its program, and its address.
using RefusedBlock = std::pair<std::int32_t, Address>;
std::vector<RefusedBlock> refused_blocks(const Code& code);

/// Return the mentions of all programs of a memory, by program and block. `machine`: the kind of
/// machine, which tells what some codes mean; the control's own where it is empty.
std::vector<Mention> mentions_of(const Code& code, const std::string& machine,
                                 const MentionsAsked& asked, InterruptCheck& interrupt);

}  // namespace cncsub
