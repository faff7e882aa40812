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

/// Make the block one whose return is executed where the condition holds, and whose words alone
/// where it does not.
void conditional_or_words(Builder& to, Statement condition, const Block& back, const Block& words,
                          Block& block) {
  Statement otherwise;
  otherwise.at = condition.at;
  otherwise.index = Statement::kAlways;
  Statement choice = condition;
  choice.number = 2;
  condition.then = to.keep(back);
  otherwise.then = to.keep(words);
  to.become(block, Op::Switch, choice);
  to.keep(condition);
  to.keep(otherwise);
}

/// Make the block one that assigns, and then does what it did. The words, as another alternative
/// that always applies, do not stand together with the assignment: they are read after it.
void assign_before(Builder& to, const Statement& assigned, Block& block) {
  Statement always;
  always.at = assigned.at;
  always.index = Statement::kAlways;
  always.then = to.keep(block);
  Statement choice = assigned;
  choice.index = 0;
  choice.number = 1;
  Block words = block;
  to.become(words, Op::Switch, choice);
  to.keep(always);
  to.parallel_assign(block, {assigned}, nullptr, &words);
}

}  // namespace

void BlockReader::read_any(Scanner& s, Block& block) {
  WordScanner words(to_, rules_, expressions_, s, block);
  if (!words.head()) return;
  const int most = control_.reading.max_block_length.value;
  if (most > 0 && s.end - (s.file + block.text) > static_cast<std::ptrdiff_t>(most))
    return to_.refuse(block, {Cause::BlockTooLong, block.text, 1,
                              "a block has at most " + std::to_string(most) + " characters"});
  if (control_.calls.conditional_return.value && s.peek() == '[') {
    tokens_.clear();
    return conditional_return(s, block);
  }
  StatementReader statement(to_, expressions_, s, block);
  if (statement.read()) {
    const auto& words = statement.before_words();
    if (const auto then = words ? words_behind(s, block, statement.assigned()) : std::nullopt)
      conditional(to_, *words, *then, block);
    return;
  }
  tokens_.clear();
  if (words.words(tokens_)) words_or_more(s, block);
}

/// Write the words that were read, or read the condition of M99 that ends them.
void BlockReader::words_or_more(Scanner& s, Block& block) {
  if (s.at != s.end && s.peek() == '[') return conditional_return(s, block);
  write(block, tokens_, true);
}

/// Read the words after a condition as a block of their own; nothing if the block is refused.
std::optional<Block> BlockReader::words_behind(Scanner& s, Block& block,
                                               const std::optional<Statement>& assigned) {
  Block behind = block;
  tokens_.clear();
  if (WordScanner(to_, rules_, expressions_, s, behind).words(tokens_)) words_or_more(s, behind);
  if (behind.op != Op::Fault && assigned) {
    assign_before(to_, *assigned, behind);
  }
  if (behind.op != Op::Fault) return behind;
  block.op = Op::Fault;
  block.aux = behind.aux;
  return std::nullopt;
}

/// Return the words of a block besides its return.
Tokens BlockReader::without_return(const Tokens& tokens) const {
  Tokens left;
  for (const Token& token : tokens) {
    const bool of_return =
        token.letter == 'M'
            ? control_.calls.roles.value.of_m(to_whole<int>(token.operand.value)) == Role::Return
            : !token.comma && std::string_view("PL").find(token.letter) != std::string_view::npos;
    if (!of_return) left.push_back(token);
  }
  return left;
}

/// Read the condition of a block such as `X5. [#1 LT 10] M99 P10`, whose words before it have been
/// read. The words are executed in any case: the condition is that of M99 alone. [HNGC p.227]
void BlockReader::conditional_return(Scanner& s, Block& block) {
  Statement statement;
  statement.at = s.offset();
  const auto condition = expressions_.condition(s);
  if (!condition) return to_.refuse(block, expressions_.fault());
  statement.expression = *condition;
  statement.width = s.offset() - statement.at;
  if (!WordScanner(to_, rules_, expressions_, s, block).words(tokens_)) return;
  Block back = block;
  write(back, tokens_, true);
  if (back.op == Op::Fault) {
    block.op = Op::Fault;
    block.aux = back.aux;
    return;
  }
  if (back.op != Op::Return)
    return to_.refuse(block, {Cause::StatementFormat, statement.at, statement.width,
                              "a condition between brackets must have M99 after it"});
  const Tokens left = without_return(tokens_);
  if (!left.empty()) {
    Block words = block;
    write(words, left, false);
    if (words.op != Op::Fault) return conditional_or_words(to_, statement, back, words, block);
    block.op = Op::Fault;
    block.aux = words.aux;
    return;
  }
  conditional(to_, statement, back, block);
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
