// haply_stand_in [version]: the stand-in for Haply's service as a program. It prints its port, and runs until its input ends.
#include "tests/support/haply_service.h"

#include <cstdio>

int main(int argc, char** argv) {
    fulcrum::test_support::HaplyOptions options;
    if (argc > 1) {
        options.version = argv[1];
        options.takes_values = options.version < "3.5";
        options.takes_vector = !options.takes_values;
    }
    fulcrum::test_support::HaplyService service(options);
    std::printf("%u\n", static_cast<unsigned>(service.port()));
    (void)std::fflush(stdout);
    while (std::getchar() != EOF) {
    }
    return 0;
}
