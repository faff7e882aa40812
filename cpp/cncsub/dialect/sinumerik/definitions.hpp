// The variables that a program defines: in the list of its PROC, and by DEF.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace cncsub::sinumerik {

enum class Type : std::uint8_t { Int, Real, Bool, Char, String, Axis, Frame };

/// Return the type of this name, in capitals; nothing where it is none.
std::optional<Type> type_named(std::string_view word);

/// A variable of the program that is read.
struct Definition {
  Type type = Type::Real;
  bool array = false;
  std::int32_t local = 0;  // among the locals of a level

  /// Return what its values are, where they are not computed here; else nothing.
  const char* uncomputed() const;
};

/// The variables of one program by their names, in capitals. [840Df p.62, identifiers]
class Definitions {
 public:
  void clear() { all_.clear(); }
  const Definition* find(const std::string& name) const {
    const auto found = all_.find(name);
    return found == all_.end() ? nullptr : &found->second;
  }
  void add(const std::string& name, const Definition& definition) {
    all_.emplace(name, definition);
  }

 private:
  std::unordered_map<std::string, Definition> all_;
};

}  // namespace cncsub::sinumerik
