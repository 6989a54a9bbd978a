#include "runtime/lesson/first_use.h"

#include <algorithm>
#include <cctype>
#include <iterator>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::array<Way, kWays> kOrder{Way::right, Way::up,   Way::left,
                                        Way::away,  Way::down, Way::near};
// What an arm's own friction hides is pushed again, stronger.
constexpr std::array<double, 3> kPushes_N{0.8, 1.6, kMostPush_N};
// Parts of that. The stronger one comes first, then last: who always says the same is found out.
constexpr std::array<std::array<double, 2>, 2> kCompared{{{1.0, 0.5}, {0.5, 1.0}}};

struct Word {
    std::string_view word;
    Way way;
};
constexpr std::array<Word, 12> kWords{{{"right", Way::right},
                                       {"left", Way::left},
                                       {"up", Way::up},
                                       {"upwards", Way::up},
                                       {"down", Way::down},
                                       {"downwards", Way::down},
                                       {"me", Way::near},
                                       {"you", Way::near},
                                       {"near", Way::near},
                                       {"away", Way::away},
                                       {"forward", Way::away},
                                       {"forwards", Way::away}}};

std::vector<std::string> words_in(std::string_view said) {
    std::vector<std::string> words(1);
    for (const char letter : said) {
        const auto byte = static_cast<unsigned char>(letter);
        if (std::isalnum(byte) != 0) {
            words.back() += static_cast<char>(std::tolower(byte));
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    return words;
}

Way opposite(Way way) {
    constexpr std::array<Way, kWays> kOpposites{Way::left, Way::right, Way::down,
                                                Way::up,   Way::away,  Way::near};
    return kOpposites[static_cast<std::size_t>(way)];
}

std::size_t index_of(Way way) {
    return static_cast<std::size_t>(way);
}

std::size_t axis_of(Way way) {
    return index_of(way) / 2;
}

// What was said of a push, as the scene has it: on a table, away is up.
Way lift(Way said, const TriedDevice& tried) {
    const bool lies =
        tried.is_stick && tried.pushes[axis_of(Way::up)] && !tried.pushes[axis_of(Way::near)];
    return !lies ? said : said == Way::away ? Way::up : said == Way::near ? Way::down : said;
}

// Axes that nobody was asked about stay themselves, or else become what is left.
void complete(Matrix3& turned) {
    for (const bool only_own : {true, false}) {
        for (int i = 0; i < 3; ++i) {
            for (int row = 0; row < 3 && turned.col(i).isZero(); ++row) {
                if ((row == i || !only_own) && turned.row(row).isZero()) {
                    turned(row, i) = 1.0;
                }
            }
        }
    }
}

}  // namespace

Vector3 vector_of(Way way) {
    constexpr int kAxes[] = {0, 0, 1, 1, 2, 2};
    const bool runs_back = way == Way::left || way == Way::down || way == Way::away;
    return (runs_back ? -1.0 : 1.0) * Vector3::Unit(kAxes[index_of(way)]);
}

std::optional<Way> way_in(std::string_view said) {
    std::optional<Way> named;
    const std::vector<std::string> words = words_in(said);
    // "Away from me" is away.
    const bool is_away = std::ranges::find(words, "away") != words.end();
    for (const std::string& word : words) {
        const auto found = std::ranges::find(kWords, std::string_view(word), &Word::word);
        if (found == kWords.end() || (is_away && found->way == Way::near)) {
            continue;
        }
        if (named && *named != found->way) {
            return std::nullopt;
        }
        named = found->way;
    }
    return named;
}

std::optional<int> which_in(std::string_view said) {
    const std::vector<std::string> words = words_in(said);
    const auto has = [&](std::string_view one, std::string_view other) {
        return std::ranges::find(words, one) != words.end() ||
               std::ranges::find(words, other) != words.end();
    };
    const bool first = has("first", "1");
    const bool second = has("second", "2");
    return first == second ? std::nullopt : std::optional(second ? 1 : 0);
}

bool says_nothing(std::string_view said) {
    constexpr std::array<std::string_view, 6> kNothing{"nothing", "none",    "neither",
                                                       "same",    "equally", "equal"};
    return std::ranges::any_of(words_in(said), [&](const std::string& word) {
        return std::ranges::find(kNothing, std::string_view(word)) != kNothing.end();
    });
}

FirstUse::FirstUse(bool asks, const TriedDevice& tried) : asks_(asks), tried_(tried) {
    std::ranges::copy_if(kOrder, std::back_inserter(ways_),
                         [&](Way way) { return tried.pushes[axis_of(way)]; });
    if (ways_.empty()) {
        end_ = FirstUseEnd::unfelt;
        return;
    }
    begin_push();
}

// Two pushes are compared upwards, where it can.
Way FirstUse::way_now() const {
    return !compares_ ? ways_[next_] : tried_.pushes[axis_of(Way::up)] ? Way::up : ways_.front();
}

void FirstUse::begin_push() {
    const Vector3 way_W = vector_of(way_now());
    const double part = compares_ ? kCompared[round_][next_] : 1.0;
    push_.emplace(PushSettings{.force_N = part * kPushes_N[strength_]}, way_W);
}

Vector3 FirstUse::step(const HapticState& state, double now_s) {
    if (end_ != FirstUseEnd::running || question_ != FirstUseQuestion::none) {
        return Vector3::Zero();
    }
    const Vector3 force_W = push_->step(state, now_s);
    if (push_->end() != PushEnd::running) {
        finish_push();
    }
    return force_W;
}

// What did the hand do?
void FirstUse::finish_push() {
    if (push_->end() == PushEnd::ran_against) {
        axis_ = static_cast<int>(axis_of(way_now()));
        end_ = FirstUseEnd::against;
        return;
    }
    if (push_->end() != PushEnd::done) {
        end_ = FirstUseEnd::disturbed;
        return;
    }
    if (!compares_) {
        const Way way = way_now();
        if (push_->motion_W().norm() < kLeastMotion_m && strength_ + 1 < kPushes_N.size()) {
            ++strength_;
            begin_push();
            return;
        }
        motions_W_[index_of(way)] = push_->motion_W();
        if (motions_W_[index_of(opposite(way))] && !second_try_ && !judge_axis(way)) {
            return;
        }
        if (asks_) {
            question_ = FirstUseQuestion::way;
            return;
        }
    } else if (next_ == 1) {
        question_ = FirstUseQuestion::stronger;
        return;
    }
    go_on();
}

// False where that ends it.
bool FirstUse::judge_axis(Way way) {
    const std::size_t i = index_of(way);
    switch (judge_pushes(vector_of(way), *motions_W_[i], *motions_W_[index_of(opposite(way))])) {
        case PushVerdict::with:
            return true;
        case PushVerdict::unfelt:
            // Who is asked may feel what does not move.
            if (asks_) {
                return true;
            }
            end_ = FirstUseEnd::unfelt;
            break;
        case PushVerdict::against:
            end_ = FirstUseEnd::against;
            break;
        case PushVerdict::aside:
            end_ = FirstUseEnd::aside;
            break;
    }
    axis_ = static_cast<int>(axis_of(way));
    return false;
}

// The next push, or what all of them say.
void FirstUse::go_on() {
    ++next_;
    second_try_ = compares_ && second_try_;
    if (!compares_ && next_ == ways_.size()) {
        if (!asks_) {
            end_ = FirstUseEnd::good;
            return;
        }
        judge_answers();
        if (end_ != FirstUseEnd::running) {
            return;
        }
        compares_ = true;
        next_ = 0;
    }
    begin_push();
}

bool FirstUse::answer(std::string_view said) {
    const bool felt_nothing = says_nothing(said);
    if (question_ == FirstUseQuestion::stronger) {
        const auto which = felt_nothing ? std::nullopt : which_in(said);
        if (which || felt_nothing) {
            hear_stronger(which);
        }
        return which || felt_nothing;
    }
    const auto way =
        question_ == FirstUseQuestion::way && !felt_nothing ? way_in(said) : std::nullopt;
    if (question_ == FirstUseQuestion::none || (!way && !felt_nothing)) {
        return false;
    }
    hear_way(way);
    return true;
}

// None where nothing was felt.
void FirstUse::hear_way(std::optional<Way> way) {
    question_ = FirstUseQuestion::none;
    const Way pushed = way_now();
    if (way) {
        way = lift(*way, tried_);
    }
    if (way != pushed && !second_try_) {
        second_try_ = true;
        begin_push();
        return;
    }
    if (!way) {
        axis_ = static_cast<int>(axis_of(pushed));
        end_ = FirstUseEnd::unfelt;
        return;
    }
    said_[index_of(pushed)] = *way;
    go_on();
}

// None where they felt alike.
void FirstUse::hear_stronger(std::optional<int> which) {
    question_ = FirstUseQuestion::none;
    if (which && kCompared[round_][static_cast<std::size_t>(*which)] == 1.0) {
        second_try_ = false;
        ++round_;
    } else if (std::exchange(second_try_, true)) {
        end_ = FirstUseEnd::unsure;
    }
    if (round_ == kCompared.size()) {
        end_ = FirstUseEnd::good;
    }
    if (end_ == FirstUseEnd::running) {
        next_ = 0;
        begin_push();
    }
}

// M e_i is what was said of a push along e_i; of the opposite one the opposite must have been said.
void FirstUse::judge_answers() {
    Matrix3 turned = Matrix3::Zero();
    for (const Way way : {Way::right, Way::up, Way::near}) {
        if (!tried_.pushes[axis_of(way)]) {
            continue;
        }
        const Way said = said_[index_of(way)];
        if (said_[index_of(opposite(way))] != opposite(said)) {
            end_ = FirstUseEnd::unsure;
            return;
        }
        turned.col(static_cast<int>(axis_of(way))) = vector_of(said);
    }
    complete(turned);
    felt_ = AxisOrder::of(turned);
    if (!felt_) {
        end_ = FirstUseEnd::unsure;
    } else if (!felt_->is_plain()) {
        end_ = FirstUseEnd::turned;
    }
}

std::string tell(const FirstUse& trial, const AxisOrder& axes) {
    const std::string off =
        std::string("the ") + trial.tried().name() + " gives no force in this lesson: ";
    constexpr const char* kAxes[] = {"left and right", "up and down", "near and away"};
    const std::string axis = kAxes[trial.axis()];
    switch (trial.end()) {
        case FirstUseEnd::running:
        case FirstUseEnd::good:
            return {};
        case FirstUseEnd::against:
            return off + std::string("the hand goes against its push, ") + axis +
                   "; a motor or an encoder runs the wrong way, have that mended.";
        case FirstUseEnd::aside:
            return off + std::string("the hand goes across its push, ") + axis +
                   "; motors are exchanged, have that mended.";
        case FirstUseEnd::unfelt:
            if (trial.asks()) {
                return off + std::string("its pushes were not felt, ") + axis +
                       "; it is stiff, or a motor is off, have that mended.";
            }
            return off + std::string("its pushes did not move the hand, ") + axis +
                   "; it is stiff, or a motor is off: start the lesson in a window, where the "
                   "learner is asked what is felt.";
        case FirstUseEnd::disturbed:
            return off + std::string(
                             "its pushes could not be tried; hold it loosely and still, and "
                             "start the lesson again.");
        case FirstUseEnd::turned: {
            const auto mended = AxisOrder::of(trial.felt()->matrix() * axes.matrix());
            return off +
                   std::string(
                       "it stands otherwise than it says; start the lesson again with "
                       "--axes ") +
                   mended.value_or(AxisOrder{}).text() + ".";
        }
        case FirstUseEnd::unsure:
            return off + std::string(
                             "what was felt fits no way in which it could stand; start the "
                             "lesson again and say what is felt.");
    }
    return {};
}

}  // namespace fulcrum::runtime
