#include "runtime/app/installation.h"

#include "runtime/app/home_words.h"
#include "runtime/app/interrupt.h"

#include <algorithm>
#include <cstdio>
#include <utility>

namespace fulcrum::runtime {

Expected<Installation> open_installation(double started_s) {
    auto places = find_places();
    if (!places) {
        return tl::unexpected(places.error());
    }
    auto catalogue = read_words(places->words, Language::english);
    if (!catalogue) {
        return tl::unexpected(catalogue.error());
    }
    return Installation{std::move(*places), std::move(*catalogue), started_s};
}

void say(const std::string& sentence) {
    if (!sentence.empty()) {
        std::fprintf(stderr, "%s\n", sentence.c_str());
    }
}

void say_all(const std::vector<std::string>& sentences) {
    std::ranges::for_each(sentences, say);
}

int complain(const Error& error, int exit_code) {
    say(to_sentence(error));
    return exit_code;
}

int complain_of_loading(const Error& error) {
    return interrupted() ? interrupt_exit_code() : complain(error, 1);
}

}  // namespace fulcrum::runtime
