// The tests of chapter 5, "Special Functions": evaluators, selection, feedback, and lists of them (5.1
// to 5.4).
#pragma once

#include "run/test.h"

namespace softgl::suite {

std::vector<Test> special_tests();

// A function for each file of tests; each returns its rows.
std::vector<Test> special_feedback_tests();
std::vector<Test> special_feedback_value_tests();
std::vector<Test> special_feedback_mode_tests();
std::vector<Test> special_selection_tests();
std::vector<Test> special_name_tests();
std::vector<Test> special_curve_tests();
std::vector<Test> special_surface_tests();
std::vector<Test> special_mesh_tests();
std::vector<Test> special_list_tests();
std::vector<Test> special_error_tests();

} // namespace softgl::suite
