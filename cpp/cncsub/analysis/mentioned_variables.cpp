// The variables that the text of a block names.
#include <algorithm>
#include <span>

#include "cncsub/analysis/mention_reader.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// Return a name as variables are told apart: in capitals, without blanks.
std::string told_apart(std::string_view name) {
  std::string told;
  for (const char c : name)
    if (!is_blank(c)) told += upper(c);
  return told;
}

template <class List>
bool has(const List& list, std::string_view name) {
  return std::any_of(list.begin(), list.end(),
                     [&](const DefinedVariable& of) { return same_letters(of.name, name); });
}

std::span<const DefinedVariable> defined_by(const Code& code, const Program& program) {
  return {code.defined_variables.data() + program.first_defined, program.defined};
}

/// Return the call of a block that may set locals of the program it calls; null if there is none.
const CallRecord* handing_over(const Code& code, const Block& block) {
  if (block.op == Op::MacroCall || block.op == Op::ModalCall) return &code.calls[block.aux];
  const std::uint32_t call = block.op == Op::OWord ? code.o_words[block.aux].call : OWord::kNone;
  return call == OWord::kNone ? nullptr : &code.calls[call];
}

}  // namespace

bool MentionReader::is_defined(std::string_view name) const {
  return has(defined_by(code_, own()), name) || has(code_.shared_variables, name);
}

void MentionReader::variable(const NamePiece& piece, std::string_view text, std::uint32_t at) {
  const auto added = [&](bool common) -> Mention& {
    Mention& mention = add(Mention::Kind::Variable, {at + piece.name_at, piece.name_width});
    mention.to_program = common ? kNoProgram : program_;
    return mention;
  };
  if (piece.kind == NamePiece::Kind::Number) {
    if (piece.number != 0) added(!code_.place(piece.number).is_local()).number = piece.number;
    return;
  }
  const std::string name = told_apart(piece.name_in(text));
  if (piece.kind == NamePiece::Kind::Variable) {
    const auto named =
        std::find_if(code_.named_variables.begin(), code_.named_variables.end(),
                     [&](const NamedVariable& of) { return same_letters(of.name, name); });
    const bool own_name = named != code_.named_variables.end();
    const bool known =
        own_name || std::any_of(code_.names.begin(), code_.names.end(),
                                [&](const std::string& of) { return same_letters(of, name); });
    Mention& mention = added(!own_name || named->common);
    mention.name = name;
    mention.fixed = !known;  // one of the control
    return;
  }
  if (has(defined_by(code_, own()), name))
    added(false).name = name;
  else if (has(code_.shared_variables, name))
    added(true).name = name;
}

/// Add the locals that the arguments of a macro call set: their letters, or their places,
/// stand for their numbers.
void MentionReader::arguments(const Block& block, const References& references) {
  each_variant(code_, block, [&](const Block& of) {
    const CallRecord* call = handing_over(code_, of);
    for (std::uint32_t i = 0; call != nullptr && i < call->arguments; ++i) {
      const Argument& argument = code_.arguments[call->first_argument + i];
      Mention& mention =
          add(Mention::Kind::Variable, {argument.operand.at, argument.operand.width});
      mention.fixed = true;
      mention.number = argument.variable;
      const CallReference* to = references.calls.empty() ? nullptr : &references.calls.front();
      mention.computed = to == nullptr || to->found == kNoProgram;
      mention.to_program = to == nullptr ? kNoProgram : to->found;
    }
  });
}

/// Return whether a block may name the variable that is asked for: by its sign, or by the letter of
/// an argument.
bool MentionReader::may_name_variable(const Block& block, std::string_view text) const {
  if (!asked_.named || asked_.named->number < 0 || code_.spelling->variable != "#") return true;
  if (text.find_first_of("#@") != std::string_view::npos) return true;
  bool hands_over = false;
  each_variant(code_, block, [&](const Block& of) {
    hands_over = hands_over || handing_over(code_, of) != nullptr;
  });
  return hands_over;
}

void MentionReader::variables(const Block& block) {
  const std::string_view whole = code_.text_of(block, own());
  if (!may_name_variable(block, whole)) return;
  const std::vector<NamePiece> pieces = name_pieces(*code_.spelling, whole);
  const bool names_them = block.op == Op::NameVariables;  // N10 SETVN 500[ABC, DEF]
  const std::size_t list = names_them ? whole.find('[') : 0;
  for (const NamePiece& piece : pieces) {
    if (!names_them) {
      variable(piece, whole, block.text);
    } else if (piece.at > list) {
      Mention& mention =
          add(Mention::Kind::Variable, {block.text + piece.name_at, piece.name_width});
      mention.name = told_apart(piece.name_in(whole));
      mention.defines = true;
    }
  }
  const References references = references_of(code_, block, program_);
  arguments(block, references);
  for (const auto* list : {&references.reads, &references.writes}) {
    for (const VariableReference& of : *list) {
      if (of.computed) computed(Mention::Kind::Variable, of.place, kNoProgram);
      // In a comment that prints, where no piece was found.
      const std::uint32_t from = of.place.at - block.text, to = from + of.place.width;
      const bool known = std::any_of(pieces.begin(), pieces.end(), [&](const NamePiece& piece) {
        return piece.at < to && piece.at + piece.width > from;
      });
      if (known || of.place.at < block.text || from >= whole.size()) continue;
      const std::string_view inside = whole.substr(from, of.place.width);
      for (const NamePiece& piece : name_pieces(*code_.spelling, inside))
        variable(piece, inside, of.place.at);
    }
  }
}

}  // namespace cncsub
