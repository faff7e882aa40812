// Files of LinuxCNC: a file is a program, and its subprograms are parts of it.
#include <algorithm>
#include <unordered_map>
#include <utility>
#include <vector>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/linuxcnc/block.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace linuxcnc {

namespace {

class FileReader {
 public:
  explicit FileReader(Builder& to) : to_(to), blocks_(to) { to_.names().returned(); }

  void read(std::uint32_t file) {
    file_ = file;
    lines_.clear();
    const std::string_view text = to_.code().files[file].text.view();
    Program program;
    program.number = number_in(to_.code().files[file].stem);
    program.file = file;
    program.line = 1;
    program.opening = opening_of(text);
    to_.begin_program(program);
    bool first = true;          // only empty lines were read so far
    bool program_file = false;  // the first line is a %, and another one ends the program
    std::uint32_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      ++line;
      const std::string_view said = trimmed(std::string_view(text).substr(at, end - at));
      if (said == "%" && first)
        program_file = true;
      else if (!said.empty())
        add(said, static_cast<std::uint32_t>(said.data() - text.data()), line, program_file);
      first = first && said.empty();
      if (to_.interrupt().requested(end + 1 - at)) return;
      at = end + 1;
    }
    const Address end = to_.next_address();
    to_.end_program(static_cast<std::uint32_t>(text.size()), std::max(line, 1u));
    link(end);
    parts(end);
  }

 private:
  struct Met {
    Address address;
    Label label;
  };

  /// Return 1 + the place of the % that is a text's first line; 0 if the first line is another.
  static std::uint32_t opening_of(std::string_view text) {
    const std::size_t at = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    const std::string_view line = text.substr(at, std::min(text.find('\n', at), text.size()) - at);
    return trimmed(line) == "%" ? static_cast<std::uint32_t>(at + 1) : 0;
  }

  void add(std::string_view text, std::uint32_t at, std::uint32_t line, bool program_file) {
    Block block;
    block.text = at;
    block.line = line;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 65535));
    Label label;
    if (text == "%") {
      end_of_file(block, program_file);
      (program_file ? label.unreadable : label.computed) =
          true;  // no search goes past a tape's end
    } else if (!blocks_.read(text, block, label)) {
      return;
    }
    if (label.unreadable || label.unknown || label.computed || label.kind)
      lines_.push_back({to_.next_address(), label});
    to_.append(block);
  }

  /// Write a %. If no other % begins the file, this one is refused when a program comes to it.
  void end_of_file(Block& block, bool program_file) {
    OWord own;
    own.kind = OWordKind::FileEnd;
    own.at = block.text;
    own.of_another_kind = "Failed to find sub 'O{name}' before EOF";
    if (!program_file) {
      Fault fault{Cause::IllegalCharacter, block.text, 1, "no % begins the file"};
      fault.text = "Bad character '%' used";
      own.refused = to_.keep(std::move(fault));
    }
    to_.become(block, Op::OWord, own);
  }

  /// The lines after a line that decide where passing over leads.
  struct Ahead {
    Address end;
    Address wall = end;        // the next line that nothing passes over
    Address thick_wall = end;  // the next one that a definition does not pass over either
    Address head = end;        // the next head of any subprogram
    std::unordered_map<std::uint32_t, Address> of_label = {};
    std::unordered_map<std::uint32_t, Address> end_of_sub = {};  // endsub, return

    Address next(std::uint32_t label) const { return std::min(wall, nearest(of_label, label)); }
    Address next_end(std::uint32_t label) const {
      return std::min({thick_wall, head, nearest(end_of_sub, label)});
    }

   private:
    Address nearest(const std::unordered_map<std::uint32_t, Address>& of,
                    std::uint32_t label) const {
      const auto found = of.find(label);
      return found == of.end() ? end : found->second;
    }
  };

  /// Find where passing over leads from each statement, from the last statement to the first.
  void link(Address end) {
    Ahead ahead{end};
    for (auto met = lines_.rbegin(); met != lines_.rend(); ++met)
      link(met->address, met->label, ahead);
  }

  void link(Address at, const Label& label, Ahead& ahead) {
    const bool readable = to_.block(at).op == Op::OWord;
    const bool wall = label.unreadable || label.unknown;
    if (wall || label.computed || label.kind == OWordKind::Back)
      to_.names().head(LabelledHead::kReadOnTheWay, at);
    if (wall) {
      ahead.wall = at;
      if (label.unreadable) ahead.thick_wall = at;
    } else if (label.kind >= OWordKind::If) {
      if (readable) to_.record<OWord>(to_.block(at).aux).next = ahead.next(label.label);
      ahead.of_label[label.label] = at;
    } else if (label.is_head()) {
      if (readable) {
        to_.record<OWord>(to_.block(at).aux).next = ahead.next_end(label.label);
        to_.names().head(label.label, at);
      }
      ahead.head = at;
    } else if (label.kind == OWordKind::EndSub || label.kind == OWordKind::Return) {
      if (readable) to_.record<OWord>(to_.block(at).aux).next = ahead.next_end(label.label);
      ahead.end_of_sub[label.label] = at;
    }
  }

  /// Add the subprograms of the file, each up to its endsub or to the next subprogram.
  void parts(Address end) {
    const auto whole = static_cast<std::int32_t>(to_.code().programs.size()) - 1;
    const std::string_view text = to_.code().files[file_].text.view();
    for (std::size_t i = 0; i < lines_.size(); ++i) {
      const auto& [at, label] = lines_[i];
      if (!label.is_head() || to_.block(at).op != Op::OWord) continue;
      const Block& block = to_.block(at);
      Program part;
      part.file = file_;
      part.line = block.line;
      part.inside = whole;
      part.first = at;
      part.last = part_end(i, end);
      part.text = static_cast<std::uint32_t>(text.find_first_of("oO", block.text));
      part.text_end = to_.block(part.last).text;
      place_name(part, text);
      const std::string& name = to_.code().labels[label.label];
      part.number = number_in(name);
      if (name != to_.code().files[file_].stem) to_.part(part);
    }
  }

  /// Return where the subprogram ends whose head is line `i` of those with labels.
  Address part_end(std::size_t i, Address end) const {
    const Label& head = lines_[i].label;
    for (++i; i < lines_.size(); ++i) {
      const auto& [at, label] = lines_[i];
      if (head.kind == OWordKind::Sub && label.kind == OWordKind::EndSub &&
          label.label == head.label)
        return at + 1;
      if (label.is_head()) return at;
    }
    return end;
  }

  /// Set the name of a subprogram, which stands after its O: <name>, or digits.
  static void place_name(Program& part, std::string_view text) {
    std::size_t from = part.text + std::size_t{1};
    while (is_blank(text[from])) ++from;
    const bool named = text[from] == '<';
    std::size_t to = named ? text.find('>', from) : from;
    if (named) ++from;
    while (!named && to < text.size() && is_digit(text[to])) ++to;
    part.name_at = static_cast<std::uint32_t>(from);
    part.name_length = static_cast<std::uint32_t>(to - from);
  }

  Builder& to_;
  BlockReader blocks_;
  std::vector<Met> lines_;
  std::uint32_t file_ = 0;
};

}  // namespace

}  // namespace linuxcnc

cncsub::FileReader linuxcnc_reader(Builder& to, const ProgramNames& /*other_mode*/) {
  auto reader = std::make_shared<linuxcnc::FileReader>(to);
  return [reader](std::uint32_t file) { reader->read(file); };
}

// Null: what a label means depends on the lines before it.
PieceReader (*const linuxcnc_pieces)(Builder& to) = nullptr;
ProgramNames (*const linuxcnc_other_mode)(const Code& code) = nullptr;

}  // namespace cncsub
