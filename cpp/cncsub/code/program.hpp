// Programs, the files that they stand in, and how they are found.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "cncsub/code/fault.hpp"
#include "cncsub/code/file_text.hpp"

namespace cncsub {

constexpr std::int32_t kNoProgram = -1;

struct SourceFile {
  std::string name;  // as shown in messages
  std::string stem;  // names the program where the text does not
  FileText text;     // UTF-8
  bool external = false;
  bool system = false;      // a program of the control itself, which is no program of the user
  std::int32_t leader = 0;  // how many lines before its tape are no program
};

/// A word that the control reads and does not obey: an M code too many, an address written again.
struct Drop {
  std::uint32_t data = 0;  // of its block
  std::uint32_t at = 0, width = 1;
};

struct SequenceEntry {
  std::int32_t n;
  Address address;
};

/// A variable that a program defines by a name, or that all programs share, as it is shown.
struct DefinedVariable {
  enum class Type : std::uint8_t { Real, Int, Bool, Char, Text, Axis, Frame } type = Type::Real;
  bool common = false;
  std::int32_t index = 0;             // of the variable, or of the first element
  std::vector<std::int32_t> extents;  // of an array; of one that is a parameter they are 0
  std::string name;
  std::int32_t reference =
      -1;  // of a parameter by reference: the local that says what it stands for

  std::int32_t size() const {
    std::int32_t elements = 1;
    for (const std::int32_t extent : extents) elements *= extent;
    return elements;
  }
};

/// A parameter that the head of a program declares.
struct FormalParameter {
  std::int32_t variable = 0;          // the local that takes the value of a call
  double otherwise = 0;               // its value where a call leaves it out
  bool by_reference = false;          // it stands for the caller's variable
  std::int32_t reference = -1;        // the local that says for which, or for which array
  std::vector<std::int32_t> extents;  // of an array; 0: any
  DefinedVariable::Type type = DefinedVariable::Type::Real;

  bool is_array() const { return !extents.empty(); }
};

/// A program of the memory. Its name and its comment stand in the text: Code::name_of, comment_of.
struct Program {
  static constexpr std::uint32_t kOfFile = 0xffffffff;

  std::int64_t number = -1;             // of O0023, :23, %23
  std::uint32_t name_at = 0;            // in the file
  std::uint32_t name_length = kOfFile;  // kOfFile: the file gives the name
  std::uint32_t comment_at = 0;
  std::uint32_t comment_length = 0;
  std::uint32_t file = 0;
  std::uint32_t line = 0;  // of its head
  std::uint32_t text = 0;  // where its text starts in the file
  std::uint32_t text_end = 0;
  Address first = 0;
  Address last = 0;                               // one after the last block: the EndOfRecord
  std::uint32_t first_entry = 0, last_entry = 0;  // in Code::sequence, sorted by n, then by address
  std::int32_t duplicate_of = kNoProgram;
  std::int32_t same_name = kNoProgram;  // the next program of the name, which may be in another
                                        // folder of the control
  std::uint32_t folder = 0;             // in Code::folders
  bool named_with_folder = false;       // another program has the name alone
  std::uint32_t path_at = 0, path_length = 0;         // of the folder that the text itself names
  std::int32_t inside = kNoProgram;                   // the program whose blocks it is a part of
  bool keeps_modes = false;                           // its return restores the modes of its caller
  std::uint32_t first_parameter = 0, parameters = 0;  // in Code::formal_parameters
  std::uint32_t first_defined = 0, defined = 0;       // in Code::defined_variables
  std::uint32_t opening = 0;  // of a file that begins with a %: its place plus 1
};

/// A hash table that finds programs by number or name. It is allocated once.
class ProgramIndex {
 public:
  void reserve(std::size_t programs);
  /// Return the program that is `same` among those under this hash; kNoProgram where there is none.
  template <class Same>
  std::int32_t find(std::uint64_t hash, const Same& same) const {
    return slots_.empty() ? kNoProgram : slots_[slot(hash, same)];
  }
  /// Do as find; where there is none, add `program`.
  template <class Same>
  std::int32_t find_or_add(std::uint64_t hash, const Same& same, std::int32_t program) {
    std::int32_t& found = slots_[slot(hash, same)];
    return found == kNoProgram ? (found = program, kNoProgram) : found;
  }

 private:
  template <class Same>
  std::size_t slot(std::uint64_t hash, const Same& same) const {
    const std::size_t mask = slots_.size() - 1;
    std::size_t at = (hash * 0x9e3779b97f4a7c15U >> 32) & mask;
    while (slots_[at] != kNoProgram && !same(slots_[at])) at = (at + 1) & mask;
    return at;
  }

  std::vector<std::int32_t> slots_;  // a power of two, at most half of them in use
};

}  // namespace cncsub
