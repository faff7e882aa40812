// The reader of a file of the ISO family: it finds the programs on a tape and their blocks.
#include "cncsub/dialect/iso/program_file.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/iso/block.hpp"
#include "cncsub/dialect/iso/leader.hpp"
#include "cncsub/dialect/iso/next_mark.hpp"
#include "cncsub/dialect/iso/structure.hpp"
#include "cncsub/dialect/iso/structured_words.hpp"
#include "cncsub/system/compiler.hpp"
#include "cncsub/text/line_ends.hpp"

namespace cncsub {

namespace {

/// Return the first such mark outside of comments, or the end. A % in brackets does not count:
/// DPRNT has its text there.
const char* outside(char mark, const char* at, const char* end) {
  bool comment = false;
  int brackets = 0;
  for (; at < end; ++at) {
    if (*at == '(') comment = true;
    if (*at == ')') comment = false;
    if (comment) continue;
    if (mark == '%' && (*at == '[' || *at == ']')) brackets += *at == '[' ? 1 : -1;
    if (*at == mark && brackets <= 0) return at;
  }
  return end;
}

/// The characters that begin a block and neither a comment, a tape's mark nor the head of a
/// program.
constexpr auto kBeginsBlock = [] {
  std::array<bool, 256> begins{};
  for (const char c : std::string_view("#/ABCDEFGHIJKLMNPQRSTUVWXYZ"))
    begins[static_cast<unsigned char>(c)] = true;
  return begins;
}();
bool begins_block(char c) { return kBeginsBlock[static_cast<unsigned char>(c)]; }

/// Make the first comment of the head's line the title.
void title(Program& program, const char* file, const char* start, const char* end) {
  const char* open = std::find(start, end, '(');
  if (open == end) return;
  const char* close_at = std::find(open, end, ')');
  program.comment_at = static_cast<std::uint32_t>(open + 1 - file);
  program.comment_length = static_cast<std::uint32_t>(close_at - open - 1);
}

/// Return whether a comment that begins in a block is not closed there and the control alarms at
/// that.
bool comment_not_closed(const Code& code, NextMark& comments, const Scanner& s) {
  if (!comments.in(s.at, s.end)) return false;
  if (code.control->reading.open_comment.value != OpenComment::Alarm) return false;
  bool open = false;
  for (const char* c = s.at; c < s.end; ++c) {
    if (*c == '(') open = true;
    if (*c == ')') open = false;
  }
  return open;
}

class ProgramFileReader {
 public:
  explicit ProgramFileReader(Builder& to, const IsoVariant& variant = {}, OtherPrograms others = {})
      : to_(to), code_(to.code()), reader_(to, variant), others_(std::move(others)) {}

  /// Read a file; stop early if an interrupt is requested.
  void read(std::uint32_t file_index) {
    const std::string_view text = code_.files[file_index].text.view();
    begin(file_index, text);
    read_lines({text, 0, text.size()});
    finish();
  }

  void read_on(const Lines& lines) {
    if (lines.from == 0) begin(static_cast<std::uint32_t>(code_.files.size() - 1), lines.text);
    read_lines(lines);
    if (lines.to == lines.text.size()) finish();
  }

  std::optional<std::uint32_t> read_in_worker(const Lines& lines) {
    begin(0, lines.text);
    apart_ = true;
    first_in_file_ = leader_possible_ = false;
    statements_ = 0;
    to_.begin_program({});
    read_lines(lines);
    return apart_ ? std::optional(line_) : std::nullopt;
  }

  /// Append what `of` read apart: it begins with the rest of the open program. Return false if it
  /// must be read again, for example because a % that may follow a leader ended that rest.
  bool join(Joined& of, std::uint32_t lines) {
    if (!to_.in_program() || first_in_file_) return false;
    const bool ended_apart = of.code.programs.size() > 1 || !of.from.in_program();
    if (leader_possible_ && ended_apart && text_[of.code.programs[0].text_end] == '%') return false;
    of.goes_on = true;
    of.line = line_;
    if (!can_join(to_, of)) return false;
    leader_possible_ = leader_possible_ && !ended_apart;
    const std::size_t program = code_.programs.size() - 1;
    cncsub::join(to_, of);
    line_ += lines;
    if (!ended_apart) return true;
    if (code_.statements.size() > statements_) match_structure(to_, code_.programs[program]);
    statements_ = 0;  // the open program may have some
    return true;
  }

 private:
  void begin(std::uint32_t file_index, std::string_view text) {
    file_ = file_index;
    text_ = text;
    begin_ = text.data();
    line_ = 0;
    first_in_file_ = true;
    leader_possible_ = true;
    all_other_ = false;
    if (others_.begin_text) others_.begin_text(text);
  }

  void finish() {
    // A file without a block is still a program of the memory: an empty one.
    if (first_in_file_) begin_headless(0);
    close(static_cast<std::uint32_t>(text_.size()));
  }

  void read_lines(const Lines& lines) {
    const char* at = begin_ + lines.from;
    const char* end = begin_ + lines.to;
    semicolons_ = NextMark(';', at, end);
    comments_ = NextMark('(', at, end);
    percents_ = NextMark('%', at, end);
    // Lines without a semicolon or a percent sign hold one block.
    const auto next_marked = [this](const char* from) {
      return std::min(semicolons_.from(from), percents_.from(from));
    };
    const char* marked = next_marked(at);
    LineEnds ends(at, end);
    while (at < end) {
      const char* const line_end = ends.next();
      ++line_;
      if (others_.begins && begins_other(at, line_end)) {
        at = other_programs(at, line_end, end);
        ends = LineEnds(at, end);
        marked = next_marked(at);
        continue;
      }
      if (line_end <= marked) {
        words(at, line_end);
      } else {
        split(at, line_end);
        marked = next_marked(line_end);
      }
      if (to_.interrupt().requested(static_cast<std::size_t>(line_end + 1 - at))) return;
      at = line_end + 1;
    }
  }

  /// Return whether a line says that a program of the other language follows.
  bool begins_other(const char* at, const char* end) const {
    const bool empty = to_.in_program() && code_.programs.back().first == to_.next_address();
    return (!to_.in_program() || empty) && others_.begins({at, static_cast<std::size_t>(end - at)});
  }

  /// Read programs of the other language after the line that says so; return where the rest begins:
  /// at a %, or at the head of another program where the line was not the first of the file.
  const char* other_programs(const char* at, const char* line_end, const char* end) {
    if (first_in_file_) all_other_ = true;
    if (!to_.in_program()) begin_headless(static_cast<std::uint32_t>(at - begin_));
    for (at = std::min(line_end + 1, end);;) {
      const char* const stop = end_of_other(at, end);
      others_.read(static_cast<std::size_t>(at - begin_), static_cast<std::size_t>(stop - begin_),
                   line_ + 1);
      line_ += static_cast<std::uint32_t>(std::count(at, stop, '\n'));
      is_other_ = true;
      if (stop == end || *stop == '%' || !all_other_) return stop;
      const char* const head_end = std::find(stop, end, '\n');
      ++line_;
      Scanner s{stop, head_end, begin_};
      s.blanks();
      head(s);
      at = std::min(head_end + 1, end);
    }
  }

  /// Return the line of a % or of the head of a program, or the end.
  static const char* end_of_other(const char* at, const char* end) {
    while (at < end) {
      const char* const line_end = std::find(at, end, '\n');
      const std::string_view line(at, static_cast<std::size_t>(line_end - at));
      if (line.starts_with('%') || is_program_head(line)) return at;
      at = std::min(line_end + 1, end);
    }
    return end;
  }

  /// Read the blocks of a line; only the first if a semicolon begins a comment.
  void split(const char* at, const char* end) {
    const bool several = code_.control->reading.semicolon.value == Semicolon::EndOfBlock;
    do {
      const char* const stop = semicolons_.in(at, end) ? outside(';', at, end) : end;
      block(at, stop);
      at = stop + 1;
    } while (several && at < end);
  }

  /// Read a block and any % after its words. The % ends the tape like one on a line of its own, and
  /// the rest of the line belongs to no program.
  void block(const char* at, const char* end) {
    if (!percents_.in(at, end)) return words(at, end);
    while (at != end && is_blank(*at)) ++at;
    if (*at == '%') return percent({at, end, begin_});
    const bool ends_tape = !heads(code_, ProgramHead::Percent);  // otherwise % begins programs
    const char* const percent = ends_tape ? outside('%', at, end) : end;
    words(at, percent);
    if (percent != end) end_tape({percent, end, begin_});
  }

  CNCSUB_ALWAYS_INLINE void words(const char* at, const char* end) {
    Scanner s{at, end, begin_};
    if (s.at != s.end && begins_block(*s.at))
      return add_block(s, comment_not_closed(code_, comments_, s));
    while (s.at != s.end && is_blank(*s.at)) ++s.at;
    if (s.at == s.end) return;
    if (head(s)) {
      s.blanks();
      if (s.at == s.end) return;
    }
    comments_first(s);
  }

  /// Read a block before which comments may stand.
  void comments_first(Scanner& s) {
    const bool open_comment = comment_not_closed(code_, comments_, s);
    s.blanks();
    if (code_.control->reading.open_comment.value == OpenComment::RestOfBlock) s.rest_of_comment();
    if (s.at != s.end || open_comment) add_block(s, open_comment);
  }

  CNCSUB_ALWAYS_INLINE void add_block(Scanner& s, bool open_comment) {
    if (!to_.in_program()) begin_headless(s.offset());
    const char* const end = s.end;
    Block block;
    block.text = s.offset();
    block.line = line_;
    if (open_comment) s.end = std::find(s.at, s.end, '(');
    reader_.read(s, block);
    if (open_comment)
      to_.refuse(block, {Cause::CommentNotClosed, block.text, 1, "the comment is not closed"});
    const auto length = static_cast<std::size_t>(end - s.file) - block.text;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(length, 65535));
    to_.append(block);
  }

  /// Read a line that starts with %: the tape's mark, or the head of a program.
  void percent(Scanner s) {
    const char* start = s.at;
    ++s.at;
    if (!heads(code_, ProgramHead::Percent) || !is_digit(s.peek()))
      return end_tape({start, s.end, begin_});
    drop_leader({start, s.end, begin_});
    const Number number = scan_number(s);
    s.blanks();
    begin_program(trimmed({start, static_cast<std::size_t>(s.at - start)}),
                  number.value < 1e15 ? to_whole<std::int64_t>(number.value) : -1, start);
    title(to_.program(), begin_, start, s.end);
  }

  /// End the open program at the tape's mark.
  void end_tape(const Scanner& percent) {
    drop_leader(percent);
    if (to_.in_program()) close(percent.offset());
  }

  /// Drop the text before the first % of a tape if it is no program.
  void drop_leader(const Scanner& percent) {
    if (!std::exchange(leader_possible_, false) || !to_.in_program()) return;
    if (!is_leader(to_, text_, percent)) return;
    const char* before = percent.at;
    while (before != begin_ && is_blank(before[-1])) --before;
    const bool own_line = before == begin_ || before[-1] == '\n';
    to_.drop_program(static_cast<std::int32_t>(line_) - (own_line ? 1 : 0));
    first_in_file_ = true;
  }

  /// Begin a program if O0001, :1 or <NAME> stands at the head of a line.
  bool head(Scanner& s) {
    const char c = upper(*s.at);
    if (c == 'O' || c == ':') return number_head(s);
    const bool names = heads(code_, ProgramHead::Name) || code_.control->calls.bracket_names.value;
    return c == '<' && names && name_head(s);
  }

  bool number_head(Scanner& s) {
    const char* start = s.at;
    Scanner ahead = s;
    ++ahead.at;
    if (!is_digit(ahead.peek())) return false;
    const char* digits = ahead.at;
    Number number;
    while (ahead.at != ahead.end && is_digit(*ahead.at)) {
      if (number.digits > 0 || *ahead.at != '0') ++number.digits;
      number.value = number.value * 10 + (*ahead.at++ - '0');
    }
    begin_program({digits, static_cast<std::size_t>(ahead.at - digits)},
                  number.digits <= 15 ? to_whole<std::int64_t>(number.value) : -1, start);
    title(to_.program(), begin_, start, s.end);
    check_number(number.value, start, ahead.at);
    s.at = ahead.at;
    return true;
  }

  /// Append a refused block if no program may have this number.
  void check_number(double number, const char* start, const char* end) {
    const int largest = code_.control->reading.max_program_number.value;
    const bool zero =
        number == 0 && code_.control->common.refuses.value.has(Cause::ProgramNumberZero);
    if (!zero && number <= largest) return;
    Block block;
    block.text = static_cast<std::uint32_t>(start - begin_);
    block.line = line_;
    block.length = static_cast<std::uint16_t>(std::min<std::ptrdiff_t>(end - start, 65535));
    to_.refuse(block, {zero ? Cause::ProgramNumberZero : Cause::IllegalProgramNumber, block.text,
                       block.length,
                       zero ? "O0 is not a program number"
                            : "the largest program number is " + std::to_string(largest)});
    to_.append(block);
  }

  bool name_head(Scanner& s) {
    const char* start = s.at;
    const char* close_at = std::find(s.at, s.end, '>');
    if (close_at == s.end) return false;
    const std::string_view name =
        trimmed({s.at + 1, static_cast<std::size_t>(close_at - s.at - 1)});
    begin_program(name, number_in(name), start);
    title(to_.program(), begin_, start, s.end);
    s.at = close_at + 1;
    return true;
  }

  /// Begin a program whose head is at `start`; its name is a part of the file's text.
  void begin_program(std::string_view name, std::int64_t number, const char* start) {
    const auto offset = static_cast<std::uint32_t>(start - begin_);
    if (to_.in_program()) {
      const Program& before = code_.programs.back();
      const bool empty = before.first == to_.next_address();
      if (empty && is_rest()) {
        apart_ = false;  // it may not be empty: its beginning is not known
      } else if (empty && heads(code_, ProgramHead::Percent) && before.text < offset) {
        // An O line right before a % line only names the file.
        to_.drop_program();
      }
    }
    leader_possible_ = false;
    Program program;
    program.number = number;
    program.name_at = static_cast<std::uint32_t>(name.data() - begin_);
    program.name_length = static_cast<std::uint32_t>(name.size());
    open(program, offset, heads(code_, ProgramHead::File));
  }

  /// Begin a program without a head, named by its file.
  void begin_headless(std::uint32_t offset) {
    leader_possible_ = leader_possible_ && first_in_file_;
    open({}, offset, true);
  }

  void open(Program program, std::uint32_t offset, bool file_gives_name) {
    close(offset);
    const std::string& stem = code_.files[file_].stem;
    if (first_in_file_ && !stem.empty() && file_gives_name) {
      program.name_length = Program::kOfFile;
      program.number = number_in(stem);
    }
    program.file = file_;
    program.line = line_;
    program.text = offset;
    to_.begin_program(program);
    statements_ = code_.statements.size();
    first_in_file_ = false;
  }

  void close(std::uint32_t offset) {
    if (!to_.in_program()) return;
    const bool rest = is_rest();
    to_.end_program(offset, line_);
    if (std::exchange(is_other_, false))
      others_.end_program(code_.programs.back());
    else if (!rest && code_.statements.size() > statements_)
      match_structure(to_, code_.programs.back());
  }

  /// Return whether the open program began before the lines that are read apart.
  bool is_rest() const { return apart_ && code_.programs.size() == 1; }

  Builder& to_;
  const Code& code_;
  BlockReader reader_;
  OtherPrograms others_;
  bool all_other_ = false;  // every program of the file is one of the other language
  bool is_other_ = false;   // the open program is
  std::string_view text_;   // of the file
  const char* begin_ = nullptr;
  NextMark semicolons_, comments_, percents_;
  std::uint32_t file_ = 0;
  std::size_t statements_ = 0;  // of the programs before
  std::uint32_t line_ = 0;
  bool first_in_file_ = true;
  bool apart_ = false;           // lines from the middle of a program are read
  bool leader_possible_ = true;  // neither a head nor a % was met in this file
};

}  // namespace

FileReader iso_reader(Builder& to, const IsoVariant& variant, OtherPrograms others) {
  return [reader = std::make_shared<ProgramFileReader>(to, variant, std::move(others))](
             std::uint32_t file) { reader->read(file); };
}

FileReader iso_reader(Builder& to, const ProgramNames& /*other_mode*/) {
  return [reader = std::make_shared<ProgramFileReader>(to)](std::uint32_t file) {
    reader->read(file);
  };
}

namespace {

PieceReader pieces(Builder& to) {
  const auto reader = std::make_shared<ProgramFileReader>(to);
  return {
      [reader](const Lines& lines) { reader->read_on(lines); },
      [reader](const Lines& lines) { return reader->read_in_worker(lines); },
      [reader](Joined& of, std::uint32_t lines) { return reader->join(of, lines); },
  };
}

}  // namespace

PieceReader (*const iso_pieces)(Builder& to) = &pieces;
ProgramNames (*const iso_other_mode)(const Code& code) = nullptr;

}  // namespace cncsub
