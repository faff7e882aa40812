#include "cncsub/dialect/iso/block.hpp"

#include <algorithm>
#include <string>

#include "cncsub/dialect/iso/block_meaning.hpp"
#include "cncsub/dialect/iso/block_writer.hpp"
#include "cncsub/dialect/iso/statement.hpp"

namespace cncsub {

namespace {

/// Make `block` do what `then` does if its condition holds.
void conditional(Builder& to, Statement statement, const Block& then, Block& block) {
  statement.then = to.keep(then);
  to.become(block, Op::IfThen, statement);
}

}  // namespace

void BlockReader::read_any(Scanner& s, Block& block) {
  WordScanner words(to_, rules_, expressions_, s, block);
  if (!words.head()) return;
  const int most = control_.reading.max_block_length.value;
  if (most > 0 && s.end - (s.file + block.text) > static_cast<std::ptrdiff_t>(most))
    return to_.refuse(block, {Cause::BlockTooLong, block.text, 1,
                              "a block has at most " + std::to_string(most) + " characters"});
  if (control_.calls.conditional_return.value && s.peek() == '[')
    return conditional_return(s, block);
  StatementReader statement(to_, expressions_, s, block);
  if (statement.read()) {
    const auto& words = statement.before_words();
    if (const auto then = words ? words_behind(s, block) : std::nullopt)
      conditional(to_, *words, *then, block);
    return;
  }
  tokens_.clear();
  if (words.words(tokens_)) write(block, tokens_, true);
}

/// Read the words after a condition as a block of their own; nothing if the block is refused.
std::optional<Block> BlockReader::words_behind(Scanner& s, Block& block) {
  Block behind = block;
  tokens_.clear();
  if (WordScanner(to_, rules_, expressions_, s, behind).words(tokens_))
    write(behind, tokens_, true);
  if (behind.op != Op::Fault) return behind;
  block.op = Op::Fault;
  block.aux = behind.aux;
  return std::nullopt;
}

/// Read a block such as `[#1 LT 10] M99 P10`.
void BlockReader::conditional_return(Scanner& s, Block& block) {
  Statement statement;
  statement.at = s.offset();
  const auto condition = expressions_.condition(s);
  if (!condition) return to_.refuse(block, expressions_.fault());
  statement.expression = *condition;
  statement.width = s.offset() - statement.at;
  const auto back = words_behind(s, block);
  if (!back) return;
  if (back->op != Op::Return)
    return to_.refuse(block, {Cause::StatementFormat, statement.at, statement.width,
                              "a condition at the start of a block must have M99 after it"});
  conditional(to_, statement, *back, block);
}

/// Write the code of a block. `calls`: its codes may call programs.
void BlockReader::write(Block& block, const Tokens& tokens, bool calls) {
  for (std::size_t i = 0; i < tokens.size(); ++i)
    if (tokens[i].letter == '/') return write_slash(block, tokens, i, calls);
  BlockMeaning meaning;
  if (auto fault = MeaningReader(rules_, tokens, calls, meaning).read())
    return to_.refuse(block, std::move(*fault));
  if (meaning.registered == nullptr)
    return BlockWriter(to_, rules_, tokens, meaning, block).write();
  // Inside a program that a code called, codes may not call.
  Select variant;
  variant.address = meaning.call->letter;
  Block first = block;
  Block second = block;
  BlockWriter(to_, rules_, tokens, meaning, first).write();
  write(second, tokens, false);
  variant.first = to_.keep(first);
  variant.second = to_.keep(second);
  to_.become(block, Op::Select, variant);
}

/// Write a block with a slash after its head. The words after the slash do not count while its
/// switch is on.
void BlockReader::write_slash(Block& block, const Tokens& tokens, std::size_t slash, bool calls) {
  Tokens without(tokens.begin(), tokens.begin() + static_cast<std::ptrdiff_t>(slash));
  Tokens with = without;
  with.insert(with.end(), tokens.begin() + static_cast<std::ptrdiff_t>(slash) + 1, tokens.end());
  Select variant;
  variant.skip = tokens[slash].skip;
  Block first = block;
  Block second = block;
  write(first, with, calls);
  write(second, without, calls);
  variant.first = to_.keep(first);
  variant.second = to_.keep(second);
  to_.become(block, Op::Select, variant);
}

}  // namespace cncsub
