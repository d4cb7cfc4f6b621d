#pragma once

namespace kerf::core {

/// Thrown by Progress::at() when the caller has asked to stop. It leaves no function of the contract.
struct Cancelled
{
};

/// Tells the caller how far a long call is, and lets it stop.
struct Progress
{
    /// Gets the share that is done, 0 to 1; returns false to stop. May be null.
    bool (*tell)(void* user, double share) = nullptr;
    void* user = nullptr;

    /// @throws Cancelled  the caller asks to stop
    void at(double share) const
    {
        if (tell != nullptr && !tell(user, share)) throw Cancelled{};
    }
};

}  // namespace kerf::core
