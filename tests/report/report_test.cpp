// The conformance report: what the page says, and that a real browser shows it.
#include <catch2/catch.hpp>

#include "models/program_runner.h"
#include "report/report.h"
#include "test_paths.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>

namespace softgl::test {
namespace {

std::string template_page() { return read_bytes(SOFTGL_TEST_SOURCE_DIR "/tests/report/page.html"); }

Picture plain(uint8_t value) {
  Picture picture;
  picture.width = 3, picture.height = 2;
  picture.color.assign(24, value);
  picture.depth.assign(6, 0);
  return picture;
}

size_t count(const std::string& text, const std::string& part) {
  size_t n = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

// Loads the report in a frame, uses its filter and its zoom as a reader would, and leaves what it saw in the
// page.
constexpr const char* kVisitor =
    R"(<!DOCTYPE html><title>visitor</title><iframe id="frame" src="report.html" width="1200" height="900"></iframe>
<pre id="seen">nothing</pre><script>
const frame = document.getElementById('frame');
frame.addEventListener('load', () => {
  const page = frame.contentDocument, view = frame.contentWindow, seen = [];
  const images = [...page.querySelectorAll('#pictures img')];
  seen.push('images ' + images.length, 'broken ' + images.filter(image => !image.complete || !image.naturalWidth).length);
  const visible = () => [...page.querySelectorAll('tr.scene')].filter(row => row.offsetHeight > 0);
  seen.push('rows ' + visible().length);
  const filter = page.getElementById('filter');
  filter.value = 'phong_twin 11'; filter.dispatchEvent(new view.Event('input'));
  seen.push('filtered ' + visible().map(row => row.dataset.name).join('|'));
  filter.value = ''; filter.dispatchEvent(new view.Event('input'));
  const state = page.getElementById('state');
  state.value = 'failed'; state.dispatchEvent(new view.Event('change'));
  seen.push('failed ' + visible().length);
  state.value = ''; state.dispatchEvent(new view.Event('change'));
  const zoom = page.getElementById('zoom'), large = zoom.querySelector('img');
  seen.push('closed ' + (zoom.offsetHeight === 0));
  images[0].click();
  seen.push('zoomed ' + (zoom.offsetHeight > 0 && large.src === images[0].src && large.width === 4 * images[0].naturalWidth));
  page.dispatchEvent(new view.KeyboardEvent('keydown', {key: '+'}));
  seen.push('larger ' + (large.width === 8 * images[0].naturalWidth));
  page.dispatchEvent(new view.KeyboardEvent('keydown', {key: 'Escape'}));
  seen.push('closed again ' + (zoom.offsetHeight === 0));
  seen.push('plots ' + page.querySelectorAll('#plots svg').length, 'elsewhere ' + page.querySelectorAll('[src^="http"],link').length);
  document.getElementById('seen').textContent = seen.join('; ') + ';';
});
</script>)";

} // namespace

TEST_CASE("report: rows, states and sums", "[report]") {
  Report report;
  report.versions = {"one <1>"};
  report.rows.push_back({"a & b", "same", "", plain(7), plain(7), true, 0});
  report.rows.push_back({"a & b", "near", "", plain(7), plain(8), true, 1});
  report.rows.push_back({"c", "far", "", plain(7), plain(9), true, 1});
  report.curves.push_back({"errors", "sphere", {{8, 0.5}, {16, 0.1}}});
  CHECK(passes(report.rows[1]));
  CHECK_FALSE(passes(report.rows[2]));
  ReportRow deeper = report.rows[0];
  deeper.ours.depth[3] = 1;
  CHECK_FALSE(passes(deeper)); // colors are not all that counts
  deeper.same_depths = false;
  CHECK(passes(deeper));
  const std::string page = report_page(template_page(), report);
  CHECK(count(page, "data-state=\"equal\"") == 1);
  CHECK(count(page, "data-state=\"within\"") == 1);
  CHECK(count(page, "data-state=\"failed\"") == 1);
  CHECK(count(page, "src=\"data:image/png;base64,iVBORw0KGgo") == 9);
  CHECK(page.find("one &lt;1&gt;") != std::string::npos);
  CHECK(page.find("24 of 24 color bytes differ, by at most 2") != std::string::npos);
  CHECK(
      page.find("<td>a &amp; b</td><td>2</td><td>1</td><td>2</td><td>24</td><td>50&nbsp;%</td><td>1</td>") !=
      std::string::npos);
  CHECK(count(page, "<polyline") == 1);
  CHECK_THROWS(report_page("<html></html>", report));
}

TEST_CASE("report: Chromium shows all of it", "[report][slow]") {
  // The page stays: people read it after a run.
  const std::string folder = SOFTGL_TEST_OUTPUT "/report/", path = folder + "report.html";
  std::filesystem::create_directories(folder);
  const std::string make = SOFTGL_TEST_BINARY_DIR "/softgl_report -o " + path + " > /dev/null";
  REQUIRE(std::system(make.c_str()) == 0);
  if (std::system("command -v chromium > /dev/null") != 0) {
    std::cout << "SKIPPED: there is no chromium on this machine\n";
    return;
  }
  std::ofstream(folder + "visitor.html") << kVisitor;
  const std::string visit = "timeout 120 chromium --headless --no-sandbox --disable-gpu "
                            "--disable-dev-shm-usage --allow-file-access-from-files "
                            "--user-data-dir=" +
                            output_folder("chromium") +
                            "profile --virtual-time-budget=30000 --dump-dom file://" + folder +
                            "visitor.html > " + folder + "seen.html 2> " + folder + "chromium.txt";
  const int status = std::system(visit.c_str());
  const std::string page = read_bytes(folder + "seen.html");
  const size_t at = page.find("<pre id=\"seen\">");
  INFO("chromium ended with " << status);
  REQUIRE(at != std::string::npos);
  const std::string seen = page.substr(at + 15, page.find("</pre>", at) - at - 15);
  INFO(seen);
  const size_t rows = count(read_bytes(path), "<tr class=\"scene");
  CHECK(rows >= 12);
  for (const std::string& said :
       {"images " + std::to_string(3 * rows), std::string("broken 0"), "rows " + std::to_string(rows),
        std::string("filtered phong_twin 11;"), std::string("failed 0"), std::string("closed true"),
        std::string("zoomed true"), std::string("larger true"), std::string("closed again true"),
        std::string("plots 2"), std::string("elsewhere 0")}) {
    INFO(said);
    CHECK(seen.find(said) != std::string::npos);
  }
}

} // namespace softgl::test
