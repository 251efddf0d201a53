/// \file
/// whittle-bench: how much faster is a decimated mesh drawn?
#include <iostream>
#include <string>

#include "experiment/Experiment.hh"
#include "experiment/Store.hh"
#include "program/Interrupt.hh"
#include "program/commands.hh"

namespace {

namespace bench = whittle::bench;

constexpr int kIncomplete = 1;
constexpr int kBadUsageOrInput = 2;
constexpr int kSignalBase = 128;  // what shells add to the number of a signal

/// One line, whatever the message holds.
void complain(std::string message) {
  for (char& c : message)
    if (c == '\n') c = ' ';
  std::cerr << "whittle-bench: " << message << std::endl;
}

int dispatch(const bench::CommandLine& line) {
  if (!line.answer.empty()) {
    std::cout << line.answer;
    return 0;
  }
  if (line.list_devices) return bench::print_devices();
  if (line.report) return bench::remake_report(line);
  bench::catch_interrupts();
  return bench::run(line);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return dispatch(bench::parse_command_line(argc, argv));
  } catch (const bench::Stopped&) {
    complain("interrupted; what was timed so far is kept, and --resume goes on with it");
    return kSignalBase + bench::interrupt_signal();
  } catch (const bench::SaveError& error) {
    complain(error.what());
    return kIncomplete;
  } catch (const std::exception& error) {
    complain(error.what());
    return kBadUsageOrInput;
  }
}
