// The matcher calls itself once for each choice it may have to take back; kMaxPatternDepth bounds
// that. NOLINTBEGIN(misc-no-recursion)
#include "runtime/lua/sandbox/pattern.h"

#include <cctype>
#include <cstring>
#include <utility>

namespace fulcrum::runtime {
namespace {

constexpr std::size_t kStepsAReport = 256;

/// Does `c` belong to the class that follows a '%'? A capital letter means all others.
bool class_matches(unsigned char c, char letter) {
    bool in = false;
    switch (std::tolower(static_cast<unsigned char>(letter))) {
        case 'a':
            in = std::isalpha(c) != 0;
            break;
        case 'c':
            in = std::iscntrl(c) != 0;
            break;
        case 'd':
            in = std::isdigit(c) != 0;
            break;
        case 'g':
            in = std::isgraph(c) != 0;
            break;
        case 'l':
            in = std::islower(c) != 0;
            break;
        case 'p':
            in = std::ispunct(c) != 0;
            break;
        case 's':
            in = std::isspace(c) != 0;
            break;
        case 'u':
            in = std::isupper(c) != 0;
            break;
        case 'w':
            in = std::isalnum(c) != 0;
            break;
        case 'x':
            in = std::isxdigit(c) != 0;
            break;
        default:
            return static_cast<unsigned char>(letter) == c;  // %. is a dot
    }
    return std::isupper(static_cast<unsigned char>(letter)) != 0 ? !in : in;
}

/// The character there; a zero beyond the end.
char letter_at(std::string_view pattern, std::size_t p) {
    return p < pattern.size() ? pattern[p] : '\0';
}

/// The escapes that are no single characters.
bool is_special_escape(char c, char next) {
    return c == '%' &&
           (next == 'b' || next == 'f' || std::isdigit(static_cast<unsigned char>(next)) != 0);
}

}  // namespace

PatternMatcher::PatternMatcher(std::string_view text, std::string_view pattern,
                               std::function<void(std::size_t)> meter)
    : text_(text), pattern_(pattern), meter_(std::move(meter)) {}

std::optional<std::size_t> PatternMatcher::match_at(std::size_t begin) {
    n_captures_ = 0;
    return match(begin, 0, 0);
}

PatternCapture PatternMatcher::capture(int i, std::size_t begin, std::size_t end) const {
    if (i >= n_captures_) {
        if (i != 0) {
            throw PatternError{"there is no capture %" + std::to_string(i + 1)};
        }
        return {begin, end - begin, false};
    }
    const auto k = static_cast<std::size_t>(i);
    if (filling_[k] == Filling::open) {
        throw PatternError{"a capture in the pattern is not closed"};
    }
    return captures_[k];
}

void PatternMatcher::count(std::size_t steps) {
    steps_ += steps;
    if (steps_ >= kStepsAReport) {
        meter_(std::exchange(steps_, 0));
    }
}

PatternMatcher::Match PatternMatcher::match(std::size_t s, std::size_t p, int depth) {
    if (depth > kMaxPatternDepth) {
        throw PatternError{"the pattern is too complex"};
    }
    while (p < pattern_.size()) {
        count(1);
        const char c = pattern_[p];
        const char next = letter_at(pattern_, p + 1);
        if (c == '(') {
            return next == ')' ? open_capture(s, p + 2, Filling::position, depth)
                               : open_capture(s, p + 1, Filling::open, depth);
        }
        if (c == ')') {
            return close_capture(s, p + 1, depth);
        }
        if (c == '$' && p + 1 == pattern_.size()) {
            return s == text_.size() ? Match(s) : std::nullopt;
        }
        bool finished = false;
        const Match settled = is_special_escape(c, next) ? match_escape(s, p, next, finished)
                                                         : match_quantified(s, p, depth, finished);
        if (finished) {
            return settled;
        }
    }
    return s;
}

/// %b, %f and %1 to %9. Either the match has failed, or s and p have moved on.
PatternMatcher::Match PatternMatcher::match_escape(std::size_t& s, std::size_t& p, char letter,
                                                   bool& finished) {
    Match moved;
    if (letter == 'b') {
        moved = match_balanced(s, p + 2);
        p += 4;
    } else if (letter == 'f') {
        const std::size_t set = p + 2;
        if (set >= pattern_.size() || pattern_[set] != '[') {
            throw PatternError{"missing '[' after '%f' in the pattern"};
        }
        moved = at_frontier(s, set) ? Match(s) : std::nullopt;
        p = class_end(set);
    } else {
        moved = match_back_reference(s, letter);
        p += 2;
    }
    finished = !moved;
    s = moved.value_or(s);
    return std::nullopt;
}

/// One character or class and what follows it. Either the match is settled, or s and p have moved
/// on.
PatternMatcher::Match PatternMatcher::match_quantified(std::size_t& s, std::size_t& p, int depth,
                                                       bool& finished) {
    const std::size_t after = class_end(p);
    const char quantifier = letter_at(pattern_, after);
    finished = true;
    switch (quantifier) {
        case '?':
            if (s < text_.size() && single_matches(s, p, after)) {
                if (const Match taken = match(s + 1, after + 1, depth + 1)) {
                    return taken;
                }
            }
            p = after + 1;
            finished = false;
            return std::nullopt;
        case '*':
            return match_most(s, p, after, depth);
        case '+':
            return s < text_.size() && single_matches(s, p, after)
                       ? match_most(s + 1, p, after, depth)
                       : std::nullopt;
        case '-':
            return match_least(s, p, after, depth);
        default:
            if (s >= text_.size() || !single_matches(s, p, after)) {
                return std::nullopt;
            }
            ++s;
            p = after;
            finished = false;
            return std::nullopt;
    }
}

PatternMatcher::Match PatternMatcher::match_most(std::size_t s, std::size_t p, std::size_t after,
                                                 int depth) {
    std::size_t n = 0;
    while (s + n < text_.size() && single_matches(s + n, p, after)) {
        ++n;
    }
    for (;; --n) {
        if (const Match rest = match(s + n, after + 1, depth + 1)) {
            return rest;
        }
        if (n == 0) {
            return std::nullopt;
        }
    }
}

PatternMatcher::Match PatternMatcher::match_least(std::size_t s, std::size_t p, std::size_t after,
                                                  int depth) {
    for (;; ++s) {
        if (const Match rest = match(s, after + 1, depth + 1)) {
            return rest;
        }
        if (s >= text_.size() || !single_matches(s, p, after)) {
            return std::nullopt;
        }
    }
}

PatternMatcher::Match PatternMatcher::open_capture(std::size_t s, std::size_t p, Filling filling,
                                                   int depth) {
    if (n_captures_ >= kMaxPatternCaptures) {
        throw PatternError{"the pattern has too many captures"};
    }
    const auto k = static_cast<std::size_t>(n_captures_);
    captures_[k] = {s, 0, filling == Filling::position};
    filling_[k] = filling;
    ++n_captures_;
    const Match rest = match(s, p, depth + 1);
    if (!rest) {
        --n_captures_;
    }
    return rest;
}

PatternMatcher::Match PatternMatcher::close_capture(std::size_t s, std::size_t p, int depth) {
    int k = n_captures_ - 1;
    while (k >= 0 && filling_[static_cast<std::size_t>(k)] != Filling::open) {
        --k;
    }
    if (k < 0) {
        throw PatternError{"the pattern closes a capture that was not opened"};
    }
    const auto i = static_cast<std::size_t>(k);
    captures_[i].length = s - captures_[i].begin;
    filling_[i] = Filling::closed;
    const Match rest = match(s, p, depth + 1);
    if (!rest) {
        filling_[i] = Filling::open;
    }
    return rest;
}

PatternMatcher::Match PatternMatcher::match_balanced(std::size_t s, std::size_t p) {
    if (p + 1 >= pattern_.size()) {
        throw PatternError{"'%b' in the pattern needs two characters"};
    }
    if (s >= text_.size() || text_[s] != pattern_[p]) {
        return std::nullopt;
    }
    std::size_t open = 1;
    for (std::size_t i = s + 1; i < text_.size(); ++i) {
        count(1);
        if (text_[i] == pattern_[p + 1]) {
            if (--open == 0) {
                return i + 1;
            }
        } else if (text_[i] == pattern_[p]) {
            ++open;
        }
    }
    return std::nullopt;
}

bool PatternMatcher::at_frontier(std::size_t s, std::size_t set) {
    const std::size_t last = class_end(set) - 1;
    const auto before = static_cast<unsigned char>(s == 0 ? '\0' : text_[s - 1]);
    const auto here = static_cast<unsigned char>(s < text_.size() ? text_[s] : '\0');
    return !set_matches(before, set, last) && set_matches(here, set, last);
}

PatternMatcher::Match PatternMatcher::match_back_reference(std::size_t s, char digit) {
    const int k = digit - '1';
    if (k < 0 || k >= n_captures_ || filling_[static_cast<std::size_t>(k)] == Filling::open) {
        throw PatternError{std::string("the pattern has no capture %") + digit};
    }
    const PatternCapture& caught = captures_[static_cast<std::size_t>(k)];
    count(1 + caught.length / 16);
    if (caught.is_position || text_.size() - s < caught.length ||
        text_.compare(s, caught.length, text_.substr(caught.begin, caught.length)) != 0) {
        return std::nullopt;
    }
    return s + caught.length;
}

/// Where the single character, class or set that begins at `p` ends.
std::size_t PatternMatcher::class_end(std::size_t p) const {
    const char c = pattern_[p++];
    if (c == '%') {
        if (p >= pattern_.size()) {
            throw PatternError{"the pattern ends with '%'"};
        }
        return p + 1;
    }
    if (c != '[') {
        return p;
    }
    if (p < pattern_.size() && pattern_[p] == '^') {
        ++p;
    }
    do {  // a ']' right at the start is itself a member
        if (p >= pattern_.size()) {
            throw PatternError{"missing ']' in the pattern"};
        }
        if (pattern_[p++] == '%') {
            ++p;
        }
    } while (p >= pattern_.size() || pattern_[p] != ']');
    return p + 1;
}

bool PatternMatcher::single_matches(std::size_t s, std::size_t p, std::size_t after) {
    count(1);
    const auto c = static_cast<unsigned char>(text_[s]);
    switch (pattern_[p]) {
        case '.':
            return true;
        case '%':
            return class_matches(c, pattern_[p + 1]);
        case '[':
            return set_matches(c, p, after - 1);
        default:
            return static_cast<unsigned char>(pattern_[p]) == c;
    }
}

/// `p` is at '[', `last` at its ']'.
bool PatternMatcher::set_matches(unsigned char c, std::size_t p, std::size_t last) {
    bool wanted = true;
    ++p;
    if (p < last && pattern_[p] == '^') {
        wanted = false;
        ++p;
    }
    count(1 + (last - p) / 4);
    for (; p < last; ++p) {
        if (pattern_[p] == '%' && p + 1 < last) {
            ++p;
            if (class_matches(c, pattern_[p])) {
                return wanted;
            }
        } else if (p + 2 < last && pattern_[p + 1] == '-') {
            if (static_cast<unsigned char>(pattern_[p]) <= c &&
                c <= static_cast<unsigned char>(pattern_[p + 2])) {
                return wanted;
            }
            p += 2;
        } else if (static_cast<unsigned char>(pattern_[p]) == c) {
            return wanted;
        }
    }
    return !wanted;
}

}  // namespace fulcrum::runtime
// NOLINTEND(misc-no-recursion)
