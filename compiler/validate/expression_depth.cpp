// glslang's own traverser counts the depth as it goes. It is compiled without type information, so this file is too.

#include "validate/expression_depth.h"

#include <glslang/MachineIndependent/localintermediate.h>

namespace plugc {
namespace {

class DepthMeter : public glslang::TIntermTraverser {};

}  // namespace

int tree_depth(const glslang::TIntermediate& stage) {
  DepthMeter meter;
  if (TIntermNode* root = const_cast<glslang::TIntermediate&>(stage).getTreeRoot()) root->traverse(&meter);
  return meter.getMaxDepth();
}

}  // namespace plugc
