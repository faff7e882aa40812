// Branches, loops and subprograms of a language that has labels: what is not closed.
#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "cncsub/analysis/checker.hpp"

namespace cncsub {

namespace {

/// What ends a statement, the statement itself where nothing has to.
LabelledKind end_of(LabelledKind kind) {
  switch (kind) {
    case LabelledKind::If:
      return LabelledKind::EndIf;
    case LabelledKind::While:
      return LabelledKind::EndWhile;
    case LabelledKind::Do:
      return LabelledKind::While;
    case LabelledKind::Repeat:
      return LabelledKind::EndRepeat;
    default:
      return kind;
  }
}

bool begins(LabelledKind kind) { return end_of(kind) != kind; }

const char* word_of(LabelledKind kind) {
  switch (kind) {
    case LabelledKind::EndIf:
      return "endif";
    case LabelledKind::EndWhile:
      return "endwhile";
    case LabelledKind::EndRepeat:
      return "endrepeat";
    default:
      return "while";
  }
}

/// The statements of a file by subprogram and label: a label means something in its subprogram.
class LabelCheck {
 public:
  LabelCheck(Checker& c, const ProgramFlow& flow) : c_(c), flow_(flow) {}
  void run();

 private:
  using Key = std::pair<std::uint32_t, std::uint32_t>;  // subprogram, label

  void head(Address at, const Labelled& own);
  void end_sub(Address at, const Labelled& own);
  void never_ended();
  void statements(const std::vector<Address>& all);
  void crossings(std::uint32_t sub);
  const Labelled& labelled(Address at) const { return c_.code.labelled[c_.code.blocks[at].aux]; }
  TextPlace place(Address at) const { return {labelled(at).at, labelled(at).width}; }

  Checker& c_;
  const ProgramFlow& flow_;
  std::map<std::uint32_t, Address> heads_;
  Address open_ = kNowhere;  // the subprogram that has not ended yet
  std::map<Key, std::vector<Address>> statements_;
};

void LabelCheck::head(Address at, const Labelled& own) {
  const auto [first, added] = heads_.try_emplace(own.label, at);
  if (!added)
    c_.found(Check::Duplicate, at, place(at),
             "line " + std::to_string(c_.code.blocks[first->second].line) +
                 " is the head of this subprogram already");
  never_ended();
  if (own.kind == LabelledKind::Sub) open_ = at;
}

void LabelCheck::end_sub(Address at, const Labelled& own) {
  if (open_ == kNowhere || labelled(open_).label != own.label)
    c_.found(Check::LoopUnclosed, at, place(at), "no sub before it has this label");
  else
    open_ = kNowhere;
}

/// The subprogram that is open where another one begins, or the file ends.
void LabelCheck::never_ended() {
  if (open_ != kNowhere)
    c_.found(Check::LoopUnclosed, open_, place(open_), "no endsub behind it has this label");
  open_ = kNowhere;
}

void LabelCheck::run() {
  std::uint32_t sub = Labelled::kNone;
  for (Address at = flow_.first(); at < flow_.last(); ++at) {
    if (c_.code.blocks[at].op != Op::Labelled) continue;
    const Labelled& own = labelled(at);
    if (own.label == Labelled::kNone) continue;
    if (own.kind == LabelledKind::Sub || own.kind == LabelledKind::Head) {
      head(at, own);
      sub = own.label;
    } else if (own.kind == LabelledKind::EndSub) {
      end_sub(at, own);
      sub = Labelled::kNone;
    } else if (own.kind >= LabelledKind::If) {
      statements_[{sub, own.label}].push_back(at);
    }
  }
  never_ended();
  std::set<std::uint32_t> subs;
  for (const auto& [key, all] : statements_) {
    statements(all);
    subs.insert(key.first);
  }
  for (const std::uint32_t each : subs) crossings(each);
}

/// Branches and loops of one subprogram of which one begins inside another and ends behind it.
void LabelCheck::crossings(std::uint32_t sub) {
  std::vector<std::pair<Address, Address>> from_to;
  for (auto at = statements_.lower_bound({sub, 0});
       at != statements_.end() && at->first.first == sub; ++at) {
    Address open = kNowhere;
    for (const Address each : at->second) {
      const LabelledKind kind = labelled(each).kind;
      if (open != kNowhere && kind == end_of(labelled(open).kind)) {
        from_to.emplace_back(open, each);
        open = kNowhere;
      } else if (begins(kind)) {
        open = each;
      }
    }
  }
  std::sort(from_to.begin(), from_to.end());
  std::vector<Address> ends;  // of those that are open, the innermost last
  for (const auto& [from, to] : from_to) {
    while (!ends.empty() && ends.back() < from) ends.pop_back();
    if (!ends.empty() && ends.back() < to)
      c_.found(Check::LoopUnclosed, from, place(from),
               "it ends behind line " + std::to_string(c_.code.blocks[ends.back()].line) +
                   ", where what it begins in ends");
    else
      ends.push_back(to);
  }
}

/// Those of one label in one subprogram, in their order.
void LabelCheck::statements(const std::vector<Address>& all) {
  LabelledKind open = LabelledKind::Sub;  // none
  for (const Address at : all) {
    const LabelledKind kind = labelled(at).kind;
    const bool of_do = open == LabelledKind::Do && kind == LabelledKind::While;
    if (begins(kind) && !of_do) open = kind;
    if (open != LabelledKind::Sub) continue;
    Fault fault{Cause::LabelNotFound, labelled(at).at, labelled(at).width,
                "no statement before it has this label"};
    c_.refused(Check::LoopUnclosed, at, std::move(fault));
    return;
  }
  const Labelled& first = labelled(all.front());
  const LabelledKind end = end_of(first.kind);
  for (const Address at : all)
    if (labelled(at).kind == end) return;
  c_.found(Check::LoopUnclosed, all.front(), place(all.front()),
           "no " + std::string(word_of(end)) + " behind it has this label");
}

}  // namespace

void check_labels(Checker& c) {
  for (const ProgramFlow& flow : c.flows)
    if (flow.has_labels() && !c.inside(flow) && !c.over(flow.size())) LabelCheck(c, flow).run();
}

}  // namespace cncsub
