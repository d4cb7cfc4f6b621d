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

/// A step of a long call: its shares are told as shares of the whole.
class ProgressOfStep
{
public:
    ProgressOfStep() = default;
    ProgressOfStep(const Progress& whole, double begin, double end) : whole_(whole), begin_(begin), end_(end) {}

    /// @throws Cancelled  the caller asks to stop
    void at(double share) const { whole_.at(of_whole(share)); }

    /// A step of this step, from one share of it to another.
    ProgressOfStep part(double from, double to) const { return {whole_, of_whole(from), of_whole(to)}; }

private:
    double of_whole(double share) const { return begin_ + share * (end_ - begin_); }

    Progress whole_;
    double begin_ = 0.0, end_ = 1.0;
};

}  // namespace kerf::core
