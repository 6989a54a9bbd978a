#include "dialogue/marking/mark.h"

#include <algorithm>

namespace fulcrum::dialogue {
namespace {

/// Which of several errors matters most to a learner: the smaller the number, the more.
int importance(const FormError& error) {
    if (error.target) {
        return 0;
    }
    switch (error.code) {
        case ErrorCode::missing_determiner:
        case ErrorCode::wrong_determiner:
        case ErrorCode::extra_determiner:
            return 2;
        case ErrorCode::spelling:
        case ErrorCode::orthography:
            return 3;
        default:
            return 1;
    }
}

}  // namespace

bool Mark::target_right() const {
    return form_known && std::none_of(form_errors.begin(), form_errors.end(),
                                      [](const FormError& error) { return error.target; });
}

int Mark::other_errors() const {
    return static_cast<int>(std::count_if(form_errors.begin(), form_errors.end(),
                                          [](const FormError& error) { return !error.target; }));
}

const FormError* Mark::main_error() const {
    // An adjective's own form before its article, and "hardly" before "smoth".
    const auto rank = [](const FormError& error) {
        return importance(error) * 4 + (error.role == Role::determiner ? 2 : 0) +
               (error.code == ErrorCode::spelling ? 1 : 0);
    };
    const auto found = std::ranges::min_element(form_errors, {}, rank);
    return found == form_errors.end() ? nullptr : &*found;
}

std::string_view Mark::slot(std::string_view name) const {
    const auto found = std::find_if(slots.begin(), slots.end(),
                                    [&](const auto& slot) { return slot.first == name; });
    return found == slots.end() ? std::string_view{} : std::string_view(found->second);
}

Mark without_form(Mark mark) {
    mark.form_known = false;
    mark.form_errors.clear();
    mark.emphasised = mark.corrected;
    mark.emphasis.clear();
    mark.gapped.clear();
    return mark;
}

}  // namespace fulcrum::dialogue
