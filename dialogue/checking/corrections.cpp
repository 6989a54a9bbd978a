#include "dialogue/checking/corrections.h"

#include <algorithm>
#include <utility>

namespace fulcrum::dialogue {
namespace {

void put_in_order(std::vector<Proposal>& proposals) {
    std::stable_sort(proposals.begin(), proposals.end(), [](const Proposal& a, const Proposal& b) {
        return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
    });
}

/// One that was carried out, with the bytes of the outcome that it wrote, [begin, end).
struct Written {
    Proposal proposal;
    std::size_t begin = 0, end = 0;
};

std::vector<Written> written_by(std::vector<Proposal> proposals) {
    put_in_order(proposals);
    std::vector<Written> written;
    std::size_t longer = 0;  // the outcome than the text so far; it may wrap, and comes back
    for (Proposal& proposal : proposals) {
        const std::size_t begin = proposal.begin + longer;
        const std::size_t end = begin + proposal.right.size();
        longer = end - proposal.end;
        written.push_back({std::move(proposal), begin, end});
    }
    return written;
}

/// `next` changes what `before` wrote, begins or ends where that took something away, or inserts where that did.
bool changes(const Written& before, const Proposal& next) {
    const bool taken_away = before.begin == before.end;
    const bool inserted = before.proposal.begin == before.proposal.end;
    return taken_away || (inserted && next.begin == next.end)
               ? next.begin <= before.end && before.begin <= next.end
               : next.begin < before.end && before.begin < next.end;
}

/// The place in the text of a place in the outcome that nothing wrote.
std::size_t place_in_text(const std::vector<Written>& written, std::size_t place) {
    std::size_t longer = 0;
    for (const Written& one : written) {
        if (one.end <= place) {
            longer = one.end - one.proposal.end;
        }
    }
    return place - longer;
}

/// Of `next` and those that it changes: one for the text. `outcome` is what they wrote.
Proposal one_of(const std::vector<Written>& written, const std::vector<Written>& changed,
                std::string_view outcome, Proposal next) {
    std::size_t begin = next.begin;
    std::size_t end = next.end;
    for (const Written& one : changed) {
        begin = std::min(begin, one.begin);
        end = std::max(end, one.end);
    }
    std::string right(outcome.substr(begin, next.begin - begin));
    right.append(next.right).append(outcome.substr(next.end, end - next.end));
    const bool first_begins = !changed.empty() && changed.front().begin == begin;
    const bool last_ends = !changed.empty() && changed.back().end == end;
    next.begin = first_begins ? changed.front().proposal.begin : place_in_text(written, begin);
    next.end = last_ends ? changed.back().proposal.end : place_in_text(written, end);
    // "A advice" needs no other article, but none.
    next.code = changed.empty() || right.empty() ? next.code : changed.front().proposal.code;
    next.right = std::move(right);
    return next;
}

}  // namespace

std::string carried_out(std::string_view text, std::size_t begin, std::size_t end,
                        std::vector<Proposal> proposals, std::string_view mark) {
    put_in_order(proposals);
    std::string result;
    std::size_t at = begin;
    for (const Proposal& proposal : proposals) {
        result.append(text.substr(at, proposal.begin - at));
        // Blanks stand outside the marks.
        std::string_view right = proposal.right;
        const bool apart = right.starts_with(' ');
        right.remove_prefix(apart ? 1 : 0);
        const bool spaced = right.ends_with(' ');
        right.remove_suffix(spaced ? 1 : 0);
        result.append(apart ? " " : "");
        if (!right.empty()) {
            result.append(mark).append(right).append(mark);
        }
        result.append(spaced ? " " : "");
        at = proposal.end;
    }
    return result.append(text.substr(at, end - at));
}

std::vector<Proposal> joined(std::string_view text, std::vector<Proposal> first,
                             std::vector<Proposal> then) {
    put_in_order(then);
    for (std::size_t i = then.size(); i-- > 0;) {  // from behind: places before it stay
        const std::string outcome = carried_out(text, 0, text.size(), first);
        const std::vector<Written> written = written_by(std::move(first));
        std::vector<Written> changed;
        first.clear();
        for (const Written& one : written) {
            if (changes(one, then[i])) {
                changed.push_back(one);
            } else {
                first.push_back(one.proposal);
            }
        }
        Proposal one = one_of(written, changed, outcome, std::move(then[i]));
        if (text.substr(one.begin, one.end - one.begin) != one.right) {
            first.push_back(std::move(one));
        }
    }
    put_in_order(first);
    return first;
}

}  // namespace fulcrum::dialogue
