// The reader of files of the ISO family, for dialects that are built on it.
#pragma once

#include <cstdint>
#include <functional>
#include <string_view>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/iso/block_rules.hpp"

namespace cncsub {

/// Programs of another language that stand in the same files. A line says that one begins: the
/// first line of a file, for all its programs, or the one after the head of a program.
struct OtherPrograms {
  /// Let parts of a file with this text come next.
  std::function<void(std::string_view text)> begin_text;
  std::function<bool(std::string_view line)> begins;
  /// Read a part of the text into the open program; `line`: that of its first character.
  std::function<void(std::size_t from, std::size_t to, std::uint32_t line)> read;
  /// Complete the program that has ended.
  std::function<void(const Program& program)> end_program;
};

FileReader iso_reader(Builder& to, const IsoVariant& variant, OtherPrograms others);

}  // namespace cncsub
