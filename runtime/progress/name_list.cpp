#include "runtime/progress/name_list.h"

#include "dialogue/unicode.h"
#include "runtime/progress/class_list.h"
#include "runtime/progress/guest_name.h"
#include "runtime/progress/text_rules.h"

#include <map>

namespace fulcrum::runtime {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

// Takes one name after the other; `place` is where it stands.
class NameList {
  public:
    Expected<void> add(std::string_view word, const std::string& place) {
        auto name = checked_nickname(word).and_then([](const std::string& checked) {
            return checked_nickname(dialogue::composed(checked));
        });
        if (!name) {
            return fail(name.error().message, place, name.error().what_to_do);
        }
        const std::string folded = folded_nickname(*name);
        if (folded == kSimulatedPupil || folded == "guest" || is_guest_name(*name)) {
            return fail("\"" + *name + "\" is what the program calls somebody of its own", place,
                        "give another name");
        }
        const auto [before, is_new] = seen_.try_emplace(folded, place);
        if (!is_new) {
            const std::string also =
                before->second.empty() ? "" : " (first in " + before->second + ")";
            return fail("\"" + *name + "\" stands there twice" + also, place,
                        "write one of them another way, for instance \"" + *name + " B\"");
        }
        names_.push_back(*std::move(name));
        return {};
    }
    Expected<std::vector<std::string>> finish(const std::string& where) && {
        if (names_.empty()) {
            return fail("there are no names", where,
                        where.empty() ? "write them behind the command, or --names FILE"
                                      : "write one a line");
        }
        if (names_.size() > kMostPupils) {
            return fail("there are " + std::to_string(names_.size()) + " names, and a class has " +
                            std::to_string(kMostPupils) + " pupils at most",
                        where, "make two classes of them");
        }
        return std::move(names_);
    }

  private:
    std::vector<std::string> names_;
    std::map<std::string, std::string> seen_;  // by its folded name: where it stands
};

}  // namespace

Expected<std::vector<std::string>> read_name_list(std::string_view text, const std::string& where) {
    if (text.starts_with(kByteOrderMark)) {
        text.remove_prefix(kByteOrderMark.size());
    }
    NameList list;
    for (std::size_t line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        std::string_view name = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (name.ends_with('\r')) {
            name.remove_suffix(1);
        }
        const bool is_empty = name.find_first_not_of(" \t") == std::string_view::npos;
        auto added =
            is_empty ? Expected<void>{} : list.add(name, where + ':' + std::to_string(line));
        if (!added) {
            return tl::unexpected(added.error());
        }
    }
    return std::move(list).finish(where);
}

Expected<std::vector<std::string>> check_names(const std::vector<std::string>& names) {
    NameList list;
    for (const std::string& name : names) {
        if (auto added = list.add(name, {}); !added) {
            return tl::unexpected(added.error());
        }
    }
    return std::move(list).finish({});
}

}  // namespace fulcrum::runtime
