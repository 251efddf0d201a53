/// \file
/// Work in parts on several threads.
#pragma once

#include <cstddef>
#include <exception>
#include <system_error>
#include <thread>
#include <vector>

namespace whittle {

/// Calls `work(begin, end)` for parts that together are 0 .. n, each on a thread of its own. What a part does
/// must not depend on where it begins and ends, so that the result is the same for any number of threads.
template <typename Work>
void for_each_part(std::size_t n, std::size_t n_threads, Work work) {
  constexpr std::size_t kLeast = 4096;  // below this a thread costs more than it saves
  const std::size_t parts = n / kLeast < n_threads ? n / kLeast : n_threads;
  if (parts < 2) {
    if (n > 0) work(std::size_t{0}, n);
    return;
  }
  std::vector<std::exception_ptr> errors(parts);
  const auto run = [&](std::size_t part) {
    try {
      work(n * part / parts, n * (part + 1) / parts);
    } catch (...) {
      errors[part] = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t part = 1; part < parts; ++part) try {
      threads.emplace_back(run, part);
    } catch (const std::system_error&) {  // no thread to be had
      run(part);
    }
  run(0);
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace whittle
