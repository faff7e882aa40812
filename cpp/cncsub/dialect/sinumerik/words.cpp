// The words of a block as they are written. A statement is one word with all the text after it, and
// an address is one with its expression.
#include <algorithm>

#include "cncsub/control/g_codes.hpp"
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/given_value.hpp"
#include "cncsub/dialect/sinumerik/expression.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/dialect/sinumerik/line.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"

namespace cncsub {

namespace sinumerik {

namespace {

constexpr std::string_view kStatements[] = {
    "GOTO",  "GOTOB",  "GOTOC",   "GOTOF", "GOTOS", "IF",      "WHILE", "FOR",  "CASE",
    "UNTIL", "REPEAT", "REPEATB", "CALL",  "PCALL", "EXTCALL", "DEF",   "PROC", "EXTERN"};
constexpr std::string_view kBetween[] = {"DIV", "MOD",   "AND",  "OR",   "XOR",
                                         "TO",  "B_AND", "B_OR", "B_XOR"};

void pass_operand(Line& line) {
  while (line.peek() == '-' || line.peek() == '+' || capitals(line.name()) == "NOT" ||
         capitals(line.name()) == "B_NOT")
    line.pass(line.name().empty() ? 1 : line.name().size());
  if (line.peek() == '"') return line.pass_quoted();
  if (line.take('\'')) {  // 'HFF'
    while (line.ahead(0) != '\'' && line.ahead(0) != '\0') line.pass(1);
    if (line.ahead(0) == '\'') line.pass(1);
    return;
  }
  if (line.take('$')) line.peek();
  if (line.name().empty())
    line.take_number();
  else
    line.pass(line.name().size());
  if (line.peek() == '(') line.pass_brackets('(', ')');
  if (line.peek() == '[') line.pass_brackets('[', ']');
}

bool is_operator(std::string_view name) { return is_among(kBetween, capitals(name)); }
void pass_expression(Line& line) { pass_operands(line, "+-*/<>=:", pass_operand, is_operator); }

/// Pass over the value after the equals sign of CR=5: a number, or an expression.
void pass_value(Line& line, WrittenWord& word) { pass_given(line, word, pass_expression); }

/// Pass over X10, X=R1 or G54: a letter and its value.
void pass_address(Line& line, char letter, WrittenWord& word) {
  word.address = letter;
  line.pass(1);
  const std::string_view digits = line.rest();
  const bool numbered = is_digit(line.ahead(0));
  pass_number(line, word);
  if (numbered && line.ahead(0) == '=' && letter != 'R')  // X1=5, I1=5
    word.address += digits.substr(0, digits.size() - line.rest().size());
  if (line.ahead(0) == '[') line.pass_brackets('[', ']');
  if (line.peek() != '=') return;
  line.pass(1);
  pass_value(line, word);
}

/// Pass over $TC_DP3[5,1]=120, a system variable and what it is given.
void pass_system_variable(Line& line, WrittenWord& word) {
  line.pass(1);
  line.pass(line.name().size());
  if (line.ahead(0) == '[') line.pass_brackets('[', ']');
  if (line.peek() != '=') return;
  line.pass(1);
  pass_value(line, word);
  word.known = false;
}

// NOLINTNEXTLINE(readability-function-cognitive-complexity): one case after the other
void pass_word(Line& line, WrittenWord& word) {
  const std::string_view name = line.name();
  const std::string capital = capitals(name);
  if (is_among(kStatements, capital)) {
    line.pass(before_comment(line.rest()));
  } else if (name.size() > 1 && !is_digit(name[1])) {
    line.pass(name.size());
    if (line.ahead(0) == ':') return line.pass(1);
    if (code_of_word(capital) >= 0) word.address = capital;
    if (line.ahead(0) == '(') line.pass_brackets('(', ')');
    const std::string_view index = line.rest();
    if (line.ahead(0) == '[') line.pass_brackets('[', ']');
    if (capital == "AX" || capital == "POS" || capital == "FA")  // AX[X]=5
      word.address = capital + capitals(index.substr(0, index.size() - line.rest().size()));
    if (!line.take('=')) return;
    if (place_of(capital) >= 0) word.address = capital;
    pass_value(line, word);
    word.known = word.known && !word.address.empty();
  } else if (!name.empty()) {
    pass_address(line, capital[0], word);
  } else if (line.peek() == '$' && is_letter(line.ahead(1))) {
    pass_system_variable(line, word);
  } else {
    const std::string_view first = first_character(line.rest());
    word.address = first;
    if (first == "\"") return line.pass_quoted();
    if (first == "(") {  // a comment in ISO mode; in the own language no word begins so
      line.pass_brackets('(', ')');
      return;
    }
    line.pass(first.size());
    if (first == "/" && is_digit(line.ahead(0))) line.pass(1);
    if (first == ":" && is_digit(line.ahead(0))) pass_number(line, word);  // :10 of a main block
  }
}

}  // namespace

}  // namespace sinumerik

// The rules that the language of the SINUMERIK asks, as far as it is computed: its words, its
// statements and its calls have their own way.
const std::string_view sinumerik_rules =
    "refuses power_on missing_end g_codes max_sequence_number "
    "self_call caller_call max_repeats zero_repeats too_many_repeats max_nesting max_total_nesting "
    "modal_locals modal_trigger second_modal_call cancel_alone calls_in_modal "
    "search_path roles main_return end_in_subprogram commons "
    "machine g_meanings rapid_rate max_feed arc_tolerance arc_tolerance_share no_radius "
    "small_radius negative_radius helix dwell_words arc_angle_words added_turns "
    "drops_centre_across poles "
    "machine_move max_extra_systems extra_system_codes max_offset_number tool_edges "
    "shifts_move_increments written_offset rotation_words start_up acute_corner idle_blocks "
    "chamfer_words round_words angle_words angles_on_mills "
    "dwell_turn_words unit_change computed_lengths feed_mode_change speed_limit "
    "unused_words_told corner_idle_blocks modal_round_words corner_feed_words "
    "modal_corner_feed_words corner_feed_of_next round_before_chamfer corner_reduced "
    "corners_in_rapid "
    "contour_offset_words fine_shift";

namespace sinumerik {
// [SONE p.559-560: the search path; NCX chapter 1: WKS; general knowledge: DEF]
constexpr std::string_view kFolders[] = {"MPF.DIR", "SPF.DIR", "WKS.DIR", "CUS.DIR",
                                         "CMA.DIR", "CST.DIR", "DEF.DIR"};
}  // namespace sinumerik

const double sinumerik_precision = 0;  // a number has 64 bits

const std::span<const WordUse> sinumerik_word_uses;
// The feed of POS[X] stands where the centre of an arc along X does.
static constexpr Spelling::IndexedAddress kIndexed[] = {{"AX"}, {"POS"}, {"FA", 'I' - 'X'}};
const Spelling sinumerik_spelling{.comment = {";", ""},
                                  .value = {"=(", ")"},
                                  .message = {"MSG(\"", "\")"},
                                  .head = {"%_N_", "_MPF"},
                                  .main_ending = "MPF",
                                  .called_ending = "SPF",
                                  .folders = sinumerik::kFolders,
                                  .folder_ending = "WPD",
                                  .brackets = {"(", ")"},
                                  .operators = [](LogicOrder) { return sinumerik::kOperators; },
                                  .numbered = false,
                                  .variable = "R",
                                  .variable_name = sinumerik::name_of_variable,
                                  .program_name = {"", ""},
                                  .long_addresses = sinumerik::kLongAddresses,
                                  .indexed_addresses = kIndexed,
                                  .absolute = {"AC(", ")"},
                                  .incremental = {"IC(", ")"},
                                  .radius = "CR",
                                  .own_m_codes = {100, 999},
                                  .definitions = ".DEF"};

std::optional<WrittenWord> sinumerik_word(std::string_view block, std::size_t& from) {
  using namespace sinumerik;
  Line line;
  // The comment is not searched for: each word is read no farther than it is wide.
  line.set_uncut(block.substr(std::min(from, block.size())), static_cast<std::uint32_t>(from));
  if (line.at_end()) return std::nullopt;
  WrittenWord word;
  word.at = line.offset();
  pass_word(line, word);
  const std::size_t end = end_of_character(block, word.at + line.width_from(word.at));
  word.width = static_cast<std::uint32_t>(end - word.at);
  const std::string_view text = block.substr(word.at, word.width);
  for (const char c : text)
    if (!is_blank(c)) word.text += upper(c);
  from = std::size_t{word.at} + word.width;
  return word;
}

}  // namespace cncsub
