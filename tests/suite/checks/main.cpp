// The entry of softgl_suite_tests.
#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>
