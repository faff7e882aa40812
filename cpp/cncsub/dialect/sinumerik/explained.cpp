// The words of the language with what each does, for those who ask: `cncsub explain GOTOF`.
#include <algorithm>
#include <array>
#include <iterator>

#include "cncsub/control/edge_datum.hpp"
#include "cncsub/control/g_codes.hpp"
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/sinumerik/frames.hpp"
#include "cncsub/dialect/sinumerik/iso_mode.hpp"
#include "cncsub/dialect/sinumerik/keywords.hpp"
#include "cncsub/dialect/sinumerik/operands.hpp"

namespace cncsub {

namespace sinumerik {

namespace {

constexpr std::string_view kKnown = "general knowledge of the SINUMERIK 840D";
constexpr std::string_view kWithoutPath =
    "changes no path: a run reports it as dropped and goes on";

constexpr KeywordRow kRows[] = {
#define KEYWORD(word, does, words, causes, source) {word, does, words, causes, source},
#define FUNCTION KEYWORD
#include "cncsub/dialect/sinumerik/keywords.def"
#undef FUNCTION
#undef KEYWORD
};

// The words of the rows that name no variable.
constexpr std::string_view kReserved[] = {
#define KEYWORD(word, does, words, causes, source) word,
#define FUNCTION(word, does, words, causes, source)
#include "cncsub/dialect/sinumerik/keywords.def"
#undef FUNCTION
#undef KEYWORD
};

/// A list of words of the reader, and what it does with each of them.
struct TreatedWords {
  std::span<const std::string_view> words;
  std::string_view does;
};
const std::array<TreatedWords, 5> kLists = {
    {{kNeutralWords, kWithoutPath},
     {kReportedWords, "has a value that changes no path: a run reports it as dropped and goes on"},
     {kReportedCallWords, kWithoutPath},
     {kAxisEndWords, "says how exactly an axis comes to its end: a run reports it as dropped"},
     {kOffAtZeroWords,
      "with the value 0 only says that what it begins is off; with another value a run stops "
      "there"}}};

/// The words found so far, each once.
class Collection {
 public:
  void add(Keyword word) {
    const auto same = [&word](const Keyword& of) { return of.name == word.name; };
    if (std::none_of(all_.begin(), all_.end(), same)) all_.push_back(std::move(word));
  }
  std::vector<Keyword> take() { return std::move(all_); }

 private:
  std::vector<Keyword> all_;
};

void add_cycles(const Control& control, Collection& to) {
  for (const SystemProgram& of : control.system_programs) {
    if (of.is_inner()) continue;
    const bool computed = !of.text.empty();
    Keyword word{std::string(of.name), computed ? "computed" : "not-computed",
                 "is a standard cycle of the control"};
    if (computed) {
      const std::size_t open = std::min(of.text.find('('), of.text.size());
      word.does +=
          ", called with " + std::string(of.text.substr(open, of.text.find(')') + 1 - open));
    } else {
      word.does += ", which is not computed here: a run stops there";
      if (!of.needs.empty()) word.does.append("; ").append(of.needs);
    }
    word.source = kKnown;
    to.add(std::move(word));
  }
}

/// Add the variables of the control that a run knows and that have no row.
void add_system_variables(Collection& to) {
  for (const std::string_view word : known_system_variables())
    to.add({"$" + std::string(word), "computed", "is a system variable that a run knows", "", "",
            kKnown});
  for (const std::string_view word : frames_of_no_machine())
    to.add({"$" + std::string(word), "computed",
            "is a frame that the machine has none of: it changes nothing, and takes no other", "",
            "+code-not-computed", "840Dk p.2-67"});
  for (int datum = 1; datum < EdgeDatum::kData; ++datum)
    to.add({"$TC_DP" + std::to_string(datum), "computed",
            "is a datum of an edge, which a run keeps and computes nothing with",
            "[5,1]: the tool and its edge", "+array-element", kKnown});
}

/// Beginnings of the names of system variables that no run knows.
struct Prefix {
  std::string_view name, does;
};
constexpr Prefix kPrefixes[] = {{"$A_", "begins the names of data of the machine and its clock"},
                                {"$AA_", "begins the names of data of an axis"},
                                {"$AC_", "begins the names of data of the channel"},
                                {"$AN_", "begins the names of data of the control"},
                                {"$VA_", "begins the names of data of the drives"},
                                {"$P_", "begins the names of what is programmed"},
                                {"$C_", "begins the names of parameters of cycles"},
                                {"$MN_", "begins the names of machine data of the control"},
                                {"$MC_", "begins the names of machine data of the channel"},
                                {"$MA_", "begins the names of machine data of an axis"},
                                {"$SN_", "begins the names of setting data of the control"},
                                {"$SC_", "begins the names of setting data of the channel"},
                                {"$SA_", "begins the names of setting data of an axis"},
                                {"$NP_", "begins the names of data of protection areas"},
                                {"$NK_", "begins the names of data of the kinematics"},
                                {"$NT_", "begins the names of data of transformations"}};

void add_prefixes(Collection& to) {
  for (const Prefix& of : kPrefixes)
    to.add({std::string(of.name), "not-computed",
            std::string(of.does) + ": a run stops at those that it does not know", "",
            "+code-not-computed", kKnown});
}

/// Add the words of the ISO mode, which machine data switch on.
void add_iso_mode(const Control& control, Collection& to) {
  constexpr const char* kIso = "general knowledge of the SINUMERIK ISO dialects";
  const bool has = has_iso_mode(control);
  to.add({"G290", "computed", "ends the ISO mode, in a block of its own", "", "", kIso});
  to.add({"G291", has ? "computed" : "not-computed",
          has ? "begins the ISO mode, in a block of its own: blocks up to G290 are written as for "
                "another maker's mill"
              : "begins the ISO mode, which machine data 18800 and 10880 switch on for mills: "
                "without them a run stops there",
          "", "code-not-computed", kIso});
  to.add({"ISOCALL", "computed",
          has ? "calls a program in ISO mode; its end brings the own language back"
              : "calls a program in ISO mode; without machine datum 18800, one like any other",
          "a text: the name of the program", "+named-program-not-found +code-not-computed", kIso});
}

/// Add the letters that no word of the language begins with.
void add_other_letters(Collection& to) {
  static constexpr std::string_view kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";
  for (std::size_t i = 0; i < kLetters.size(); ++i)
    to.add({std::string(kLetters.substr(i, 1)), "refused",
            "is no address of the language: its block alarms", "", "address-not-usable", kKnown});
}

}  // namespace

bool is_keyword(std::string_view word) {
  const auto is_in = [word](const TreatedWords& of) { return is_among(of.words, word); };
  return code_of_word(word) >= 0 || is_among(kNotComputedWords, word) ||
         is_among(kReserved, word) || std::any_of(kLists.begin(), kLists.end(), is_in);
}

}  // namespace sinumerik

std::vector<Keyword> sinumerik_keywords(const Control& control) {
  using namespace sinumerik;
  Collection all;
  for (const KeywordRow& of : kRows) all.add(of.keyword());
  add_cycles(control, all);
  for (const TreatedWords& list : kLists)
    for (const std::string_view word : list.words)
      all.add({std::string(word), "passed-over", std::string(list.does), "", "", kKnown});
  add_system_variables(all);
  add_prefixes(all);
  for (const auto& words : {kNotComputedWords, kFurtherWords})
    for (const std::string_view word : words)
      all.add({std::string(word), "not-computed",
               "is not computed here: a run stops there; " + what_it_needs(word), "",
               "code-not-computed", kKnown});
  add_iso_mode(control, all);
  add_other_letters(all);
  return all.take();
}

}  // namespace cncsub
