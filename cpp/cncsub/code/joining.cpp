// Puts what was read into a code of its own, by another thread perhaps, after what was read before:
// every number that leads from one table into another one grows by what stands there.
#include <algorithm>
#include <bit>
#include <iterator>
#include <utility>

#include "cncsub/code/builder.hpp"
#include "cncsub/code/sequence.hpp"
#include "cncsub/system/kept_memory.hpp"

namespace cncsub {

namespace {

template <class Table>
std::uint32_t size_of(const Table& table) {
  return static_cast<std::uint32_t>(table.size());
}

/// Append one table to another; return where it begins there.
template <class Table>
std::uint32_t append(Table& to, Table& from, double to_come = 0) {
  constexpr double kMostGrowth = 8, kMargin = 1.05;
  const std::uint32_t base = size_of(to);
  const std::size_t both = to.size() + from.size();
  const bool outgrown = both > to.capacity();
  if (outgrown && to_come > 0) {
    // A table that grows is there twice. So it grows once, to what all files need if they are
    // alike.
    const double growth = std::min(kMargin * (1 + to_come), kMostGrowth);
    to.reserve(static_cast<std::size_t>(static_cast<double>(both) * growth));
  }
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
  from.clear();
  if (outgrown) system::give_back_large_memory();  // it would be the most that reading keeps
  return base;
}

std::uint32_t append(OpenTable<ExpressionCell>& to, OpenTable<ExpressionCell>& from) {
  const std::uint32_t base = size_of(to);
  to.append(from);
  from.clear();
  return base;
}

/// The joining of a part, with what its numbers grow by.
class Joining {
 public:
  Joining(Code& code, Joined& of) : code_(code), of_(of) {}

  void join() {
    append_tables();
    for (std::size_t i = blocks_; i < code_.blocks.size(); ++i) move_block(code_.blocks[i]);
    for (std::size_t i = variants_; i < code_.variants.size(); ++i) move_block(code_.variants[i]);
    move_values();
    move_statements();
    for (std::size_t i = faults_; i < code_.faults.size(); ++i) move(code_.faults[i].block);
    for (std::size_t i = drops_; i < code_.drops.size(); ++i) code_.drops[i].data += cells_;
    for (std::size_t i = entries_; i < code_.sequence.size(); ++i)
      code_.sequence[i].address += blocks_;
    move_programs();
  }

 private:
  void append_tables() {
    Code& from = of_.code;
    blocks_ = append(code_.blocks, from.blocks, of_.to_come);
    variants_ = append(code_.variants, from.variants);
    cells_ = append(code_.cells, from.cells);
    expressions_ = append(code_.expressions, from.expressions);
    calls_ = append(code_.calls, from.calls, of_.to_come);
    jumps_ = append(code_.jumps, from.jumps);
    arguments_ = append(code_.arguments, from.arguments);
    statements_ = append(code_.statements, from.statements);
    h_codes_ = append(code_.h_codes, from.h_codes);
    prints_ = append(code_.prints, from.prints);
    selects_ = append(code_.selects, from.selects);
    faults_ = append(code_.faults, from.faults);
    drops_ = append(code_.drops, from.drops);
    entries_ = append(code_.sequence, from.sequence);
  }

  /// Return where the records of a kind of block begin; 0 for blocks without, or without in a part.
  std::uint32_t record_base(Op op) const {
    const auto is_one_of = [op](auto... ops) { return ((op == ops) || ...); };
    if (is_one_of(Op::Call, Op::MacroCall, Op::ModalCall, Op::RepeatPart, Op::Return))
      return calls_;
    if (op == Op::Set) return expressions_;
    if (op >= Op::Assign && op <= Op::EndDo) return statements_;
    if (is_one_of(Op::OpenOutput, Op::CloseOutput, Op::NameVariables)) return statements_;
    if (op == Op::Jump) return jumps_;
    if (op == Op::HCode) return h_codes_;
    if (op == Op::Print) return prints_;
    if (op == Op::Select) return selects_;
    if (op == Op::Fault) return faults_;
    return 0;
  }

  void move_block(Block& block) {
    block.line += of_.line;
    if (block.op != Op::Set) block.data += cells_;
    if (!is_words(block.op)) block.aux += record_base(block.op);
    if ((block.flags & Block::kListed) != 0)
      block.set_codes(of_.lists[block.list], block.g_count, block.m_count);
    if ((block.flags & (Block::kHasExtra | Block::kCodeExpression)) != 0) move_cells(block);
  }

  void move_cells(const Block& block) {
    Cell* cell = code_.cells.data() + block.data;
    std::uint32_t computed = 0;
    if ((block.flags & Block::kHasExtra) != 0) computed = cell++->extra.expressions;
    if ((block.flags & Block::kCodeExpression) != 0)
      for (int i = 0; i < block.code_cells(); ++i)
        if (cell[i].value < 0) cell[i].value -= expressions_;
    cell += block.code_cells();
    for (std::uint32_t left = computed; left != 0; left &= left - 1) {
      const std::uint32_t before = block.mask & ((left & -left) - 1);
      cell[std::popcount(before)].expression += expressions_;
    }
  }

  void move(Operand& operand) const {
    if (operand.kind == Operand::Kind::Expression) operand.expression += expressions_;
  }
  void move(Address& address) const {
    if (address != kNowhere) address += blocks_;
  }

  /// Move expressions, and the words of calls and jumps.
  void move_values() {
    for (std::size_t i = calls_; i < code_.calls.size(); ++i) {
      CallRecord& call = code_.calls[i];
      for (Operand* operand : {&call.p, &call.l}) move(*operand);
      if (CallExtras* extras = call.extras.find()) {
        for (Operand* operand : {&extras->start, &extras->device, &extras->name_text})
          move(*operand);
        for (ActualParameter& given : extras->given) move(given.operand);
      }
      call.first_argument += arguments_;
    }
    for (std::size_t i = arguments_; i < code_.arguments.size(); ++i)
      move(code_.arguments[i].operand);
    for (std::size_t i = jumps_; i < code_.jumps.size(); ++i) {
      move(code_.jumps[i].p);
      code_.jumps[i].input += expressions_;
    }
    for (std::size_t i = prints_; i < code_.prints.size(); ++i)
      for (PrintField& field : code_.prints[i].fields) field.expression += expressions_;
    for (std::size_t i = selects_; i < code_.selects.size(); ++i) {
      code_.selects[i].first += variants_;
      code_.selects[i].second += variants_;
    }
  }

  void move_statements() {
    const auto move_one = [this](Statement& statement) {
      statement.expression += expressions_;
      statement.variable += expressions_;
      statement.then += variants_;
      move(statement.to);
      move(statement.end);
    };
    for (std::size_t i = statements_; i < code_.statements.size(); ++i)
      move_one(code_.statements[i]);
    for (std::size_t i = h_codes_; i < code_.h_codes.size(); ++i) {
      HCode& code = code_.h_codes[i];
      move_one(code);
      for (Operand* operand : {&code.p, &code.q, &code.r}) move(*operand);
    }
  }

  void move_programs() {
    const auto file = size_of(code_.files) - (of_.goes_on ? 1 : 0);
    for (Program& program : of_.code.programs) {
      program.first += blocks_;
      program.last += blocks_;
      program.first_entry += entries_;
      program.last_entry += entries_;
      program.file += file;
      program.line += of_.line;
    }
  }

  Code& code_;
  Joined& of_;
  // The places where the tables of the part begin.
  std::uint32_t blocks_ = 0, variants_ = 0, cells_ = 0, expressions_ = 0, calls_ = 0, jumps_ = 0,
                arguments_ = 0, statements_ = 0, h_codes_ = 0, prints_ = 0, selects_ = 0,
                faults_ = 0, drops_ = 0, entries_ = 0;
};

/// Number each list of codes of the part in `code`. Return false where there are too many.
bool list_codes(Code& code, const Code& part, std::vector<int>& numbers) {
  const auto lists = part.code_lists.all();
  while (numbers.size() < lists.size()) {
    const int number = code.code_lists.keep(lists[numbers.size()]);
    if (number < 0) return false;
    numbers.push_back(number);
  }
  return true;
}

}  // namespace

/// The functions that reach into the builder.
struct Joint {
  static bool can_join(Builder& to, const Joined& of);
  static void join(Builder& to, Joined& of);
};

bool Joint::can_join(Builder& to, const Joined& of) {
  const Code& part = of.code;
  const bool own_names = !part.names.empty() || part.labels.size() > 1 || !part.o_words.empty() ||
                         !part.heads.empty() || !part.named_variables.empty() ||
                         part.returned >= 0 || part.texts.size() > 1 || !part.structures.empty() ||
                         !part.lists.empty();
  const bool looks_at_file = of.goes_on && !part.h_codes.empty();
  return !own_names && !looks_at_file && part.parallel_assigns.empty() &&
         list_codes(to.code_, part, of.lists);
}

void Joint::join(Builder& to, Joined& of) {
  Code& code = to.code_;
  Joining(code, of).join();
  to.in_program_ = std::exchange(of.from.in_program_, false);
  of.from.first_drop_ = 0;
  to.first_drop_ = code.drops.size();
  auto& programs = of.code.programs;
  auto first = programs.begin();
  if (of.goes_on) {
    const Program& rest = *first++;
    if (first != programs.end() || !to.in_program_) {
      Program& program = code.programs.back();
      program.text_end = rest.text_end;
      program.last = rest.last;
      program.last_entry = rest.last_entry;
      sort_numbers(code, program, to.interrupt_);
    }
  } else {
    std::move(of.code.files.begin(), of.code.files.end(), std::back_inserter(code.files));
    of.code.files.clear();
  }
  code.programs.insert(code.programs.end(), first, programs.end());
  programs.clear();
}

bool can_join(Builder& to, const Joined& of) { return Joint::can_join(to, of); }
void join(Builder& to, Joined& of) { Joint::join(to, of); }

}  // namespace cncsub
