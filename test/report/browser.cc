/// \file
/// The report in a real browser: headless Chromium.
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "Folder.hh"
#include "example.hh"
#include "render/Image.hh"
#include "report/Report.hh"

using namespace whittle;
namespace fs = std::filesystem;

namespace {

/// Once all is loaded, counts what the reader sees and leaves the counts in the page.
constexpr char kProbe[] = R"(<script>
addEventListener("load", () => {
  const all = selector => [...document.querySelectorAll(selector)];
  document.body.dataset.seen = [
    all("img").filter(i => i.complete && i.naturalWidth > 0).length + "/" + all("img").length + " pictures",
    all("svg").filter(s => s.getBBox().width > 100 && s.getBoundingClientRect().height > 100).length + "/" +
        all("svg").length + " charts",
    all("table").length + " tables", all("nav a").filter(a => document.querySelector(a.hash)).length + "/" +
        all("nav a").length + " links",
    performance.getEntriesByType("resource").filter(r => !r.name.startsWith("data:")).length + " fetched",
    document.documentElement.scrollWidth <= innerWidth ? "fits" : "too wide"].join(", ");
});
</script></body>)";

}  // namespace

TEST_CASE("the HTML report shows all charts and pictures in a browser, without a console error") {
  const std::string chromium = WHITTLE_CHROMIUM;
  if (chromium.empty() || !fs::exists(chromium)) {
    tests::skip("chromium is not installed; bootstrap.sh installs it");
    return;
  }
  const scratch::Folder folder;
  fs::create_directories(folder / "pictures");
  const render::Image image{2, 1, {255, 0, 0, 255, 0, 0, 255, 255}};
  for (const char* name : {"whole", "detail", "heat"})
    std::ofstream(folder / ("pictures/" + std::string(name) + ".png"), std::ios::binary)
        << render::encode_png(image);
  auto results = example::results();
  results.experiments[0].sets[0].pictures = results.experiments[0].sets[1].pictures;
  bench::write_report(results, folder / "");

  std::string html = scratch::contents(folder / "report.html");
  html.replace(html.rfind("</body>"), 7, kProbe);
  std::ofstream(folder / "probed.html") << html;
  for (const char* size : {"1280,900", "390,844"}) {
    const std::string command =
        "timeout 120 '" + chromium +
        "' --headless --no-sandbox --disable-gpu --enable-logging=stderr --user-data-dir='" +
        (folder / "profile").string() + "' --window-size=" + size + " --dump-dom 'file://" +
        (folder / "probed.html").string() + "' >'" + (folder / "dom").string() + "' 2>'" +
        (folder / "log").string() + "' </dev/null";
    const int status = std::system(command.c_str());
    const std::string log = scratch::contents(folder / "log");
    INFO(size << "\n" << log);
    REQUIRE((WIFEXITED(status) && WEXITSTATUS(status) == 0));
    CHECK_THAT(log, !Catch::Contains("CONSOLE"));
    const std::string dom = scratch::contents(folder / "dom");
    const auto begin = dom.find("data-seen=\"");
    REQUIRE(begin != std::string::npos);
    // Pictures: panorama and detail of the original, two details, two heat maps. Charts: two of Paper 1, two
    // of errors.
    CHECK_THAT(dom.substr(begin, 200), Catch::Contains("\"6/6 pictures, 5/5 charts, ") &&
                                           Catch::Contains(" tables, 7/7 links, 0 fetched, fits\""));
  }
}
