/// \file
/// Standard output that cannot take what is printed.
#include <fcntl.h>
#include <unistd.h>

#include "TorusFile.hh"

using namespace whittle;
using Catch::Matchers::Contains;
using programs::Folder;
namespace fs = std::filesystem;

namespace {

/// Runs a line of bash in a folder; $W is the program.
programs::Outcome shell(const Folder& folder, const std::string& line) {
  std::ofstream(folder / "run.sh") << "cd '" << folder.path().string() << "'\nW='" WHITTLE_PROGRAM "'\n"
                                   << line << "\n";
  return programs::run("/bin/bash", {folder / "run.sh"});
}

void write_meshes(const Folder& folder) {
  files::write_mesh(folder / "a.ply", meshes::torus(8, 5));
  files::write_mesh(folder / "b.ply", meshes::torus(6, 4));
}

}  // namespace

TEST_CASE("standard output that is full, closed or a pipe without a reader is an error of every command") {
  const Folder folder;
  write_meshes(folder);
  // A reader that has ended leaves its pipe closed.
  const std::string closed_pipe = "exec 3> >(true); wait $!; $W ";
  for (const std::string command : {"info a.ply", "measure a.ply b.ply --samples 10", "completion bash",
                                    "manual", "--version", "simplify --help", "info a.ply --json -"})
    for (const auto& [line, why] :
         {std::pair<std::string, std::string>{"$W " + command + " >/dev/full", "No space left"},
          {"$W " + command + " >&-", "Bad file descriptor"},
          {closed_pipe + command + " >&3", "Broken pipe"}}) {
      const auto done = shell(folder, line);
      INFO(line << ": " << done.err);
      CHECK(done.code == 2);
      CHECK(done.error_lines() == 1);
      CHECK_THAT(done.err, Contains("standard output: " + why));
    }
}

TEST_CASE("JSON that standard output does not take keeps the mesh away; a summary comes after it") {
  const Folder folder;
  write_meshes(folder);
  const std::string old = programs::contents(folder / "b.ply");
  const auto json = shell(folder, "$W simplify a.ply b.ply --ratio 0.5 --json - >/dev/full");
  CHECK(json.code == 2);
  CHECK(programs::contents(folder / "b.ply") == old);
  for (const std::string command : {"simplify a.ply b.ply --ratio 0.5", "lods a.ply --levels 2 --out b.ply",
                                    "batch b.ply.txt --out . --ratio 0.5"}) {
    std::ofstream(folder / "b.ply.txt") << "a.ply\n";
    const auto summary = shell(folder, "$W " + command + " >/dev/full");
    INFO(command << ": " << summary.err);
    CHECK(summary.code == 1);
    CHECK_THAT(summary.err, Contains("all is written, but not the summary: standard output: No space left"));
  }
  CHECK(programs::contents(folder / "b.ply") != old);
  CHECK(fs::exists(folder / "b-lod1.ply"));
}

TEST_CASE("with standard streams closed no output lands in another, and errors are told") {
  const Folder folder;
  write_meshes(folder);
  CHECK(shell(folder, "$W simplify a.ply c.ply --ratio 0.5 --quiet <&- >&- 2>&-").code == 0);
  CHECK(files::read_mesh(folder / "c.ply").mesh.triangles.size() == 40);
  std::ofstream(folder / "bad.obj") << "f 1 2 3\n";
  std::ofstream(folder / "list.txt") << "bad.obj\n";
  const auto batch = shell(folder, "$W batch list.txt --out out --ratio 0.5 --quiet <&- >&-");
  CHECK(batch.code == 1);
  CHECK_THAT(batch.err, Contains("bad.obj: failed: line 1: "));
}

TEST_CASE("bash completes names with blanks and stars as they are") {
  const Folder folder;
  for (const char* name : {"my scan.ply", "my *.ply", "my other.ply"}) std::ofstream(folder / name) << "";
  const auto done =
      shell(folder,
            "source <($W completion bash)\n"
            "COMP_WORDS=(whittle info 'my '); COMP_CWORD=2; _whittle; printf '[%s]\\n' \"${COMPREPLY[@]}\"");
  CHECK_THAT(done.out, Contains("[my scan.ply]") && Contains("[my *.ply]") && Contains("[my other.ply]"));
  CHECK(std::count(done.out.begin(), done.out.end(), '\n') == 3);
}

TEST_CASE("fish completes commands, options, their values, and names with blanks") {
  const Folder folder;
  if (shell(folder, "command -v fish >/dev/null").code != 0) return tests::skip("fish");
  std::ofstream(folder / "my scan.ply") << "";
  const auto done =
      shell(folder,
            "$W completion fish >whittle.fish\n"
            "HOME=$PWD fish --no-config -c 'source whittle.fish; complete -C \"whittle simp\";"
            " complete -C \"whittle simplify --rat\"; complete -C \"whittle simplify --driver s\";"
            " complete -C \"whittle info my\"'");
  CHECK(done.out == "simplify\n--ratio\nsweep\nmy scan.ply\n");
}

TEST_CASE("zsh completes from the first time on, names with blanks too") {
  const Folder folder;
  if (shell(folder, "command -v zsh >/dev/null").code != 0) return tests::skip("zsh");
  std::ofstream(folder / "my scan.ply") << "";
  fs::create_directory(folder / "functions");
  // A line editor needs a terminal. What each key press leaves on the line is printed by a widget.
  std::ofstream(folder / "try.zsh") << R"zsh(
zmodload zsh/zpty
zpty shell zsh -f -i
out=
await() {
  local i line
  for i in {1..200}; do
    zpty -r -t shell line && out+=$line
    [[ $out == *"$1"* ]] && return
    sleep 0.05
  done
  print -r -- "no $1 in $out"
}
zpty -w shell "fpath=($PWD/functions \$fpath); autoload -Uz compinit; compinit -u -D; show() { print -r -- \"<\$BUFFER>\"; BUFFER=; }; zle -N show; bindkey '^G' show; print rea''dy"
await ready
try() { zpty -w -n shell "$1"$'\t\C-g'; await "$2" }
try 'whittle simp' '<whittle simplify'
try 'whittle simplify --rat' '<whittle simplify --ratio'
try 'whittle info my' '<whittle info my\ scan.ply'
print done
)zsh";
  const auto done =
      shell(folder, "$W completion zsh >functions/_whittle\nHOME=$PWD TERM=dumb timeout 60 zsh -f try.zsh");
  CHECK(done.out == "done\n");
}
