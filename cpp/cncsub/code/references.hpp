// The references of a block: the programs it calls, the blocks it jumps to, the variables it reads
// and writes. They are found in the code, without a run.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// A piece of a file's text.
struct TextPlace {
  std::uint32_t at = 0, width = 1;
};

struct CallReference {
  CallKind kind = CallKind::Subprogram;
  std::string program;              // as it is found, or as it is written where it is missing
  std::int32_t found = kNoProgram;  // among the programs of the code
  bool external = false;            // of the external device
  std::int64_t start = -1;          // the sequence number it begins at, -1: its first block
  std::int64_t repeats = 1;         // 0: it is skipped
  std::optional<TextPlace> computed_program, computed_start, computed_repeats;
  // Where the number or the name of the program stands, where the number of the first block does;
  // nothing where the block does not write it, as a code that calls does.
  std::optional<TextPlace> program_place, start_place;
  bool block_in_p = false;  // P is the number of a block of the own program
  bool by_name = false;     // the program is called by its name
  bool own_locals = false;  // its numbered locals are not those of its caller
  TextPlace place;
};

struct JumpReference {
  std::string_view kind;  // GOTO, M99, M97, G65
  bool conditional = false;
  bool in_caller = false;  // M99 P: a block of the program that called
  std::int64_t n = -1;     // the sequence number it names
  Address to = kNowhere;   // the block, where the code knows it
  std::optional<TextPlace> computed;
  TextPlace place;
};

struct VariableReference {
  std::int64_t number = -1;  // -1 where it has a name
  std::string name;          // of a dialect or a table of names
  bool common = false;       // of one with a name: it is of all programs, not of a level
  bool computed = false;     // the number is computed: `place` holds what gives it
  bool asked = false;        // only whether it has a value is asked: EXISTS[#<a>]
  TextPlace place;           // the value or the word that holds it
};

struct References {
  std::vector<CallReference> calls;
  std::vector<JumpReference> jumps;
  std::vector<VariableReference> reads, writes;
};

constexpr bool is_call(Op op) {
  return op == Op::Call || op == Op::MacroCall || op == Op::ModalCall;
}
/// Return whether a block of this kind can call, itself or as one of its variants.
constexpr bool may_call(Op op) {
  return is_call(op) || op == Op::RepeatPart || op == Op::OWord || op == Op::Select ||
         op == Op::IfThen || op == Op::ParallelAssign;
}
/// Return the references of a block of a program. A block that depends on switches or callers has
/// those of each variant.
References references_of(const Code& code, const Block& block, std::int32_t program);

}  // namespace cncsub
