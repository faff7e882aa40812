#include "cncsub/analysis/formatting.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/analysis/nesting_depth.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

using Kind = BlockToken::Kind;

/// Return the tokens of a block.
std::vector<BlockToken> tokens_of(ReadWord read, std::string_view text) {
  std::vector<BlockToken> tokens;
  TokenReader reader(read, text);
  while (auto token = reader.next()) tokens.push_back(std::move(*token));
  return tokens;
}

/// A text in which comments and what stands between quotes are passed over. Round brackets may be
/// none of a comment: what stands between quotes in them is passed over as a whole.
template <class Change>
std::string outside_comments(const Spelling& spelling, std::string_view text,
                             const Change& change) {
  std::string written;
  char end = '\0';         // of the comment or the text that is open
  std::size_t quoted = 0;  // up to here a text between quotes in brackets goes
  for (std::size_t at = 0; at < text.size(); ++at) {
    const char c = text[at];
    const bool outside = end == '\0';
    if (end == ')' && c == '"' && at >= quoted) quoted = text.find('"', at + 1) + 1;  // 0: none
    if (outside && (c == '"' || (c == '(' && spelling.comment.before == "(")))
      end = c == '"' ? '"' : ')';
    else if (c == end && at >= quoted)
      end = '\0';
    if (outside && end == '\0')
      change(written, c);
    else
      written += c;
  }
  return written;
}

/// Return where the text of a block begins that it prints as it is written, as that of
/// DPRNT[...]; the end of the block where it prints none. A text between quotes is not meant.
std::size_t printed_from(const Code& code, const Block& block, std::string_view text) {
  std::size_t from = text.size();
  each_variant(code, block, [&](const Block& of) {
    if (of.op != Op::Print) return;
    std::size_t at = code.prints[of.aux].at - block.text;
    while (at < text.size() && is_blank(text[at])) ++at;
    if (at < text.size() && text[at] == '[') from = std::min(from, at);
  });
  return from;
}

class BlockLayout {
 public:
  BlockLayout(const Code& code, const Layout& layout, std::string_view text, const Block& block)
      : code_(code),
        layout_(layout),
        text_(text),
        block_(block),
        printed_(printed_from(code, block, text)) {}

  /// Return the changes of the block, as places in it; nothing where it would be read otherwise.
  std::optional<std::vector<LayoutChange>> changes();

 private:
  std::string word(const BlockToken& token) const;
  bool takes_point(const WrittenWord& word) const;
  bool joined(const BlockToken& before, const BlockToken& behind) const;
  std::string between(const BlockToken& before, std::string_view blanks,
                      const BlockToken& behind) const;
  void write(std::vector<LayoutChange>& changes);
  bool same_word(const WrittenWord& old, const WrittenWord& now) const;
  bool reads_alike(const std::string& written) const;

  const Code& code_;
  const Layout& layout_;
  std::string_view text_;
  const Block& block_;
  std::size_t printed_;  // where a text begins that is printed
  std::vector<BlockToken> tokens_;
};

/// Return whether X10 of a plain move is a length that a point does not change.
bool BlockLayout::takes_point(const WrittenWord& word) const {
  const bool moves = block_.op == Op::Linear || block_.op == Op::Arc;
  const bool millimetres = code_.control->reading.whole_numbers.value == WholeNumbers::Millimetres;
  constexpr std::uint32_t kLengths = kEndWords | kCentreWords;
  return layout_.points && moves && millimetres && word.known && word.address.size() == 1 &&
         is_letter(word.address[0]) && (bit(upper(word.address[0])) & kLengths) != 0 &&
         word.text.find_first_of(".=") == std::string::npos && is_digit(word.text.back());
}

/// Return a word as it is written by the layout.
std::string BlockLayout::word(const BlockToken& token) const {
  const std::size_t width =
      std::clamp<std::size_t>(printed_, token.at, token.at + token.width) - token.at;
  const std::string_view own = text_.substr(token.at, width);
  const bool plain =
      token.word.known && !token.word.address.empty() && own.find('(') == std::string_view::npos;
  const auto change = [&](std::string& to, char c) {
    if (plain && layout_.blanks != Layout::Blanks::Keep && is_blank(c)) return;
    to += layout_.capitals ? upper(c) : c;
  };
  std::string written = outside_comments(*code_.spelling, own, change);
  written += text_.substr(token.at + width, token.width - width);
  if (takes_point(token.word)) written += '.';
  return written;
}

/// Return whether nothing stands between a sign and the word that it belongs to.
bool BlockLayout::joined(const BlockToken& before, const BlockToken& behind) const {
  return (before.kind == Kind::Word && before.word.address == "/") ||
         (behind.kind == Kind::Word && behind.word.address == ":");
}

/// Return the blanks between two tokens that stand one after the other, but for blanks.
std::string BlockLayout::between(const BlockToken& before, std::string_view blanks,
                                 const BlockToken& behind) const {
  const bool ignored = before.kind == Kind::Ignored || behind.kind == Kind::Ignored;
  const bool ends_line = blanks.find('\n') != std::string_view::npos;
  if (layout_.blanks == Layout::Blanks::Keep || ignored || ends_line) return std::string(blanks);
  if (joined(before, behind)) return "";
  const auto statement = [](const BlockToken& of) {
    return of.kind == Kind::Word && (of.word.address.empty() || !of.word.known);
  };
  // Where a name alone calls a program, words without a blank between them are one name.
  const bool names = code_.spelling->program_name.before.empty();
  const bool needed =
      layout_.blanks == Layout::Blanks::One || names || statement(before) || statement(behind);
  return needed ? " " : "";
}

/// Write each stretch between two comments anew; the comments stay where they are.
void BlockLayout::write(std::vector<LayoutChange>& changes) {
  std::uint32_t from = 0, to = 0;
  std::string written;
  const auto end_stretch = [&] {
    if (text_.substr(from, to - from) != written) changes.push_back({from, to - from, written});
    written.clear();
  };
  const BlockToken* before = nullptr;
  std::string_view blanks;
  for (const BlockToken& token : tokens_) {
    if (token.kind == Kind::Blank) {
      blanks = text_.substr(token.at, token.width);
      to = token.at + token.width;
      continue;
    }
    if (before != nullptr) written += between(*before, std::exchange(blanks, {}), token);
    to = token.at;
    if (token.kind == Kind::Comment) {
      end_stretch();
      from = token.at + token.width;
    } else {
      written +=
          token.kind == Kind::Word ? word(token) : std::string(text_.substr(token.at, token.width));
    }
    to = token.at + token.width;
    before = &token;
  }
  if (layout_.blanks == Layout::Blanks::Keep) written += blanks;
  end_stretch();
}

/// Return whether a word is another one but for small letters, blanks and its point.
bool BlockLayout::same_word(const WrittenWord& old, const WrittenWord& now) const {
  const bool same_value = old.known == now.known && (!old.known || old.value == now.value);
  const std::string with_point = takes_point(old) ? old.text + '.' : old.text;
  return same_value && same_letters(old.address, now.address) && same_letters(with_point, now.text);
}

/// Return whether a text has the same tokens, but for its blanks.
bool BlockLayout::reads_alike(const std::string& written) const {
  std::vector<BlockToken> now = tokens_of(code_.read_word, written), old = tokens_;
  for (auto* const of : {&now, &old})
    std::erase_if(*of, [](const BlockToken& token) { return token.kind == Kind::Blank; });
  return std::equal(old.begin(), old.end(), now.begin(), now.end(),
                    [&](const BlockToken& a, const BlockToken& b) {
                      if (a.kind != b.kind) return false;
                      if (a.kind == Kind::Word) return same_word(a.word, b.word);
                      return text_.substr(a.at, a.width) ==
                             std::string_view(written).substr(b.at, b.width);
                    });
}

std::optional<std::vector<LayoutChange>> BlockLayout::changes() {
  tokens_ = tokens_of(code_.read_word, text_);
  std::vector<LayoutChange> found;
  write(found);
  if (found.empty()) return found;
  std::string written(text_);
  for (auto each = found.rbegin(); each != found.rend(); ++each)
    written.replace(each->at, each->width, each->text);
  if (!reads_alike(written)) return std::nullopt;
  return found;
}

/// Reduce a change to what differs. A change that only adds text replaces a character beside it, so
/// that it has a place of its own.
LayoutChange reduced(std::string_view file, const LayoutChange& change) {
  const std::string_view old = file.substr(change.at, change.width);
  const std::string_view text = change.text;
  std::size_t before = 0, behind = 0;
  const std::size_t most = std::min(old.size(), text.size());
  while (before < most && old[before] == text[before]) ++before;
  while (behind < most - before && old[old.size() - 1 - behind] == text[text.size() - 1 - behind])
    ++behind;
  if (before + behind == old.size() && before > 0)
    --before;
  else if (before + behind == old.size() && behind > 0)
    --behind;
  // A character is changed as a whole, however many bytes it has.
  while (before > 0 && before < old.size() && is_inside_character(old[before])) --before;
  while (behind > 0 && is_inside_character(old[old.size() - behind])) --behind;
  return {change.at + static_cast<std::uint32_t>(before),
          static_cast<std::uint32_t>(old.size() - before - behind),
          std::string(text.substr(before, text.size() - before - behind))};
}

/// Lays out the blocks of one file.
class FileLayout {
 public:
  FileLayout(const Code& code, std::uint32_t file, const Layout& layout)
      : code_(code), text_(code.files[file].text.view()), layout_(layout) {}

  void program(std::int32_t index, InterruptCheck& interrupt);
  Formatted done() {
    std::stable_sort(found_.changes.begin(), found_.changes.end(),
                     [](const auto& a, const auto& b) { return a.at < b.at; });
    return std::move(found_);
  }

 private:
  void block(const Block& block, const Program& program, int depth);
  std::optional<LayoutChange> indent(const Block& block, int depth) const;

  const Code& code_;
  std::string_view text_;
  const Layout& layout_;
  Formatted found_;
};

/// Return the blanks before a block that begins its line, if they have to change.
std::optional<LayoutChange> FileLayout::indent(const Block& block, int depth) const {
  if (layout_.indent < 0 || block.length == 0) return std::nullopt;
  std::size_t from = block.text;
  while (from > 0 && is_blank(text_[from - 1])) --from;
  if (from > 0 && text_[from - 1] != '\n') return std::nullopt;
  const std::string wanted(static_cast<std::size_t>(layout_.indent * depth), ' ');
  if (text_.substr(from, block.text - from) == wanted) return std::nullopt;
  const auto at = static_cast<std::uint32_t>(from);
  return LayoutChange{at, block.text - at, wanted};
}

void FileLayout::block(const Block& block, const Program& program, int depth) {
  const std::string_view text = code_.text_of(block, program);
  std::optional<std::vector<LayoutChange>> changes;
  // A block that is refused stays as it is written: what it means is not known.
  if (block.op != Op::Fault) changes = BlockLayout(code_, layout_, text, block).changes();
  if (!changes) {
    if (block.op != Op::Fault) found_.left.push_back(block.line);
    changes.emplace();
  }
  for (LayoutChange& change : *changes) {
    change.at += block.text;
    change = reduced(text_, change);
  }
  std::erase_if(*changes, [](const LayoutChange& of) { return of.width == 0; });
  if (auto blanks = indent(block, depth)) {
    // The first character of the block goes with them, or the change that begins there.
    if (changes->empty() || changes->front().at != block.text) {
      const std::string_view first = first_character(text);
      changes->insert(changes->begin(),
                      {block.text, static_cast<std::uint32_t>(first.size()), std::string(first)});
    }
    changes->front().at = blanks->at;
    changes->front().width += blanks->width;
    changes->front().text.insert(0, blanks->text);
  }
  found_.changes.insert(found_.changes.end(), changes->begin(), changes->end());
}

void FileLayout::program(std::int32_t index, InterruptCheck& interrupt) {
  const Program& program = code_.programs[static_cast<std::size_t>(index)];
  NestingDepth depth(code_, program);
  for (Address at = program.first; at < program.last; ++at) {
    const Block& block = code_.blocks[at];
    if (interrupt.requested(block.length + InterruptCheck::kBlock)) return;
    if (code_.program_at(at) != index) continue;
    const int its = depth.of(at);
    if (!depth.is_second(at)) this->block(block, program, its);
  }
}

}  // namespace

Formatted format_file(const Code& code, std::uint32_t file, const Layout& layout,
                      InterruptCheck& interrupt) {
  FileLayout laid_out(code, file, layout);
  for (std::size_t p = 0; p < code.programs.size(); ++p)
    if (code.programs[p].file == file) laid_out.program(static_cast<std::int32_t>(p), interrupt);
  return laid_out.done();
}

}  // namespace cncsub
