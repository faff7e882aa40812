#include "cncsub/code/builder.hpp"

#include <algorithm>
#include <cmath>

#include "cncsub/code/sequence.hpp"

namespace cncsub {

namespace {

Cell cell_of(const WordValue& value) {
  Cell cell{};
  if (value.computed)
    cell.expression = value.expression;
  else
    cell.value = value.value;
  return cell;
}

/// Return the cell of a code. A code below 0 would read as an expression, and one too large is
/// refused when it runs.
Cell code_cell(const WordValue& code) {
  Cell cell{};
  if (code.computed)
    cell.value = -1.0 - code.expression;
  else
    cell.value = code.value >= 0 && code.value <= kLargestCode ? code.value : kLargestCode + 1;
  return cell;
}

}  // namespace

// ---- programs ----

void Builder::begin_program(const Program& program) {
  code_.programs.push_back(program);
  code_.programs.back().first = next_address();
  code_.programs.back().line = std::max(program.line, 1u);  // an empty file has a first line too
  code_.programs.back().first_entry = static_cast<std::uint32_t>(code_.sequence.size());
  in_program_ = true;
}

void Builder::end_program(std::uint32_t text_end, std::uint32_t line) {
  in_program_ = false;
  Program& program = code_.programs.back();
  program.text_end = text_end;
  program.last = next_address();
  Block end;
  end.op = Op::EndOfRecord;
  end.line = std::max(line, 1u);
  end.text = text_end;
  append(end);
  program.last_entry = static_cast<std::uint32_t>(code_.sequence.size());
  sort_numbers(code_, program, interrupt_);
}

void Builder::part(const Program& program) {
  code_.programs.push_back(program);
  Program& part = code_.programs.back();
  part.first_entry = static_cast<std::uint32_t>(code_.sequence.size());
  for (Address a = part.first; a < part.last && !interrupt_.requested(InterruptCheck::kBlock); ++a)
    if (code_.blocks[a].n >= 0) code_.sequence.push_back({code_.blocks[a].n, a});
  part.last_entry = static_cast<std::uint32_t>(code_.sequence.size());
  sort_numbers(code_, part, interrupt_);
}

void Builder::drop_program(std::int32_t leader) {
  if (leader > 0) code_.files[code_.programs.back().file].leader = leader;
  code_.blocks.erase(code_.blocks.begin() + code_.programs.back().first, code_.blocks.end());
  code_.sequence.resize(code_.programs.back().first_entry);
  code_.programs.pop_back();
  in_program_ = false;
}

// ---- blocks ----

void assign(Builder& to, Block& block, const Statement& statement) {
  const Expression value = to.code().expression(statement.expression);
  const std::uint32_t end = value.at() + value.width();
  const bool indirect = statement.target == Statement::Target::Indirect;
  const Assigned assigned{statement.target,
                          indirect ? statement.expression - statement.variable
                                   : static_cast<std::uint32_t>(statement.index),
                          statement.variable_at - block.text, statement.variable_width};
  const bool as_told = statement.text_length == 0 && statement.at == statement.variable_at &&
                       statement.at + statement.width == end;
  if (assigned.fits() && as_told && !to.code().general_only)
    return set(block, assigned, statement.expression);
  to.become(block, Op::Assign, statement);
}

void Builder::parallel_assign(Block& block, const std::vector<Statement>& statements,
                              const Print* print, const Block* words) {
  ParallelAssign all;
  all.first_statement = static_cast<std::uint32_t>(code_.statements.size());
  all.statements = static_cast<std::uint32_t>(statements.size());
  code_.statements.insert(code_.statements.end(), statements.begin(), statements.end());
  if (print != nullptr) all.print = keep(*print);
  if (words != nullptr) all.words = keep(*words);
  become(block, Op::ParallelAssign, all);
}

// ---- words ----

void write_codes(Code& code, Block& block, const CodeList& list) {
  const int number = code.code_lists.keep(list);
  block.set_codes(number, list.g_count, list.m_count);
  if (number >= 0) return;
  const auto write = [&](int of) { code.cells.push_back({.value = static_cast<double>(of)}); };
  for (const int g : list.g()) write(g);
  for (const int m : list.m()) write(m);
}

namespace {

bool is_within(double value, double most) { return value >= 0 && value <= most; }

/// Return the codes, where all of them are written as numbers that the control knows.
std::optional<CodeList> known_codes(const Code& code, const WordList& words) {
  CodeList list;
  for (int i = 0; i < words.g_count; ++i) {
    const auto& [computed, expression, g] = words.g[static_cast<std::size_t>(i)];
    if (computed || !is_within(g, 10000) || !code.g_codes.test(to_whole<std::size_t>(g)))
      return std::nullopt;
    list.add_g(to_whole<int>(g));
  }
  for (int i = 0; i < words.m_count; ++i) {
    const auto& [computed, expression, m] = words.m[static_cast<std::size_t>(i)];
    if (computed || !is_within(m, kLargestCode)) return std::nullopt;
    list.add_m(to_whole<int>(m));
  }
  return list;
}

/// Return whether a plain move may have these words: no check asks where it leads to.
bool are_small(const WordList& words) {
  constexpr double kMost = 1e30;  // the sum of very many of them is still a position
  for (std::uint32_t left = words.mask; left != 0; left &= left - 1)
    if (std::fabs(words.values[static_cast<std::size_t>(std::countr_zero(left))].value) > kMost)
      return false;
  return true;
}

void write_codes(Code& code, Block& block, const WordList& words) {
  if (const auto list = known_codes(code, words)) return write_codes(code, block, *list);
  block.set_codes(-1, static_cast<std::size_t>(words.g_count),
                  static_cast<std::size_t>(words.m_count));
  const auto write = [&](const WordValue& of) {
    if (of.computed) block.flags |= Block::kCodeExpression;
    code.cells.push_back(code_cell(of));
  };
  for (int i = 0; i < words.g_count; ++i) write(words.g[static_cast<std::size_t>(i)]);
  for (int i = 0; i < words.m_count; ++i) write(words.m[static_cast<std::size_t>(i)]);
}

void write_forms(Code& code, Block& block, const WordForms& forms) {
  block.flags |= Block::kHasForms;
  Cell cell{};
  cell.extra = {forms.absolute, forms.incremental};
  code.cells.push_back(cell);
  cell.extra = {forms.rotary, 0};
  code.cells.push_back(cell);
}

}  // namespace

void Builder::words(Block& block, const WordList& words) {
  block.data = static_cast<std::uint32_t>(code_.cells.size());
  block.mask = words.mask;
  block.flags = 0;
  std::uint32_t expressions = 0;
  for (std::uint32_t left = words.mask; left != 0; left &= left - 1)
    if (words.values[static_cast<std::size_t>(std::countr_zero(left))].computed)
      expressions |= left & -left;
  if ((expressions | words.whole) != 0) {
    Cell cell{};
    cell.extra = {expressions, words.whole};
    code_.cells.push_back(cell);
    block.flags |= Block::kHasExtra;
  }
  if (words.g_count + words.m_count > 0) write_codes(code_, block, words);
  for (std::uint32_t left = words.mask; left != 0; left &= left - 1)
    code_.cells.push_back(cell_of(words.values[static_cast<std::size_t>(std::countr_zero(left))]));
  if (words.forms.any()) write_forms(code_, block, words.forms);
  if (code_.drops.size() > first_drop_) {
    block.flags |= Block::kDrops;
    // Drops are found by the block's data, which then are its own.
    if (code_.cells.size() == block.data) code_.cells.push_back({});
  }
  for (; first_drop_ < code_.drops.size(); ++first_drop_)
    code_.drops[first_drop_].data = block.data;
  block.op = Op::Words;
  if (code_.general_only || (block.flags & ~Block::kListed) != 0 || block.m_count != 0 ||
      block.g_count > 1 || block.code_cells() > 0 || !are_small(words))
    return;
  const double g = block.g_count == 0 ? -10 : words.g.front().value;
  if (g <= 30 && std::fmod(g, 10) == 0) mark_move(block, to_whole<int>(g / 10));
}

}  // namespace cncsub
