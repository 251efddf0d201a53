/// \file
/// The chapters of the report.
#pragma once

#include <string>

#include "report/Document.hh"
#include "results/Figures.hh"
#include "results/Results.hh"

namespace whittle::bench {

Section verdict_section(const Results& results);
Section method_section(const Results& results);
Section paper1_section(const ExperimentResult& experiment);
Section paper2_section(const ExperimentResult& experiment);
Section fidelity_section(const Results& results);
Section tradeoff_section(const ExperimentResult& beyond);
Section peer_section(const ExperimentResult& beyond);
Section cache_section(const ExperimentResult& beyond);

/// "12.3 (11.8 to 12.9)", or a dash while the set has no times. A figure whose spread is larger than itself
/// is marked.
std::string improvement_text(const std::optional<Figures>& figures);

/// A sentence for each set that cannot be told from the original, or that has a note.
std::vector<Block> warnings(const ExperimentResult& experiment);

constexpr char kNone[] = "–";

}  // namespace whittle::bench
