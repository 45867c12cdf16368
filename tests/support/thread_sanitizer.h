#pragma once

/// Under ThreadSanitizer protobuf's headers lay a Map out in another way than Debian's library, which was built
/// without: tests that read JSON by protobuf end with a crash of their own there.
#if defined(__SANITIZE_THREAD__)
#define DUALARM_SKIP_WITHOUT_PROTOBUF_MAPS() GTEST_SKIP() << "protobuf's Map is another one under ThreadSanitizer"
#else
#define DUALARM_SKIP_WITHOUT_PROTOBUF_MAPS() static_cast<void>(0)
#endif
