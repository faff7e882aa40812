// A dialect: a language that NC programs are written in. It is a folder beside this file; the build
// finds it and lists it, and a control names the one it speaks (Control::dialect).
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "cncsub/code/builder.hpp"
#include "cncsub/text/words.hpp"

namespace cncsub {

/// Reads a file of Code::files, whose lines end with a line feed, into programs. It never fails:
/// what the control would refuse becomes the fault of its block. It stops early where somebody
/// wants it interrupted (Builder::interrupt).
using FileReader = std::function<void(std::uint32_t file)>;

struct Dialect {
  std::string_view name;
  /// The reader of the files of one library, one after the other.
  FileReader (*reader)(Builder& to);
  /// The words of a block as they are written.
  ReadWord read_word;
  /// How it writes what is no plain word.
  const Spelling* spelling;
};

/// The dialect of this name, null where there is none.
const Dialect* find_dialect(std::string_view name);

// The build writes the list from the names of the folders; each holds what it names.
#define DIALECT(folder)                    \
  extern const Spelling folder##_spelling; \
  FileReader folder##_reader(Builder& to); \
  std::optional<WrittenWord> folder##_word(std::string_view block, std::size_t& from);
#include "dialect/list.def"
#undef DIALECT

}  // namespace cncsub
