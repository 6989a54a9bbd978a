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

/// The adjective, the degree that is right, and the words that make it.
struct Target {
    std::string base, ending, word, other_word;
    Degree other_degree;
    std::vector<std::string> right;
    Comparison comparison;
};

/// Wrong spelling of an ending that belongs there; where none belongs, the ending itself is the error.
void add_endings(const Target& target, Collector& forms) {
    const bool takes_ending =
        target.comparison == Comparison::ending || target.comparison == Comparison::both;
    for (const std::string& text : misspelt(target.base, target.ending)) {
        forms.add(text, takes_ending ? ErrorCode::spelling : ErrorCode::adjective_form,
                  takes_ending ? 1 : 2);
    }
    forms.add(with_ending(target.base, target.ending), ErrorCode::adjective_form, 2);
}

/// more heavy; more heavier; more heavyer; bestest, worser.
void add_doubled(const Target& target, Collector& forms) {
    for (const std::string& text :
         {target.base, with_ending(target.base, target.ending), target.base + target.ending}) {
        forms.add(target.word + text, ErrorCode::adjective_form, 2);
    }
    for (const std::string& form : target.right) {
        if (form.find(' ') != std::string::npos) {
            continue;
        }
        forms.add(target.word + form, ErrorCode::adjective_form, 2);
        if (target.comparison == Comparison::irregular) {
            forms.add(with_ending(form, target.ending), ErrorCode::adjective_form, 2);
        }
    }
}

/// Another degree: heavier or heavy for heaviest; more heavy, most heavier, more heavier.
void add_other_degrees(const Target& target, Collector& forms) {
    for (const std::string& form : degree_forms(target.base, target.other_degree)) {
        forms.add(form, ErrorCode::adjective_form, 3);
        if (form.find(' ') == std::string::npos) {
            forms.add(target.word + form, ErrorCode::adjective_form, 3);
            forms.add(target.other_word + form, ErrorCode::adjective_form, 3);
        }
    }
    forms.add(target.other_word + target.base, ErrorCode::adjective_form, 3);
    forms.add(target.other_word + target.right.front(), ErrorCode::adjective_form, 3);
    forms.add(target.base, ErrorCode::adjective_form, 3);
}

/// The adverb: softly, stickily, gently.
std::string adverb_of(std::string_view adjective) {
    const std::string base(adjective);
    const std::size_t n = base.size();
    if (n > 1 && base.back() == 'y' && !is_vowel_letter(base[n - 2])) {
        return base.substr(0, n - 1) + "ily";
    }
    if (n > 2 && base.substr(n - 2) == "le" && !is_vowel_letter(base[n - 3])) {
        return base.substr(0, n - 1) + "y";
    }
    return base + "ly";
}

/// The noun that a -y makes an adjective of: stick, bump, fog; its own -y is no such ending in a short word.
std::string without_y(std::string stem) {
    stem.pop_back();
    const std::size_t n = stem.size();
    if (n > 2 && stem[n - 1] == stem[n - 2] && !is_vowel_letter(stem[n - 1])) {
        stem.pop_back();
    }
    return stem;
}

/// Where the plain adjective belongs: hardly, hardness, hardy, hards; stick, stickey for sticky; then the other degrees.
std::vector<LearnerForm> positive_forms(std::string_view adjective) {
    Collector forms({std::string(adjective)});
    const std::string base(adjective);
    const std::size_t n = base.size();
    const bool in_y = n > 3 && base.back() == 'y' && !is_vowel_letter(base[n - 2]);
    forms.add(adverb_of(base), ErrorCode::morphology, 2);
    forms.add((in_y ? base.substr(0, n - 1) + "i" : base) + "ness", ErrorCode::morphology, 2);
    if (in_y) {
        forms.add(without_y(base), ErrorCode::morphology, 2);
        forms.add(base.substr(0, n - 1) + "ey", ErrorCode::spelling, 1);
    } else {
        forms.add(with_ending(base, "y"), ErrorCode::morphology, 2);
        forms.add(base + "s", ErrorCode::morphology, 2);
    }
    for (const Degree degree : {Degree::comparative, Degree::superlative}) {
        const std::string word = degree == Degree::comparative ? "more " : "most ";
        forms.add(word + base, ErrorCode::adjective_form, 3);
        for (const std::string& form : degree_forms(base, degree)) {
            forms.add(form, ErrorCode::adjective_form, 3);
            if (form.find(' ') == std::string::npos) {
                forms.add(word + form, ErrorCode::adjective_form, 3);
            }
        }
    }
    return forms.take();
}

}  // namespace

std::vector<LearnerForm> learner_forms(std::string_view adjective, Degree degree) {
    if (adjective.empty()) {
        return {};
    }
    if (degree == Degree::positive) {
        return positive_forms(adjective);
    }
    const bool comparative = degree == Degree::comparative;
    const Target target{std::string(adjective),
                        comparative ? "er" : "est",
                        comparative ? "more " : "most ",
                        comparative ? "most " : "more ",
                        comparative ? Degree::superlative : Degree::comparative,
                        degree_forms(adjective, degree),
                        comparison_of(adjective)};
    Collector forms(target.right);
    add_endings(target, forms);
    add_doubled(target, forms);
    add_other_degrees(target, forms);
    return forms.take();
}

}  // namespace fulcrum::dialogue
