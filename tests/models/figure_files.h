// The files of softgl figure, taken apart.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "models/program_runner.h"

namespace softgl::test {

// What keeps the text from being well-formed XML; "" for nothing.
std::string xml_fault(const std::string& text);
// Addresses of attributes that are neither part of the text (data:) nor a place in it (#).
std::vector<std::string> outside_references(const std::string& text);

using Curve = std::vector<std::pair<double, double>>; // x and y, in the units of its axes
// By the name of each curve; those of all figures of the text together.
std::map<std::string, Curve> curves_of(const std::string& svg);
// By the name of each picture.
std::map<std::string, TestPicture> pictures_of(const std::string& svg);

// Standard output of softgl figure with --format svg and pictures of 64x64 on black.
std::string figure_svg(const std::string& name, const std::vector<std::string>& options = {});

} // namespace softgl::test
