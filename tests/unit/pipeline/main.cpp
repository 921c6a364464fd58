// The validator forks, so it is made before any test draws (which starts threads).

#include <gtest/gtest.h>

#include "support/compile_text.h"

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  plugc::process_validator();
  return RUN_ALL_TESTS();
}
