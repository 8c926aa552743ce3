// Programs in the worker's place that keep none of the protocol's rules.
#include "host/worker_process.h"
#include "support/test_coursework_files.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>

namespace pathmark::test {
namespace {

class HostileWorker : public testing::Test {
 protected:
  // Starts a shell script as the worker and asks it for its stubs.
  WorkerFault faultOf(const std::string& script) {
    return faultOf(script, [](WorkerProcess& worker) { worker.stubs(); });
  }

  WorkerFault faultOfPaths(const std::string& script) {
    return faultOf(script, [](WorkerProcess& worker) {
      SharedFilm film(2, 2);
      worker.recordPaths(RenderJob{}, film, [](const RenderProgress&) { return true; });
    });
  }

  WorkerFault faultOf(const std::string& script,
                      const std::function<void(WorkerProcess&)>& question) {
    const std::filesystem::path program = folder_ / "worker.sh";
    std::ofstream(program) << "#!/bin/bash\n" << script;
    std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    WorkerProcess::Options options;
    options.program = program;
    options.courseworkFolder = folder_.path();
    options.limits.secondsWithoutAnswer = 1.0;
    options.limits.outputBytes = 100000;
    try {
      WorkerProcess worker(std::move(options));
      question(worker);
    } catch (const WorkerError& e) {
      EXPECT_FALSE(std::string(e.what()).empty());
      return e.fault();
    }
    ADD_FAILURE() << "the worker was believed";
    return WorkerFault::kEnded;
  }

  // A message header: magic, kind, sequence, reserved, length; little-endian.
  static std::string header(const char* magic, int kind, int sequence, const char* length) {
    return std::string("printf '") + magic + "\\x0" + std::to_string(kind) + "\\x00\\x00\\x00\\x0" +
           std::to_string(sequence) + "\\x00\\x00\\x00" + "\\x00\\x00\\x00\\x00" + length +
           "' >&3\n";
  }
  static constexpr const char* kMagic = "PMW1";
  static constexpr const char* kEight = "\\x08\\x00\\x00\\x00\\x00\\x00\\x00\\x00";
  static constexpr const char* kHelloBody =
      "printf '\\x01\\x00\\x00\\x00\\x00\\x00\\x00\\x00' >&3\n";

  TemporaryFolder folder_;
};

TEST_F(HostileWorker, SilenceIsATimeLimit) {
  EXPECT_EQ(faultOf("exec sleep 60\n"), WorkerFault::kTimeLimit);
}

TEST_F(HostileWorker, SilenceAfterTheGreetingIsATimeLimit) {
  EXPECT_EQ(faultOf(header(kMagic, 1, 0, kEight) + kHelloBody + "exec sleep 60\n"),
            WorkerFault::kTimeLimit);
}

TEST_F(HostileWorker, EndingAtOnceIsReported) {
  EXPECT_EQ(faultOf("exit 7\n"), WorkerFault::kEnded);
}

TEST_F(HostileWorker, AFloodOfTextIsStopped) {
  EXPECT_EQ(faultOf("exec yes\n"), WorkerFault::kOutputLimit);
}

TEST_F(HostileWorker, AFloodOnTheWireIsNonsense) {
  EXPECT_EQ(faultOf("exec cat /dev/zero >&3\n"), WorkerFault::kNonsense);
}

TEST_F(HostileWorker, AFloodBesideAnHonestGreetingIsNonsense) {
  EXPECT_EQ(faultOf(header(kMagic, 1, 0, kEight) + kHelloBody + "exec cat /dev/urandom >&3\n"),
            WorkerFault::kNonsense);
}

TEST_F(HostileWorker, ALengthBeyondAllMeasureIsNotAllocated) {
  EXPECT_EQ(
      faultOf(header(kMagic, 1, 0, kEight) + kHelloBody +
              header(kMagic, 2, 1, "\\xff\\xff\\xff\\xff\\xff\\xff\\xff\\x7f") + "exec sleep 60\n"),
      WorkerFault::kNonsense);
}

TEST_F(HostileWorker, AnAnswerToAnotherQuestionIsNonsense) {
  EXPECT_EQ(faultOf(header(kMagic, 1, 0, kEight) + kHelloBody + header(kMagic, 2, 9, kEight) +
                    "exec sleep 60\n"),
            WorkerFault::kNonsense);
}

TEST_F(HostileWorker, AnAnswerThatNeverEndsIsATimeLimit) {
  EXPECT_EQ(faultOf(header(kMagic, 1, 0, kEight) + kHelloBody +
                    header(kMagic, 2, 1, "\\x80\\x00\\x00\\x00\\x00\\x00\\x00\\x00") +
                    "while :; do printf x >&3; sleep 0.3; done\n"),
            WorkerFault::kTimeLimit);
}

// A record without a single path would begin with 48 bytes: that many are there, and one more.
TEST_F(HostileWorker, ARecordOfPathsThatIsNoneIsNonsense) {
  const std::string greeting = header(kMagic, 1, 0, kEight) + kHelloBody;
  const auto record = [&](const std::string& length, int bytes) {
    return faultOfPaths(greeting + header(kMagic, 8, 1, length.c_str()) + "head -c " +
                        std::to_string(bytes) + " /dev/zero >&3\nexec sleep 60\n");
  };
  const std::string rest = "\\x00\\x00\\x00\\x00\\x00\\x00\\x00";
  EXPECT_EQ(record("\\x00" + rest, 0), WorkerFault::kNonsense) << "it does not record";
  EXPECT_EQ(record("\\x31" + rest, 0x31), WorkerFault::kNonsense);
  EXPECT_EQ(record("\\x74" + rest, 0x74), WorkerFault::kNonsense) << "an event of no kind";
  EXPECT_EQ(record("\\x00\\x00\\x00\\x00\\x01\\x00\\x00\\x00", 100), WorkerFault::kNonsense)
      << "longer than any record";
}

TEST_F(HostileWorker, AForgedCrashRecordIsRead) {
  EXPECT_EQ(faultOf("head -c 5000 /dev/urandom >&4; exit 3\n"), WorkerFault::kEnded);
}

TEST_F(HostileWorker, AProgramThatIsNotThereIsReported) {
  WorkerProcess::Options options;
  options.program = folder_ / "nothing";
  EXPECT_THROW(WorkerProcess worker(std::move(options)), WorkerError);
}

}  // namespace
}  // namespace pathmark::test
