// What composing costs beside validating the same programs: no cache of verdicts, glslang warm. Both are measured within
// each compilation, so that noise meets both alike.

#include "tests/bench/bench_scenes.h"

namespace plugc {
namespace {

void compose_and_validate(benchmark::State& state, const SceneSet& set) {
  Validator validator({});
  compile_each(set, validator);  // warm
  CompileStatistics sum;
  for (auto _ : state) {
    const CompileStatistics one = compile_each(set, validator);
    sum.compose += one.compose;
    sum.validate += one.validate;
    sum.compositions += one.compositions;
  }
  const auto programs = static_cast<double>(sum.compositions);
  state.counters["compose_us_a_program"] = sum.compose * 1e3 / programs;
  state.counters["validate_us_a_program"] = sum.validate * 1e3 / programs;
  state.counters["programs"] = benchmark::Counter(programs, benchmark::Counter::kAvgIterations);
}

const bool registered = (register_for_sets("compose_and_validate", compose_and_validate), true);

}  // namespace
}  // namespace plugc
