#include "runtime/app/installation.h"

#include "runtime/app/interrupt.h"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

namespace fulcrum::runtime {

Expected<Installation> open_installation(double started_s) {
    auto places = find_places();
    if (!places) {
        return tl::unexpected(places.error());
    }
    const std::filesystem::path words = places->words / "en.txt";
    std::ifstream file(words);
    std::ostringstream text;
    text << file.rdbuf();
    if (!file) {
        return fail("the program's words cannot be read", words.string(), "restore the file");
    }
    auto catalogue = dialogue::Catalogue::parse(text.str());
    if (!catalogue) {
        return fail(catalogue.error().message,
                    words.string() + ":" + std::to_string(catalogue.error().line),
                    "mend that line");
    }
    return Installation{std::move(*places), std::move(*catalogue), started_s};
}

int complain(const Error& error, int exit_code) {
    std::fprintf(stderr, "%s\n", to_sentence(error).c_str());
    return exit_code;
}

int complain_of_loading(const Error& error) {
    return interrupted() ? interrupt_exit_code() : complain(error, 1);
}

}  // namespace fulcrum::runtime
