#include "report/markup.h"

namespace softgl::suite {
namespace {

const char kStyle[] =
    "<style>body{font:16px/1.45 sans-serif;max-width:72em;margin:2em auto;padding:0 1em;color:#222}"
    "table{border-collapse:collapse}td,th{text-align:left;padding:.2em .9em .2em 0;border-bottom:1px solid "
    "#ddd}"
    "figure{display:inline-block;margin:.5em 1em .5em 0}img{image-rendering:pixelated;border:1px solid #999}"
    "pre{background:#f4f4f4;padding:1em;overflow:auto;max-height:30em;font-size:13px}"
    ".fail{color:#b00020}.pass{color:#1b7a2f}section{border-top:2px solid #ccc;margin-top:2em}</style>";

} // namespace

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
    case '&': out += "&amp;"; break;
    case '<': out += "&lt;"; break;
    case '>': out += "&gt;"; break;
    case '"': out += "&quot;"; break;
    default: out += static_cast<unsigned char>(c) < 32 && c != '\n' ? ' ' : c;
    }
  }
  return out;
}

std::string page_begin(const std::string& title) {
  return "<!doctype html><meta charset=utf-8><title>softgl-conformance</title>" + std::string(kStyle) +
         "<h1>" + escaped(title) + "</h1>";
}

std::string figure(const std::string& png, const std::string& caption) {
  if (png.empty()) return "";
  return "<figure><img width=192 height=192 src=\"data:image/png;base64," + escaped(png) + "\"><figcaption>" +
         escaped(caption) + "</figcaption></figure>";
}

} // namespace softgl::suite
