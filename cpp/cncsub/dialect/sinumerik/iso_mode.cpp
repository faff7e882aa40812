// Blocks in ISO mode, and the calls that begin it.
#include "cncsub/dialect/sinumerik/iso_mode.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "cncsub/text/scan.hpp"

namespace cncsub::sinumerik {

namespace {

constexpr int kNothing = -1;      // the code changes no path here
constexpr int kNotComputed = -2;  // a run stops at it
constexpr char kCount = 'L';      // the address of a count in ISO mode; P in the own language
constexpr std::size_t kProgramDigits = 4, kMostDigitsOfP = 8;  // [general knowledge: M98 Pnnnnmmmm]
constexpr std::string_view kIsoAddresses = "ABCFIJKRSTUVWXYZ";

struct IsoCode {
  int code, own;  // ten times their numbers
  std::string_view needs;
};
constexpr IsoCode kIsoCodes[] = {
#define ISO_CODE(code, own, needs) {code, own, needs},
#include "cncsub/dialect/sinumerik/iso_codes.def"
#undef ISO_CODE
};

/// A word that says how its block goes on, and the digits of its value as they are written.
struct Given {
  Value value;
  std::string_view digits;
};

/// The words of a block in ISO mode that the own language writes otherwise.
struct IsoWords {
  std::optional<Given> p, l;
  std::optional<Value> call, back;  // M98, and M99 or M17
  bool dwell = false;               // G4
};

/// Refuse the block for a word of it, once the block is read.
bool refuse_word(OpenBlock& open, Block& block, Cause cause, std::string detail,
                 const Value& word) {
  open.to.refuse(block, {cause, word.at, word.width, std::move(detail)});
  return false;
}

/// Return the number of a word; where it is missing, the address is what is wrong.
bool number_of(OpenBlock& open, Block& block, char letter, std::uint32_t at, Given& given) {
  const char next = open.line.peek();
  if (next == '#' || next == '[' || next == '=')
    return open.not_computed(block, "variables and expressions in ISO mode", at);
  if (is_letter(next) || next == '\0')
    return open.refuse(block, Cause::AddressWithoutValue,
                       std::string(1, letter) + " without a number", at);
  const std::string_view before = open.line.rest();
  if (!open.expression.number(given.value)) return open.refuse(block);
  if (open.line.peek() == '=')
    return open.not_computed(block, "assignments in ISO mode: G290 before them", at);
  given.digits = trimmed(before.substr(0, before.size() - open.line.rest().size()));
  given.value.at = at;
  given.value.width = open.line.width_from(at);
  return true;
}

bool g_word(OpenBlock& open, Block& block, Words& words, IsoWords& iso, const Given& given) {
  const auto code = to_whole<int>(std::round(given.value.number * 10));
  const std::uint32_t at = given.value.at;
  if (code == kIsoModeOff || code == kIsoModeOn)
    return mode_code(open, block, words, code, given.value);
  const auto* const of = std::find_if(std::begin(kIsoCodes), std::end(kIsoCodes),
                                      [code](const IsoCode& each) { return each.code == code; });
  if (of == std::end(kIsoCodes))
    return open.not_computed(block, "G" + std::string(given.digits) + " in ISO mode", at);
  words.any = true;
  if (of->own == kNothing) return true;
  if (of->own == kNotComputed) return open.not_computed(block, of->needs, at);
  iso.dwell = iso.dwell || code == 40;
  return add_code(open, block, words, group_of(of->own / 10), of->own, at);
}

bool m_word(OpenBlock& open, Block& block, Words& words, IsoWords& iso, const Given& given) {
  constexpr double kCall = 98, kReturn = 99, kInterruptOn = 96, kInterruptOff = 97;
  const double code = given.value.number;
  if (code == kInterruptOn || code == kInterruptOff)
    return open.not_computed(block, "programs that interrupt others, M96 in ISO mode",
                             given.value.at);
  if (code == kCall) {
    if (iso.call) return open.refuse(block, Cause::CallGivenTwice, "a second call", given.value.at);
    iso.call = given.value;
    return true;
  }
  words.any = true;
  if (code == kReturn) {
    iso.back = given.value;
    return true;
  }
  if (code != std::floor(code) || code < 0)
    return open.refuse(block, Cause::WholeNumberExpected, "its number is whole", given.value.at);
  if (!m_code(open, block, words, given.value)) return false;
  if (words.back && !iso.back) iso.back = given.value;  // M17
  return true;
}

/// Pass over ( ), a comment.
bool comment(OpenBlock& open, Block& block) {
  const std::uint32_t at = open.line.offset();
  const std::size_t close = open.line.rest().find(')');
  if (close != std::string_view::npos) return open.line.pass(close + 1), true;
  open.line.pass(1);
  return open.refuse(block, Cause::CommentNotClosed, "the comment has no )", at);
}

/// Refuse what begins with no letter.
bool other_character(OpenBlock& open, Block& block, std::uint32_t at) {
  const char first = open.line.peek();
  const std::string_view character = first_character(open.line.rest());
  open.line.pass(character.size());
  if (first == ',')
    return open.not_computed(block,
                             "a chamfer or a rounding in ISO mode: G290, CHR or RND after it", at);
  if (first == '#') return open.not_computed(block, "variables in ISO mode", at);
  return open.refuse(block, Cause::IllegalCharacter, "no word begins with this character", at);
}

/// Keep the value of P or L until the code that it belongs to is known.
bool keep(OpenBlock& open, Block& block, std::optional<Given>& kept, const Given& given) {
  if (kept)
    return open.refuse(block, Cause::AddressGivenTwice, "the address is in the block twice",
                       given.value.at);
  kept = given;
  return true;
}

// A line for each kind of word.
// NOLINTNEXTLINE(readability-function-cognitive-complexity)
bool iso_word(OpenBlock& open, Block& block, Words& words, IsoWords& iso) {
  const std::uint32_t at = open.line.offset();
  if (open.line.peek() == '(') return comment(open, block);
  if (open.line.begins_word()) {
    const std::string name = capitals(open.line.name());
    open.line.pass(name.size());
    return open.not_computed(
        block, name + " in ISO mode: G290 before it begins the control's own language", at);
  }
  const char letter = open.line.peek();
  if (!is_letter(letter)) return other_character(open, block, at);
  open.line.pass(1);
  Given given;
  if (!number_of(open, block, letter, at, given)) return false;
  switch (letter) {
    case 'G':
      return g_word(open, block, words, iso, given);
    case 'M':
      return m_word(open, block, words, iso, given);
    case 'O':
      return reported(open, words, at);
    case 'P':
      return keep(open, block, iso.p, given);
    case 'L':
      return keep(open, block, iso.l, given);
    case 'D':
    case 'H':
      return open.not_computed(
          block, "the offsets that D and H choose in ISO mode: G290, and D after it", at);
    default:
      break;
  }
  if (kIsoAddresses.find(letter) == std::string_view::npos)
    return open.refuse(block, Cause::AddressNotUsable,
                       std::string(1, letter) + " cannot be an address of a block in ISO mode", at);
  if (letter == 'T' && given.value.number != std::floor(given.value.number))
    return open.refuse(block, Cause::WholeNumberExpected, "its number is whole", at);
  return put(open, block, words, letter - 'A', given.value);
}

/// Let G4 X5 and G4 P5000 be G4 F5.
bool write_dwell(OpenBlock& open, Block& block, Words& words, IsoWords& iso) {
  Value time;
  const auto x = static_cast<std::size_t>('X' - 'A');
  if (iso.p) {
    time = iso.p->value;
    time.number *= 1e-3;  // of milliseconds
    iso.p.reset();
  } else if ((words.list.mask & bit('X')) != 0) {
    time.number = words.list.values[x].value;
    words.list.mask &= ~bit('X');
  } else {
    return true;
  }
  return put(open, block, words, 'F' - 'A', time);
}

Operand constant(const Value& value, double number) {
  Operand operand;
  operand.kind = Operand::Kind::Constant;
  operand.value = number;
  operand.at = value.at;
  operand.width = value.width;
  return operand;
}

/// Write M98 P21, M98 P30021 for three passes of 0021, or M98 P21 L3.
bool write_call(OpenBlock& open, Block& block, const Words& words, const IsoWords& iso,
                const Value& m98) {
  const auto refuse = [&](Cause cause, const char* detail, const Value& word) {
    return refuse_word(open, block, cause, detail, word);
  };
  if (!iso.p) return refuse(Cause::ProgramNumberMissing, "M98 without P", m98);
  const std::string_view digits = iso.p->digits;
  const Value& p = iso.p->value;
  if (!std::all_of(digits.begin(), digits.end(), is_digit))
    return refuse(Cause::IllegalProgramNumber, "P is the number of a program", p);
  if (digits.size() > kMostDigitsOfP)
    return refuse(Cause::TooManyDigits, "P has at most 8 digits", p);
  if (iso.back || words.ends)
    return refuse(Cause::CodeNotComputed,
                  "cncsub does not compute M98 beside the end of the program", m98);
  const std::size_t before = digits.size() - std::min(digits.size(), kProgramDigits);
  if (before > 0 && iso.l)
    return refuse(Cause::CodeNotComputed, "cncsub does not compute a count in P and another in L",
                  iso.l->value);
  CallRecord call = iso_call(open, digits.substr(before), m98.at);
  call.kind = CallKind::Subprogram;
  call.width = m98.width;
  call.extras.make().name_at = p.at;
  call.extras.make().name_width = p.width;
  if (before > 0) call.l = constant(p, std::floor(p.number * 1e-4));
  if (iso.l) call.l = constant(iso.l->value, iso.l->value.number);
  open.to.words(block, words.list);
  open.to.become(block, Op::Call, std::move(call));
  return true;
}

/// Write M99, or M99 P100: the block to return to.
bool write_return(OpenBlock& open, Block& block, const Words& words, const IsoWords& iso,
                  const Value& m99) {
  if (words.ends)
    return refuse_word(open, block, Cause::CodeNotComputed,
                       "cncsub does not compute M30 beside the return", m99);
  CallRecord back;
  back.at = m99.at;
  back.width = m99.width;
  if (iso.p) {
    CallExtras& to = back.extras.make();
    to.by_values = true;
    to.name = "N" + std::string(iso.p->digits);
    to.name_at = iso.p->value.at;
    to.name_width = iso.p->value.width;
  }
  open.to.words(block, words.list);
  open.to.become(block, Op::Return, std::move(back));
  return true;
}

bool write(OpenBlock& open, Block& block, Words& words, IsoWords& iso) {
  if (!switch_mode(open, block, words, iso.call || iso.back || iso.p || iso.l)) return false;
  if (iso.dwell && !write_dwell(open, block, words, iso)) return false;
  if (iso.l && !iso.call)
    return refuse_word(open, block, Cause::AddressNotUsable, "L belongs to M98", iso.l->value);
  if (iso.p && !iso.call && !iso.back)
    return refuse_word(open, block, Cause::AddressNotUsable, "P belongs to M98, M99 or G4",
                       iso.p->value);
  for (const Drop& drop : words.drops) open.to.drop(drop.at, drop.width);
  if (iso.call) return write_call(open, block, words, iso, *iso.call);
  if (iso.back) return write_return(open, block, words, iso, *iso.back);
  open.to.words(block, words.list);
  if (words.ends) block.op = Op::EndProgram;
  return true;
}

}  // namespace

/// Return what a program is known by: its number, or its name.
static std::string key_of(std::string_view name) {
  const std::int64_t number = number_in(name);
  return number >= 0 ? std::to_string(number) : capitals(name);
}

bool has_iso_mode(const Control& control) {
  constexpr double kMilling = 1, kNewMilling = 4;  // ISO_21, ISO_22
  const double system = control.parameter("10880");
  return control.parameter("18800") != 0 && (system == kMilling || system == kNewMilling);
}

bool mode_code(OpenBlock& open, Block& block, Words& words, int code, const Value& word) {
  if (code == kIsoModeOn && !has_iso_mode(open.to.control()))
    return open.not_computed(block,
                             "the ISO mode of a control whose machine data do not switch it on for "
                             "milling: 18800 = 1, and 10880 = 1 or 4",
                             word.at);
  words.iso_mode = code == kIsoModeOn;
  words.iso_mode_at = word.at;
  words.iso_mode_width = word.width;
  return true;
}

bool switch_mode(OpenBlock& open, Block& block, const Words& words, bool beside_call) {
  if (!words.iso_mode) return true;
  const WordList& list = words.list;
  const bool beside = beside_call || list.g_count > 0 || list.m_count > 0 || list.mask != 0 ||
                      !words.statements.empty() || words.print || !words.drops.empty() ||
                      words.call || words.modal || words.back || !words.positions.empty();
  if (beside || block.skip != 0)
    return refuse_word(open, block, Cause::CodeNotComputed,
                       beside ? "cncsub does not compute G290 or G291 beside other words"
                              : "cncsub does not compute a change of the mode that a switch skips",
                       {.at = words.iso_mode_at, .width = words.iso_mode_width});
  open.iso_mode = *words.iso_mode;
  return true;
}

CallRecord iso_call(const OpenBlock& open, std::string_view name, std::uint32_t at) {
  CallRecord call = call_of(open, name, at);
  call.extras.make().count = kCount;
  return call;
}

std::vector<std::string> programs_called_in_iso_mode(const Code& code) {
  std::vector<std::string> called;
  if (!has_iso_mode(*code.control)) return called;
  for (const CallRecord& call : code.calls)
    if (!call.name().empty() && call.extras.get().count == kCount && !call.extras.get().by_values)
      called.push_back(key_of(call.name()));
  std::sort(called.begin(), called.end());
  called.erase(std::unique(called.begin(), called.end()), called.end());
  return called;
}

bool is_called_in_iso_mode(const std::vector<std::string>& called, std::string_view name) {
  return !called.empty() && std::binary_search(called.begin(), called.end(), key_of(name));
}

void read_iso_block(OpenBlock& open, Block& block) {
  Words words;
  IsoWords iso;
  while (!open.line.at_end())
    if (!iso_word(open, block, words, iso)) return;
  write(open, block, words, iso);
}

}  // namespace cncsub::sinumerik
