// A dialect: a language that NC programs are written in. It is a folder beside this file. The build
// finds it and lists it, and a control names the one that it speaks (Control::dialect).
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/builder.hpp"
#include "cncsub/code/expression_list.hpp"
#include "cncsub/text/words.hpp"

namespace cncsub {

/// The function that reads a file of Code::files, whose lines end with a line feed, into programs.
/// It never fails: what the control would refuse becomes the fault of its block. It stops early if
/// an interrupt is requested (Builder::interrupt).
using FileReader = std::function<void(std::uint32_t file)>;

/// Names of programs, sorted.
using ProgramNames = std::vector<std::string>;

/// Lines of a file that is read in pieces.
struct Lines {
  std::string_view text;         // of the whole file
  std::size_t from = 0, to = 0;  // line starts; `to` may be the end of the text
};

/// The reader of large files in pieces. Several pieces can be read at the same time, each into a
/// code of its own.
struct PieceReader {
  /// Read on in the file that was added last, from its beginning to its end.
  std::function<void(const Lines&)> read_on;
  /// Read lines from the middle of a program, into a code without blocks that has a file without a
  /// text. Return how many lines; nothing if the text before them decides what they are.
  std::function<std::optional<std::uint32_t>(const Lines&)> read_in_worker;
  /// Append such lines to those that were read on to; return false if they must be read again.
  std::function<bool(Joined&, std::uint32_t lines)> join;
};

/// A word of a language that is no G or M code: a statement, a function, an address. `words` and
/// `causes` are written as in meanings.def, the treatment as in CodeFacts.
struct Keyword {
  std::string name;
  std::string_view treatment;
  std::string does;
  std::string_view words{}, causes{}, source{};
  std::string_view rule{};  // the rule that says that the control has it
};

/// A text that is an expression and nothing else, such as the condition of a breakpoint.
struct ExpressionText {
  std::string_view text;
  std::uint32_t file = 0, at = 0;  // where it stands
  std::int32_t program = 0;        // the program whose variables it may name
};

/// A row of the words of a language, in a file keywords.def.
struct KeywordRow {
  std::string_view word, does, words, causes, source{};

  Keyword keyword() const {
    return {std::string(word), "computed", std::string(does), words, causes, source};
  }
};

struct Dialect {
  std::string_view name;
  /// The reader of the files of one library, one after the other; `other_mode`: the programs that
  /// it reads in the other mode of the language.
  FileReader (*reader)(Builder& to, const ProgramNames& other_mode);
  /// Compile an expression, a condition or a value; a fault says why the text is none.
  std::optional<Fault> (*read_expression)(Builder& to, const ExpressionText& text,
                                          std::uint32_t& expression, ValueType& type);
  /// The words of a block as they are written.
  ReadWord read_word;
  /// The same reader for pieces; null if the language is not read in pieces.
  PieceReader (*pieces)(Builder& to);
  /// Return the programs that the calls of a code mean in the other mode of the language: the
  /// library is read again with them. Null: the language has one mode.
  ProgramNames (*other_mode)(const Code& code);
  /// The spelling of what is no plain word.
  const Spelling* spelling;
  /// The names of the rules that it asks, separated by blanks: those that its reader asks, and
  /// those that a run of its programs comes to. Empty: all.
  std::string_view rules;
  /// The words that it refuses if no code uses them. Empty: it takes any word.
  std::span<const WordUse> word_uses;
  /// Return its words as a control has them, each once.
  std::vector<Keyword> (*keywords)(const Control& control);
  /// How exactly it reads a number, relative to the number: 4.4 may become 4.400000095.
  double precision;
};

/// Return the dialect of this name; null if there is none.
const Dialect* find_dialect(std::string_view name);

// The build writes the list from the names of the folders. Each folder holds these functions.
#define DIALECT(folder)                                                                 \
  extern const Spelling folder##_spelling;                                              \
  extern const std::string_view folder##_rules;                                         \
  extern const double folder##_precision;                                               \
  extern const std::span<const WordUse> folder##_word_uses;                             \
  std::vector<Keyword> folder##_keywords(const Control&);                               \
  FileReader folder##_reader(Builder& to, const ProgramNames& other_mode);              \
  std::optional<Fault> folder##_expression(Builder& to, const ExpressionText& text,     \
                                           std::uint32_t& expression, ValueType& type); \
  extern PieceReader (*const folder##_pieces)(Builder & to);                            \
  extern ProgramNames (*const folder##_other_mode)(const Code& code);                   \
  std::optional<WrittenWord> folder##_word(std::string_view block, std::size_t& from);
#include "dialect/list.def"
#undef DIALECT

}  // namespace cncsub
