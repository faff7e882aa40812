// The words of LinuxCNC with what each does, for those who ask: `cncsub explain endsub`.
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/linuxcnc/built_in.hpp"

namespace cncsub {

namespace {

constexpr std::string_view kSource = "rs274 2.9";

constexpr KeywordRow kRows[] = {
#define KEYWORD(word, does, words, causes) {word, does, words, causes, kSource},
#include "cncsub/dialect/linuxcnc/keywords.def"
#undef KEYWORD
};

}  // namespace

std::vector<Keyword> linuxcnc_keywords(const Control& /*control*/) {
  std::vector<Keyword> all;
  for (const KeywordRow& of : kRows) all.push_back(of.keyword());
  for (const std::string_view name : linuxcnc::names_of_built_ins())
    all.push_back({"#<" + std::string(name) + ">", "computed",
                   "is a parameter of the control that a run knows", "", "", kSource});
  for (const std::string_view name : linuxcnc::names_of_machine())
    all.push_back({"#<" + std::string(name) + ">", "not-computed",
                   "is a parameter of the machine: a run stops where a program reads it", "", "",
                   kSource});
  return all;
}

}  // namespace cncsub
