// Writes the words of blocks anew. The code says what a block executes. The text says how a number
// is spelled (`X10.0`, `T0101`, `M08`) and in which order words stand, where it says the same.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "cncsub/flat/numbers.hpp"
#include "cncsub/machine/state/observer.hpp"

namespace cncsub {

class BlockWriter {
 public:
  explicit BlockWriter(const Machine& machine);

  /// Write the words of a block, with `values` (or null) where they are computed. Return false
  /// where one of them cannot be written: then `failed` is that word.
  bool write(std::string& to, const Block& block, std::int32_t program, const NcWords* values);
  /// Write a cycle so that its P and Q become the numbers of a profile's first and last block.
  bool write_cycle(std::string& to, const Block& block, std::int32_t program, const NcWords* values,
                   const std::array<std::int64_t, 2>& profile);
  const std::string& failed() const { return failed_; }

 private:
  /// A piece of a block's line.
  struct Part {
    enum class Kind : std::uint8_t { Text, Word, Formed, Codes, Unwritten } kind = Kind::Text;
    char letter = 0;                 // Codes: G or M; Unwritten: what cannot be written
    std::uint32_t at = 0, size = 0;  // Text: in `texts_`; Word: its place in a mask
    std::uint8_t place = 0;  // Formed: the same; `at` and `size` are its text up to the value
  };
  struct Line {
    std::uint32_t first = 0, parts = 0;  // in `parts_`; 0 where not made yet
  };

  const Line& line_of(const Block& block, std::int32_t program);
  Line make(const Block& block, std::int32_t program,
            const std::array<std::int64_t, 2>* profile = nullptr);
  void add_text(std::string_view text);
  void add_formed(std::string_view before, std::uint8_t place);
  bool put(std::string& to, const Line& line, const NcWords* values);
  bool put_value(std::string& to, const Part& part, const NcWords& values);
  bool put_codes(std::string& to, char letter, const BlockCodes& codes);

  class Maker;

  const Code& code_;
  WordWriter words_;
  std::vector<Line> lines_;                           // of Code::blocks
  std::unordered_map<std::uint32_t, Line> variants_;  // of Code::variants
  std::vector<Part> parts_;
  std::string texts_;
  std::size_t open_ = 0;  // the first part of the line that is being made
  std::string failed_;
};

}  // namespace cncsub
