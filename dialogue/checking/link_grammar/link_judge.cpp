#include "dialogue/checking/link_grammar/link_judge.h"

#include <clocale>
#include <cstdio>
#include <dlfcn.h>
#include <link-grammar/link-includes.h>
#include <string>
#include <utility>

namespace fulcrum::dialogue {
namespace {

constexpr const char* kLibrary = "liblink-grammar.so.5";
constexpr const char* kLanguage = "en";
constexpr const char* kDictionary = "en/4.0.dict";
constexpr const char* kNoDictionary =
    "the English grammar is missing; install the Debian package link-grammar-dictionaries-en";
constexpr int kMostNulls = 4;       // a sentence that fits worse is not judged
constexpr int kMostLinkages = 10;   // ways of one sentence that are counted
constexpr int kLongestParse_s = 1;  // the library's clock counts whole seconds

/// The functions of the library that are used, found when it is opened.
struct Functions {
    decltype(&::linkgrammar_open_data_file) open_file = nullptr;
    decltype(&::dictionary_create_lang) create_dictionary = nullptr;
    decltype(&::parse_options_create) create_options = nullptr;
    decltype(&::parse_options_delete) delete_options = nullptr;
    decltype(&::parse_options_set_verbosity) set_verbosity = nullptr;
    decltype(&::parse_options_set_spell_guess) set_spell_guess = nullptr;
    decltype(&::parse_options_set_linkage_limit) set_linkage_limit = nullptr;
    decltype(&::parse_options_set_max_parse_time) set_parse_time = nullptr;
    decltype(&::parse_options_set_min_null_count) set_least_nulls = nullptr;
    decltype(&::parse_options_set_max_null_count) set_most_nulls = nullptr;
    decltype(&::parse_options_reset_resources) reset_resources = nullptr;
    decltype(&::sentence_create) create_sentence = nullptr;
    decltype(&::sentence_delete) delete_sentence = nullptr;
    decltype(&::sentence_split) split = nullptr;
    decltype(&::sentence_length) length = nullptr;
    decltype(&::sentence_parse) parse = nullptr;
    decltype(&::sentence_null_count) null_count = nullptr;
    decltype(&::lg_error_set_handler) set_error_handler = nullptr;
};

template <class Function>
bool find_function(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(::dlsym(library, name));
    return function != nullptr;
}

bool find_all(void* library, Functions& use) {
    return find_function(library, "linkgrammar_open_data_file", use.open_file) &&
           find_function(library, "dictionary_create_lang", use.create_dictionary) &&
           find_function(library, "parse_options_create", use.create_options) &&
           find_function(library, "parse_options_delete", use.delete_options) &&
           find_function(library, "parse_options_set_verbosity", use.set_verbosity) &&
           find_function(library, "parse_options_set_spell_guess", use.set_spell_guess) &&
           find_function(library, "parse_options_set_linkage_limit", use.set_linkage_limit) &&
           find_function(library, "parse_options_set_max_parse_time", use.set_parse_time) &&
           find_function(library, "parse_options_set_min_null_count", use.set_least_nulls) &&
           find_function(library, "parse_options_set_max_null_count", use.set_most_nulls) &&
           find_function(library, "parse_options_reset_resources", use.reset_resources) &&
           find_function(library, "sentence_create", use.create_sentence) &&
           find_function(library, "sentence_delete", use.delete_sentence) &&
           find_function(library, "sentence_split", use.split) &&
           find_function(library, "sentence_length", use.length) &&
           find_function(library, "sentence_parse", use.parse) &&
           find_function(library, "sentence_null_count", use.null_count) &&
           find_function(library, "lg_error_set_handler", use.set_error_handler);
}

// What the library has to tell is for those who write grammars.
void ignore(lg_errinfo*, void*) {}

/// English letters and the commonest signs, in words and sentences that are not too long: of other texts the library may end the
/// program.
bool is_plain_text(std::string_view text) {
    constexpr std::string_view kSigns = " ',.?!;:-";
    constexpr int kLongestWord = 40;
    int n_words = 1;
    int n_letters = 0;
    bool any = false;
    for (const char sign : text) {
        const bool letter = (sign >= 'a' && sign <= 'z') || (sign >= 'A' && sign <= 'Z') ||
                            (sign >= '0' && sign <= '9');
        any = any || letter;
        n_words += sign == ' ' ? 1 : 0;
        n_letters = sign == ' ' ? 0 : n_letters + 1;
        if ((!letter && kSigns.find(sign) == std::string_view::npos) || n_letters > kLongestWord) {
            return false;
        }
    }
    return any && n_words <= kMostJudgedWords;
}

/// The library and its English dictionary, opened once: it takes a fifth of a second, and judges read it only. Neither is closed: what the
/// library opened itself could not be told to go.
struct Grammar {
    Functions use;
    Dictionary dictionary = nullptr;
};

class LinkJudge final : public SentenceJudge {
  public:
    explicit LinkJudge(const Grammar& grammar)
        : use_(grammar.use),
          dictionary_(grammar.dictionary),
          options_(grammar.use.create_options()) {
        use_.set_verbosity(options_, 0);
        use_.set_spell_guess(options_, 0);
        use_.set_linkage_limit(options_, kMostLinkages);
        use_.set_parse_time(options_, kLongestParse_s);
    }
    ~LinkJudge() override { use_.delete_options(options_); }
    LinkJudge(const LinkJudge&) = delete;
    LinkJudge& operator=(const LinkJudge&) = delete;

    std::optional<int> misfits(std::string_view sentence) override {
        if (!is_plain_text(sentence)) {
            return {};
        }
        const std::string text(sentence);
        const Sentence parsed = use_.create_sentence(text.c_str(), dictionary_);
        if (parsed == nullptr) {
            return {};
        }
        const std::optional<int> found = count_misfits(parsed);
        use_.delete_sentence(parsed);
        return found;
    }

  private:
    std::optional<int> count_misfits(Sentence parsed) {
        use_.reset_resources(options_);
        if (use_.split(parsed, options_) < 0 || use_.length(parsed) > kMostJudgedWords + 3) {
            return {};
        }
        // Without words that fit nowhere first: that is quick, and enough for a good sentence.
        for (const auto& [least, most] : {std::pair{0, 0}, std::pair{1, kMostNulls}}) {
            use_.set_least_nulls(options_, least);
            use_.set_most_nulls(options_, most);
            if (use_.parse(parsed, options_) > 0) {
                return use_.null_count(parsed);
            }
        }
        return {};
    }

    Functions use_;
    Dictionary dictionary_;
    Parse_Options options_;
};

// The library, with the dictionary lying there.
Expected<Functions> find_library() {
    void* library = ::dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
    Functions use;
    if (library == nullptr || !find_all(library, use)) {
        return fail(
            "the grammar's library is missing; install the Debian package liblink-grammar5");
    }
    use.set_error_handler(ignore, nullptr);
    std::FILE* dictionary = use.open_file(kDictionary);
    if (dictionary == nullptr) {
        return fail(kNoDictionary);
    }
    (void)std::fclose(dictionary);
    return use;
}

Expected<Grammar> open_dictionary(const Functions& use) {
    // It sets how characters are read for the whole program.
    const std::string locale = std::setlocale(LC_CTYPE, nullptr);
    const Dictionary dictionary = use.create_dictionary(kLanguage);
    std::setlocale(LC_CTYPE, locale.c_str());
    if (dictionary == nullptr) {
        return fail(kNoDictionary);
    }
    return Grammar{use, dictionary};
}

const Expected<Functions>& library() {
    static const Expected<Functions> found = find_library();
    return found;
}

const Expected<Grammar>& grammar() {
    static const Expected<Grammar> opened = library().and_then(open_dictionary);
    return opened;
}

// Opens the dictionary for its first sentence. What is there and cannot be opened judges nothing.
class LateJudge final : public SentenceJudge {
  public:
    std::optional<int> misfits(std::string_view sentence) override {
        if (!judge_ && grammar()) {
            judge_.emplace(*grammar());
        }
        return judge_ ? judge_->misfits(sentence) : std::nullopt;
    }

  private:
    std::optional<LinkJudge> judge_;
};

}  // namespace

Expected<std::unique_ptr<SentenceJudge>> make_link_judge(GrammarOpens when) {
    if (when == GrammarOpens::for_a_sentence) {
        const auto& found = library();
        if (!found) {
            return tl::unexpected(found.error());
        }
        return std::make_unique<LateJudge>();
    }
    const auto& opened = grammar();
    if (!opened) {
        return tl::unexpected(opened.error());
    }
    return std::make_unique<LinkJudge>(*opened);
}

}  // namespace fulcrum::dialogue
