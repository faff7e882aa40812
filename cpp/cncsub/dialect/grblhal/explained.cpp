// The words of grblHAL with what each does, for those who ask: `cncsub explain endsub`.
#include "cncsub/dialect/dialect.hpp"
#include "cncsub/dialect/grblhal/built_in.hpp"

namespace cncsub {

namespace {

constexpr std::string_view kSource = "gHx; gHf";

constexpr KeywordRow kRows[] = {
#define KEYWORD(word, does, words, causes) {word, does, words, causes, kSource},
#include "cncsub/dialect/grblhal/keywords.def"
#undef KEYWORD
};

}  // namespace

std::vector<Keyword> grblhal_keywords(const Control& /*control*/) {
  std::vector<Keyword> all;
  for (const KeywordRow& of : kRows) all.push_back(of.keyword());
  for (const BuiltIn& of : grblhal::built_ins())
    all.push_back({"#<" + std::string(of.name) + ">", "computed",
                   "is a parameter of the control that a run knows", "", "", "gHp"});
  for (const std::string_view name : grblhal::kReturned)
    all.push_back({"#<" + std::string(name) + ">", "computed",
                   "is what the last subprogram returned, or whether it did", "", "", "gHf"});
  for (const std::string_view name : grblhal::names_of_machine())
    all.push_back({"#<" + std::string(name) + ">", "not-computed",
                   "is a parameter of the machine: a run stops where a program reads it", "", "",
                   "gHp"});
  return all;
}

}  // namespace cncsub
