// Labels and variables that have names: each name has one number.
#pragma once

#include <cstdint>
#include <string>

#include "cncsub/code/code.hpp"

namespace cncsub {

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
  /// Return the place in Code::names of a name that a variable is given, or used by.
  std::uint32_t text(std::string name);

 private:
  Code& code_;
};

}  // namespace cncsub
