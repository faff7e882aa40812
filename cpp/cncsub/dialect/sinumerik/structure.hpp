// The jumps and control structures of a program, resolved once all its blocks are read.
#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "cncsub/code/builder.hpp"
#include "cncsub/dialect/sinumerik/link.hpp"

namespace cncsub::sinumerik {

class Structure {
 public:
  explicit Structure(Builder& to) : to_(to) {}

  void begin() {
    labels_.clear();
    numbered_.clear();
    links_.clear();
    modes_.clear();
    iso_mode_ = false;
  }
  /// Say in which mode the block is that is appended next.
  void mode(bool iso_mode) {
    if (iso_mode != iso_mode_) modes_.push_back(to_.next_address());
    iso_mode_ = iso_mode;
  }
  /// Add the block that is appended next.
  void add(const std::string& label, const Link& link);
  /// Resolve the last program of the builder, which has ended.
  void match();

 private:
  struct Met {
    Address address;
    Link link;
  };
  /// The word of a control structure.
  struct Word {
    Address block = kNowhere;
    std::uint32_t at = 0, width = 1;
  };
  static Word word_of(const Met& met) { return {met.address, met.link.at, met.link.width}; }
  struct Open {
    Word word;
    Link::Kind kind;
    Word other;  // of an IF: its ELSE
    std::size_t span = 0;
  };

  /// A control structure whose end is known; kNowhere: it has none.
  struct Span {
    Address first, last = kNowhere;
    std::size_t around = 0;  // the number of the structure around it, from 1

    /// Return whether a block stands after the beginning of the structure, up to its end.
    bool holds(Address at) const { return at > first && (last == kNowhere || at <= last); }
  };
  /// The block from which on `span` is the innermost structure.
  struct Mark {
    Address from;
    std::size_t span;
  };

  void match(const Met& met);
  void open(const Met& met);
  void close(const Met& met, Link::Kind opener);
  void match_else(const Word& word);
  void resolve(const Met& met);
  void resolve(Address from, const AlternativeJump& one);
  void resolve_part(const Met& met);
  void refuse_jump(Block& block, const JumpTarget& target, bool inside);
  bool refuse_other_mode(Block& block, Address from, Address to, const JumpTarget& target);
  const std::vector<Address>& blocks_of(const JumpTarget& target);
  Address target(Address from, const JumpTarget& sought, Address& other);
  Address part_end(const Met& met, Address first);
  void keep_structures();
  bool leads_inside(Address from, Address to) const;
  bool runs(Address address, Op op) { return to_.block(address).op == op; }
  Statement& statement(Address address) { return to_.record<Statement>(to_.block(address).aux); }
  void refuse(const Word& word, Cause cause, const char* detail);
  void leave_open(const Open& open);
  void refuse_otherwise(const Word& word, Cause cause, const char* detail);

  Builder& to_;
  std::unordered_map<std::string, std::vector<Address>> labels_;
  std::unordered_map<std::int32_t, std::vector<Address>> numbered_;  // the blocks of a number
  std::vector<Met> links_;
  std::vector<Address> modes_;  // the blocks from which on another mode holds
  bool iso_mode_ = false;       // of the next block
  std::vector<Open> open_;
  std::vector<Span> spans_;  // by their numbers, less 1
  std::vector<Mark> marks_;
  bool computed_ = false;  // a jump of the program goes to what a text names
};

}  // namespace cncsub::sinumerik
