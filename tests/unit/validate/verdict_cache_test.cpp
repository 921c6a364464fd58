#include "validate/verdict_cache.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>

#include "tests/unit/validate/programs.h"

namespace plugc {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
 protected:
  Cache() {
    std::string name = fs::temp_directory_path() / "plugc-verdicts-XXXXXX";
    folder_ = mkdtemp(name.data());
  }
  ~Cache() override {
    chmod(folder_.c_str(), 0700);
    fs::remove_all(folder_);
  }

  ValidatorOptions options() const {
    ValidatorOptions options;
    options.cache_folder = folder_;
    return options;
  }
  std::vector<fs::path> entries() const { return {fs::directory_iterator(folder_), {}}; }

  /// Stores an odd verdict for the program, so that who gives it is known.
  void store_odd_verdict(const ProgramText& program) const {
    Verdict verdict;
    verdict.uniforms = {{"from_the_cache", "float", 1}};
    VerdictCache(folder_).store(encode(program), verdict);
  }

  /// Who judged the program: the cache or the worker?
  bool comes_from_cache(const ProgramText& program) const {
    Validator validator(options());
    const ValidationResult result = validate_one(validator, program);
    return result.program.has_value() && shown(result.program->uniforms()) == std::vector<std::string>{"float from_the_cache"};
  }

  fs::path folder_;
};

TEST_F(Cache, AHitEqualsAMiss) {
  for (const Target target : {Target::glsl330, Target::spirv}) {
    const ProgramText program = program_of(kVertex, kFragment, target);
    Validator validator(options());
    const ValidationResult miss = validate_one(validator, program);
    const ValidationResult hit = validate_one(validator, program);
    ASSERT_TRUE(miss.program && hit.program);
    EXPECT_EQ(hit.program->target(), miss.program->target());
    EXPECT_EQ(hit.program->stages()[1].text.text(), miss.program->stages()[1].text.text());
    EXPECT_EQ(shown(hit.program->uniforms()), shown(miss.program->uniforms()));
    EXPECT_EQ(shown(hit.program->attributes()), shown(miss.program->attributes()));
    EXPECT_EQ(hit.program->spirv(), miss.program->spirv());
  }
  EXPECT_EQ(entries().size(), 2u);
}

TEST_F(Cache, IsAskedBeforeTheWorker) {
  EXPECT_FALSE(comes_from_cache(plain_program()));
  store_odd_verdict(plain_program());
  EXPECT_TRUE(comes_from_cache(plain_program()));
}

TEST_F(Cache, KeepsOnlyValidVerdicts) {
  Validator validator(options());
  EXPECT_FALSE(validate_one(validator, plain_program("a;")).program.has_value());
  EXPECT_THAT(entries(), testing::IsEmpty());
}

TEST_F(Cache, ComparesContentAndNotOnlyTheName) {
  store_odd_verdict(plain_program());
  const fs::path stored = entries().front();
  store_odd_verdict(plain_program("color = vec4(0.5);"));
  fs::path other = entries()[0] == stored ? entries()[1] : entries()[0];
  fs::rename(stored, other);  // as if two programs had the same hash
  EXPECT_FALSE(comes_from_cache(plain_program("color = vec4(0.5);")));
}

TEST_F(Cache, PassesOverDamagedEntries) {
  store_odd_verdict(plain_program());
  const fs::path entry = entries().front();
  std::ifstream stream(entry, std::ios::binary);
  const std::string good((std::istreambuf_iterator<char>(stream)), {});
  const VerdictCache cache(folder_);
  const std::string candidate = encode(plain_program());
  ASSERT_TRUE(cache.find(candidate).has_value());
  for (std::size_t i = 0; i < good.size(); ++i) {
    std::string damaged = good;
    damaged[i] ^= 0x20;
    std::ofstream(entry, std::ios::binary) << damaged;
    ASSERT_FALSE(cache.find(candidate).has_value()) << "byte " << i;
    std::ofstream(entry, std::ios::binary) << good.substr(0, i);
    ASSERT_FALSE(cache.find(candidate).has_value()) << i << " bytes";
  }
}

TEST_F(Cache, PassesOverWhatOthersMayHaveWritten) {
  store_odd_verdict(plain_program());
  const fs::path entry = entries().front();
  fs::permissions(entry, fs::perms(0666));
  EXPECT_FALSE(VerdictCache(folder_).find(encode(plain_program())).has_value());
  fs::permissions(entry, fs::perms(0644));
  EXPECT_TRUE(VerdictCache(folder_).find(encode(plain_program())).has_value());
  if (geteuid() != 0) return;  // only root can give a file away
  ASSERT_EQ(chown(entry.c_str(), 12345, 12345), 0);
  EXPECT_FALSE(VerdictCache(folder_).find(encode(plain_program())).has_value());
}

TEST_F(Cache, WorksWhereItCannotWrite) {
  const fs::path file = folder_ / "file";
  std::ofstream(file) << "in the way";
  ValidatorOptions impossible;
  impossible.cache_folder = file / "cache";
  Validator validator(impossible);
  EXPECT_TRUE(validate_one(validator, good_program()).program.has_value());
  EXPECT_TRUE(validate_one(validator, good_program()).program.has_value());
}

TEST_F(Cache, ServesFromAReadOnlyFolder) {
  store_odd_verdict(plain_program());
  chmod(folder_.c_str(), 0500);
  EXPECT_TRUE(comes_from_cache(plain_program()));
}

}  // namespace
}  // namespace plugc
