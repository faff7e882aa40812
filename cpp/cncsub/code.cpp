#include "cncsub/code.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "cncsub/scan.hpp"
#include "cncsub/words.hpp"

namespace cncsub {

std::string_view to_string(CallKind kind) {
  switch (kind) {
    case CallKind::M98:
      return "M98";
    case CallKind::M198:
      return "M198";
    case CallKind::M97:
      return "M97";
    case CallKind::G65:
      return "G65";
    case CallKind::G66:
      return "G66";
    case CallKind::G661:
      return "G66.1";
    case CallKind::GCode:
      return "G-code";
    case CallKind::MCode:
      return "M-code";
    case CallKind::TCode:
      return "T-code";
    case CallKind::SCode:
      return "S-code";
    case CallKind::BCode:
      return "B-code";
    case CallKind::Ascii:
      return "ASCII";
  }
  return "";
}

std::int64_t number_in(std::string_view name) {
  if (!name.empty() && (upper(name[0]) == 'O' || name[0] == '%' || name[0] == ':'))
    name.remove_prefix(1);
  if (name.empty() || name.size() > 15) return -1;
  std::int64_t number = 0;
  for (const char c : name) {
    if (!is_digit(c)) return -1;
    number = number * 10 + (c - '0');
  }
  return number;
}

void Code::list_statements() {
  const std::string list = " " + control->statements.value + " ";
  for (std::size_t i = 0; i < static_cast<std::size_t>(StatementKind::Count); ++i) {
    const std::string name = " " + std::string(statement_name(static_cast<StatementKind>(i)));
    unheard_of.set(i, list.find(name + "? ") != std::string::npos);
    lacking.set(i, list.find(name + " ") == std::string::npos);
  }
}

Fault Code::lacking_fault(StatementKind kind, std::uint32_t at) const {
  const std::string name(statement_name(kind));
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
  // Locals and commons are the first ranges, and what programs use most: they are met one by one.
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

std::int32_t Code::program_at(Address address) const {
  const auto behind =
      std::upper_bound(programs.begin(), programs.end(), address,
                       [](Address a, const Program& program) { return a < program.first; });
  return static_cast<std::int32_t>(behind - programs.begin()) - 1;
}

std::string_view Code::text_of(const Block& block, const Program& program) const {
  const std::string& text = files[program.file].text;
  std::size_t end = std::min<std::size_t>(text.size(), std::size_t{block.text} + block.length);
  if (block.length == 65535) end = std::min(text.find('\n', block.text), text.size());
  std::string_view view(text.data() + block.text, end - block.text);
  while (!view.empty() && is_blank(view.back())) view.remove_suffix(1);
  return view;
}

std::string Code::name_of(const Program& program) const {
  const SourceFile& file = files[program.file];
  if (program.name_length == Program::kOfFile) return file.stem.empty() ? "MAIN" : file.stem;
  if (program.name_length == 0) return "MAIN";
  const char head = file.text[program.text];
  const bool numbered = upper(head) == 'O' || head == ':';
  return (numbered ? "O" : "") + file.text.substr(program.name_at, program.name_length);
}

std::string_view Code::comment_of(const Program& program) const {
  return std::string_view(files[program.file].text)
      .substr(program.comment_at, program.comment_length);
}

void ProgramIndex::reserve(std::size_t programs) {
  slots_.assign(std::bit_ceil(2 * programs + 1), kNoProgram);
}

namespace {

std::uint64_t hash_of(std::string_view name) {  // FNV-1a of the letters as capitals
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char c : name) hash = (hash ^ static_cast<unsigned char>(upper(c))) * 0x100000001b3U;
  return hash;
}

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return upper(x) == upper(y); });
}

std::string_view last_part(std::string_view path) {
  const std::size_t slash = path.find_last_of("/\\");
  return slash == std::string_view::npos ? path : path.substr(slash + 1);
}

bool first_in_file(const Code& code, std::size_t program) {
  return program == 0 || code.programs[program - 1].file != code.programs[program].file;
}

/// Whether a program answers to a number.
auto numbered(const Code& code, std::int64_t number) {
  return [&code, number](std::int32_t i) {
    return code.programs[static_cast<std::size_t>(i)].number == number;
  };
}

/// Whether a program answers to a name: its own, or the one of the file that it is the first of.
auto named(const Code& code, std::string_view name) {
  return [&code, name](std::int32_t i) {
    const auto at = static_cast<std::size_t>(i);
    const Program& program = code.programs[at];
    return same_name(code.name_of(program), name) ||
           (first_in_file(code, at) && same_name(last_part(code.files[program.file].name), name));
  };
}

}  // namespace

void Code::register_programs(const std::function<bool()>& over) {
  for (auto* index : {&by_number, &by_name})
    for (ProgramIndex& table : *index) table.reserve(programs.size() + files.size());
  for (std::size_t i = 0; i < programs.size() && !over(); ++i) {
    Program& program = programs[i];
    const SourceFile& file = files[program.file];
    const auto place = static_cast<std::int32_t>(i);
    if (program.number >= 0)
      program.duplicate_of = by_number[file.external].find_or_add(
          static_cast<std::uint64_t>(program.number), numbered(*this, program.number), place);
    ProgramIndex& names = by_name[file.external];
    const std::string name = name_of(program);
    const std::int32_t before = names.find_or_add(hash_of(name), named(*this, name), place);
    if (program.number < 0) program.duplicate_of = before;
    const std::string_view base = last_part(file.name);
    if (first_in_file(*this, i) && !base.empty())
      names.find_or_add(hash_of(base), named(*this, base), place);
  }
}

std::int32_t Code::find(std::int64_t number, bool external) const {
  return by_number[external].find(static_cast<std::uint64_t>(number), numbered(*this, number));
}

std::int32_t Code::find(std::string_view name, bool external) const {
  const std::int32_t found = by_name[external].find(hash_of(name), named(*this, name));
  if (found != kNoProgram) return found;
  const std::int64_t number = number_in(name);
  return number >= 0 ? find(number, external) : kNoProgram;
}

namespace {

struct Entries {
  const SequenceEntry* first;
  const SequenceEntry* last;
};

/// The blocks of one number, in the order of the program.
Entries entries(const Code& code, const Program& program, std::int64_t n) {
  const SequenceEntry* first = code.sequence.data() + program.first_entry;
  const SequenceEntry* last = code.sequence.data() + program.last_entry;
  const auto* const low = std::lower_bound(
      first, last, n, [](const SequenceEntry& e, std::int64_t value) { return e.n < value; });
  const auto* const high = std::upper_bound(
      low, last, n, [](std::int64_t value, const SequenceEntry& e) { return value < e.n; });
  return {low, high};
}

}  // namespace

Address Code::first_of(const Program& program, std::int64_t n) const {
  const Entries found = entries(*this, program, n);
  return found.first == found.last ? kNowhere : found.first->address;
}

Address Code::first_from(const Program& program, std::int64_t n, Address from) const {
  const Entries found = entries(*this, program, n);
  const auto* const next =
      std::lower_bound(found.first, found.last, from,
                       [](const SequenceEntry& e, Address a) { return e.address < a; });
  return next == found.last ? kNowhere : next->address;
}

Address Code::next_of(const Program& program, std::int64_t n, Address behind) const {
  return first_from(program, n, behind + 1);
}

Address Code::last_of(const Program& program, std::int64_t n, Address before) const {
  const Entries found = entries(*this, program, n);
  const auto* const behind =
      std::lower_bound(found.first, found.last, before,
                       [](const SequenceEntry& e, Address a) { return e.address < a; });
  return behind == found.first ? kNowhere : behind[-1].address;
}

Address Code::jump_target(const Program& program, std::int64_t n, Address from) const {
  if (control->jump_search.value == JumpSearch::ForwardThenHead) {
    const Address next = next_of(program, n, from);
    if (next != kNowhere) return next;
  }
  return first_of(program, n);
}

Address Code::return_target(const Program& program, std::int64_t n, Address call) const {
  switch (control->return_search.value) {
    case ReturnSearch::FromHead:
      return first_of(program, n);
    case ReturnSearch::NearestBehindCall: {
      const Address behind = next_of(program, n, call);
      return behind != kNowhere ? behind : last_of(program, n, call + 1);
    }
  }
  return kNowhere;
}

namespace {

constexpr std::size_t kLookedAt = 65535;  // bytes of a block in which a word is looked for

struct WordPlace {
  std::uint32_t at, width;
};

bool in_name(char c) { return is_letter(upper(c)) || c == '_'; }
bool in_number(char c) { return is_digit(c) || c == '.'; }

/// An operator ends where a number begins: 1EQ2 are three words, DO1 is one.
bool is_operator(std::string_view name) {
  std::string word;
  for (const char c : name) word += upper(c);
  return std::string_view(" EQ NE GT GE LT LE AND OR XOR MOD ").find(' ' + word + ' ') !=
         std::string_view::npos;
}

/// Behind the # at `from`: its number, or its expression as far as that is closed.
std::size_t end_of_variable(std::string_view text, std::size_t from) {
  std::size_t to = from;
  while (to < text.size() && (text[to] == '#' || is_blank(text[to]))) ++to;
  if (to < text.size() && is_digit(text[to])) {
    while (to < text.size() && is_digit(text[to])) ++to;
    return to;
  }
  if (to == text.size() || text[to] != '[') return from + 1;
  for (int open = 0; to < text.size(); ++to) {
    open += text[to] == '[' ? 1 : text[to] == ']' ? -1 : 0;
    if (open == 0) return to + 1;
  }
  return from + 1;
}

/// The name, number, variable or numbered word (DO1) of a macro statement that a place lies in.
WordPlace whole_token(std::string_view text, WordPlace place) {
  std::size_t first = place.at, last = first + place.width;
  if (place.width == 0 || last > text.size()) return place;
  const auto token = [](std::size_t from, std::size_t to) {
    return WordPlace{static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to - from)};
  };
  if (text[first] == '#') return token(first, std::max(last, end_of_variable(text, first)));
  const bool name = in_name(text[first]);
  if (!name && !in_number(text[first])) return place;
  while (!name && first > 0 && in_number(text[first - 1])) --first;
  std::size_t number = first;  // where the letters end
  while (first > 0 && in_name(text[first - 1])) --first;
  while (number < text.size() && in_name(text[number])) ++number;
  last = std::max(last, number);
  while (last < text.size() && in_number(text[last])) ++last;
  if (is_operator(text.substr(first, number - first)))
    return name ? token(first, number) : token(number, last);
  if (!name && first == number && first > 0 && text[first - 1] == '#') --first;
  return token(first, last);
}

/// The bytes of the whole word that a fault points into.
WordPlace whole_word(const Code& code, const Program& program, const Block& block,
                     const Fault& fault) {
  const WordPlace place{fault.at, std::max(fault.width, 1u)};
  const std::string_view text = code.text_of(block, program).substr(0, kLookedAt);
  const bool named = fault.block == kNowhere && fault.address != 0;
  if (!named && (place.at < block.text || place.at >= block.text + text.size())) return place;
  for (const WrittenWord& word : written_words(text)) {
    const WordPlace whole{block.text + word.at, word.width};
    if (named) {
      const bool same = word.address == std::string_view(&fault.address, 1);
      if (same && (fault.code < 0 || !word.known || std::lround(word.value * 10) == fault.code))
        return whole;
      continue;
    }
    if (place.at < whole.at || place.at >= whole.at + whole.width) continue;
    const char head = word.address.empty() ? '#' : word.address[0];
    if (!is_letter(head) && head != ',' && head != '<' && head != '#') return place;
    const bool statement = word.address.empty() || word.address == "#";
    if (!statement) return {whole.at, std::max(whole.width, place.at + place.width - whole.at)};
    const WordPlace token = whole_token(text, {place.at - block.text, place.width});
    return {token.at + block.text, token.width};
  }
  return place;
}

}  // namespace

Alarm alarm_of(const Code& code, Address address, const Fault& fault) {
  Alarm alarm;
  alarm.cause = fault.cause;
  alarm.detail = fault.detail;
  if (const AlarmEntry* entry = code.control->alarm(fault.cause)) {
    const DirectedNumber* own = entry->towards({fault.direction.data(), fault.direction.size()});
    alarm.number = own != nullptr ? own->number : entry->number;
    alarm.text = own != nullptr ? own->text : entry->text;
  }
  const std::int32_t index = code.program_at(address);
  if (index < 0) return alarm;
  const Program& program = code.programs[static_cast<std::size_t>(index)];
  const SourceFile& file = code.files[program.file];
  const Block& block = code.blocks[address];
  alarm.program = code.name_of(program);
  alarm.file = file.name;
  alarm.n = block.n;
  alarm.line = block.line;
  const std::string& text = file.text;
  const WordPlace place = whole_word(code, program, block, fault);
  const std::size_t at = std::min<std::size_t>(std::max(place.at, block.text), text.size());
  const std::size_t before = at == 0 ? std::string::npos : text.rfind('\n', at - 1);
  const std::size_t line_start = before == std::string::npos ? 0 : before + 1;
  const std::size_t line_end = std::min(text.find('\n', at), text.size());
  const auto characters = [&](std::size_t from, std::size_t to) {
    std::uint32_t count = 0;
    for (std::size_t i = from; i < to; ++i)
      if ((static_cast<unsigned char>(text[i]) & 0xC0u) != 0x80u) ++count;
    return count;
  };
  const std::size_t word_end = std::min(line_end, at + place.width);
  alarm.source_line = text.substr(line_start, std::min(line_end - line_start, kLongestSource));
  alarm.column = characters(line_start, at) + 1;
  alarm.width = std::max(1u, characters(at, word_end));
  alarm.word = text.substr(at, std::min(word_end - at, kLongestSource));
  while (!alarm.word.empty() && is_blank(alarm.word.back())) alarm.word.pop_back();
  if (fault.cause == Cause::EndOfRecord) alarm.word.clear();  // a word is missing there
  if (alarm.detail.starts_with("{}")) alarm.detail.replace(0, 2, alarm.word);
  return alarm;
}

}  // namespace cncsub
