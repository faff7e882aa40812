#include "cncsub/analysis/mentions.hpp"

#include <algorithm>
#include <charconv>
#include <set>
#include <tuple>
#include <utility>

#include "cncsub/analysis/mention_reader.hpp"
#include "cncsub/analysis/profiles.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

constexpr std::size_t kMostReturns = 1 << 20;  // looked up in the callers of a program

/// Return whether a block may name another block or a program.
bool may_name(Op op) {
  return may_call(op) || op == Op::Return || op == Op::Jump || op == Op::Goto || op == Op::IfGoto ||
         op == Op::HCode || op == Op::Switch || op == Op::Fault;
}

/// Return the number in a text such as N40, or 40; -1 where it is none.
std::int64_t block_number_in(std::string_view text) {
  if (!text.empty() && upper(text.front()) == 'N') text.remove_prefix(1);
  const bool digits =
      !text.empty() && text.size() < 12 && std::all_of(text.begin(), text.end(), is_digit);
  std::int64_t number = -1;
  if (digits) std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

// ---- places ----

Mention& MentionReader::add(Mention::Kind kind, TextPlace place) {
  Mention& mention = found_.emplace_back();
  mention.kind = kind;
  mention.program = program_;
  mention.block = at_;
  mention.place = place;
  if (at_ == kNowhere) return mention;
  // What the block does not write, as an argument that is left out, is named by all of it.
  const Block& block = code_.blocks[at_];
  if (place.at < block.text || place.at > block.text + block.length) {
    mention.place = {block.text, block.length};
    mention.fixed = true;
  }
  return mention;
}

Mention& MentionReader::number(TextPlace place, std::int64_t n) {
  const auto digits = digits_in(text(), place, n);
  Mention& mention = add(Mention::Kind::Number, digits.value_or(place));
  mention.number = n;
  mention.fixed = !digits;
  mention.to_program = program_;
  return mention;
}

void MentionReader::computed(Mention::Kind kind, TextPlace place, std::int32_t to_program) {
  Mention& mention = add(kind, place);
  mention.computed = true;
  mention.to_program = to_program;
}

/// Return the word of an address in the block; nothing where it has none.
std::optional<TextPlace> MentionReader::word(std::string_view address, double value) const {
  const Block& block = code_.blocks[at_];
  const std::string_view whole = code_.text_of(block, own());
  std::size_t from = 0;
  while (const auto word = code_.read_word(whole, from))
    if (word->address == address && word->known && word->value == value)
      return TextPlace{block.text + word->at, word->width};
  return std::nullopt;
}

// ---- blocks ----

/// Add the beginning of a block that has no number. None can stand before the values of a branch,
/// `2, 3:`, and the second block of a statement that does two things has that of the first.
void MentionReader::unnumbered(const Block& block) {
  const std::string_view whole = code_.text_of(block, own());
  const bool second = at_ > own().first && code_.blocks[at_ - 1].text == block.text;
  if (second || (!whole.empty() && is_digit(whole[0]))) return;
  std::size_t from = 0;
  auto first = code_.read_word(whole, from);
  while (first && first->address == "/") first = code_.read_word(whole, from);
  if (!first || block.op == Op::Fault) return;
  const auto width = static_cast<std::uint32_t>(first_character(whole.substr(first->at)).size());
  Mention& mention = add(Mention::Kind::Number, {block.text + first->at, width});
  mention.defines = true;
  mention.to_program = program_;
  mention.to = at_;
}

void MentionReader::sequence_number(const Block& block) {
  const std::string_view whole = code_.text_of(block, own());
  std::size_t from = 0;
  std::optional<WrittenWord> n;
  bool others = false;
  for (auto word = code_.read_word(whole, from); word; word = code_.read_word(whole, from)) {
    const bool numbers = word->address == "N" || word->address == ":";  // :10 of a main block
    if (!n && numbers && word->known && word->value == block.n)
      n = std::move(word);
    else
      others = others || word->address != "/";
    if (n && others) break;
  }
  const TextPlace place =
      n ? TextPlace{block.text + n->at, n->width} : TextPlace{block.text, block.length};
  Mention& mention = number(place, block.n);
  mention.defines = true;
  mention.to = at_;
  if (!n || !others) return;
  std::size_t end = std::size_t{n->at} + n->width;
  while (end < whole.size() && is_blank(whole[end])) ++end;
  mention.word = {place.at, static_cast<std::uint32_t>(end - n->at)};
}

void MentionReader::profile(const Block& block) {
  if (!cuts_profile(code_, codes_, block)) return unknown_profile(block);
  const NamedProfile named = profile_of(code_, own(), at_);
  for (const auto& [address, n, to] :
       {std::tuple('P', named.p, named.first), std::tuple('Q', named.q, named.last)}) {
    const auto place = word(std::string(1, address), static_cast<double>(n));
    if (n < 0 || !place)
      computed(Mention::Kind::Number, {block.text, block.length}, program_);
    else
      number(*place, n).to = to;
  }
}

/// Report P and Q that may name blocks of the program, beside a code whose meaning is not known
/// here: each is computed, and has a number.
void MentionReader::unknown_profile(const Block& block) {
  const std::uint32_t both = bit('P') | bit('Q');
  if ((block.mask & both) != both || block.g_count == 0) return;
  bool known = true;
  const CodeList list = code_.codes_of(block);
  for (const int g : list.g()) {
    const Meaning meaning = codes_.find(g).meaning;
    known = known && meaning != Meaning::Uncomputed && meaning != Meaning::Unknown &&
            meaning != Meaning::None;
  }
  const NamedProfile named = profile_of(code_, own(), at_);
  if (known || code_.first_of(own(), named.p) == kNowhere ||
      code_.first_of(own(), named.q) == kNowhere)
    return;
  for (const auto& [address, n] : {std::pair("P", named.p), std::pair("Q", named.q)}) {
    const auto place = word(address, static_cast<double>(n));
    computed(Mention::Kind::Number, place.value_or(TextPlace{block.text, block.length}), program_);
    found_.back().number = n;
  }
}

/// Add what a jump or a part names: a block number or a label.
void MentionReader::target(TextPlace place, Address to, bool in_caller, std::int32_t to_program) {
  const std::string_view written = text().substr(place.at, place.width);
  const std::int64_t n = block_number_in(trimmed(written));
  Mention& mention = n >= 0 ? number(place, n) : add(Mention::Kind::Label, place);
  if (n < 0) mention.name = capitals(trimmed(written));
  mention.in_caller = in_caller;
  mention.to_program = to_program;
  mention.to = to;
}

void MentionReader::jump(const JumpReference& jump) {
  if (jump.in_caller) return back(jump);
  if (jump.computed) return computed(Mention::Kind::Number, *jump.computed, program_);
  if (jump.n < 0) return target(jump.place, jump.to, false, program_);
  Address to = jump.to;
  if (to == kNowhere) to = code_.jump_target(own(), jump.n, at_);
  number(jump.place, jump.n).to = to;
}

/// Add a return to a block of the program that called: once for each block that may be meant.
void MentionReader::back(const JumpReference& jump) {
  const auto& callers = callers_[static_cast<std::size_t>(program_)];
  std::set<std::pair<std::int32_t, Address>> to;
  for (const Site& site : callers) {
    if (++looked_up_ > kMostReturns)
      return computed(Mention::Kind::Number, jump.place, site.program);
    const Program& caller = code_.programs[static_cast<std::size_t>(site.program)];
    to.emplace(site.program,
               jump.computed ? kNowhere : code_.return_target(caller, jump.n, site.at));
  }
  if (callers.empty()) to.emplace(program_, code_.first_of(own(), jump.n));
  for (const Site& site : jump.computed ? std::vector<Site>() : computed_callers_) {
    if (++looked_up_ > kMostReturns)
      return computed(Mention::Kind::Number, jump.place, site.program);
    const Program& caller = code_.programs[static_cast<std::size_t>(site.program)];
    const Address found = code_.return_target(caller, jump.n, site.at);
    if (found != kNowhere) to.emplace(site.program, found);
  }
  for (const auto& [program, block] : to) {
    if (jump.computed) {
      computed(Mention::Kind::Number, *jump.computed, program);
      continue;
    }
    Mention& mention = number(jump.place, jump.n);
    mention.in_caller = true;
    mention.to_program = program;
    mention.to = block;
  }
}

/// Add the block that RET("N40") names in the programs that call.
void MentionReader::return_by_values(const CallRecord& back) {
  const CallExtras& extras = back.extras.get();
  if (!extras.by_values || extras.name.empty()) return;
  const std::string_view written = text().substr(extras.name_at, extras.name_width);
  const std::size_t quote = written.find('"') + 1;  // 0 where there is none
  const TextPlace place{extras.name_at + static_cast<std::uint32_t>(quote),
                        static_cast<std::uint32_t>(written.find_last_of('"') - quote)};
  const std::int64_t n = block_number_in(extras.name);
  for (const Site& site : callers_[static_cast<std::size_t>(program_)]) {
    const Program& caller = code_.programs[static_cast<std::size_t>(site.program)];
    const Address to = n < 0 ? kNowhere : code_.named_return_target(caller, extras.name, site.at);
    target(place, to, true, site.program);
  }
}

/// Add the blocks of a part that is found when it is called. What a text names is computed, and so
/// is a number in another program.
void MentionReader::searched_part(const CallRecord& call) {
  const CallExtras& extras = call.extras.get();
  const bool is_own = call.name().empty() && !call.name_text().present();
  for (const Operand* of : {&extras.first_text, &extras.last_text}) {
    const TextPlace place{of->at, of->width};
    const bool written = of->kind == Operand::Kind::Constant;
    const std::string name = written ? code_.texts.at(to_whole<std::size_t>(of->value)) : "";
    if (!written || (!is_own && block_number_in(name) >= 0))
      computed(Mention::Kind::Number, place, is_own ? program_ : kNoProgram);
    else if (is_own)
      target(place, code_.named_return_target(own(), name, own().first - 1), false, program_);
  }
}

void MentionReader::part(const CallRecord& call) {
  const CallExtras& extras = call.extras.get();
  if (extras.first_text.present()) return searched_part(call);
  const Address first = call.target.start;
  target({extras.name_at, extras.name_width}, first, false, program_);
  if (extras.last_width == 0) return;
  const TextPlace place{extras.last_at, extras.last_width};
  const std::int64_t n = block_number_in(trimmed(text().substr(place.at, place.width)));
  target(place, n < 0 ? kNowhere : code_.first_from(own(), n, first), false, program_);
}

/// Add a number or a label that leads nowhere: the block is refused for it.
void MentionReader::fault(const Fault& fault) {
  const bool names =
      fault.cause == Cause::JumpTargetNotFound || fault.cause == Cause::PartIncomplete;
  if (names && fault.width > 0) target({fault.at, fault.width}, kNowhere, false, program_);
}

// ---- all ----

void MentionReader::block(const Block& block) {
  if (block.op == Op::Fault) {
    if (asked_.blocks) fault(code_.faults[block.aux]);
  } else if (block.op == Op::OWord) {
    o_word(code_.o_words[block.aux]);
  } else if (!asked_.blocks) {
    return;
  } else if (block.op == Op::RepeatPart) {
    part(code_.calls[block.aux]);
  } else if (block.op == Op::Return) {
    return_by_values(code_.calls[block.aux]);
  } else {
    profile(block);
  }
}

/// Return whether a mention stands where it is asked for, and names what is asked for.
bool MentionReader::is_asked(const Mention& mention) const {
  const auto& [part, named] = std::tie(asked_.part, asked_.named);
  if (part && (mention.place.at < part->from || mention.place.at > part->to)) return false;
  if (!named) return true;
  if (mention.computed || mention.to_program != named->program) return false;
  if (mention.kind == Mention::Kind::Program) return true;
  if (mention.kind != Mention::Kind::Variable) return mention.to == named->block;
  return mention.number == named->number &&
         (mention.number >= 0 || capitals(mention.name) == named->name);
}

/// Return whether it is worth reading a block.
bool MentionReader::may_be_asked(const Block& block) const {
  if (!asked_.part) return true;
  return block.text <= asked_.part->to && block.text + block.length >= asked_.part->from;
}

/// Drop the mentions from `from` on that nobody asks for.
void MentionReader::drop_unasked(std::size_t from) {
  if (!asked_.part && !asked_.named) return;
  const auto first = found_.begin() + static_cast<std::ptrdiff_t>(from);
  found_.erase(
      std::remove_if(first, found_.end(), [this](const Mention& of) { return !is_asked(of); }),
      found_.end());
}

/// Add what a block gives a name to.
void MentionReader::definitions(const Block& block) {
  if (asked_.named && asked_.named->block != at_) return;
  if (block.n >= 0)
    sequence_number(block);
  else if (asked_.unnumbered)
    unnumbered(block);
  if (!labelled_.empty()) label_of(at_);
}

/// Add what a block calls and where it jumps.
void MentionReader::references(const Block& block) {
  const References found = references_of(code_, block, program_);
  for (const CallReference& of : found.calls)
    if (block.op != Op::RepeatPart) call(of);
  if (!asked_.blocks) return;
  for (const JumpReference& of : found.jumps) jump(of);
}

void MentionReader::program(std::int32_t index, InterruptCheck& interrupt) {
  program_ = index;
  if (asked_.part && own().file != asked_.part->file) return;
  head();
  drop_unasked(0);
  for (at_ = own().first; at_ < own().last; ++at_) {
    const Block& block = code_.blocks[at_];
    if (interrupt.requested(block.length + InterruptCheck::kBlock)) return;
    if (!may_be_asked(block) || code_.program_at(at_) != program_) continue;
    const std::size_t before = found_.size();
    if (asked_.blocks) definitions(block);
    each_variant(code_, block, [this](const Block& of) { this->block(of); });
    if (may_name(block.op)) references(block);
    if (asked_.programs && code_.spelling->program_name.before.empty()) declared(block);
    if (asked_.variables) variables(block);
    drop_unasked(before);
  }
}

void MentionReader::collect_calls(InterruptCheck& interrupt) {
  callers_.resize(code_.programs.size());
  for (std::size_t p = 0; p < code_.programs.size(); ++p) {
    const Program& program = code_.programs[p];
    if (code_.files[program.file].system) continue;
    const auto index = static_cast<std::int32_t>(p);
    for (Address at = program.first; at < program.last; ++at) {
      if (interrupt.requested(InterruptCheck::kBlock)) return;
      if (!may_call(code_.blocks[at].op) || code_.program_at(at) != index) continue;
      for (const CallReference& call : references_of(code_, code_.blocks[at], index).calls) {
        if (call.computed_program)
          computed_callers_.push_back({index, at});
        else if (call.found != kNoProgram)
          callers_[static_cast<std::size_t>(call.found)].push_back({index, at});
      }
    }
  }
}

void MentionReader::collect_labels() {
  // The heads of programs that labels name are programs, not labels.
  for (const LabelledHead& head : code_.heads) {
    if (head.label >= code_.labels.size() || head.address >= code_.blocks.size()) continue;
    if (code_.blocks[head.address].op != Op::OWord)
      labelled_.emplace_back(head.address, head.label);
  }
  std::sort(labelled_.begin(), labelled_.end());
}

std::vector<Mention> MentionReader::read(InterruptCheck& interrupt) {
  if (asked_.blocks) {
    collect_calls(interrupt);
    collect_labels();
  }
  for (std::size_t p = 0; p < code_.programs.size(); ++p)
    if (!code_.files[code_.programs[p].file].system)
      program(static_cast<std::int32_t>(p), interrupt);
  // Both variants of a block mention the same.
  std::set<std::tuple<Mention::Kind, std::int32_t, std::uint32_t, std::int32_t, Address, bool,
                      std::int64_t, std::string>>
      seen;
  std::erase_if(found_, [&](const Mention& of) {
    if (of.defines && of.kind == Mention::Kind::Number) return false;
    return !seen.emplace(of.kind, of.program, of.place.at, of.to_program, of.to, of.computed,
                         of.number, capitals(of.name))
                .second;
  });
  return std::move(found_);
}

std::vector<RefusedBlock> refused_blocks(const Code& code) {
  std::vector<RefusedBlock> refused;
  for (std::size_t p = 0; p < code.programs.size(); ++p) {
    const Program& program = code.programs[p];
    for (Address at = program.first; at < program.last; ++at)
      if (code.blocks[at].op == Op::Fault)
        refused.emplace_back(static_cast<std::int32_t>(p), at - program.first);
  }
  return refused;
}

std::vector<Mention> mentions_of(const Code& code, const std::string& machine,
                                 const MentionsAsked& asked, InterruptCheck& interrupt) {
  return MentionReader(code, GCodes(*code.control, machine_of(*code.control, machine)), asked)
      .read(interrupt);
}

}  // namespace cncsub
