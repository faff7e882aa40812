// Files into a library: where programs begin, their blocks, and what jumps and calls lead to.
#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "cncsub/block.hpp"
#include "cncsub/call.hpp"
#include "cncsub/code.hpp"
#include "cncsub/patience.hpp"
#include "cncsub/scan.hpp"
#include "cncsub/variable_table.hpp"

namespace cncsub {

namespace {

/// Where a character stands in a text that is gone through from front to back: looked for once.
class Marks {
 public:
  Marks() = default;
  Marks(char mark, const char* at, const char* end) : end_(end), mark_(mark) { seek(at); }

  bool in(const char* at, const char* end) {
    if (next_ < at) seek(at);
    return next_ < end;
  }

 private:
  void seek(const char* at) {
    const void* found = std::memchr(at, mark_, static_cast<std::size_t>(end_ - at));
    next_ = found == nullptr ? end_ : static_cast<const char*>(found);
  }

  const char* next_ = nullptr;
  const char* end_ = nullptr;
  char mark_ = 0;
};

constexpr std::size_t kBlock = 8;  // what going over a block once more is worth, in bytes of text

class LibraryReader {
 public:
  LibraryReader(Code& code, Patience& patience)
      : code_(code), reader_(code, patience), patience_(patience) {}

  /// Stops early where patience is over.
  void read(std::uint32_t file_index) {
    file_ = file_index;
    std::string& text = code_.files[file_].text;
    unify_line_ends(text);
    begin_ = text.data();
    const char* at = begin_;
    const char* end = begin_ + text.size();
    semicolons_ = Marks(';', at, end);
    comments_ = Marks('(', at, end);
    line_ = 0;
    open_ = false;
    first_in_file_ = true;
    leader_possible_ = true;
    const bool semicolons = code_.control->semicolon.value == Semicolon::EndOfBlock;
    while (at < end) {
      const char* newline =
          static_cast<const char*>(std::memchr(at, '\n', static_cast<std::size_t>(end - at)));
      const char* line_end = newline == nullptr ? end : newline;
      ++line_;
      if (!semicolons_.in(at, line_end)) {
        block(at, line_end);
      } else if (semicolons) {
        split(at, line_end);
      } else {
        block(at, outside_comment(at, line_end));
      }
      if (patience_.over(static_cast<std::size_t>(line_end + 1 - at))) return;
      at = line_end + 1;
    }
    // A file without a block is still a program of the memory, an empty one.
    if (first_in_file_) begin_headless(0);
    close(static_cast<std::uint32_t>(text.size()));
  }

 private:
  /// CR, LF and CRLF all end a line; a CR before a LF counts as a blank.
  void unify_line_ends(std::string& text) {
    std::size_t at = 0;
    while ((at = text.find('\r', at)) != std::string::npos && !patience_.over(kBlock)) {
      text[at] = at + 1 < text.size() && text[at + 1] == '\n' ? ' ' : '\n';
      ++at;
    }
  }

  /// The first semicolon that is not inside a comment, or the end.
  static const char* outside_comment(const char* at, const char* end) {
    bool comment = false;
    for (; at < end; ++at) {
      if (*at == '(') comment = true;
      if (*at == ')') comment = false;
      if (*at == ';' && !comment) return at;
    }
    return end;
  }

  void split(const char* at, const char* end) {
    while (at < end) {
      const char* stop = outside_comment(at, end);
      block(at, stop);
      at = stop + 1;
    }
  }

  void block(const char* at, const char* end) {
    Scanner s{at, end, begin_};
    while (s.at != s.end && is_blank(*s.at)) ++s.at;
    if (s.at == s.end) return;
    if (*s.at == '%') {
      percent(s);
      return;
    }
    if (head(s)) {
      s.blanks();
      if (s.at == s.end) return;
    }
    add_block(s);
  }

  void add_block(Scanner s) {
    const bool open_comment = comment_not_closed(s);
    s.blanks();
    if (code_.control->open_comment.value == OpenComment::RestOfBlock) s.rest_of_comment();
    if (s.at == s.end && !open_comment) return;
    if (!open_) begin_headless(s.offset());
    Block block;
    block.text = s.offset();
    block.line = line_;
    if (open_comment) {
      reader_.read(Scanner{s.at, std::find(s.at, s.end, '('), s.file}, block);
      block.op = Op::Fault;
      block.aux = static_cast<std::uint32_t>(code_.faults.size());
      code_.faults.push_back({Cause::CommentNotClosed, block.text, 1, "the comment is not closed"});
    } else {
      reader_.read(s, block);
    }
    const auto length = static_cast<std::size_t>(s.end - s.file) - block.text;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(length, 65535));
    code_.blocks.push_back(block);
  }

  bool comment_not_closed(const Scanner& s) {
    if (!comments_.in(s.at, s.end)) return false;
    if (code_.control->open_comment.value != OpenComment::Alarm) return false;
    bool open = false;
    for (const char* c = s.at; c < s.end; ++c) {
      if (*c == '(') open = true;
      if (*c == ')') open = false;
    }
    return open;
  }

  /// A line that starts with %: the tape's mark, or the head of a program.
  void percent(Scanner s) {
    const char* start = s.at;
    if (std::exchange(leader_possible_, false) && open_ && tape_begins(s)) drop_leader();
    ++s.at;
    if (code_.control->percent_programs.value && is_digit(s.peek())) {
      const Number number = scan_number(s);
      s.blanks();
      begin_program(trimmed({start, static_cast<std::size_t>(s.at - start)}),
                    number.value < 1e15 ? to_whole<std::int64_t>(number.value) : -1, start);
      title(start, s.end);
      return;
    }
    if (open_) close(static_cast<std::uint32_t>(start - begin_));
  }

  /// Whether a tape begins with the % of this line: a program's head, or blocks that another %
  /// ends.
  bool tape_begins(const Scanner& percent) {
    const std::string& text = code_.files[file_].text;
    const char* end = begin_ + text.size();
    bool blocks = false;
    for (const char* at = percent.at; at < end;) {
      const char* line_end = std::find(at, end, '\n');
      if (patience_.over(static_cast<std::size_t>(line_end + 1 - at))) return false;
      Scanner line{at, line_end, begin_};
      at = line_end + 1;
      const char c = line.peek();
      if (c == '\0') continue;
      ++line.at;
      if (c == '%') {
        if (blocks) return true;
        if (code_.control->percent_programs.value && is_digit(line.peek())) return true;
        continue;
      }
      if (!blocks && (c == 'O' || c == ':') && is_digit(line.peek())) return true;
      if (!blocks && c == '<' && code_.control->named_programs.value) return true;
      blocks = true;
    }
    return false;
  }

  /// What stands before the first % of a tape is no program: a reader looks for the % first.
  void drop_leader() {
    const Program& leader = code_.programs.back();
    code_.blocks.erase(code_.blocks.begin() + leader.first, code_.blocks.end());
    code_.files[file_].leader = line_ - 1;
    code_.programs.pop_back();
    open_ = false;
    first_in_file_ = true;
  }

  /// O0001, :1 or <NAME> at the head of a line begins a program.
  bool head(Scanner& s) {
    const char* start = s.at;
    const char c = upper(*s.at);
    if (c == 'O' || c == ':') {
      Scanner ahead = s;
      ++ahead.at;
      if (!is_digit(ahead.peek())) return false;
      const char* digits = ahead.at;
      Number number;
      while (ahead.at != ahead.end && is_digit(*ahead.at)) {
        if (number.digits > 0 || *ahead.at != '0') ++number.digits;
        number.value = number.value * 10 + (*ahead.at++ - '0');
      }
      const auto offset = static_cast<std::uint32_t>(start - begin_);
      begin_program({digits, static_cast<std::size_t>(ahead.at - digits)},
                    number.digits <= 15 ? to_whole<std::int64_t>(number.value) : -1, start);
      title(start, s.end);
      const bool zero = number.value == 0 && !code_.control->zero_numbers.value;
      const bool large = number.value > code_.control->max_program_number.value;
      if (zero || large) {
        Block block;
        block.text = offset;
        block.line = line_;
        block.op = Op::Fault;
        block.length =
            static_cast<std::uint16_t>(std::min<std::ptrdiff_t>(ahead.at - start, 65535));
        block.aux = static_cast<std::uint32_t>(code_.faults.size());
        code_.faults.push_back(
            {zero ? Cause::ProgramNumberZero : Cause::IllegalProgramNumber, offset, block.length,
             zero ? "O0 is no program number"
                  : "the largest program number is " +
                        std::to_string(code_.control->max_program_number.value)});
        code_.blocks.push_back(block);
      }
      s.at = ahead.at;
      return true;
    }
    if (c == '<' && (code_.control->named_programs.value || code_.control->bracket_names.value)) {
      const char* close_at = std::find(s.at, s.end, '>');
      if (close_at == s.end) return false;
      const std::string_view name =
          trimmed({s.at + 1, static_cast<std::size_t>(close_at - s.at - 1)});
      begin_program(name, number_in(name), start);
      title(start, s.end);
      s.at = close_at + 1;
      return true;
    }
    return false;
  }

  static std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return text;
  }

  /// The first comment of the head's line.
  void title(const char* start, const char* end) {
    const char* open = std::find(start, end, '(');
    if (open == end) return;
    const char* close_at = std::find(open, end, ')');
    Program& program = code_.programs.back();
    program.comment_at = static_cast<std::uint32_t>(open + 1 - begin_);
    program.comment_length = static_cast<std::uint32_t>(close_at - open - 1);
  }

  /// A program that begins with its head, at `start`; its name is a part of the file's text.
  void begin_program(std::string_view name, std::int64_t number, const char* start) {
    const auto offset = static_cast<std::uint32_t>(start - begin_);
    if (open_) {
      const Program& before = code_.programs.back();
      const bool empty = before.first == static_cast<Address>(code_.blocks.size());
      if (empty && code_.control->percent_programs.value && before.text < offset) {
        // An O line right before a % line only names the file.
        code_.programs.pop_back();
        open_ = false;
      }
    }
    leader_possible_ = false;
    Program program;
    program.number = number;
    program.name_at = static_cast<std::uint32_t>(name.data() - begin_);
    program.name_length = static_cast<std::uint32_t>(name.size());
    open(program, offset, code_.control->file_name_wins.value);
  }

  /// A program without a head, named by its file.
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
    program.first = static_cast<Address>(code_.blocks.size());
    code_.programs.push_back(program);
    first_in_file_ = false;
    open_ = true;
  }

  void close(std::uint32_t offset) {
    if (!open_) return;
    open_ = false;
    Program& program = code_.programs.back();
    program.text_end = offset;
    program.last = static_cast<Address>(code_.blocks.size());
    Block end;
    end.op = Op::EndOfRecord;
    end.line = line_;
    end.text = offset;
    code_.blocks.push_back(end);
    finish_program(program);
  }

  // ---- what a program's own blocks lead to ----

  void finish_program(Program& program) {
    program.first_entry = static_cast<std::uint32_t>(code_.sequence.size());
    bool statements = false;
    for (Address a = program.first; a < program.last && !patience_.over(kBlock); ++a) {
      const Block& block = code_.blocks[a];
      if (block.n >= 0) code_.sequence.push_back({block.n, a});
      statements = statements || !is_words(block.op);
    }
    program.last_entry = static_cast<std::uint32_t>(code_.sequence.size());
    sort_sequence(program.first_entry);
    if (!statements) return;
    match_loops(program);
    for (Address a = program.first; a < program.last && !patience_.over(kBlock); ++a)
      resolve_jump(program, a, code_.blocks[a]);
  }

  /// By number, then by address. Pieces are sorted, then merged, so that patience is asked between.
  void sort_sequence(std::size_t from) {
    const auto by_number = [](const SequenceEntry& a, const SequenceEntry& b) { return a.n < b.n; };
    const auto end = code_.sequence.end();
    const std::size_t size = code_.sequence.size() - from;
    const auto at = [&](std::size_t i) {
      return end - static_cast<std::ptrdiff_t>(size - std::min(i, size));
    };
    if (std::is_sorted(at(0), end, by_number)) return;
    std::size_t piece = 1 << 16;
    for (std::size_t i = 0; i < size && !patience_.over(piece * kBlock); i += piece)
      std::stable_sort(at(i), at(i + piece), by_number);
    for (; piece < size; piece *= 2)
      for (std::size_t i = 0; i + piece < size && !patience_.over(piece * kBlock); i += 2 * piece)
        std::inplace_merge(at(i), at(i + piece), at(i + 2 * piece), by_number);
  }

  void resolve_jump(const Program& program, Address address, const Block& block) {
    if (block.op == Op::Goto || block.op == Op::IfGoto) {
      Statement& jump = code_.statements[block.aux];
      if (jump.number >= 0) jump.to = code_.jump_target(program, jump.number, address);
    } else if (block.op == Op::IfThen) {
      resolve_jump(program, address, code_.variants[code_.statements[block.aux].then]);
    }
  }

  void fault_at(Address address, Cause cause, const std::string& detail) {
    Block& block = code_.blocks[address];
    const Statement& statement = code_.statements[block.aux];
    const Fault fault{cause, statement.at, statement.width, detail};
    block.op = Op::Fault;
    block.aux = static_cast<std::uint32_t>(code_.faults.size());
    code_.faults.push_back(fault);
  }

  struct Open {
    Address address;
    std::int32_t number;
    Address other = kNowhere;  // of an IF: its ELSE
  };

  /// Pairs WHILE and DO with END, IF with ELSE and ENDIF. What has no partner becomes a fault where
  /// it stands.
  void match_loops(const Program& program) {
    std::vector<Open> loops, ifs;
    for (Address a = program.first; a < program.last && !patience_.over(kBlock); ++a) {
      switch (code_.blocks[a].op) {
        case Op::While:
        case Op::Do:
          open_loop(loops, a);
          break;
        case Op::EndDo:
          close_loop(loops, a);
          break;
        case Op::If:
          ifs.push_back({a, 0});
          if (ifs.size() > static_cast<std::size_t>(code_.control->max_ifs.value)) {
            fault_at(a, Cause::IfTooDeep,
                     "more IF blocks inside each other than the control takes");
          }
          break;
        case Op::Else:
          match_else(ifs, a);
          break;
        case Op::EndIf:
          match_end_if(ifs, a);
          break;
        default:
          break;
      }
    }
    for (const Open& open : loops)
      fault_at(open.address, Cause::MissingEnd, "this loop has no end");
    for (const Open& open : ifs) {
      if (open.other != kNowhere)
        fault_at(open.other, Cause::IfWithoutEnd, "this ELSE has no ENDIF");
      if (code_.blocks[open.address].op == Op::If)
        fault_at(open.address, Cause::IfWithoutEnd, "this IF has no ENDIF");
    }
  }

  void open_loop(std::vector<Open>& loops, Address a) {
    const std::int32_t number = code_.statements[code_.blocks[a].aux].number;
    const bool numbered = code_.control->loop_form.value == LoopForm::DoEnd;
    if (numbered)
      for (const Open& open : loops)
        if (open.number == number)
          return fault_at(a, Cause::MissingEnd, "this DO number is open already");
    if (loops.size() >= static_cast<std::size_t>(code_.control->max_loops.value))
      return fault_at(a, Cause::LoopsTooDeep,
                      "more loops inside each other than the control takes");
    loops.push_back({a, number});
  }

  void close_loop(std::vector<Open>& loops, Address a) {
    const std::int32_t number = code_.statements[code_.blocks[a].aux].number;
    const bool numbered = code_.control->loop_form.value == LoopForm::DoEnd;
    std::size_t at = loops.size();
    while (at > 0 && numbered && loops[at - 1].number != number) --at;
    if (at == 0) return fault_at(a, Cause::MissingDo, "this end has no loop");
    for (std::size_t i = at; i < loops.size(); ++i)
      fault_at(loops[i].address, Cause::MissingEnd, "this loop crosses another");
    const Address start = loops[at - 1].address;
    loops.resize(at - 1);
    code_.statements[code_.blocks[start].aux].end = a;
    code_.statements[code_.blocks[start].aux].to = a + 1;
    code_.statements[code_.blocks[a].aux].to = start;
  }

  void match_else(std::vector<Open>& ifs, Address a) {
    if (ifs.empty() || ifs.back().other != kNowhere)
      return fault_at(a, Cause::IfWithoutEnd, "this ELSE has no IF");
    ifs.back().other = a;
    if (code_.blocks[ifs.back().address].op == Op::If)
      code_.statements[code_.blocks[ifs.back().address].aux].to = a + 1;
  }

  void match_end_if(std::vector<Open>& ifs, Address a) {
    if (ifs.empty()) return fault_at(a, Cause::IfWithoutEnd, "this ENDIF has no IF");
    const Open open = ifs.back();
    ifs.pop_back();
    if (open.other != kNowhere)
      code_.statements[code_.blocks[open.other].aux].to = a;
    else if (code_.blocks[open.address].op == Op::If)
      code_.statements[code_.blocks[open.address].aux].to = a;
  }

  Code& code_;
  BlockReader reader_;
  Patience& patience_;
  const char* begin_ = nullptr;
  Marks semicolons_, comments_;
  std::uint32_t file_ = 0;
  std::uint32_t line_ = 0;
  bool open_ = false;
  bool first_in_file_ = true;
  bool leader_possible_ = true;  // neither a head nor a % was met in this file
};

void number_variables(Code& code) {
  for (const VariableRange& range : variable_ranges(*code.control)) {
    if (range.kind == VariableKind::Local) {
      code.locals = std::max(code.locals, range.last + 1);
      code.locals_per_level = range.last - range.first + 1;
    }
    code.variables.push_back({range, code.commons});
    if (is_alias(range)) continue;
    if (range.kind == VariableKind::Common || range.kind == VariableKind::Kept)
      code.commons += range.last - range.first + 1;
  }
  for (PlacedRange& placed : code.variables)
    if (is_alias(placed.range)) placed.base = code.place(placed.range.from).index;
}

constexpr std::size_t kProgram = 64;  // what giving a program its names is worth

/// Calls whose operands are written as numbers are decided once.
void resolve_calls(Code& code, std::size_t from, Patience& patience) {
  const auto resolve = [&](Block& block, std::int32_t own) {
    if (block.op != Op::Call && block.op != Op::MacroCall && block.op != Op::ModalCall) return;
    CallRecord& call = code.calls[block.aux];
    const auto constant = [](const Operand& operand) {
      return operand.kind != Operand::Kind::Expression;
    };
    if (!constant(call.p) || !constant(call.l) || !constant(call.start) || !constant(call.device))
      return;
    const CallOperands operands{call.p.value, call.l.value, call.start.value, call.device.value};
    Target target;
    if (auto fault = decode_call(code, call, operands, own, target)) {
      block.op = Op::Fault;
      block.aux = static_cast<std::uint32_t>(code.faults.size());
      code.faults.push_back(std::move(*fault));
      return;
    }
    if (find_target(code, call, target)) return;  // told when the call is reached
    call.target = target;
    call.constant = true;
  };
  std::vector<bool> seen(code.variants.size(), false);
  const auto variants_of = [&](const auto& self, const Block& block, std::int32_t own) -> void {
    if (block.op != Op::Choose) return;
    const Variant variant = code.choices[block.aux];
    for (const std::uint32_t i : {variant.first, variant.second}) {
      if (seen[i]) continue;
      seen[i] = true;
      self(self, code.variants[i], own);
      resolve(code.variants[i], own);
    }
  };
  for (std::size_t p = from; p < code.programs.size(); ++p)
    for (Address a = code.programs[p].first; a < code.programs[p].last && !patience.over(kBlock);
         ++a) {
      variants_of(variants_of, code.blocks[a], static_cast<std::int32_t>(p));
      resolve(code.blocks[a], static_cast<std::int32_t>(p));
    }
}

/// Gives back many megabytes without keeping whoever interrupted the reading waiting: the system
/// takes its time over them.
void free_aside(std::shared_ptr<Code> code, std::vector<SourceFile> files) {
  try {
    std::thread([code = std::move(code), files = std::move(files)] {}).detach();
  } catch (const std::system_error&) {  // NOLINT: no thread to be had, it was freed here
  }
}

}  // namespace

std::shared_ptr<const Code> compile(std::shared_ptr<const Control> control,
                                    std::vector<SourceFile> files, bool external_device,
                                    const std::function<bool()>& interrupted) {
  auto code = std::make_shared<Code>();
  code->external_device = external_device;
  code->control = std::move(control);
  number_variables(*code);
  Patience patience(interrupted);
  LibraryReader reader(*code, patience);
  std::size_t bytes = 0;
  for (const SourceFile& file : files) bytes += file.text.size();
  // Room that is never written costs nothing, and a table that never moves is never copied.
  code->blocks.reserve(bytes / 8 + files.size());
  code->cells.reserve(bytes / 4);
  code->files.reserve(files.size());
  for (SourceFile& file : files) {
    code->files.push_back(std::move(file));
    reader.read(static_cast<std::uint32_t>(code->files.size() - 1));
    if (patience.over(kProgram)) break;
  }
  code->register_programs([&patience] { return patience.over(kProgram); });
  resolve_calls(*code, 0, patience);
  if (!patience.over(0)) return code;
  free_aside(std::move(code), std::move(files));
  return nullptr;
}

std::shared_ptr<const Code> compile_mdi(const Code& code, const std::string& text,
                                        const std::function<bool()>& interrupted) {
  auto with = std::make_shared<Code>(code);
  const std::size_t programs = with->programs.size();
  with->files.push_back({"MDI", "MDI", text, false});
  Patience patience(interrupted);
  LibraryReader reader(*with, patience);
  reader.read(static_cast<std::uint32_t>(with->files.size() - 1));
  // What is typed in MDI is no program of the memory: it is not registered, nothing finds it.
  resolve_calls(*with, programs, patience);
  if (!patience.over(0)) return with;
  free_aside(std::move(with), {});
  return nullptr;
}

}  // namespace cncsub
