/// \file
/// The commands of `whittle`. Each adds itself to the command line; main runs the one that was named.
#pragma once

#include <CLI/App.hpp>
#include <functional>

namespace whittle::cli {

/// What a command does once its options are parsed.
/// \return the exit code: 0 done; 1 could not reach what was asked, but wrote what there is. Bad usage and
/// bad input are thrown.
using Command = std::function<int()>;

Command add_simplify(CLI::App& app);
Command add_lods(CLI::App& app);
Command add_batch(CLI::App& app);
Command add_measure(CLI::App& app);
Command add_info(CLI::App& app);
/// `modules`: lists them with their keys.
Command add_modules(CLI::App& app);

/// `completion` and `manual`, which describe the others: shell completions and the man page.
Command add_completion(CLI::App& app);
Command add_manual(CLI::App& app);

}  // namespace whittle::cli
