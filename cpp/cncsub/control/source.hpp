// The sources of facts, and how far each may be trusted on a control.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cncsub {

/// How far a fact may be trusted, the strongest first.
enum class Evidence : std::uint8_t { SourceDocument, Manual, Secondary, Inferred };
std::string_view to_string(Evidence evidence);

struct Source {
  std::string_view key;      // as facts cite it: "TA", "Talm", "M7 p"
  std::string_view title;    // what it is
  std::string_view address;  // where it can be read; empty of the given documents
  std::string_view about;    // the controls whose own it is, separated by blanks
  Evidence evidence;         // how strong it is on these

  /// Return the strongest evidence that the source can be on a control. Another control's manual or
  /// document is secondary.
  Evidence on(std::string_view control) const;
};

/// Return every source, in the order of cpp/controls/sources.def.
const std::vector<Source>& all_sources();

/// Return the sources that a text cites by their keys, each once: `TA27, note 3; Talm 212`.
std::vector<const Source*> cited(std::string_view text);

/// Return the strongest evidence that a fact with this source may carry on a control; inferred
/// where the text cites nothing.
Evidence strongest(std::string_view text, std::string_view control);

}  // namespace cncsub
