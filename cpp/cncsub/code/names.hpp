// Labels and variables that have names: each name has one number.
#pragma once

#include <cstdint>
#include <string>

#include "cncsub/code/code.hpp"

namespace cncsub {

class Names {
 public:
  explicit Names(Code& code) : code_(code) {}

  /// The place of a label among Code::labels.
  std::uint32_t label(const std::string& name);
  /// The block at this address is where calls of the label lead.
  void head(std::uint32_t label, Address address) { code_.heads.push_back({label, address}); }
  /// Once all files are read: from now on the heads can be found.
  void sort_heads();
  /// The variable of a name, which is a local or a common one: its place in Code::named_variables.
  std::uint32_t variable(const std::string& name, bool common);
  /// Two commons are kept for what the last subprogram returned, and whether it did: the first.
  std::int32_t returned();
  /// A name that a variable is given, or used by: its place in Code::names.
  std::uint32_t text(std::string name);

 private:
  Code& code_;
};

}  // namespace cncsub
