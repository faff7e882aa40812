// Values that people trip over.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr std::uint32_t kLengths = bit('X') | bit('Y') | bit('Z') | bit('U') | bit('V') | bit('W');
constexpr double kFewIncrements = 1000;

/// The lengths of a block that are written with a point, and those without one that are small.
struct Points {
  std::uint32_t with = 0, without = 0;
};

Points points_of(const Code& code, const Block& block) {
  const std::uint32_t lengths = block.mask & kLengths;
  if (lengths == 0) return {};
  if ((block.flags & Block::kHasExtra) == 0) return {lengths, 0};
  const auto extra = code.cells[block.data].extra;
  Points points{lengths & ~extra.whole & ~extra.expressions, 0};
  const Cell* cell = code.cells.data() + block.data + 1 + block.code_cells();
  for (std::uint32_t left = block.mask; left != 0; left &= left - 1, ++cell) {
    const std::uint32_t address = left & ~(left - 1);
    if ((address & lengths & extra.whole & ~extra.expressions) == 0) continue;
    if (cell->value != 0 && std::fabs(cell->value) < kFewIncrements) points.without |= address;
  }
  return points;
}

void check_points(Checker& c, const ProgramFlow& flow) {
  if (c.code.control->reading.whole_numbers.value != WholeNumbers::Increments) return;
  bool points = false;
  std::vector<Address> without;
  for (Address at = flow.first(); at < flow.last(); ++at) {
    const Points of = points_of(c.code, c.code.blocks[at]);
    points = points || of.with != 0;
    if (of.without != 0) without.push_back(at);
  }
  if (!points) return;
  const Program& program = c.program(flow.program());
  for (const Address at : without) {
    const Block& block = c.code.blocks[at];
    const std::uint32_t addresses = points_of(c.code, block).without;
    for (const WrittenWord& word : c.code.words_of(block, program)) {
      const bool meant = word.address.size() == 1 && word.address[0] >= 'A' &&
                         word.address[0] <= 'Z' && (addresses & bit(word.address[0])) != 0;
      if (meant)
        c.found(Check::NoPoint, at,
                {static_cast<std::uint32_t>(block.text + word.at),
                 static_cast<std::uint32_t>(word.width)},
                "it counts increments of the control, a thousandth of a millimetre or less");
    }
  }
}

void check_call(Checker& c, Address at, const CallRecord& record) {
  const auto constant = [](const Operand& of) { return of.kind == Operand::Kind::Constant; };
  if (constant(record.l) && record.l.value == 0 &&
      c.code.control->calls.zero_repeats.value != ZeroRepeats::Alarm)
    c.found(Check::NoRepeats, at, {record.l.at, record.l.width},
            c.code.control->calls.zero_repeats.value == ZeroRepeats::Skip
                ? "the call is passed over"
                : "the control calls once");
  if (!record.constant || record.kind != CallKind::Subprogram || !constant(record.p)) return;
  const auto whole = to_whole<std::int64_t>(record.p.value);
  if (record.target.program_number < 0 || record.target.program_number == whole) return;
  if (c.code.find(whole) == kNoProgram) return;
  c.found(
      Check::CountInP, at, {record.p.at, record.p.width},
      "it calls O" + std::to_string(record.target.program_number) + ", " +
          (record.target.repeats == 1 ? "once" : std::to_string(record.target.repeats) + " times") +
          ", while O" + std::to_string(whole) + " exists");
}

void check_drops(Checker& c, Address at, const Block& block) {
  if ((block.flags & Block::kDrops) == 0) return;
  auto drop = std::lower_bound(c.code.drops.begin(), c.code.drops.end(), block.data,
                               [](const Drop& of, std::uint32_t data) { return of.data < data; });
  for (; drop != c.code.drops.end() && drop->data == block.data; ++drop)
    c.found(Check::Dropped, at, {drop->at, drop->width}, "the control does not obey it");
}

bool is_logic(std::string_view name) { return name == "AND" || name == "OR" || name == "XOR"; }
bool is_operator(std::string_view name) {
  for (const std::string_view of : {"EQ", "NE", "GT", "LT", "GE", "LE", "MOD"})
    if (name == of) return true;
  return false;
}

/// The operations of an expression by its brackets.
class Operations {
 public:
  /// Whether a logic operation stands beside another one in the same brackets.
  bool mixed(std::string_view text);

 private:
  struct Level {
    bool logic = false, other = false;
    bool mixed() const { return logic && other; }
  };
  /// Takes one sign; false where brackets end that hold both kinds.
  bool take(char sign);
  void take_name(std::string_view written);

  std::vector<Level> levels_{1};
  bool value_ = false;  // behind one, where a sign is an operation
};

bool Operations::take(char sign) {
  const bool operation = sign == '+' || sign == '-' || sign == '*' || sign == '/';
  if (sign == '[') levels_.emplace_back();
  if (operation && value_) levels_.back().other = true;
  if (sign == ']') {
    if (levels_.back().mixed()) return false;
    if (levels_.size() > 1) levels_.pop_back();
  }
  if (!is_blank(sign)) value_ = !operation && sign != '[';
  return true;
}

void Operations::take_name(std::string_view written) {
  std::string name;
  for (const char letter : written) name += upper(letter);
  levels_.back().logic = levels_.back().logic || is_logic(name);
  levels_.back().other = levels_.back().other || is_operator(name);
  value_ = false;
}

bool Operations::mixed(std::string_view text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (!is_letter(text[i])) {
      if (!take(text[i])) return true;
      continue;
    }
    std::size_t end = i;
    while (end < text.size() && is_letter(text[end])) ++end;
    take_name(text.substr(i, end - i));
    i = end - 1;
  }
  return levels_.back().mixed();
}

const char* read_as(LogicOrder order) {
  switch (order) {
    case LogicOrder::Last:
      return "here logic comes after comparisons and arithmetic";
    case LogicOrder::LastOfConditions:
      return "here logic of conditions comes last, that of numbers as in arithmetic";
    default:
      return "here AND comes where * does, OR and XOR where + does, before any comparison";
  }
}

void check_logic(Checker& c, Address at, const Block& block, std::string_view text) {
  switch (block.op) {
    case Op::Assign:
    case Op::IfGoto:
    case Op::IfThen:
    case Op::If:
    case Op::While:
      break;
    default:
      return;
  }
  const Expression& of = c.code.expressions[c.code.statements[block.aux].expression];
  bool logic = false;
  for (const Instruction* ins = c.code.instructions.data() + of.first; ins->op != Ins::End; ++ins)
    logic = logic || ins->op == Ins::And || ins->op == Ins::Or || ins->op == Ins::Xor;
  if (logic && Operations().mixed(text.substr(of.at, of.width)))
    c.found(Check::LogicOrder, at, {of.at, of.width},
            read_as(c.code.control->macros.logic_order.value));
}

/// G99 as the last block of a program that nothing else ends.
void check_last(Checker& c, const ProgramFlow& flow) {
  if (flow.last() == flow.first() || flow.ever_returns() || flow.program() == c.main) return;
  constexpr int kG99 = 990;
  const Block& block = c.code.blocks[flow.last() - 1];
  bool g99 = false;
  each_g(c.code, block, [&](int g) { g99 = block.g_count == 1 && g == kG99; });
  if (g99 && block.op == Op::Words && (block.mask & ~bit('P')) == 0 && block.m_count == 0)
    c.found(Check::G99ForM99, flow.last() - 1, {block.text, block.length}, "");
}

}  // namespace

void check_values(Checker& c) {
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow)) continue;
    const std::string& text = c.code.files[c.program(flow.program()).file].text;
    check_points(c, flow);
    check_last(c, flow);
    for (Address at = flow.first(); at < flow.last(); ++at)
      each_variant(c.code, c.code.blocks[at], [&](const Block& block) {
        check_drops(c, at, block);
        check_logic(c, at, block, text);
        if (block.op == Op::Call || block.op == Op::MacroCall || block.op == Op::ModalCall)
          check_call(c, at, c.code.calls[block.aux]);
      });
  }
}

}  // namespace cncsub
