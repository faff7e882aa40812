// The names in the text of a block: of labels, programs and variables, each with its place.
// Comments and texts between quotes hold none.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/code/references.hpp"
#include "cncsub/code/spelling.hpp"

namespace cncsub {

/// A name as it is written, or the variable that it is: a number, or a name after the sign of
/// variables (#ABC, #<abc>).
struct NamePiece {
  enum class Kind : std::uint8_t { Name, Number, Variable } kind = Kind::Name;
  std::uint32_t at = 0, width = 0;            // in the text
  std::uint32_t name_at = 0, name_width = 0;  // of the number or the name alone
  std::int64_t number = -1;                   // of Kind::Number

  std::string_view name_in(std::string_view text) const { return text.substr(name_at, name_width); }
};

std::vector<NamePiece> name_pieces(const Spelling& spelling, std::string_view text);

/// Return the place of the digits of a number that stands somewhere in `place`: after its address,
/// a bracket, a sign or a comment. Nothing where other characters stand between its digits, or
/// where they are not `number`.
std::optional<TextPlace> digits_in(std::string_view file, TextPlace place, std::int64_t number);

}  // namespace cncsub
