#pragma once

#include <sys/types.h>
#include <string>

namespace kerf::test {

/// An X server without a screen (Xvfb, of cmake/debian-packages.txt) for the life of the object; the environment's
/// DISPLAY names it.
class VirtualDisplay
{
public:
    /// @throws std::runtime_error  Xvfb does not start
    VirtualDisplay();
    ~VirtualDisplay();
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;

    const std::string& name() const { return name_; }  ///< ":99"

private:
    pid_t server_ = -1;
    std::string name_;
};

}  // namespace kerf::test
