#include "cncsub/code/references.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>

#include "cncsub/code/own_locals.hpp"
#include "cncsub/code/target.hpp"
#include "cncsub/code/variables_used.hpp"

namespace cncsub {

namespace {

class ReferenceReader {
 public:
  ReferenceReader(const Code& code, std::int32_t program, References& to)
      : code_(code), program_(program), to_(to), used_(code, to) {}

  void read(const Block& block, bool conditional);

 private:
  const Program& own() const { return code_.programs[static_cast<std::size_t>(program_)]; }
  TextPlace place_of(std::uint32_t expression) const { return used_.place_of(expression); }
  static TextPlace place_of(const Operand& operand) { return {operand.at, operand.width}; }

  void call(const CallRecord& call);
  void part(const CallRecord& call);
  void places_of(const CallRecord& call, CallRecord& known, CallReference& reference) const;
  void target_of(const CallRecord& call, CallReference& reference);
  void o_word(const OWord& own);
  void label_of(const OWord& own, CallReference& reference) const;
  void back(const CallRecord& back, bool conditional);
  void back_by_name(const CallExtras& to, bool conditional);
  void jump(const JumpRecord& record);
  void statement(Op op, const Statement& statement, bool conditional);
  void go_to(const Statement& statement, bool conditional);
  void h_code(const HCode& h);
  void print(const Print& print);
  void parallel_assign(const ParallelAssign& all, bool conditional);
  void select(const Select& variant);
  void alternatives(const Statement& choice);

  void operands(const CallRecord& call);

  const Code& code_;
  std::int32_t program_;
  References& to_;
  VariablesUsed used_;
};

// ---- calls ----

void ReferenceReader::operands(const CallRecord& call) {
  for (const Operand* of : {&call.p, &call.l, &call.start(), &call.device()}) used_.operand(*of);
  for (std::uint32_t i = 0; i < call.arguments; ++i)
    used_.operand(code_.arguments[call.first_argument + i].operand);
  used_.operand(call.name_text());
  for (const PassedReference& of : call.references())
    if (!of.copied) used_.written(of.variable);
}

/// Fill in where the operands stand, and which of them are computed: those are left out of `known`.
void ReferenceReader::places_of(const CallRecord& call, CallRecord& known,
                                CallReference& reference) const {
  const auto computed = [this](Operand& of, std::optional<TextPlace>& place) {
    if (of.kind != Operand::Kind::Expression) return;
    place = place_of(of.expression);
    of = Operand{};
  };
  computed(known.l, reference.computed_repeats);
  if (CallExtras* extras = known.extras.find()) computed(extras->start, reference.computed_start);
  computed(known.p, reference.computed_program);
  if (call.name_text().present()) reference.computed_program = place_of(call.name_text());
  reference.by_name = !call.name().empty();
  if (reference.by_name)
    reference.program_place = TextPlace{call.extras.get().name_at, call.extras.get().name_width};
  else if (call.p.present() && call.program_number < 0)
    reference.program_place = place_of(call.p);
  else if (call.kind == CallKind::OWord)
    reference.program_place = reference.place;
  if (call.start().present()) reference.start_place = place_of(call.start());
  if (reference.computed_program) known.program_number = 0;
}

/// Fill in what the operands say that are written as numbers; the others are computed.
void ReferenceReader::target_of(const CallRecord& call, CallReference& reference) {
  CallRecord known = call;
  places_of(call, known, reference);
  Target target;
  const CallOperands values{known.p.value, known.l.value, known.start().value,
                            known.device().value};
  if (call.kind == CallKind::OWord)
    target = call.target;  // the reader has found the label
  else if (decode_call(code_, known, values, program_, target))
    return;
  const bool found = !reference.computed_program &&
                     !find_target(code_, known, target, known_search(code_, program_));
  reference.external = target.external;
  reference.start = target.start_n;
  reference.block_in_p = call.p.present() && call.name().empty() && target.program == program_ &&
                         target.program_number < 0 && call.program_number < 0;
  reference.repeats = target.skipped ? 0 : target.repeats;
  if (target.program != kNoProgram && (found || !reference.computed_program)) {
    reference.found = target.program;
    reference.program = code_.name_of(target.program);
  } else if (!reference.computed_program) {
    reference.program =
        call.name().empty() ? "O" + std::to_string(target.program_number) : call.name();
  }
}

void ReferenceReader::call(const CallRecord& call) {
  CallReference reference;
  reference.kind = call.kind;
  reference.own_locals = has_own_numbers(call, *code_.control);
  reference.place = {call.at, call.width};
  target_of(call, reference);
  to_.calls.push_back(std::move(reference));
  operands(call);
}

/// List a part of the own program that is executed as a call.
void ReferenceReader::part(const CallRecord& call) {
  CallReference reference;
  reference.kind = call.kind;
  reference.place = {call.at, call.width};
  reference.found = call.target.program;
  const CallExtras& named = call.extras.get();
  for (const Operand* of : {&named.first_text, &named.last_text}) used_.operand(*of);
  if (call.name_text().present()) reference.computed_program = place_of(call.name_text());
  if (reference.found == kNoProgram && !reference.computed_program) {
    reference.found = find_called(code_, call.name(), named.path, known_search(code_, program_));
    reference.program = call.name();
  }
  if (reference.found != kNoProgram) reference.program = code_.name_of(reference.found);
  if (call.l.kind == Operand::Kind::Expression)
    reference.computed_repeats = place_of(call.l.expression);
  else if (call.l.present())
    reference.repeats = to_whole<std::int64_t>(std::clamp(call.l.value, 0.0, 1e9));
  to_.calls.push_back(std::move(reference));
  operands(call);
}

/// Find where a label leads that is known before anything runs: a head, or the file of its name.
void ReferenceReader::label_of(const OWord& own, CallReference& reference) const {
  const CallRecord& call = code_.calls[own.call];
  std::uint32_t label = own.label;
  reference.program = label == OWord::kNone ? "" : code_.labels[label];
  if (label == OWord::kNone) {
    if (call.p.kind == Operand::Kind::Expression) {
      reference.computed_program = place_of(call.p.expression);
      return;
    }
    const auto number = to_whole<std::int64_t>(std::clamp(call.p.value, 0.0, 1e9));
    label = code_.label(number);
    reference.program = std::to_string(number);
  }
  const auto head =
      std::lower_bound(code_.heads.begin(), code_.heads.end(), label,
                       [](const LabelledHead& of, std::uint32_t own) { return of.label < own; });
  if (label != OWord::kNone && head != code_.heads.end() && head->label == label)
    reference.found = code_.program_at(head->address);
  else
    reference.found = code_.find(reference.program);
  if (reference.found != kNoProgram) reference.program = code_.name_of(reference.found);
}

void ReferenceReader::o_word(const OWord& own) {
  if (own.value != OWord::kNone) used_.reads(own.value);
  if (own.kind != OWordKind::Call && own.kind != OWordKind::Call98) return;
  const CallRecord& call = code_.calls[own.call];
  CallReference reference;
  reference.kind = call.kind;
  reference.own_locals = has_own_numbers(call, *code_.control);
  reference.place = {own.at, own.width};
  reference.by_name = own.label != OWord::kNone;
  reference.program_place = reference.by_name ? reference.place : place_of(call.p);
  label_of(own, reference);
  if (call.l.kind == Operand::Kind::Expression)
    reference.computed_repeats = place_of(call.l.expression);
  else if (call.l.present())
    reference.repeats = to_whole<std::int64_t>(std::clamp(call.l.value, 0.0, 1e9));
  to_.calls.push_back(std::move(reference));
  operands(call);
}

// ---- jumps ----

/// List the jump of RET("N10").
void ReferenceReader::back_by_name(const CallExtras& to, bool conditional) {
  JumpReference jump;
  jump.kind = "RET";
  jump.conditional = conditional;
  jump.in_caller = true;
  jump.place = {to.name_at, to.name_width};
  used_.operand(to.name_text);
  if (to.name_text.present()) jump.computed = place_of(to.name_text.expression);
  if (to.name.size() > 1 && to.name[0] == 'N')
    std::from_chars(to.name.data() + 1, to.name.data() + to.name.size(), jump.n);
  to_.jumps.push_back(jump);
}

/// List the jump of M99 P.
void ReferenceReader::back(const CallRecord& back, bool conditional) {
  const CallExtras& to = back.extras.get();
  for (const Operand* of : {&back.p, &back.l, &to.after, &to.levels}) used_.operand(*of);
  if (!to.name.empty() || (to.by_values && to.name_text.present()))
    return back_by_name(to, conditional);
  if (!back.p.present()) return;
  JumpReference jump;
  jump.kind = "M99";
  jump.conditional = conditional;
  jump.in_caller = code_.control->calls.return_with_p.value != ReturnWithP::OwnProgram;
  jump.place = place_of(back.p);
  if (back.p.kind == Operand::Kind::Expression)
    jump.computed = place_of(back.p.expression);
  else
    jump.n = to_whole<std::int64_t>(back.p.value);
  if (!jump.in_caller && jump.n >= 0) jump.to = code_.first_of(own(), jump.n);
  to_.jumps.push_back(jump);
}

/// List the jump of M97 P, or of M96 P Q while an input is 0.
void ReferenceReader::jump(const JumpRecord& record) {
  used_.operand(record.p);
  if (record.reads_input) used_.reads(record.input);
  JumpReference jump;
  jump.kind = record.reads_input ? "M96" : "M97";
  jump.conditional = record.reads_input;
  jump.place = {record.at, record.width};
  if (record.p.kind == Operand::Kind::Expression)
    jump.computed = place_of(record.p.expression);
  else
    jump.n = to_whole<std::int64_t>(record.p.value);
  if (jump.n >= 0) jump.to = code_.first_of(own(), jump.n);
  to_.jumps.push_back(jump);
}

void ReferenceReader::go_to(const Statement& statement, bool conditional) {
  JumpReference jump;
  jump.kind = "GOTO";
  jump.conditional = conditional;
  jump.n = statement.number > 0 ? statement.number : -1;  // 0: a label
  jump.to = statement.to;
  jump.place = {statement.variable_at, statement.variable_width};
  if (jump.n < 0 && jump.to == kNowhere) {
    used_.reads(statement.variable);
    jump.computed = place_of(statement.variable);
  }
  to_.jumps.push_back(jump);
}

/// List what G65 H refers to. P is the variable that is set, from H80 on the block it jumps to, and
/// the alarm of H99; Q and R are values.
void ReferenceReader::h_code(const HCode& h) {
  constexpr int kJumpAlways = 80, kAlarm = 99;
  const bool jumps = h.number >= kJumpAlways && h.number != kAlarm;
  used_.operand(h.q);
  used_.operand(h.r);
  if (jumps || h.number == kAlarm) used_.operand(h.p);
  if (jumps) {
    JumpReference jump;
    jump.kind = "G65";
    jump.conditional = h.number > kJumpAlways;
    jump.place = place_of(h.p);
    if (h.p.kind == Operand::Kind::Expression)
      jump.computed = place_of(h.p.expression);
    else
      jump.n = to_whole<std::int64_t>(h.p.value);
    if (h.p.present()) to_.jumps.push_back(jump);
  } else if (h.number != kAlarm && h.p.kind == Operand::Kind::Expression) {
    used_.named_by(h.p);
  }
}

// ---- statements ----

void ReferenceReader::print(const Print& print) {
  for (const PrintField& field : print.fields)
    if (field.is_variable) used_.reads(field.expression);
  if (print.last_number != 0) used_.reads(print.number);
}

void ReferenceReader::statement(Op op, const Statement& statement, bool conditional) {
  switch (op) {
    case Op::Assign:
      used_.reads(statement.expression);
      used_.written(statement);
      break;
    case Op::Goto:
    case Op::IfGoto:
      if (op == Op::IfGoto) used_.reads(statement.expression);
      go_to(statement, conditional || op == Op::IfGoto);
      break;
    case Op::If:
    case Op::While:
      used_.reads(statement.expression);
      break;
    case Op::IfThen:
      used_.reads(statement.expression);
      read(code_.variants[statement.then], true);
      break;
    case Op::For:
      used_.reads(statement.expression);
      used_.reads(code_.statements[statement.then].expression);
      used_.written(code_.statements[statement.then]);
      break;
    case Op::Switch:
      alternatives(statement);
      break;
    default:
      break;
  }
}

void ReferenceReader::parallel_assign(const ParallelAssign& all, bool conditional) {
  for (std::uint32_t i = 0; i < all.statements; ++i)
    statement(Op::Assign, code_.statements[all.first_statement + i], conditional);
  if (all.print != OWord::kNone) print(code_.prints[all.print]);
  if (all.words != OWord::kNone) read(code_.variants[all.words], conditional);
}

void ReferenceReader::alternatives(const Statement& choice) {
  if (choice.index == Statement::kHasValue) used_.reads(choice.expression);
  for (const Statement& of : alternatives_of(choice)) {
    if (of.index != Statement::kAlways) used_.reads(of.expression);
    read(code_.variants[of.then], true);
  }
}

void ReferenceReader::select(const Select& variant) {
  read(code_.variants[variant.first], true);
  read(code_.variants[variant.second], true);
}

void ReferenceReader::read(const Block& block, bool conditional) {
  used_.words(block);
  switch (block.op) {
    case Op::Call:
    case Op::MacroCall:
    case Op::ModalCall:
      return call(code_.calls[block.aux]);
    case Op::RepeatPart:
      return part(code_.calls[block.aux]);
    case Op::Return:
      return back(code_.calls[block.aux], conditional);
    case Op::Jump:
      return jump(code_.jumps[block.aux]);
    case Op::Set:
    case Op::Assign:
      return statement(Op::Assign, assignment_of(code_, block), conditional);
    case Op::Goto:
    case Op::IfGoto:
    case Op::IfThen:
    case Op::Switch:
    case Op::If:
    case Op::While:
    case Op::For:
      return statement(block.op, code_.statements[block.aux], conditional);
    case Op::HCode:
      return h_code(code_.h_codes[block.aux]);
    case Op::Print:
      return print(code_.prints[block.aux]);
    case Op::OWord:
      return o_word(code_.o_words[block.aux]);
    case Op::ParallelAssign:
      return parallel_assign(code_.parallel_assigns[block.aux], conditional);
    case Op::Select:
      return select(code_.selects[block.aux]);
    default:
      return;
  }
}

/// Drop references that are listed twice: both variants of a block have them, or a word and the
/// call that it belongs to.
void drop_twins(References& of_block) {
  const auto once = [](auto& list, const auto& key) {
    std::set<decltype(key(list[0]))> seen;
    std::erase_if(list, [&](const auto& of) { return !seen.insert(key(of)).second; });
  };
  once(of_block.calls, [](const CallReference& of) { return std::tuple(of.kind, of.place.at); });
  once(of_block.jumps, [](const JumpReference& of) { return std::tuple(of.kind, of.place.at); });
  const auto variable = [](const VariableReference& of) {
    return std::tuple(of.number, of.name, of.computed, of.place.at);
  };
  once(of_block.reads, variable);
  once(of_block.writes, variable);
}

}  // namespace

References references_of(const Code& code, const Block& block, std::int32_t program) {
  References found;
  ReferenceReader(code, program, found).read(block, false);
  drop_twins(found);
  return found;
}

}  // namespace cncsub
