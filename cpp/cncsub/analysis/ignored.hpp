// Comments that switch rules of a check off for their line: `(cncsub: ignore CS701)`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cncsub/analysis/check.hpp"

namespace cncsub {

class IgnoredLines {
 public:
  IgnoredLines() = default;
  explicit IgnoredLines(std::string_view text);

  /// Return whether a rule is switched off in the line of a place.
  bool holds(Check check, std::size_t at) const;

 private:
  struct Line {
    std::size_t from, to;
    std::vector<std::string> names;  // none: all rules
  };
  std::vector<Line> lines_;
};

}  // namespace cncsub
