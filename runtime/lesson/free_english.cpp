#include "runtime/lesson/free_english.h"

#include "dialogue/checking/link_grammar/link_judge.h"

#include <memory>
#include <string_view>
#include <utility>

namespace fulcrum::runtime {

Expected<dialogue::FormCheck> open_free_english() {
    auto lexicon = dialogue::Lexicon::open();
    if (!lexicon) {
        return fail(lexicon.error().message, {}, {});
    }
    auto judge = dialogue::make_link_judge();
    if (!judge) {
        return fail(judge.error().message, {}, {});
    }
    const auto checker =
        std::make_shared<dialogue::EnglishChecker>(std::move(*lexicon), std::move(*judge));
    return [checker](std::string_view text) { return checker->check(text); };
}

}  // namespace fulcrum::runtime
