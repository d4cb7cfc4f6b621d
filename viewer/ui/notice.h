#pragma once

#include <algorithm>
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
    void advance(double seconds)
    {
        constexpr double kLongest = 0.25;  // nobody can read while a frame takes long
        left_ -= std::min(seconds, kLongest);
        if (left_ <= 0.0) text_.clear();
    }
    /// Empty: nothing.
    const std::string& text() const { return text_; }

private:
    std::string text_;
    double left_ = 0.0;
};

}  // namespace kerf::ui
