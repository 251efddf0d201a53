/// \file
/// From results to reports. Nothing here draws or measures.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "report/Document.hh"
#include "results/Results.hh"

namespace whittle::bench {

/// The whole report of a run, finished or not.
Document make_document(const Results& results);

/// One file that needs no other and no network: pictures as data, charts as SVG, light or dark as the reader
/// likes. A picture that cannot be read leaves its caption and a word on it.
/// \param folder  of the results.
std::string html_text(const Document& document, const std::filesystem::path& folder);

/// Pictures and charts are links: to the pictures of the run and to charts/NAME.svg.
std::string markdown_text(const Document& document);

/// One line a set, with a header; units are in the names of the columns.
std::string csv_text(const Results& results);

/// One line for each raw time.
std::string times_csv_text(const Results& results);

/// Writes report.html, report.md, charts/, report.csv and times.csv.
/// \param pictures  the folder of the results, which pictures are relative to; without it, `folder`.
/// \throw files::FileError
void write_report(const Results& results, const std::filesystem::path& folder);
void write_report(const Results& results, const std::filesystem::path& folder,
                  const std::filesystem::path& pictures);

}  // namespace whittle::bench
