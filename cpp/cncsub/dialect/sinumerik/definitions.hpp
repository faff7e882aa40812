// The variables that a program defines: in the list of its PROC, and by DEF.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "cncsub/code/program.hpp"

namespace cncsub::sinumerik {

enum class Type : std::uint8_t { Int, Real, Bool, Char, String, Axis, Frame };

/// Return the type under which a variable is shown, and by which parameters are compared.
DefinedVariable::Type shown_type(Type type);

/// Return the type of this name, in capitals; nothing where it is none.
std::optional<Type> type_named(std::string_view word);

constexpr std::int32_t kLongestText = 200;  // of a STRING [840Df p.63, types]

/// A variable of the program that is read, or of all programs.
struct Definition {
  static constexpr std::size_t kMostDimensions = 3;

  Type type = Type::Real;
  bool global = false;     // of all programs
  std::int32_t local = 0;  // among the locals of a level, or the commons; of an array: its first
                           // element among those of a level, or the commons
  std::int32_t length = kLongestText;  // of a STRING
  std::size_t dimensions = 0;          // of an array
  std::array<std::int32_t, kMostDimensions> extents{};
  std::optional<double> constant{};  // the number that a macro stands for
  bool macro = false;                // what a macro stands for is no number
  // Of a parameter that stands for a variable: the local that says for which. Of an array the
  // next one holds how many elements it has, and the extents, which are 0 here, come after it.
  std::int32_t reference = -1;

  bool is_array() const { return dimensions > 0; }
  std::vector<std::int32_t> shape() const {
    return {extents.begin(), extents.begin() + dimensions};
  }
  std::int32_t size() const {
    std::int32_t elements = 1;
    for (std::size_t i = 0; i < dimensions; ++i) elements *= extents[i];
    return elements;
  }
};

/// The variables of one program by their names, in capitals. [840Df p.62, identifiers] Those of all
/// programs stay when the next one begins.
class Definitions {
 public:
  void clear() {
    own_.clear();
    elements = 0;
  }
  const Definition* find(const std::string& name) const {
    const auto own = own_.find(name);
    if (own != own_.end()) return &own->second;
    const auto shared = shared_.find(name);
    return shared == shared_.end() ? nullptr : &shared->second;
  }
  /// Return whether a program, or the definitions of all, define the name already.
  bool defines(const std::string& name, bool global) const {
    return (global ? shared_ : own_).contains(name);
  }
  void add(const std::string& name, const Definition& definition) {
    (definition.global ? shared_ : own_).emplace(name, definition);
  }

  std::int32_t elements = 0;  // of the arrays of the program so far

 private:
  std::unordered_map<std::string, Definition> own_, shared_;
};

}  // namespace cncsub::sinumerik
