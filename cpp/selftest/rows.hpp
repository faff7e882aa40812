// The rows of the self-test: programs, how they run, and the recorded outcome of the run.
//
// A file of rows is lines of fields with tabs between; in a field a backslash stands before a
// backslash, and for a tab, a line feed and a return (\t \n \r). The first line names the format, a
// row goes from its line `row` to its line `end`, and every line of it begins with a key.
// tools/selftest_rows.py writes them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/control/control.hpp"
#include "cncsub/machine/state/options.hpp"

namespace cncsub::selftest {

constexpr int kFormat = 1;

/// The fields of a line, its key first.
using Fields = std::vector<std::string>;

struct Row {
  std::string name;
  std::shared_ptr<Control> control;
  std::vector<SourceFile> files;
  bool device = false;
  std::optional<std::string> typed;  // in MDI
  std::size_t main = 0;
  Options options;
  std::vector<Fields> outcome;  // the outcome to compare, in the order in which `run` gives it
  std::string wrong;            // the error in the row itself
};

/// Reads the rows of a text in turn.
class Reader {
 public:
  /// Throws std::runtime_error if the text is no file of rows.
  explicit Reader(std::string_view text);
  /// Return the next row; nothing after the last one.
  std::optional<Row> next();

 private:
  std::optional<Fields> line();

  std::string_view left_;
};

double number_of(const std::string& field);

}  // namespace cncsub::selftest
