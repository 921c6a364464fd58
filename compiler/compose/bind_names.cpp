// What an owner only declares is sought elsewhere: a function, an input, a uniform's field. What is found gets the name that it
// has there. The renderer's own code declares nothing that it lacks.

#include "compose/bind_names.h"

#include "compose/bind_functions.h"
#include "compose/bind_inputs.h"

namespace plugc {

void bind_names(Composition& composition) {
  if (composition.owners.size() == 1) return;
  compare_stages(composition);
  FunctionBinder functions(composition);
  InputBinder inputs(composition);
  for (const PlacedUnit& unit : composition.units) {
    if (unit.dropped || !composition.by_author(unit)) continue;
    functions.bind(unit);
    inputs.bind(unit);
  }
  functions.finish();
  list_fields(composition);
}

}  // namespace plugc
