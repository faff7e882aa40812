// The branches, loops and subprograms of a file, resolved once all its lines are read.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/grblhal/block.hpp"

namespace cncsub::grblhal {

class Structure {
 public:
  explicit Structure(Builder& to) : to_(to) {}

  void begin(std::uint32_t file);
  /// Add the flow word of the block that is appended next.
  void add(const Flow& flow);
  /// Resolve the last program of the builder, which has ended, and add its subprograms as parts.
  void match();

 private:
  struct Met {
    Address address;
    Flow flow;
  };
  struct Open {
    std::size_t met;                       // the word that it begins with
    Address last = kNowhere;               // of an if: the last condition, whose end is not known
    std::vector<Address> ends = {};        // of an if: blocks that go to its end
    std::vector<std::size_t> leaves = {};  // break, continue
  };

  void match(std::size_t met);
  bool open(std::size_t met);
  Open* innermost(Flow::Kind a, Flow::Kind b, const Met& met);
  void branch(std::size_t met);
  void end_branch(std::size_t met);
  void end_loop(std::size_t met);
  void end_do(const Met& word);
  void leave_loop(std::size_t met);
  void next_pass(const Met& word, Address head, Address end);
  void jumps_of(const Open& open, Address end, Address next);
  void count(Flow& flow);
  void sub(std::size_t met);
  const Met* endsub(std::size_t from);
  void call(std::size_t met);
  std::int32_t part(const Met& word, Address end);
  void go_to(Address from, Address to);
  Address passing(Address from, Address to) const;
  Statement& statement(Address address) { return to_.record<Statement>(to_.block(address).aux); }
  void become(const Met& met, Op op);
  void refuse(const Met& met, Cause cause, const char* detail);

  Builder& to_;
  std::uint32_t file_ = 0;
  std::int32_t program_ = kNoProgram;  // that of the file
  std::vector<Met> lines_;
  std::size_t endsub_ = 0;       // the last one found
  Address part_end_ = kNowhere;  // of the last part
  std::vector<Open> open_;
  std::vector<Address> walls_;  // lines that are refused where they are passed over, too
  std::unordered_map<std::string, std::pair<Address, std::int32_t>> subs_;  // the block after the
                                                                            // head, and the part
};

}  // namespace cncsub::grblhal
