#include "cncsub/code/fault.hpp"

#include <algorithm>

#include "cncsub/code/code.hpp"
#include "cncsub/code/fault_words.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

struct WordPlace {
  std::uint32_t at, width;
};

bool in_name(char c) { return is_letter(upper(c)) || c == '_'; }
bool in_number(char c) { return is_digit(c) || c == '.'; }

bool is_variable_sign(char c) { return c == '#' || c == '@'; }

/// Return the end of the # at `from`: of its number, or of its expression as far as that is closed.
std::size_t end_of_variable(std::string_view text, std::size_t from) {
  std::size_t to = from;
  while (to < text.size() && (is_variable_sign(text[to]) || is_blank(text[to]))) ++to;
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

/// Return the name, number, variable or numbered word (DO1) of a macro statement that a place lies
/// in.
WordPlace whole_token(const Spelling& spelling, std::string_view text, WordPlace place) {
  std::size_t first = place.at, last = first + place.width;
  if (place.width == 0 || last > text.size()) return place;
  const auto token = [](std::size_t from, std::size_t to) {
    return WordPlace{static_cast<std::uint32_t>(from), static_cast<std::uint32_t>(to - from)};
  };
  if (is_variable_sign(text[first]))
    return token(first, std::max(last, end_of_variable(text, first)));
  const bool name = in_name(text[first]);
  if (!name && !in_number(text[first])) return place;
  while (!name && first > 0 && in_number(text[first - 1])) --first;
  std::size_t number = first;  // where the letters end
  while (first > 0 && in_name(text[first - 1])) --first;
  while (number < text.size() && in_name(text[number])) ++number;
  last = std::max(last, number);
  while (last < text.size() && in_number(text[last])) ++last;
  // An operator ends where a number begins: 1EQ2 are three words, DO1 is one.
  const auto operators = spelling.operators(LogicOrder::Last);
  if (operator_of_letters(operators, text.substr(first, number - first)) != nullptr)
    return name ? token(first, number) : token(number, last);
  if (!name && first == number && first > 0 && text[first - 1] == '#') --first;
  return token(first, last);
}

/// Return whether a place lies inside the value of a word, and is not all of it: the 2/0 of
/// X[1+2/0], the R9 of X=1+R9.
bool is_part_of_value(WordPlace place, const WrittenWord& word, std::string_view text) {
  const std::string_view written = text.substr(word.at, word.width);
  const std::size_t before = written.find_first_of("=[(");
  if (before == std::string_view::npos || place.at <= word.at + before) return false;
  const std::size_t first = word.at + before + (written[before] == '=' ? 1 : 0);
  return place.at > first || place.at + place.width < word.at + word.width;
}

/// Return the word, or of a statement or a value the token, that holds a place of the block's
/// `text`.
WordPlace widened(const Spelling& spelling, WordPlace place, const WrittenWord& word,
                  std::string_view text) {
  if (word.address.empty() || word.address == "#") return whole_token(spelling, text, place);
  const char head = word.address[0];
  if (!is_letter(head) && head != ',' && head != '<' && head != '#') return place;
  if (is_part_of_value(place, word, text)) return whole_token(spelling, text, place);
  return {word.at, std::max(word.width, place.at + place.width - word.at)};
}

/// Return the bytes of the whole word that a fault points into.
WordPlace whole_word(const Code& code, const Program& program, const Block& block,
                     const Fault& fault) {
  const WordPlace place{fault.at, std::max(fault.width, 1u)};
  const std::string_view text = code.text_of(block, program).substr(0, kLookedAt);
  const bool named = fault.block == kNowhere && fault.word.any();
  if (!named && (place.at < block.text || place.at >= block.text + text.size())) return place;
  const std::vector<WrittenWord> words = code.words_of(block, program);
  if (named) {
    const WrittenWord* const word = find_word(fault.word, words, *code.spelling, nullptr);
    return word == nullptr ? place : WordPlace{block.text + word->at, word->width};
  }
  const WordPlace here{place.at - block.text, place.width};
  for (const WrittenWord& word : words) {
    if (here.at < word.at || here.at >= word.at + word.width) continue;
    const WordPlace whole = widened(*code.spelling, here, word, text);
    return {block.text + whole.at, whole.width};
  }
  return place;
}

std::uint32_t characters(std::string_view text) {
  return static_cast<std::uint32_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return !is_inside_character(c); }));
}

/// Return the first characters of a text, as many as so many bytes hold.
std::string_view first_of(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && is_inside_character(text[bytes])) --bytes;
  return text.substr(0, bytes);
}

/// Show a place of a file's text: its line, and the word with its column, in whole characters.
void show(Alarm& alarm, std::string_view text, std::size_t at, std::uint32_t width) {
  while (at > 0 && at < text.size() && is_inside_character(text[at])) --at;
  const std::size_t before = at == 0 ? std::string_view::npos : text.rfind('\n', at - 1);
  const std::size_t line = before == std::string_view::npos ? 0 : before + 1;
  std::size_t line_end = std::min(text.find('\n', at), text.size());
  // The end of a line on Windows is read as a blank and an end of a line: it is neither shown nor
  // marked.
  while (line_end > at && is_blank(text[line_end - 1])) --line_end;
  std::size_t end = at + std::min<std::size_t>(width, line_end - at);
  while (end < line_end && is_inside_character(text[end])) ++end;
  const std::string_view word = text.substr(at, end - at);
  alarm.source_line = first_of(text.substr(line, line_end - line), kLongestSource);
  alarm.column = characters(text.substr(line, at - line)) + 1;
  alarm.width = std::max(1u, characters(word));
  alarm.word = first_of(word, kLongestSource);
  while (!alarm.word.empty() && is_blank(alarm.word.back())) alarm.word.pop_back();
}

/// Fill in the places that a text of the list has for what the control puts in: {line}, {block},
/// {name}, {file}.
void fill_in(Alarm& alarm, std::string_view name, std::string_view block) {
  const auto put = [&alarm](std::string_view mark, std::string_view what) {
    std::size_t at = alarm.text.find(mark);
    for (; at != std::string::npos; at = alarm.text.find(mark, at + what.size()))
      alarm.text.replace(at, mark.size(), what);
  };
  if (alarm.text.find('{') == std::string::npos) return;
  put("{line}", std::to_string(alarm.line));
  put("{file}", alarm.file);
  put("{name}", name);
  put("{block}", block);
}

/// Return whether a fault points into the head of a program, which stands before its first block.
bool is_of_head(const Program& program, Address address, const Fault& fault) {
  return address == program.first && fault.width > 1 && program.name_length != Program::kOfFile &&
         fault.at + 1 >= program.name_at &&
         fault.at + fault.width <= program.name_at + program.name_length;
}

}  // namespace

Alarm alarm_of(const Code& code, Address address, const Fault& fault) {
  Alarm alarm;
  alarm.cause = fault.cause;
  alarm.detail = fault.detail;
  if (const AlarmEntry* entry = code.control->alarm(fault.cause)) {
    const DirectedNumber* own = entry->towards({fault.kind.data(), fault.kind.size()});
    alarm.number = own != nullptr ? own->number : entry->number;
    alarm.text = own != nullptr ? own->text : entry->text;
  }
  if (!fault.text.empty()) alarm.text = fault.text;
  const std::int32_t index = code.program_at(address);
  if (index < 0) return alarm;
  const Program& program = code.programs[static_cast<std::size_t>(index)];
  const SourceFile& file = code.files[program.file];
  const Block& block = code.blocks[address];
  alarm.program = code.name_of(program);
  alarm.file = file.name;
  alarm.n = block.n;
  alarm.line = block.line;
  if (is_of_head(program, address, fault)) {
    alarm.n = -1;
    alarm.line = program.line;
    show(alarm, file.text.view(), fault.at, fault.width);
    return alarm;
  }
  const WordPlace place = whole_word(code, program, block, fault);
  const std::string_view text = file.text.view();
  show(alarm, text, std::min<std::size_t>(std::max(place.at, block.text), text.size()),
       place.width);
  if (fault.cause == Cause::EndOfRecord) alarm.word.clear();  // a word is missing there
  fill_in(alarm, fault.name, code.text_of(block, program));
  if (alarm.detail.starts_with("{}")) alarm.detail.replace(0, 2, alarm.word);
  return alarm;
}

}  // namespace cncsub
