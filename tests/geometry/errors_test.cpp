#include "recon/geometry/errors.h"

#include <gtest/gtest.h>

#include <string>

namespace isostack {
namespace {

TEST(Errors, MessageIsOneSentenceOfWhereWhatAndRemedy) {
  const InputError error("a.nii", "the file is cut off", "copy it again");
  EXPECT_STREQ(error.what(), "a.nii: the file is cut off; copy it again.");
}

TEST(Errors, PartsOfTheSentenceCanBeAskedFor) {
  const GeometryError error("slice 3", "its axes are not orthogonal", "export it again");
  EXPECT_EQ(error.where(), "slice 3");
  EXPECT_EQ(error.problem(), "its axes are not orthogonal");
  EXPECT_EQ(Error(error).remedy(), "export it again");  // a copy has them, too
}

TEST(Errors, EveryKindIsAnErrorAndNoOtherKind) {
  EXPECT_THROW(throw InputError("a", "b", "c"), Error);
  EXPECT_THROW(throw GeometryError("a", "b", "c"), Error);
  EXPECT_THROW(throw SolveError("a", "b", "c"), Error);
  const SolveError solve("a", "b", "c");
  const Error& base = solve;
  EXPECT_EQ(dynamic_cast<const InputError*>(&base), nullptr);
}

TEST(Errors, CancellingIsNoFailure) {
  try {
    throw Cancelled();
  } catch (const Error&) {
    FAIL() << "a cancelled run must not be reported as an error";
  } catch (const std::runtime_error& cancelled) {
    EXPECT_STREQ(cancelled.what(), "cancelled");
  }
}

}  // namespace
}  // namespace isostack
