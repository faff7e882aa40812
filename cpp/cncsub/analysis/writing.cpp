// Finds blocks in which a control reads something other than a reader sees.
#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

// ---- two codes of a group ----

TextPlace place_of_code(const Code& code, const Block& block, const Program& program, int g,
                        bool last) {
  TextPlace place{block.text, block.length};
  for (const WrittenWord& word : code.words_of(block, program)) {
    if (word.address != "G" || !word.known || std::lround(word.value * 10) != g) continue;
    place = {block.text + word.at, word.width};
    if (!last) break;
  }
  return place;
}

/// Report two codes of one group as the motion reads them: the last one counts, or the control
/// refuses the second.
void check_conflict(Checker& c, Address at, const Block& block, const Program& program) {
  if (block.g_count < 2 || block.op > Op::Arc) return;
  const Control& control = *c.code.control;
  std::vector<std::pair<Group, int>> seen;
  bool refused = false;
  each_g(c.code, block, [&](int g) {
    const GCode code = c.g_codes.find(g);
    const bool goes = code.meaning != Meaning::None && code.meaning != Meaning::Unknown &&
                      code.meaning != Meaning::Uncomputed && !is_neutral(code.meaning);
    if (!goes || refused || changes_shift(code.meaning)) return;
    const auto before = std::find_if(seen.begin(), seen.end(),
                                     [&](const auto& of) { return of.first == code.group; });
    if (before == seen.end()) {
      seen.emplace_back(code.group, g);
      return;
    }
    refused = code.group != Group::OneShot &&
              control.reading.repeated_address.value == RepeatedAddress::Alarm;
    const std::string both = code_name(before->second) + " and " + code_name(g);
    if (refused) {
      const TextPlace place = place_of_code(c.code, block, program, g, true);
      Fault fault{Cause::AddressGivenTwice, place.at, place.width, both + " are of one group"};
      fault.word.code = g;
      c.refused(Check::Refused, at, std::move(fault));
    } else if (before->second != g) {
      c.found(Check::CodesInConflict, at,
              place_of_code(c.code, block, program, before->second, false),
              both + " are of one group: the control executes only " + code_name(g));
    }
    before->second = g;
  });
}

// ---- a semicolon inside a line ----

/// Report a block that begins after a semicolon, in the line of the block before it.
void check_semicolon(Checker& c, Address at, std::string_view text) {
  const Block& block = c.code.blocks[at];
  const Block& before = c.code.blocks[at - 1];
  if (block.line != before.line || block.text <= before.text || block.text >= text.size()) return;
  std::size_t from = block.text;
  while (from > before.text && is_blank(text[from - 1])) --from;
  const char first = text[block.text];
  if (from == before.text || text[from - 1] != ';' || first == '(' || first == ';') return;
  c.found(Check::BlockInLine, at, {block.text, block.length},
          "the semicolon before it ends a block");
}

// ---- a comment that is not closed ----

/// Report a comment that nothing closes and that the control accepts: it takes the rest of the
/// line.
void check_open_comment(Checker& c, Address at, std::string_view text) {
  const Block& block = c.code.blocks[at];
  const std::size_t end = std::min(text.find('\n', block.text), text.size());
  const std::string_view line =
      text.substr(std::min<std::size_t>(block.text, end), end - block.text);
  const std::size_t open = line.rfind('(');
  if (open == std::string_view::npos || line.find(')', open) != std::string_view::npos) return;
  const bool ends = c.code.control->reading.semicolon.value == Semicolon::Comment;
  if (ends && line.substr(0, open).find(';') != std::string_view::npos) return;
  if (c.code.blocks[at].op == Op::Fault) return;  // the open comment may be what is wrong there
  std::size_t width = end - block.text - open;
  while (width > 1 && is_blank(line[open + width - 1])) --width;
  c.found(Check::OpenComment, at,
          {static_cast<std::uint32_t>(block.text + open), static_cast<std::uint32_t>(width)},
          "the comment is not closed: the rest of the block belongs to it");
}

// ---- small letters ----

bool is_small(char c) { return c >= 'a' && c <= 'z'; }

/// Return whether a name is an address or names a statement, an operation or a function. Any other
/// name may be the program's own, and capitals would change it.
bool is_written_in_capitals(std::string_view name) {
  if (name.size() == 1) return true;
  static constexpr std::string_view kNames[] = {
      "IF",  "GOTO", "THEN", "ELSE", "ENDIF", "WHILE", "DO",   "END", "EQ",
      "NE",  "GT",   "LT",   "GE",   "LE",    "AND",   "OR",   "XOR", "MOD",
      "SIN", "COS",  "TAN",  "ASIN", "ACOS",  "ATAN",  "SQRT", "ABS", "ROUND",
      "FIX", "FUP",  "BIN",  "BCD",  "LN",    "EXP",   "ADP"};
  std::string capitals;
  for (const char letter : name) capitals += upper(letter);
  return std::find(std::begin(kNames), std::end(kNames), capitals) != std::end(kNames);
}

std::size_t end_of_letters(std::string_view text, std::size_t from, std::size_t end) {
  while (from < end && is_letter(text[from])) ++from;
  return from;
}
std::size_t end_of_number(std::string_view text, std::size_t from, std::size_t end) {
  while (from < end && (is_digit(text[from]) || text[from] == '.' || text[from] == '-')) ++from;
  return from;
}

/// Return the first stretch of a block that has small letters, up to a comment; none where it has
/// names.
TextPlace small_letters(std::string_view text, const Block& block) {
  const std::size_t end = std::min(text.size(), std::size_t{block.text} + block.length);
  std::size_t first = end;
  std::size_t behind = end;
  for (std::size_t i = block.text; i < end; ++i) {
    if (text[i] == '(' || text[i] == ';' || text[i] == '\n') break;
    if (text[i] == '<' || text[i] == '"') return {0, 0};
    if (!is_letter(text[i])) continue;
    const std::size_t to = end_of_letters(text, i, end);
    const std::string_view name = text.substr(i, to - i);
    if (std::any_of(name.begin(), name.end(), is_small)) {
      if (!is_written_in_capitals(name)) return {0, 0};
      first = std::min(first, i);
      behind = to;
    }
    i = to - 1;
  }
  if (first == end) return {0, 0};
  // Includes the number after the last letter: a whole word is easier to see.
  behind = end_of_number(text, behind, end);
  return {static_cast<std::uint32_t>(first), static_cast<std::uint32_t>(behind - first)};
}

bool prints(const Code& code, const Block& block) {
  bool found = false;
  each_variant(code, block, [&](const Block& of) {
    found = found || (of.op >= Op::Print && of.op <= Op::NameVariables) || of.op == Op::Fault;
  });
  return found;
}

constexpr const char* kSmall =
    "this control reads them as capitals; one without small letters refuses or ignores them";

CertainEdit in_capitals(Address block, TextPlace place, std::string_view text) {
  CertainEdit edit{block, place, std::string(text.substr(place.at, place.width))};
  for (char& letter : edit.text) letter = upper(letter);
  return edit;
}

/// Offer a capital for the o of a program head such as o2.
void head_in_capitals(const Checker& c, const ProgramFlow& flow, std::string_view text,
                      std::vector<CertainEdit>& edits) {
  const Program& program = c.program(flow.program());
  if (program.name_length == Program::kOfFile || program.number < 0) return;
  for (std::uint32_t at = program.name_at > 0 ? program.name_at - 1 : 0; at <= program.name_at;
       ++at)
    if (at < text.size() && text[at] == 'o')
      edits.push_back(
          in_capitals(flow.first(), {at, program.name_at + program.name_length - at}, text));
}

/// Report small letters once for each program: who writes them writes them everywhere.
void check_letters(Checker& c, const ProgramFlow& flow, std::string_view text) {
  if (c.code.spelling->small_letters) return;
  std::vector<CertainEdit> edits;
  head_in_capitals(c, flow, text, edits);
  for (Address at = flow.first(); at < flow.last() && !c.over(); ++at) {
    const Block& block = c.code.blocks[at];
    const TextPlace place = small_letters(text, block);
    if (place.width > 0 && !prints(c.code, block)) edits.push_back(in_capitals(at, place, text));
  }
  if (edits.empty()) return;
  const std::string more =
      edits.size() == 1 ? "" : " (and in " + std::to_string(edits.size() - 1) + " more places)";
  c.found(Check::SmallLetters, edits.front().block, edits.front().place, kSmall + more).edits =
      std::move(edits);
}

}  // namespace

void check_writing(Checker& c) {
  const bool ends_blocks = c.code.control->reading.semicolon.value == Semicolon::EndOfBlock;
  const bool open = c.code.spelling->open_comments &&
                    c.code.control->reading.open_comment.value == OpenComment::RestOfBlock;
  for (const ProgramFlow& flow : c.flows) {
    if (c.inside(flow)) continue;
    const Program& program = c.program(flow.program());
    const std::string_view text = c.code.files[program.file].text.view();
    check_letters(c, flow, text);
    for (Address at = flow.first(); at < flow.last() && !c.over(); ++at) {
      if (ends_blocks && at > flow.first()) check_semicolon(c, at, text);
      const bool last =
          at + 1 == flow.last() || c.code.blocks[at + 1].line != c.code.blocks[at].line;
      if (open && last) check_open_comment(c, at, text);
      each_variant(c.code, c.code.blocks[at],
                   [&](const Block& block) { check_conflict(c, at, block, program); });
    }
  }
}

}  // namespace cncsub
