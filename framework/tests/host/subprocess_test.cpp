// Waiting for programs.
#include "host/subprocess.h"

#include <gtest/gtest.h>

#include <csignal>

namespace pathmark::test {
namespace {

ProcessRequest shell(const char* script) {
  ProcessRequest request;
  request.arguments = {"/bin/sh", "-c", script};
  return request;
}

TEST(RunProcess, EndsOneThatMayNotGoOn) {
  for (const char* script : {"exec sleep 100", "exec >&- 2>&-; exec sleep 100"}) {
    ProcessRequest request = shell(script);
    int asked = 0;
    request.goOn = [&] { return ++asked < 5; };
    const ProcessResult result = runProcess(request);
    EXPECT_TRUE(result.stopped) << script;
    EXPECT_FALSE(result.timedOut) << script;
    EXPECT_EQ(result.exitCode, 128 + SIGKILL) << script;
  }
}

TEST(RunProcess, SaysOfOneThatTookTooLongThatItsTimeWasUp) {
  ProcessRequest request = shell("exec sleep 100");
  request.timeLimitSeconds = 0.3;
  request.goOn = [] { return true; };
  const ProcessResult result = runProcess(request);
  EXPECT_TRUE(result.timedOut);
  EXPECT_FALSE(result.stopped);
}

TEST(RunProcess, LetsOneEndThatMayGoOn) {
  ProcessRequest request = shell("sleep 0.3; echo done; exit 3");
  request.goOn = [] { return true; };
  const ProcessResult result = runProcess(request);
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_EQ(result.output, "done\n");
  EXPECT_FALSE(result.stopped || result.timedOut);
}

}  // namespace
}  // namespace pathmark::test
