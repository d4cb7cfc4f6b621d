#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace kerf::render {

/// What the GL driver complained about. Every error is counted; the first few are kept in words.
///
/// Uses KHR_debug where the driver has it (synchronous, so a breakpoint in the call-back shows the call that was
/// wrong), and glGetError() at each check() where it has not.
class GlErrorLog
{
public:
    /// Listens to the current context until the log dies.
    GlErrorLog();
    ~GlErrorLog();
    GlErrorLog(const GlErrorLog&) = delete;
    GlErrorLog& operator=(const GlErrorLog&) = delete;

    /// Collects what glGetError() still holds. Cheap enough for once a frame.
    void check();

    std::size_t count() const { return count_; }
    const std::vector<std::string>& messages() const { return messages_; }

    /// Counts an error: what the call-back does.
    void add(std::string message);

private:
    bool has_callback_ = false;
    std::size_t count_ = 0;
    std::vector<std::string> messages_;
};

}  // namespace kerf::render
