// A dialect: a language that NC programs are written in. It is a folder beside this file; the build
// finds it and lists it, and a control names the one it speaks (Control::dialect).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/text/words.hpp"

namespace cncsub {

/// Reads a file of Code::files, whose lines end with a line feed, into programs. It never fails:
/// what the control would refuse becomes the fault of its block. It stops early where somebody
/// wants it interrupted (Builder::interrupt).
using FileReader = std::function<void(std::uint32_t file)>;

/// Lines of a file that is read in pieces.
struct Lines {
  std::string_view text;         // of the whole file
  std::size_t from = 0, to = 0;  // the beginning of a line, and of another one or the end
};

/// Reads large files in pieces, of which several can be read at the same time, each into a code of
/// its own.
struct PieceReader {
  /// Reads on in the file that was added last, from its beginning to its end.
  std::function<void(const Lines&)> read_on;
  /// Reads lines as they stand in the middle of a program, into a code without blocks that has a
  /// file without a text: how many lines. None where what stands before them decides what they are.
  std::function<std::optional<std::uint32_t>(const Lines&)> read_in_worker;
  /// Puts such lines behind those that were read on to. False where they have to be read once more.
  std::function<bool(Joined&, std::uint32_t lines)> join;
};

struct Dialect {
  std::string_view name;
  /// The reader of the files of one library, one after the other.
  FileReader (*reader)(Builder& to);
  /// The words of a block as they are written.
  ReadWord read_word;
  /// The same reader for pieces; null where the language is not read so.
  PieceReader (*pieces)(Builder& to);
  /// How it writes what is no plain word.
  const Spelling* spelling;
  /// The rules that it asks, by their names and separated by blanks: those that its reader asks,
  /// and those that a run of what it can say comes to. Empty: all.
  std::string_view rules;
  /// The words that it refuses where no code uses them; none: it takes any.
  std::span<const WordUse> word_uses;
};

/// The dialect of this name, null where there is none.
const Dialect* find_dialect(std::string_view name);

// The build writes the list from the names of the folders; each holds the functions that it names.
#define DIALECT(folder)                                      \
  extern const Spelling folder##_spelling;                   \
  extern const std::string_view folder##_rules;              \
  extern const std::span<const WordUse> folder##_word_uses;  \
  FileReader folder##_reader(Builder& to);                   \
  extern PieceReader (*const folder##_pieces)(Builder & to); \
  std::optional<WrittenWord> folder##_word(std::string_view block, std::size_t& from);
#include "dialect/list.def"
#undef DIALECT

}  // namespace cncsub
