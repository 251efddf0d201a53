#include "report/Document.hh"

#include "files/MeshFile.hh"
#include "report/Report.hh"
#include "report/sections.hh"

namespace whittle::bench {

Document make_document(const Results& results) {
  Document document;
  document.title = "Whittle render benchmark";
  document.summary = results.experiments.empty() ? "" : results.experiments.front().model.label + " on ";
  document.summary += results.environment.gl_renderer + ", " + results.environment.date_utc + ", " +
                      results.protocol + " protocol" + (results.complete ? "" : ", not finished");
  document.sections.push_back(verdict_section(results));
  if (!results.complete)
    document.sections.front().blocks.insert(
        document.sections.front().blocks.begin(),
        Callout{"This run is not finished; what follows is what it has. `--resume` goes on with it."});
  document.sections.push_back(method_section(results));
  if (const auto* const e = find(results, "paper1")) document.sections.push_back(paper1_section(*e));
  if (const auto* const e = find(results, "paper2")) document.sections.push_back(paper2_section(*e));
  document.sections.push_back(fidelity_section(results));
  if (const auto* const e = find(results, "beyond")) {
    document.sections.push_back(tradeoff_section(*e));
    document.sections.push_back(peer_section(*e));
    document.sections.push_back(cache_section(*e));
  }
  return document;
}

void write_report(const Results& results, const std::filesystem::path& folder) {
  write_report(results, folder, folder);
}

void write_report(const Results& results, const std::filesystem::path& folder,
                  const std::filesystem::path& pictures) {
  const Document document = make_document(results);
  std::filesystem::create_directories(folder / "charts");
  for (const Section& section : document.sections)
    for (const Block& block : section.blocks)
      if (const Chart* const chart = std::get_if<Chart>(&block))
        files::write_file(folder / "charts" / (chart->name + ".svg"), chart->svg);
  files::write_file(folder / "report.csv", csv_text(results));
  files::write_file(folder / "times.csv", times_csv_text(results));
  files::write_file(folder / "report.md", markdown_text(document));
  files::write_file(folder / "report.html", html_text(document, pictures));
}

}  // namespace whittle::bench
