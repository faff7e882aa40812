// What the lines of the RS274/NGC family have in common: messages, and words beside assignments.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "cncsub/dialect/ngc_values.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

/// Take a word, which is in capitals, from the head of a text that may have it in small letters.
bool ngc_take_word(std::string_view& text, std::string_view word);

/// How the values in a message are shown.
struct NgcFormat {
  int decimals = 0;            // of a value before which nothing says how many
  int of_f = 0;                // of one after %f
  bool loses_percent = false;  // %. without a number loses its percent sign
};

/// Take %d, %f or %.3f, and return how many decimals the values after it have. Any other text
/// stays.
int ngc_take_format(const NgcFormat& format, std::string_view& text, std::string& plain,
                    int decimals);

/// Write a message into `print`: `#5` and `#<name>` in it stand for their values. The message
/// stands at `at`; `expression` reads values from `line`, which is left as it was.
template <class Expression>
void ngc_message(Builder& to, BareLine& line, Expression& expression, const NgcFormat& format,
                 std::string_view text, std::uint32_t at, Print& print) {
  std::string plain;
  int decimals = format.decimals;
  const BareLine kept = line;
  while (!text.empty()) {
    if (text.front() == '%') {
      decimals = ngc_take_format(format, text, plain, decimals);
      continue;
    }
    const bool names = text.size() > 1 && (text[1] == '<' || is_digit(text[1]));
    ValueRead value;
    if (text.front() == '#' && names) line.set(text.substr(1), at);
    if (text.front() != '#' || !names || !expression.shown(value)) {
      plain += text.front();
      text.remove_prefix(1);
      continue;
    }
    if (!plain.empty()) print.fields.push_back({.text = std::exchange(plain, {})});
    print.fields.push_back({.is_variable = true,
                            .text = {},
                            .expression = to.expressions().expression_of(value),
                            .whole_digits = PrintField::kPlain,
                            .decimals = decimals});
    text.remove_prefix(std::min<std::size_t>(1 + line.width_from(at), text.size()));
  }
  if (!plain.empty()) print.fields.push_back({.text = plain});
  line = kept;
}

/// Write a block of words, assignments and a message, of which any may be missing.
template <class Words>
void ngc_write(Builder& to, Block& block, Words& words) {
  const bool beside = !words.statements.empty() || words.print;
  if (!words.any && words.statements.size() == 1 && !words.print)
    return assign(to, block, words.statements.front());
  if (!words.any && words.statements.empty() && words.print)
    return to.become(block, Op::Print, *words.print);
  if (!beside) {
    to.words(block, words.list);
    if (words.ends) block.op = Op::EndProgram;
    return;
  }
  Block own = block;
  if (words.any) {
    to.words(own, words.list);
    // A plain move would leave out what stands beside it.
    own.op = words.ends ? Op::EndProgram : Op::Words;
  }
  to.parallel_assign(block, words.statements, words.print ? &*words.print : nullptr,
                     words.any ? &own : nullptr);
}

}  // namespace cncsub
