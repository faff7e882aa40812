// Labels and variables that have names: each name has one number.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// Return the place in Code::named_variables of a name, of a common or of a local; nothing where no
/// variable has it.
std::optional<std::uint32_t> place_of_name(const Code& code, const std::string& name, bool common);

class Names {
 public:
  explicit Names(Code& code) : code_(code) {}

  /// Return the place of a label among Code::labels.
  std::uint32_t label(const std::string& name);
  /// Make the block at this address the one that calls of the label lead to.
  void head(std::uint32_t label, Address address) { code_.heads.push_back({label, address}); }
  /// Sort the heads when all files are read: from then on they can be found.
  void sort_heads();
  /// Return the place in Code::named_variables of the variable of a name, a local or a common one.
  std::uint32_t variable(const std::string& name, bool common);
  /// Return the first of two commons that hold what the last subprogram returned, and whether it
  /// did.
  std::int32_t returned();
  /// Return the first of so many commons that nothing else uses.
  std::int32_t commons(std::int32_t count);
  /// Return the first of so many locals in a row that no program can name, for this purpose.
  std::int32_t hidden(const std::string& purpose, std::int32_t count);
  /// Return the place in Code::lists of a list of numbers.
  std::uint32_t list(std::vector<double> numbers);
  /// Make a common have a value when a run begins.
  void first_value(std::int32_t common, double value);
  /// Make room for the arrays of a level: so many elements.
  void elements(std::int32_t count);
  /// Return the number of a text that stands in a program.
  std::uint32_t constant_text(const std::string& text) { return code_.texts.number_of(text); }
  /// Record how a variable is shown, of the program that was begun last or, `shared`, of all.
  void defined(DefinedVariable variable, bool shared);
  /// Return the place in Code::names of a name that a variable is given, or used by.
  std::uint32_t text(std::string name);

 private:
  Code& code_;
};

}  // namespace cncsub
