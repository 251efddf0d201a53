#include "experiment/Environment.hh"

#include "experiment/Machine.hh"

namespace whittle::bench {

Environment environment(const egl::ContextFacts& gl) {
  const Machine m = machine();
  return {gl.renderer, gl.vendor,    gl.version, gl.device,      m.cpu_model, m.cpu_threads,
          m.compiler,  m.build_type, m.commit,   m.commit_dirty, m.date_utc};
}

}  // namespace whittle::bench
