// The names of blocks, and the jumps to them, which are resolved once a file is read.
#pragma once

#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include "cncsub/dialect/okuma/block.hpp"

namespace cncsub::okuma {

class Jumps {
 public:
  explicit Jumps(Builder& to) : to_(to) {}

  /// Begin a file.
  void begin();
  /// Add the block that is appended next, with its name and its jump, if it has any.
  void add(const std::string& name, const Jump& jump);
  /// Resolve the jumps of the file.
  void resolve();

 private:
  struct Met {
    Address address;
    std::size_t program;
    Jump jump;
  };
  struct Named {
    Address first = kNowhere;
    bool again = false;  // another block of the program has the name
  };

  void resolve(const Met& met);
  void refuse(const Met& met, Cause cause, std::string detail);
  std::size_t program() const { return to_.code().programs.size(); }
  static std::string key_of(const std::string& name, std::size_t program);

  Builder& to_;
  std::unordered_map<std::string, Named> named_;  // by name and program
  std::unordered_set<std::string> names_;         // of all programs of the file
  std::unordered_set<std::string> numbers_;       // the same without leading zeros
  std::vector<Met> jumps_;
};

}  // namespace cncsub::okuma
