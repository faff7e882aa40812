#include "cncsub/code/code.hpp"

#include <algorithm>

#include "cncsub/text/scan.hpp"

namespace cncsub {

void list_statements(Code& code) {
  code.lacking.set();
  for (const auto& [kind, unsure] : code.control->macros.statements.value) {
    code.unheard_of.set(static_cast<std::size_t>(kind), unsure);
    code.lacking.set(static_cast<std::size_t>(kind), unsure);
  }
}

Fault Code::lacking_fault(StatementKind kind, std::uint32_t at) const {
  const std::string name(cncsub::name_of(kind));
  if (unheard_of.test(static_cast<std::size_t>(kind)))
    return {Cause::StatementNotKnown, at, 1, "no source says whether this control has " + name};
  return {Cause::StatementNotAvailable, at, 1, "this control has no " + name};
}

namespace {

VariablePlace placed(const PlacedRange& of, std::int64_t number) {
  const auto& [range, base] = of;
  const auto offset = static_cast<std::int32_t>(number) - range.first;
  const bool common = range.kind == VariableKind::Common || range.kind == VariableKind::Kept;
  const std::int32_t index = range.kind == VariableKind::Local ? static_cast<std::int32_t>(number)
                             : common                          ? base + offset
                                                               : offset + range.from;
  return {range.kind, index, &range};
}

}  // namespace

VariablePlace Code::place(std::int64_t number) const {
  // Tries the first ranges one by one: locals and commons stand there, and programs use them most.
  auto from = variables.begin();
  for (int i = 0; i < 4 && from != variables.end() && from->range.first <= number; ++i) {
    if (number <= from->range.last) break;
    ++from;
  }
  if (from != variables.end() && number >= from->range.first && number <= from->range.last)
    return placed(*from, number);
  const auto behind = std::upper_bound(
      from, variables.end(), number,
      [](std::int64_t n, const PlacedRange& placed) { return n < placed.range.first; });
  if (behind == variables.begin()) return {};
  if (number > behind[-1].range.last) return {};
  return placed(behind[-1], number);
}

bool Code::can_name(std::int64_t number, std::int64_t last) const {
  if (number >= 1 && number <= last) return true;
  const VariablePlace found = place(number);
  return found.range != nullptr &&
         (found.kind == VariableKind::Common || found.kind == VariableKind::Kept);
}

std::int32_t Code::program_at(Address address) const {
  const auto behind =
      std::upper_bound(programs.begin(), programs.end(), address,
                       [](Address a, const Program& program) { return a < program.first; });
  auto at = static_cast<std::int32_t>(behind - programs.begin()) - 1;
  while (at > 0 && programs[static_cast<std::size_t>(at)].inside != kNoProgram &&
         address >= programs[static_cast<std::size_t>(at)].last)
    at = programs[static_cast<std::size_t>(at)].inside;
  return at;
}

std::uint32_t Code::label(std::int64_t number) const {
  const auto found = label_places.find(std::to_string(number));
  return found == label_places.end() ? OWord::kNone : found->second;
}

namespace {

/// Return the first head of a label from an address on, in the file that holds `text_of`.
Address first_head(const Code& code, std::uint32_t label, Address from, Address text_of) {
  const auto& heads = code.heads;
  const auto found = std::lower_bound(
      heads.begin(), heads.end(), from, [label](const LabelledHead& head, Address address) {
        return head.label != label ? head.label < label : head.address < address;
      });
  if (found == heads.end() || found->label != label) return kNowhere;
  const auto file = [&code](Address at) {
    return code.programs[static_cast<std::size_t>(code.program_at(at))].file;
  };
  return file(text_of) == file(found->address) ? found->address : kNowhere;
}

}  // namespace

Address Code::head_from(std::uint32_t label, Address from) const {
  return first_head(*this, label, from, from);
}

Address Code::head_behind(std::uint32_t label, Address at) const {
  return first_head(*this, label, at + 1, at);
}

std::string_view Code::text_of(const Block& block, const Program& program) const {
  const std::string_view text = files[program.file].text.view();
  std::size_t end = std::min<std::size_t>(text.size(), std::size_t{block.text} + block.length);
  if (block.length == 65535) end = std::min(text.find('\n', block.text), text.size());
  std::string_view view(text.data() + block.text, end - block.text);
  while (!view.empty() && is_blank(view.back())) view.remove_suffix(1);
  return view;
}

std::vector<WrittenWord> Code::words_of(const Block& block, const Program& program) const {
  return written_words(read_word, text_of(block, program).substr(0, kLookedAt));
}

Statement assignment_of(const Code& code, const Block& block) {
  if (block.op != Op::Set) return code.statements[block.aux];
  const Expression value = code.expression(block.aux);
  Statement statement = Assigned::of(block).statement(block.aux, block.text);
  statement.width = value.at() + value.width() - statement.at;
  return statement;
}

CodeList Code::codes_of(const Block& block) const {
  if ((block.flags & Block::kListed) != 0) return code_lists[block.list];
  if (!block.has_codes()) return {};
  const Cell* cell = cells.data() + block.data + ((block.flags & Block::kHasExtra) != 0 ? 1 : 0);
  CodeList list;
  const auto known = [&] { return cell->value >= 0 && cell->value <= kLargestCode; };
  for (unsigned i = 0; i < block.g_count; ++i, ++cell)
    if (known()) list.add_g(to_whole<int>(cell->value));
  for (unsigned i = 0; i < block.m_count; ++i, ++cell)
    if (known()) list.add_m(to_whole<int>(cell->value));
  return list;
}

std::string Code::name_of(const Program& program) const {
  if (program.named_with_folder) return folders[program.folder] + "/" + bare_name_of(program);
  return bare_name_of(program);
}

std::string Code::bare_name_of(const Program& program) const {
  const SourceFile& file = files[program.file];
  if (program.name_length == Program::kOfFile) return file.stem.empty() ? "MAIN" : file.stem;
  if (program.name_length == 0) return "MAIN";
  const std::string_view text = file.text.view();
  const char head = text[program.text];
  const bool numbered = (upper(head) == 'O' || head == ':') && is_digit(text[program.name_at]);
  return (numbered ? "O" : "") + std::string(text.substr(program.name_at, program.name_length));
}

std::string_view Code::comment_of(const Program& program) const {
  return files[program.file].text.view().substr(program.comment_at, program.comment_length);
}

std::string_view to_string(CallKind kind) {
  static constexpr std::array<std::string_view, 17> kNames{
      "M98",    "M198",   "M97",    "O",      "call",  "G65",    "G66",   "G66.1", "G-code",
      "M-code", "T-code", "S-code", "B-code", "ASCII", "REPEAT", "BLOCK", "MDI"};
  return kNames[static_cast<std::size_t>(kind)];
}

}  // namespace cncsub
