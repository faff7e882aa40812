// Finds branches, loops and subprograms that are not closed, in a language that has labels.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/analysis/checker.hpp"
#include "cncsub/text/scan.hpp"

namespace cncsub {

namespace {

/// Return the kind that ends a statement; the kind itself where the statement needs no end.
OWordKind end_of(OWordKind kind) {
  switch (kind) {
    case OWordKind::If:
      return OWordKind::EndIf;
    case OWordKind::While:
      return OWordKind::EndWhile;
    case OWordKind::Do:
      return OWordKind::While;
    case OWordKind::Repeat:
      return OWordKind::EndRepeat;
    default:
      return kind;
  }
}

bool begins(OWordKind kind) { return end_of(kind) != kind; }

const char* word_of(OWordKind kind) {
  switch (kind) {
    case OWordKind::EndIf:
      return "endif";
    case OWordKind::EndWhile:
      return "endwhile";
    case OWordKind::EndRepeat:
      return "endrepeat";
    default:
      return "while";
  }
}

/// The statements of a file by subprogram and label. A label has a meaning only in its subprogram.
class LabelCheck {
 public:
  LabelCheck(Checker& c, const ProgramFlow& flow) : c_(c), flow_(flow) {}
  void run();

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;  // subprogram, label

  void look_ahead();
  void head(Address at, const OWord& own);
  void end_sub(Address at, const OWord& own);
  void never_ended();
  bool ends_later(Address at) const;
  void breaks(const std::vector<Address>& all);
  void statements(const std::vector<Address>& all);
  void crossings(std::uint32_t sub);
  std::string refused_label(Address at) const;
  const OWord& o_word(Address at) const { return c_.code.o_words[c_.code.blocks[at].aux]; }
  TextPlace place(Address at) const { return {o_word(at).at, o_word(at).width}; }

  Checker& c_;
  const ProgramFlow& flow_;
  std::map<std::uint32_t, Address> heads_;
  std::vector<Address> open_;                   // the subprograms that have not ended yet
  std::map<std::uint32_t, Address> last_ends_;  // the last endsub of each label
  std::set<std::string> refused_;               // the labels of blocks that are refused
  Address last_do_ = kNowhere;
  std::map<Key, std::vector<Address>> statements_;
};

void LabelCheck::head(Address at, const OWord& own) {
  const auto [first, added] = heads_.try_emplace(own.label, at);
  if (!added)
    c_.found(Check::Duplicate, at, place(at),
             "this subprogram already begins in line " +
                 std::to_string(c_.code.blocks[first->second].line));
  while (!open_.empty() && !ends_later(at)) never_ended();
  if (!open_.empty())
    c_.found(Check::SubInSub, at, place(at),
             "the subprogram of line " + std::to_string(c_.code.blocks[open_.back()].line) +
                 " is still open here");
  if (own.kind == OWordKind::Sub) open_.push_back(at);
}

/// Return whether the innermost open subprogram ends after a block.
bool LabelCheck::ends_later(Address at) const {
  const auto end = last_ends_.find(o_word(open_.back()).label);
  return end != last_ends_.end() && end->second > at;
}

void LabelCheck::end_sub(Address at, const OWord& own) {
  const auto ended = std::find_if(open_.rbegin(), open_.rend(),
                                  [&](Address head) { return o_word(head).label == own.label; });
  if (ended == open_.rend()) {
    c_.found(Check::LoopUnclosed, at, place(at), "no sub has this label");
    return;
  }
  const Address head = *ended;
  while (open_.back() != head) never_ended();
  open_.pop_back();
}

/// Report that the innermost open subprogram has no end: another one begins or ends, or the file
/// ends.
void LabelCheck::never_ended() {
  const Address head = open_.back();
  c_.found(Check::LoopUnclosed, head, place(head), "no later endsub has this label");
  open_.pop_back();
}

/// Return the label that a refused block begins with, as the code stores labels; empty where it
/// begins with none.
std::string LabelCheck::refused_label(Address at) const {
  const Block& block = c_.code.blocks[at];
  if (block.op != Op::Fault) return "";
  const std::string_view all = c_.code.files[c_.program(flow_.program()).file].text.view();
  std::string_view text = all.substr(block.text, block.length);
  const auto pass = [&text](auto passes) {
    while (!text.empty() && passes(text.front())) text.remove_prefix(1);
  };
  pass(is_blank);
  if (text.empty() || upper(text.front()) != 'O') return "";
  text.remove_prefix(1);
  const bool named = text.starts_with('<');
  if (named) text.remove_prefix(1);
  std::string label;
  for (const char c : text) {
    if (named ? c == '>' : !is_digit(c)) break;
    if (!is_blank(c)) label += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return label;
}

/// Collect what later blocks decide: the labels of refused blocks, the last endsub of each label,
/// the last do.
void LabelCheck::look_ahead() {
  for (Address at = flow_.first(); at < flow_.last(); ++at) {
    if (std::string label = refused_label(at); !label.empty()) refused_.insert(std::move(label));
    if (c_.code.blocks[at].op != Op::OWord) continue;
    if (o_word(at).kind == OWordKind::EndSub) last_ends_[o_word(at).label] = at;
    if (o_word(at).kind == OWordKind::Do) last_do_ = at;
  }
}

void LabelCheck::run() {
  look_ahead();
  std::uint32_t sub = OWord::kNone;
  for (Address at = flow_.first(); at < flow_.last(); ++at) {
    if (c_.code.blocks[at].op != Op::OWord) continue;
    const OWord& own = o_word(at);
    if (own.label == OWord::kNone) continue;
    if (own.kind == OWordKind::Sub || own.kind == OWordKind::Head) {
      head(at, own);
      sub = own.label;
    } else if (own.kind == OWordKind::EndSub) {
      end_sub(at, own);
      sub = OWord::kNone;
    } else if (own.kind >= OWordKind::If) {
      statements_[{sub, own.label}].push_back(at);
    }
  }
  while (!open_.empty()) never_ended();
  std::set<std::uint32_t> subs;
  for (const auto& [key, all] : statements_) {
    // The alarm of a refused block already reports the statement that it would have begun or ended.
    if (!refused_.contains(c_.code.labels[key.second])) statements(all);
    breaks(all);
    subs.insert(key.first);
  }
  for (const std::uint32_t each : subs) crossings(each);
}

/// Report each break out of a while loop that a later do loop takes as its own.
void LabelCheck::breaks(const std::vector<Address>& all) {
  if (o_word(all.front()).kind != OWordKind::While || last_do_ == kNowhere) return;
  for (const Address at : all)
    if (o_word(at).kind == OWordKind::Break && at < last_do_)
      c_.found(Check::BreakLeftOver, at, place(at),
               "a later do loop, such as that of line " +
                   std::to_string(c_.code.blocks[last_do_].line) + ", ends after its first pass");
}

/// Report branches and loops of one subprogram that begin inside another one and end after it.
void LabelCheck::crossings(std::uint32_t sub) {
  std::vector<std::pair<Address, Address>> from_to;
  for (auto at = statements_.lower_bound({sub, 0});
       at != statements_.end() && at->first.first == sub; ++at) {
    Address open = kNowhere;
    for (const Address each : at->second) {
      const OWordKind kind = o_word(each).kind;
      if (open != kNowhere && kind == end_of(o_word(open).kind)) {
        from_to.emplace_back(open, each);
        open = kNowhere;
      } else if (begins(kind)) {
        open = each;
      }
    }
  }
  std::sort(from_to.begin(), from_to.end());
  std::vector<Address> ends;  // of the open statements, the innermost last
  for (const auto& [from, to] : from_to) {
    while (!ends.empty() && ends.back() < from) ends.pop_back();
    if (!ends.empty() && ends.back() < to)
      c_.found(Check::LoopUnclosed, from, place(from),
               "it ends after line " + std::to_string(c_.code.blocks[ends.back()].line) +
                   ", and must end before that line");
    else
      ends.push_back(to);
  }
}

/// Check the statements of one label in one subprogram, in the order of their blocks.
void LabelCheck::statements(const std::vector<Address>& all) {
  OWordKind open = OWordKind::Sub;  // none
  for (const Address at : all) {
    const OWordKind kind = o_word(at).kind;
    const bool of_do = open == OWordKind::Do && kind == OWordKind::While;
    if (begins(kind) && !of_do) open = kind;
    if (open != OWordKind::Sub) continue;
    Fault fault{Cause::LabelNotFound, o_word(at).at, o_word(at).width,
                "no earlier statement has this label"};
    c_.refused(Check::LoopUnclosed, at, std::move(fault));
    return;
  }
  const OWord& first = o_word(all.front());
  const OWordKind end = end_of(first.kind);
  for (const Address at : all)
    if (o_word(at).kind == end) return;
  c_.found(Check::LoopUnclosed, all.front(), place(all.front()),
           "no " + std::string(word_of(end)) + " with this label comes after it");
}

}  // namespace

namespace {

/// Report calls of a program whose file begins with %, from a main program between two %: such a
/// file is not read.
void check_openings(Checker& c, const ProgramFlow& flow) {
  const Program& main = c.program(c.main >= 0 ? c.main : flow.program());
  if (main.opening == 0) return;
  for (const CallEdge& edge : flow.calls()) {
    const std::int32_t whole = c.program(edge.called).inside;
    const Program& called = c.program(whole == kNoProgram ? edge.called : whole);
    if (called.opening == 0 || called.file == main.file) continue;
    const CallRecord& record = c.code.calls[edge.record];
    c.refused(Check::ProgramMissing, edge.from,
              {Cause::ProgramNotFound, record.at, record.width,
               "its file begins with %, as that of the main program does: the control reads no "
               "second such file"});
  }
}

}  // namespace

void check_labels(Checker& c) {
  for (const ProgramFlow& flow : c.flows) {
    if (!flow.has_labels() || c.inside(flow) || c.over(flow.size())) continue;
    LabelCheck(c, flow).run();
    check_openings(c, flow);
  }
}

}  // namespace cncsub
