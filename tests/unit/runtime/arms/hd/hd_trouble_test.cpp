#include "runtime/arms/hd/hd_trouble.h"

#include "runtime/arms/hd/hd_library.h"

#include <catch2/catch.hpp>

#include <set>

namespace fulcrum::runtime {

TEST_CASE("hd trouble: each has a sentence of its own, and an error without one tells its number") {
    std::set<std::string> all;
    for (const std::uint32_t trouble :
         {std::uint32_t{hd_no_error}, kHdNoNumber, kHdStandsStill, std::uint32_t{hd_needs_update},
          std::uint32_t{hd_needs_person}, std::uint32_t{hd_warm_motors},
          std::uint32_t{hd_too_much_force}, std::uint32_t{hd_too_sudden_force},
          std::uint32_t{hd_too_fast}, std::uint32_t{hd_force_error}, std::uint32_t{hd_device_fault},
          std::uint32_t{hd_no_connection}, std::uint32_t{hd_bad_configuration},
          std::uint32_t{hd_timer}, std::uint32_t{hd_no_licence}}) {
        const std::string words = words_of_hd(trouble);
        INFO(words);
        CHECK(words.back() == '.');
        CHECK(words.find("0x") == std::string::npos);
        CHECK(all.insert(words).second);
    }
    CHECK(words_of_hd(0x0402).find("0x0402") != std::string::npos);
    CHECK(words_of_hd(hd_needs_person).find("inkwell") != std::string::npos);
}

TEST_CASE("hd trouble: warm motors rest longer") {
    CHECK(rest_after_s(hd_warm_motors) > rest_after_s(hd_too_fast));
    CHECK(rest_after_s(hd_too_fast) >= 0.5);
}

}  // namespace fulcrum::runtime
