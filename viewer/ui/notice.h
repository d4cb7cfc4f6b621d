#pragma once

#include <algorithm>
#include <deque>
#include <string>
#include <utility>

namespace kerf::ui {

/// A sentence at the edge of the picture that goes away by itself.
class Notice
{
public:
    static constexpr double kShown = 6.0;  ///< seconds

    /// In place of what is shown. Nothing to say changes nothing.
    void say(std::string text)
    {
        if (text.empty()) return;
        text_ = std::move(text);
        left_ = kShown;
    }
    /// After what is shown, and what waits for that already: nothing of it is lost.
    void say_next(std::string text)
    {
        if (text.empty()) return;
        if (text_.empty()) return say(std::move(text));
        waiting_.push_back(std::move(text));
    }
    void advance(double seconds)
    {
        constexpr double kLongest = 0.25;  // nobody can read while a frame takes long
        left_ -= std::min(seconds, kLongest);
        if (left_ > 0.0) return;
        text_.clear();
        if (waiting_.empty()) return;
        say(std::move(waiting_.front()));
        waiting_.pop_front();
    }
    /// Empty: nothing.
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::deque<std::string> waiting_;
    double left_ = 0.0;
};

}  // namespace kerf::ui
