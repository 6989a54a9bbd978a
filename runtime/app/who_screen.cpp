#include "runtime/app/who_screen.h"

#include "runtime/progress/text_rules.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::runtime {
namespace {

constexpr double kSettle_s = 0.4;  // a double click on a card is one click, and none on a picture
constexpr double kLongestWrongWait_s = 8.0;

View cards_view(const MenuChoice& choice, std::string title) {
    View view;
    view.tool_visible = false;
    view.title = std::move(title);
    view.menu_selected = choice.selected;
    view.menu_first_row = choice.first_row;
    view.menu_is_small = true;
    return view;
}

ViewMenuItem card_of(std::string title, std::string_view icon, std::string_view second = {}) {
    ViewMenuItem item;
    item.title = std::move(title);
    item.icon = icon;
    item.second_icon = second;
    return item;
}

}  // namespace

View classes_view(const std::vector<SchoolClass>& classes, const MenuChoice& choice,
                  const dialogue::Catalogue& catalogue) {
    View view = cards_view(choice, catalogue.say("who.class"));
    for (std::size_t i = 0; i < classes.size(); ++i) {
        view.menu.push_back(
            card_of(classes[i].record.name, kClassPictures[i % kClassPictures.size()]));
    }
    return view;
}

View pupils_view(const SchoolClass& one, const MenuChoice& choice,
                 const dialogue::Catalogue& catalogue) {
    View view = cards_view(choice, catalogue.say("who.title"));
    const bool with_pictures = one.shown_as == ShownAs::pictures;
    for (const Pupil& pupil : one.pupils) {
        const auto& card = pupil.pictures.card;
        view.menu.push_back(with_pictures ? card_of(pupil.learner.nickname, card[0], card[1])
                                          : card_of(pupil.learner.nickname, {}));
    }
    view.menu.push_back(
        card_of(catalogue.say("menu.guest"), with_pictures ? kGuestPicture : std::string_view{}));
    return view;
}

View secret_view(const Pupil& pupil, const MenuChoice& choice, const dialogue::Catalogue& catalogue,
                 SecretSaid said) {
    View view = cards_view(choice, catalogue.say("who.hello", {{"name", pupil.learner.nickname}}));
    view.caption = catalogue.say(said == SecretSaid::asked ? "who.picture" : "who.wrong");
    for (const std::string_view picture : kClassPictures) {
        view.menu.push_back(card_of(catalogue.say("picture." + std::string(picture)), picture));
    }
    ViewMenuItem back = card_of(catalogue.say("menu.back"), {});
    back.leads_back = true;
    view.menu.push_back(std::move(back));
    return view;
}

View turned_down(View view) {
    for (ViewMenuItem& item : view.menu) {
        item = ViewMenuItem{};
    }
    return view;
}

bool is_secret_of(const Pupil& pupil, int card) noexcept {
    return card >= 0 && static_cast<std::size_t>(card) < kClassPictures.size() &&
           kClassPictures[static_cast<std::size_t>(card)] == pupil.pictures.secret;
}

double wait_after_s(int n_wrong) noexcept {
    return n_wrong < 1 ? 0.0 : std::min(std::ldexp(1.0, n_wrong - 1), kLongestWrongWait_s);
}

WhoScreen::WhoScreen(Desktop& desktop, const dialogue::Catalogue& catalogue, ProgressStore& store,
                     std::string only)
    : desktop_(desktop),
      catalogue_(catalogue),
      store_(store),
      only_(std::move(only)),
      picker_(desktop) {}

Expected<void> WhoScreen::read() {
    const auto rows = store_.read_classes();
    if (!rows) {
        return tl::unexpected(rows.error());
    }
    auto classes = list_classes(*rows);
    if (!only_.empty()) {
        auto found = find_class(classes, only_);
        if (!found) {
            return tl::unexpected(found.error());
        }
        classes = {std::move(*found)};
    }
    std::erase_if(classes, [](const SchoolClass& one) { return one.pupils.empty(); });
    classes_ = std::move(classes);
    return {};
}

std::optional<std::string> WhoScreen::ask() {
    std::vector<std::string> models(kClassPictures.begin(), kClassPictures.end());
    models.emplace_back(kGuestPicture);
    desktop_.picture->load_models(models, {});
    MenuChoice choice;
    Found found = Found::back;
    while (found == Found::back) {
        const bool several = classes_.size() > 1;
        if (several && picker_.pick(
                           [&](const MenuChoice& chosen) {
                               return classes_view(classes_, chosen, catalogue_);
                           },
                           choice) != PickEnd::picked) {
            return std::nullopt;
        }
        found = ask_class(classes_[several ? static_cast<std::size_t>(choice.selected) : 0]);
        if (found == Found::back && !several) {
            return std::nullopt;
        }
    }
    desktop_.hush();
    return found == Found::yes ? std::optional(found_) : std::nullopt;
}

WhoScreen::Found WhoScreen::ask_class(const SchoolClass& one) {
    MenuChoice choice;
    desktop_.say_again({desktop_.words->english().say("who.title")});
    while (true) {
        const PickEnd end = picker_.pick(
            [&](const MenuChoice& chosen) { return pupils_view(one, chosen, catalogue_); }, choice);
        if (end != PickEnd::picked) {
            return end == PickEnd::back ? Found::back : Found::closed;
        }
        const auto card = static_cast<std::size_t>(choice.selected);
        if (card >= one.pupils.size()) {
            found_.clear();
            return Found::yes;
        }
        const Pupil& pupil = one.pupils[card];
        const Found found = one.shown_as == ShownAs::names ? Found::yes : ask_secret(pupil);
        if (found != Found::back) {
            found_ = pupil.learner.nickname;
            return found;
        }
    }
}

WhoScreen::Found WhoScreen::ask_secret(const Pupil& pupil) {
    MenuChoice choice;
    SecretSaid said = SecretSaid::asked;
    const auto view = [&](const MenuChoice& chosen) {
        return secret_view(pupil, chosen, catalogue_, said);
    };
    desktop_.say_again({desktop_.words->english().say("who.picture")});
    if (!picker_.rest(view(choice), kSettle_s)) {
        return Found::closed;
    }
    while (true) {
        const PickEnd end = picker_.pick(view, choice);
        if (end == PickEnd::closed) {
            return Found::closed;
        }
        if (end == PickEnd::back ||
            static_cast<std::size_t>(choice.selected) >= kClassPictures.size()) {
            return Found::back;
        }
        int& n_wrong = n_wrong_[pupil.learner.id];
        if (is_secret_of(pupil, choice.selected)) {
            n_wrong = 0;
            return Found::yes;
        }
        said = SecretSaid::wrong;
        desktop_.say_again({desktop_.words->english().say("who.wrong")});
        if (!picker_.rest(turned_down(view(choice)), wait_after_s(++n_wrong))) {
            return Found::closed;
        }
    }
}

}  // namespace fulcrum::runtime
