// Files of a SINUMERIK: a file is one program, or several in punched tape format.
#include <algorithm>
#include <memory>

#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/sinumerik/block.hpp"
#include "cncsub/dialect/sinumerik/structure.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace sinumerik {

namespace {

/// Return the name at the head of a text that begins with a digit: 0122_SPF.
std::string_view numbered_name_in(std::string_view text) {
  const auto* const digits = std::find_if_not(text.begin(), text.end(), is_digit);
  const auto count = static_cast<std::size_t>(digits - text.begin());
  return text.substr(0, count == 0 ? 0 : count + name_in(text.substr(count)).size());
}

/// Return the folder that a comment from a place on, before anything else, names, as it is written:
/// ;$PATH=/_N_WKS_DIR/_N_SHAFT_WPD. [NCX chapter 1]
std::string_view path_in(std::string_view text, std::size_t from) {
  constexpr std::string_view kPath = ";$PATH=";
  while (from < text.size()) {
    const std::size_t end = std::min(text.find('\n', from), text.size());
    const std::string_view said = trimmed(text.substr(from, end - from));
    if (same_letters(said.substr(0, kPath.size()), kPath))
      return trimmed(said.substr(kPath.size()));
    if (!said.empty() && said[0] != ';') break;
    from = end + 1;
  }
  return {};
}

class FileReader {
 public:
  FileReader(Builder& to, const ProgramNames& called_in_iso_mode)
      : to_(to), blocks_(to, called_in_iso_mode), structure_(to) {}

  void read(std::uint32_t file) {
    const std::string_view text = to_.code().files[file].text.view();
    bool begun = false;
    std::uint32_t line = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      ++line;
      const std::string_view said = trimmed(std::string_view(text).substr(at, end - at));
      const auto place = static_cast<std::uint32_t>(said.data() - text.data());
      const bool tape = is_tape(said, file, begun);
      const bool head = !tape && said.starts_with('%');
      if (head || (!begun && !tape && !said.empty() && said[0] != ';')) {
        if (begun) end_program(place, line);
        begin_program(file, line, head ? said : std::string_view(), place);
        begun = true;
      }
      if (!head && !tape && begun && !said.empty()) add(said, place, line);
      if (to_.interrupt().requested(end + 1 - at)) break;
      at = end + 1;
    }
    if (!begun) begin_program(file, 1, {}, 0);
    end_program(static_cast<std::uint32_t>(text.size()), std::max(line, 1u));
  }

 private:
  /// Return whether a line is the % that begins or ends the tape of a program in ISO mode.
  bool is_tape(std::string_view said, std::uint32_t file, bool begun) const {
    if (said != "%") return false;
    return begun ? blocks_.is_in_iso_mode()
                 : blocks_.is_called_in_iso_mode(to_.code().files[file].stem);
  }

  /// Begin a program: %_N_SHAFT_MPF is SHAFT. Without a head the file gives the name. [SONE p.43]
  void begin_program(std::uint32_t file, std::uint32_t line, std::string_view head,
                     std::uint32_t at) {
    Program program;
    program.file = file;
    program.line = line;
    program.text = at;
    const std::string_view text = to_.code().files[file].text.view();
    const std::string_view path = path_in(text, head.empty() ? 0 : at + head.size());
    program.path_at = path.empty() ? 0 : static_cast<std::uint32_t>(path.data() - text.data());
    program.path_length = static_cast<std::uint32_t>(path.size());
    std::string_view rest;
    if (!head.empty()) {
      const std::string_view said = trimmed(head.substr(1));
      const std::size_t before = said.starts_with("_N_") || said.starts_with("_n_") ? 3 : 0;
      std::string_view name = said.substr(before, name_in(said.substr(before)).size());
      if (name.empty() && before > 0) name = numbered_name_in(said.substr(before));
      rest = trimmed(said.substr(before + name.size()));
      const std::string capital = capitals(name);
      if (capital.ends_with("_MPF") || capital.ends_with("_SPF")) name.remove_suffix(4);
      program.name_at = at + static_cast<std::uint32_t>(name.data() - head.data());
      program.name_length = static_cast<std::uint32_t>(name.size());
    }
    const bool in_iso_mode = blocks_.is_called_in_iso_mode(to_.code().name_of(program));
    if (in_iso_mode) program.number = number_in(to_.code().name_of(program));
    to_.begin_program(program);
    structure_.begin();
    blocks_.begin_program(in_iso_mode);
    structure_.mode(in_iso_mode);
    if (!rest.empty() && rest[0] != ';')
      drop(rest, at + static_cast<std::uint32_t>(rest.data() - head.data()), line);
  }

  void end_program(std::uint32_t text_end, std::uint32_t line) {
    to_.end_program(text_end, line);
    structure_.match();
  }

  /// Add a block that says what of the head is no name: the control reads it and does not obey it.
  void drop(std::string_view text, std::uint32_t at, std::uint32_t line) {
    Block block;
    block.text = at;
    block.line = line;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 65535));
    to_.drop(at, static_cast<std::uint32_t>(text.size()));
    to_.words(block, {});
    to_.append(block);
  }

  void add(std::string_view text, std::uint32_t at, std::uint32_t line) {
    Block block;
    block.text = at;
    block.line = line;
    block.length = static_cast<std::uint16_t>(std::min<std::size_t>(text.size(), 65535));
    std::string label;
    Link link;
    if (!blocks_.read(text, block, label, link)) return;
    structure_.add(label, link);
    to_.append(block);
    structure_.mode(blocks_.is_in_iso_mode());
  }

  Builder& to_;
  BlockReader blocks_;
  Structure structure_;
};

}  // namespace

}  // namespace sinumerik

FileReader sinumerik_reader(Builder& to, const ProgramNames& called_in_iso_mode) {
  auto reader = std::make_shared<sinumerik::FileReader>(to, called_in_iso_mode);
  return [reader](std::uint32_t file) { reader->read(file); };
}

ProgramNames (*const sinumerik_other_mode)(const Code& code) =
    sinumerik::programs_called_in_iso_mode;

// Null: what a label means depends on the blocks before it.
PieceReader (*const sinumerik_pieces)(Builder& to) = nullptr;

}  // namespace cncsub
