// How many loops, branches and subprograms are open at each block of a program.
#pragma once

#include <unordered_map>
#include <vector>

#include "cncsub/code/code.hpp"

namespace cncsub {

/// Counts what is open, over the blocks of a program in their order.
class NestingDepth {
 public:
  NestingDepth(const Code& code, const Program& program);

  /// Return the depth at which the next block stands: an end stands at the depth of its beginning.
  int of(Address at);
  /// Return whether a block is the second one of a statement that does two things, as ELSEIF.
  bool is_second(Address at) const;

 private:
  struct Open {
    Address end;       // the block that ends it; kNowhere: the next end of its kind
    OWordKind kind{};  // of one with a label
    std::uint32_t label = OWord::kNone;
  };
  int of_o_word(const OWord& word);
  bool ends(const OWord& word) const;
  int depth() const { return static_cast<int>(open_.size()); }

  const Code& code_;
  std::vector<Open> open_;
  std::unordered_map<Address, Address> ends_;  // of loops that ask at their end, by their heads
};

}  // namespace cncsub
