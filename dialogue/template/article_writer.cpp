#include "dialogue/template/article_writer.h"

#include <string>

namespace fulcrum::dialogue {

void ArticleWriter::write(Branch branch) {
    if (policy_ == ArticlePolicy::after_no) {
        return no_determiner();
    }
    switch (branch) {
        case Branch::with_a:
            return count_noun("a", "an");
        case Branch::with_an:
            return count_noun("an", "a");
        case Branch::with_both:
            return count_noun("a", "");
        case Branch::one_with_a:
            return one_of_several("a", "an");
        case Branch::one_with_an:
            return one_of_several("an", "a");
        case Branch::bare_or_the:
            return without({"some", "this", "that"}, {"these", "those"});
        case Branch::the_stuff:
            return the_one_around();
        case Branch::bare_plural:
            return without({"some", "these", "those"}, {"this", "that"});
        case Branch::made_plural:
            return plurals_in_general();
        case Branch::plural_of_one:
            return plurals_that_are_there();
        case Branch::name:
            return only_name();
        case Branch::the_name:
            return with_the(ErrorCode::missing_determiner);
        case Branch::name_or_the:
            return with_the(ErrorCode::none);
        case Branch::plural_after_a:
            return miscounted("a", "an");
        case Branch::plural_after_an:
            return miscounted("an", "a");
        case Branch::unit:
            return no_determiner();
    }
}

void ArticleWriter::right(std::string_view said, bool canonical) {
    writer_.add_arc(from_, to_, element_, {said, said, ErrorCode::none, 0, canonical});
}

void ArticleWriter::passes(std::string_view said, std::string_view belongs) {
    writer_.add_arc(from_, to_, element_, {said, belongs, ErrorCode::none, 0});
}

void ArticleWriter::wrong(std::string_view said, std::string_view belongs, ErrorCode code) {
    writer_.add_arc(from_, to_, element_, {said, belongs, code, kSlipCost});
}

void ArticleWriter::count_noun(std::string_view own, std::string_view other) {
    const bool definite = policy_ == ArticlePolicy::definite;
    const bool bare = policy_ == ArticlePolicy::bare;
    if (definite) {
        passes(own, "the");
    } else {
        right(own, !bare);
    }
    right("the", definite);
    for (const std::string_view said : {"this", "that", "my", "your", "our", "its"}) {
        right(said, false);
    }
    wrong("these", "this", ErrorCode::wrong_determiner);
    wrong("those", "that", ErrorCode::wrong_determiner);
    if (other.empty()) {
        passes("an", definite ? "the" : "an");
    } else {
        wrong(other, own, ErrorCode::wrong_determiner);
    }
    if (bare || policy_ == ArticlePolicy::short_answer) {
        right("", bare);
    } else {
        wrong("", definite ? "the" : own, ErrorCode::missing_determiner);
    }
    for (const std::string_view article : {"a", "an"}) {
        wrong("the " + std::string(article), "the", ErrorCode::extra_determiner);
    }
}

void ArticleWriter::one_of_several(std::string_view own, std::string_view other) {
    for (const std::string_view said : {own, std::string_view("the"), std::string_view("this"),
                                        std::string_view("that"), std::string_view("one")}) {
        right(said, false);
    }
    wrong(other, own, ErrorCode::wrong_determiner);
}

void ArticleWriter::without(const std::array<std::string_view, 3>& determiners,
                            const std::array<std::string_view, 2>& others) {
    const bool definite = policy_ == ArticlePolicy::definite;
    right("", !definite);
    right("the", definite);
    for (const std::string_view said : determiners) {
        right(said, false);
    }
    right("its", false);
    for (std::size_t i = 0; i < others.size(); ++i) {
        wrong(others[i], determiners[i + 1], ErrorCode::wrong_determiner);
    }
    wrong("a", "", ErrorCode::extra_determiner);
    wrong("an", "", ErrorCode::extra_determiner);
}

void ArticleWriter::plurals_in_general() {
    if (policy_ != ArticlePolicy::definite) {
        right("", false);
        right("some", false);
    }
    if (policy_ == ArticlePolicy::bare) {
        right("these", false);
        right("those", false);
    }
}

void ArticleWriter::plurals_that_are_there() {
    right("the", false);
    passes("these", "this");
    passes("those", "that");
    right("this", false);
    right("that", false);
    if (policy_ == ArticlePolicy::definite) {
        passes("some", "the");
        wrong("", "the", ErrorCode::missing_determiner);
    }
}

void ArticleWriter::only_name() {
    right("", true);
    for (const std::string_view said : {"a", "an", "the", "this", "that"}) {
        wrong(said, "", ErrorCode::extra_determiner);
    }
}

void ArticleWriter::no_determiner() {
    right("", true);
    for (const std::string_view said :
         {"a", "an", "the", "this", "that", "these", "those", "some", "its"}) {
        wrong(said, "", ErrorCode::extra_determiner);
    }
}

void ArticleWriter::with_the(ErrorCode without_it) {
    const bool free = without_it == ErrorCode::none || policy_ == ArticlePolicy::short_answer;
    right("the", true);
    if (free) {
        right("", false);
    } else {
        wrong("", "the", without_it);
    }
    wrong("a", "the", ErrorCode::wrong_determiner);
    wrong("an", "the", ErrorCode::wrong_determiner);
}

void ArticleWriter::the_one_around() {
    right("the", true);
    right("this", false);
    right("that", false);
    wrong("", "the", ErrorCode::missing_determiner);
    wrong("a", "the", ErrorCode::wrong_determiner);
    wrong("an", "the", ErrorCode::wrong_determiner);
}

void ArticleWriter::miscounted(std::string_view own, std::string_view other) {
    right(own, false);
    wrong(other, own, ErrorCode::wrong_determiner);
    if (predicate_) {
        passes("some", own);
        wrong("", own, ErrorCode::missing_determiner);
    }
}

}  // namespace fulcrum::dialogue
