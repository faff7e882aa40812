#include "cncsub/flat/blocks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "cncsub/control/g_codes.hpp"

namespace cncsub {

namespace {

/// Remove the blank that a part ends with, at the end of a line.
void end_line(std::string& to) {
  if (!to.empty() && to.back() == ' ') to.pop_back();
}

}  // namespace

/// Makes the line of one block.
class BlockWriter::Maker {
 public:
  Maker(BlockWriter& to, const Block& block, const std::array<std::int64_t, 2>* profile)
      : to_(to), block_(block), profile_(profile) {
    const Code& code = to.code_;
    if ((block.flags & Block::kCodeExpression) == 0) codes_ = code.codes_of(block);
    cells_ = code.cells.data() + block.data;
    if ((block.flags & Block::kHasExtra) != 0) {
      expressions_ = cells_->extra.expressions;
      whole_ = cells_->extra.whole;
      ++cells_;
    }
    cells_ += block.code_cells();
    left_ = block.mask;
    if ((block.flags & Block::kHasForms) != 0) {
      const Cell::Extra forms = cells_[std::popcount(block.mask)].extra;
      formed_ = forms.expressions | forms.whole;
      increments_ = forms.whole;
    }
    if ((block.flags & Block::kCodeExpression) != 0) add({Part::Kind::Codes, 'G', 0, 0});
  }

  void take(const WrittenWord& word);
  void take_rest();
  const std::string& failed() const { return failed_; }
  /// Return the part that says which word cannot be written.
  Part unwritten() const { return {Part::Kind::Unwritten, failed_[0], 0, 0}; }

 private:
  void add(Part part) { to_.parts_.push_back(part); }
  double constant(int place) const {
    const auto before = static_cast<std::uint32_t>(block_.mask & ((1u << place) - 1));
    return cells_[std::popcount(before)].value;
  }
  /// Return whether an M code is the end of the block's program.
  bool ends(int m) const {
    return block_.op == Op::EndProgram && to_.code_.control->calls.roles.value.of_m(m) == Role::End;
  }
  bool take_code(char letter, const WrittenWord& word);
  bool take_code_word(const WrittenWord& word);
  void pass_code(const std::string& name);
  bool take_end(const WrittenWord& word);
  void take_formed(int place, const WrittenWord& word);
  void take_value(int place, const WrittenWord& word);
  void take_left(int place);
  void text(char letter, const WrittenWord& word);

  BlockWriter& to_;
  const Block& block_;
  const std::array<std::int64_t, 2>* profile_;
  CodeList codes_;
  const Cell* cells_ = nullptr;
  std::uint32_t expressions_ = 0, whole_ = 0, left_ = 0;
  std::uint32_t formed_ = 0;      // the words whose value has a form of its own
  std::uint32_t increments_ = 0;  // those of them that are increments
  std::uint32_t g_taken_ = 0, m_taken_ = 0;
  bool ended_ = false;
  std::string failed_;
};

/// Add the text of a word. A code that calls where it stands as a number was executed as a word: it
/// is written in brackets.
void BlockWriter::Maker::text(char letter, const WrittenWord& word) {
  if (!to_.words_.calls(letter, word.value)) return to_.add_text(word.text);
  std::string written;
  if (to_.words_.bracketed(written, std::string(1, letter), word.value))
    to_.add_text(written);
  else
    failed_ = word.text;
}

bool BlockWriter::Maker::take_end(const WrittenWord& word) {
  const double m = word.value;
  if (ended_ || m != std::floor(m) || !ends(to_whole<int>(m))) return false;
  ended_ = true;
  to_.add_text(word.text);
  return true;
}

bool BlockWriter::Maker::take_code(char letter, const WrittenWord& word) {
  const bool g = letter == 'G';
  const std::span<const int> codes = g ? codes_.g() : codes_.m();
  std::uint32_t& taken = g ? g_taken_ : m_taken_;
  const double code = g ? std::round(word.value * 10) : word.value;
  for (std::size_t i = 0; i < codes.size(); ++i) {
    if (codes[i] != code || (taken >> i & 1) != 0) continue;
    taken |= 1u << i;
    ended_ = ended_ || (!g && ends(codes[i]));
    text(letter, word);
    return true;
  }
  return !g && take_end(word);
}

/// Take a word as it is written, with a number for what is computed.
void BlockWriter::Maker::take_formed(int place, const WrittenWord& word) {
  if ((expressions_ >> place & 1) == 0)
    to_.add_text(word.text);
  else if (const std::size_t open = word.text.find('('); open < word.text.size())
    to_.add_formed(word.text.substr(0, open + 1), static_cast<std::uint8_t>(place));
  else
    failed_ = word.text;
}

void BlockWriter::Maker::take_value(int place, const WrittenWord& word) {
  const std::uint32_t mark = 1u << place;
  if ((left_ & mark) == 0) return;
  if ((formed_ & mark) != 0) {
    take_formed(place, word);
  } else if (profile_ != nullptr && (place == 'P' - 'A' || place == 'Q' - 'A')) {
    const std::int64_t n = (*profile_)[place == 'P' - 'A' ? 0 : 1];
    to_.add_text(static_cast<char>('A' + place) + std::to_string(n));
  } else if ((expressions_ & mark) != 0 && word.address.ends_with(']')) {  // POS[X]=R1
    to_.add_formed(word.address + "=(", static_cast<std::uint8_t>(place));
  } else if ((expressions_ & mark) != 0 && word.address.size() > 1 &&
             to_.code_.spelling->address_of(place) != word.address) {
    failed_ = word.text;  // of two addresses in one place the other would be written
  } else if ((expressions_ & mark) != 0) {
    add({Part::Kind::Word, 0, static_cast<std::uint32_t>(place), 0});
  } else if (word.address.size() > 1 && word.address.front() != ',') {
    to_.add_text(word.text);  // I1=5, which is no I
  } else if (word.known && word.value == constant(place)) {
    text(static_cast<char>('A' + place), word);
  } else {
    return;
  }
  left_ &= ~mark;
}

/// Take the G code that a word with an index stands for: POS[X]=5.
void BlockWriter::Maker::pass_code(const std::string& name) {
  const int code = code_of_word(name);
  for (std::size_t i = 0; code >= 0 && i < codes_.g_count; ++i)
    if (codes_.g_codes[i] == code) g_taken_ |= 1u << i;
}

/// Add a G code that is written as a word, where the block has it.
bool BlockWriter::Maker::take_code_word(const WrittenWord& word) {
  const int code = code_of_word(word.address);
  if (code < 0) return false;
  for (std::size_t i = 0; i < codes_.g_count; ++i) {
    if (codes_.g_codes[i] != code || (g_taken_ >> i & 1) != 0) continue;
    g_taken_ |= 1u << i;
    to_.add_text(word.text);
    break;
  }
  return true;
}

void BlockWriter::Maker::take(const WrittenWord& word) {
  if (take_code_word(word)) return;
  if (word.address.ends_with(']')) {
    pass_code(word.address.substr(0, word.address.find('[')));
    pass_code("POS");  // FA[X]=500 is of its blocks, too
  }
  if (word.address == "G" || word.address == "M") {
    if (word.known) take_code(word.address.front(), word);
    return;
  }
  if (const int place = to_.code_.spelling->place_of(word.address); place >= 0)
    take_value(place, word);
}

/// Add a value that the text does not spell.
void BlockWriter::Maker::take_left(int place) {
  const bool formed = (formed_ >> place & 1) != 0, computed = (expressions_ >> place & 1) != 0;
  const Spelling& spelling = *to_.code_.spelling;
  if (formed && computed) {  // AX[AXIS]=IC(2)
    const bool adds = (increments_ >> place & 1) != 0;
    const Spelling::Around& form = adds ? spelling.incremental : spelling.absolute;
    to_.add_formed(spelling.address_of(place) + "=" + std::string(form.before),
                   static_cast<std::uint8_t>(place));
  } else if (formed) {
    failed_ = spelling.address_of(place);
  } else if (computed) {
    add({Part::Kind::Word, 0, static_cast<std::uint32_t>(place), 0});
  } else {
    std::string text;
    to_.words_.constant(text, place, constant(place), (whole_ >> place & 1) != 0);
    to_.add_text(text);
  }
}

/// Add what the text does not spell.
void BlockWriter::Maker::take_rest() {
  for (std::size_t i = 0; i < codes_.g_count; ++i)
    if (std::string text; (g_taken_ >> i & 1) == 0) {
      to_.words_.code(text, 'G', codes_.g_codes[i]);
      to_.add_text(text);
    }
  for (; left_ != 0; left_ &= left_ - 1) take_left(std::countr_zero(left_));
  if ((block_.flags & Block::kCodeExpression) != 0) add({Part::Kind::Codes, 'M', 0, 0});
  for (std::size_t i = 0; i < codes_.m_count; ++i)
    if (std::string text; (m_taken_ >> i & 1) == 0) {
      ended_ = ended_ || ends(codes_.m_codes[i]);
      to_.words_.code(text, 'M', codes_.m_codes[i] * 10);
      to_.add_text(text);
    }
  const auto end = to_.code_.control->calls.roles.value.code_of(Role::End);
  if (block_.op == Op::EndProgram && !ended_ && end) to_.add_text(end->text());
}

BlockWriter::BlockWriter(const Machine& machine)
    : code_(machine.code()), words_(machine), lines_(code_.blocks.size()) {}

/// Add a text; one after another text becomes one with it.
void BlockWriter::add_text(std::string_view text) {
  Part* last = parts_.empty() ? nullptr : &parts_.back();
  const bool joins = last != nullptr && last->kind == Part::Kind::Text && last->size != 0 &&
                     last->at + last->size == texts_.size() && parts_.size() > open_;
  if (!joins) parts_.push_back({Part::Kind::Text, 0, static_cast<std::uint32_t>(texts_.size()), 0});
  texts_ += text;
  texts_ += ' ';
  parts_.back().size = static_cast<std::uint32_t>(texts_.size()) - parts_.back().at;
}

/// Add a word up to its value in brackets, which is written where the block is.
void BlockWriter::add_formed(std::string_view before, std::uint8_t place) {
  const auto at = static_cast<std::uint32_t>(texts_.size());
  texts_ += before;
  parts_.push_back({Part::Kind::Formed, 0, at, static_cast<std::uint32_t>(before.size()), place});
}

BlockWriter::Line BlockWriter::make(const Block& block, std::int32_t program,
                                    const std::array<std::int64_t, 2>* profile) {
  open_ = parts_.size();
  Maker maker(*this, block, profile);
  const Program& own = code_.programs[static_cast<std::size_t>(program)];
  const std::string_view text = code_.text_of(block, own).substr(0, kLookedAt);
  std::size_t from = 0;
  while (const auto word = code_.read_word(text, from)) maker.take(*word);
  maker.take_rest();
  if (!maker.failed().empty()) parts_.push_back(maker.unwritten());
  return {static_cast<std::uint32_t>(open_), static_cast<std::uint32_t>(parts_.size() - open_ + 1)};
}

const BlockWriter::Line& BlockWriter::line_of(const Block& block, std::int32_t program) {
  const Block* const first = code_.blocks.data();
  const bool own = &block >= first && &block < first + code_.blocks.size();
  Line& line = own ? lines_[static_cast<std::size_t>(&block - first)]
                   : variants_[static_cast<std::uint32_t>(&block - code_.variants.data())];
  if (line.parts == 0) line = make(block, program);
  return line;
}

bool BlockWriter::put_codes(std::string& to, char letter, const BlockCodes& codes) {
  const bool g = letter == 'G';
  for (const int code : g ? codes.g() : codes.m()) {
    if (!words_.code(to, letter, g ? code : code * 10)) {
      failed_ = letter + std::to_string(code);
      return false;
    }
    to += ' ';
  }
  return true;
}

bool BlockWriter::put(std::string& to, const Line& line, const NcWords* values) {
  const Part* part = parts_.data() + line.first;
  if (values != nullptr) words_.begin(*values->codes);
  for (std::uint32_t i = 1; i < line.parts; ++i, ++part) {
    if (part->kind == Part::Kind::Unwritten) {
      failed_ = part->letter;
      return false;
    }
    if (part->kind == Part::Kind::Text)
      to.append(texts_, part->at, part->size);
    else if (values != nullptr && !put_value(to, *part, *values))
      return false;
  }
  end_line(to);
  return true;
}

/// Write codes or a word whose value was computed, where the block has it.
bool BlockWriter::put_value(std::string& to, const Part& part, const NcWords& values) {
  if (part.kind == Part::Kind::Codes) return put_codes(to, part.letter, *values.codes);
  if (part.kind == Part::Kind::Formed) {
    if ((values.mask >> part.place & 1) == 0) return true;
    to.append(texts_, part.at, part.size);
    words_.value(to, part.place, values.value[part.place]);
    to += ") ";
    return true;
  }
  if ((values.mask >> part.at & 1) == 0) return true;
  if (!words_.computed(to, static_cast<int>(part.at), values.value[part.at])) {
    failed_ = static_cast<char>(part.at < 26 ? 'A' + part.at : ',');
    return false;
  }
  to += ' ';
  return true;
}

bool BlockWriter::write(std::string& to, const Block& block, std::int32_t program,
                        const NcWords* values) {
  return put(to, line_of(block, program), values);
}

bool BlockWriter::write_cycle(std::string& to, const Block& block, std::int32_t program,
                              const NcWords* values, const std::array<std::int64_t, 2>& profile) {
  const std::size_t parts = parts_.size(), texts = texts_.size();
  const bool done = put(to, make(block, program, &profile), values);
  parts_.resize(parts);
  texts_.resize(texts);
  return done;
}

}  // namespace cncsub
