// The programs and the labels that blocks and heads name.
#include <algorithm>

#include "cncsub/analysis/mention_reader.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

void MentionReader::call(const CallReference& call) {
  if (asked_.blocks) start_of(call);
  if (!asked_.programs) return;
  if (call.computed_program)
    return computed(Mention::Kind::Program, *call.computed_program, kNoProgram);
  if (call.block_in_p || call.program.empty()) return;
  const std::int64_t n = number_in(call.program);
  const bool by_name = n < 0 || call.by_name;
  Mention& mention = add(Mention::Kind::Program, call.program_place.value_or(call.place));
  mention.to_program = call.found;
  mention.number = by_name ? -1 : n;
  mention.name = call.program;
  std::optional<TextPlace> place;
  if (call.program_place)
    place = !by_name                       ? program_digits(*call.program_place, n)
            : call.kind == CallKind::OWord ? label_in(*call.program_place, call.program)
                                           : last_in(*call.program_place, bare(call.program));
  mention.fixed = !place;
  if (place) mention.place = *place;
}

/// Add the block at which a call begins, if it names one.
void MentionReader::start_of(const CallReference& call) {
  if (call.computed_start)
    computed(Mention::Kind::Number, *call.computed_start,
             call.computed_program ? kNoProgram : call.found);
  const auto place = call.start_place ? call.start_place : call.program_place;
  if (call.start < 0 || !place || (!call.start_place && !call.block_in_p)) return;
  if (call.computed_program) return computed(Mention::Kind::Number, *place, kNoProgram);
  Mention& mention = number(*place, call.start);
  mention.to_program = call.found;
  if (call.found != kNoProgram)
    mention.to = code_.first_of(code_.programs[static_cast<std::size_t>(call.found)], call.start);
}

/// Return the digits of a program's number: the last four where a count stands before them.
std::optional<TextPlace> MentionReader::program_digits(TextPlace place, std::int64_t n) const {
  if (const auto digits = digits_in(text(), place, n)) return digits;
  constexpr std::uint32_t kOfNumber = 4;
  const std::string_view written = trimmed(text().substr(place.at, place.width));
  const auto behind = place.at + static_cast<std::uint32_t>(written.size());
  if (written.size() <= kOfNumber) return std::nullopt;
  const auto digits = digits_in(text(), {behind - kOfNumber, kOfNumber}, n);
  return digits && digits->width == kOfNumber ? digits : std::nullopt;
}

/// Return the last place of a name in a text that holds it, such as the path of a program.
std::optional<TextPlace> MentionReader::last_in(TextPlace place, std::string_view name) const {
  const std::string_view written = text().substr(place.at, place.width);
  if (name.empty() || name.size() > written.size()) return std::nullopt;
  for (std::size_t from = written.size() - name.size() + 1; from-- > 0;)
    if (same_letters(written.substr(from, name.size()), name))
      return TextPlace{place.at + static_cast<std::uint32_t>(from),
                       static_cast<std::uint32_t>(name.size())};
  return std::nullopt;
}

/// Return the place of the label of a statement: o100 while, o<abc> call.
std::optional<TextPlace> MentionReader::label_in(TextPlace place, std::string_view label) const {
  const std::string_view written = text().substr(place.at, place.width);
  std::size_t from = 1;  // after the letter
  while (from < written.size() && (is_blank(written[from]) || written[from] == '<')) ++from;
  if (label.empty() || !same_letters(written.substr(from, label.size()), label))
    return std::nullopt;
  return TextPlace{place.at + static_cast<std::uint32_t>(from),
                   static_cast<std::uint32_t>(label.size())};
}

std::string_view MentionReader::bare(std::string_view name) const {
  return code_.spelling->bare_name(name);
}

/// Add the names of programs in a statement that nothing else mentions, such as PROC SUB(REAL A).
void MentionReader::declared(const Block& block) {
  const std::string_view whole = code_.text_of(block, own());
  std::size_t from = 0;
  while (const auto word = code_.read_word(whole, from)) {
    if (!word->address.empty()) continue;
    const std::string_view statement = whole.substr(word->at, word->width);
    for (const NamePiece& piece : name_pieces(*code_.spelling, statement)) {
      const std::string_view name = piece.name_in(statement);
      const std::uint32_t at = block.text + word->at + piece.name_at;
      const std::int32_t found =
          name.size() > 1 && piece.kind == NamePiece::Kind::Name ? code_.find(name) : kNoProgram;
      const auto others = std::find_if(found_.rbegin(), found_.rend(), [&](const Mention& of) {
        return of.block != at_ || of.place.at == at;
      });
      const bool known = others != found_.rend() && others->block == at_;
      if (found == kNoProgram || known || is_defined(name)) continue;
      Mention& mention = add(Mention::Kind::Program, {at, piece.name_width});
      mention.name = code_.name_of(found);
      mention.to_program = found;
    }
  }
}

/// Add the head of a program: the text, or the file, that gives its name.
void MentionReader::head() {
  if (!asked_.programs) return;
  const Program& program = own();
  at_ = kNowhere;
  const bool of_file = program.name_length == Program::kOfFile;
  Mention& mention =
      add(Mention::Kind::Program,
          of_file ? TextPlace{program.text, 0} : TextPlace{program.name_at, program.name_length});
  mention.defines = true;
  mention.fixed = of_file;
  mention.number = program.number;
  mention.name = code_.name_of(program);
  mention.to_program = program_;
}

// ---- labels ----

/// Add the label of a block, which stands before its other words.
void MentionReader::label_of(Address at) {
  const auto from =
      std::lower_bound(labelled_.begin(), labelled_.end(), std::pair(at, std::uint32_t{0}));
  for (auto each = from; each != labelled_.end() && each->first == at; ++each) {
    const Block& block = code_.blocks[at];
    const std::string_view whole = code_.text_of(block, own());
    for (const NamePiece& piece : name_pieces(*code_.spelling, whole)) {
      if (!same_letters(piece.name_in(whole), code_.labels[each->second])) continue;
      Mention& mention = add(Mention::Kind::Label, {block.text + piece.name_at, piece.name_width});
      mention.name = code_.labels[each->second];
      mention.defines = true;
      mention.to_program = program_;
      mention.to = at;
      break;
    }
  }
}

/// Add the label of a statement that labels tell apart: it is the name of a subprogram, or has a
/// meaning in its own program alone.
void MentionReader::o_word(const OWord& own_word) {
  if (own_word.label == OWord::kNone) return;
  const std::string& label = code_.labels[own_word.label];
  const bool of_program = own_word.kind <= OWordKind::Call98;
  if (own_word.kind == OWordKind::Call || own_word.kind == OWordKind::Call98) return;
  if (of_program ? !asked_.programs : !asked_.blocks) return;
  const auto place = label_in({own_word.at, own_word.width}, label);
  Mention& mention = add(of_program ? Mention::Kind::Program : Mention::Kind::Label,
                         place.value_or(TextPlace{own_word.at, own_word.width}));
  mention.fixed = !place;
  mention.name = label;
  mention.number = of_program ? number_in(label) : -1;
  mention.to_program = program_;
}

}  // namespace cncsub
