// The wrong forms of adjectives that learners make, generated from the rules they overuse.
#include "dialogue/english/adjective.h"
#include "dialogue/english/letters.h"

#include <algorithm>

#include <string>

namespace fulcrum::dialogue {
namespace {

/// Collects forms, dropping the accepted ones and repetitions.
class Collector {
  public:
    explicit Collector(std::vector<std::string> accepted) : accepted_(std::move(accepted)) {}

    void add(std::string text, ErrorCode code, int slip) {
        const bool right = std::find(accepted_.begin(), accepted_.end(), text) != accepted_.end();
        const bool seen = std::any_of(forms_.begin(), forms_.end(),
                                      [&](const LearnerForm& form) { return form.text == text; });
        if (!right && !seen) {
            forms_.push_back({std::move(text), code, slip});
        }
    }
    std::vector<LearnerForm> take() { return std::move(forms_); }

  private:
    std::vector<std::string> accepted_;
    std::vector<LearnerForm> forms_;
};

/// The ending put on by a wrong rule of spelling: heavyest, bigest, largeest, cheappest, heaviyest.
std::vector<std::string> misspelt(std::string_view adjective, std::string_view ending) {
    const std::string base(adjective);
    const std::string end(ending);
    std::vector<std::string> result{base + end};
    if (base.size() < 2) {
        return result;
    }
    if (base.back() == 'y') {
        result.push_back(base.substr(0, base.size() - 1) + end);
        result.push_back(base.substr(0, base.size() - 1) + "i" + end);
    } else if (!is_vowel_letter(base.back())) {
        result.push_back(base + std::string(1, base.back()) + end);
    }
    return result;
}

}  // namespace

std::vector<LearnerForm> learner_forms(std::string_view adjective, Degree degree) {
    const std::string base(adjective);
    if (base.empty() || degree == Degree::positive) {
        return {};
    }
    const bool comparative = degree == Degree::comparative;
    const std::string ending = comparative ? "er" : "est";
    const std::string word = comparative ? "more " : "most ";
    const Degree other_degree = comparative ? Degree::superlative : Degree::comparative;
    const std::string other_word = comparative ? "most " : "more ";
    const std::vector<std::string> right = degree_forms(base, degree);
    Collector forms(right);

    // Wrong spelling of an ending that belongs there; where none belongs, the ending itself is the error.
    const Comparison comparison = comparison_of(base);
    const bool takes_ending = comparison == Comparison::ending || comparison == Comparison::both;
    for (const std::string& text : misspelt(base, ending)) {
        forms.add(text, takes_ending ? ErrorCode::spelling : ErrorCode::adjective_form,
                  takes_ending ? 1 : 2);
    }
    forms.add(with_ending(base, ending), ErrorCode::adjective_form, 2);

    // more heavy; more heavier; more heavyer; betterer, bestest, worser.
    forms.add(word + base, ErrorCode::adjective_form, 2);
    forms.add(word + with_ending(base, ending), ErrorCode::adjective_form, 2);
    forms.add(word + base + ending, ErrorCode::adjective_form, 2);
    for (const std::string& form : right) {
        if (form.find(' ') == std::string::npos) {
            forms.add(word + form, ErrorCode::adjective_form, 2);
            if (comparison == Comparison::irregular) {
                forms.add(with_ending(form, ending), ErrorCode::adjective_form, 2);
            }
        }
    }

    // Another degree: heavier or heavy for heaviest; more heavy, most heavier.
    for (const std::string& form : degree_forms(base, other_degree)) {
        forms.add(form, ErrorCode::adjective_form, 3);
        if (form.find(' ') == std::string::npos) {
            forms.add(word + form, ErrorCode::adjective_form, 3);
        }
    }
    forms.add(other_word + base, ErrorCode::adjective_form, 3);
    forms.add(other_word + right.front(), ErrorCode::adjective_form, 3);
    forms.add(base, ErrorCode::adjective_form, 3);
    return forms.take();
}

}  // namespace fulcrum::dialogue
