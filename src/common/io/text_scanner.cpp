#include "common/io/text_scanner.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <utility>

#include "common/io/read_formats.h"

namespace kerf::core::io {

namespace {

bool is_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

/// Decides about a number that std::from_chars calls out of range for a float: it is 0, or too large.
NumberError resolve_out_of_range(std::string_view text, float& value)
{
    double wide = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), wide);
    bool small = false;
    if (error == std::errc::result_out_of_range) {
        // Outside the doubles too: the sign of the exponent tells, or, for a very long number, its first digit.
        const std::size_t exponent = text.find_first_of("eE");
        if (exponent != std::string_view::npos)
            small = exponent + 1 < text.size() && text[exponent + 1] == '-';
        else
            small =
                text.starts_with('.') || text.starts_with("0.") || text.starts_with("-.") || text.starts_with("-0.");
    } else {
        small = std::abs(wide) < 1.0;
    }
    if (!small) return NumberError::too_large;
    value = text.starts_with('-') ? -0.0f : 0.0f;
    return NumberError::none;
}

/// How Microsoft's runtimes before 2015 write non-finite numbers, behind a sign and a digit: 1.#IND, -1.#INF00.
bool is_word_of_old_runtime(std::string_view text)
{
    return text.starts_with("#IND") || text.starts_with("#INF") || text.starts_with("#QNAN") ||
           text.starts_with("#SNAN");
}

/// Parses spellings that std::from_chars does not know.
NumberError parse_unusual(std::string_view text, float& value)
{
    if (const std::size_t mark = text.find(".#"); mark != std::string_view::npos && mark > 0)
        return is_word_of_old_runtime(text.substr(mark + 1)) ? NumberError::not_finite : NumberError::not_a_number;

    std::array<char, 64> copy{};
    const std::size_t exponent = text.find_first_of("dD");
    if (exponent == std::string_view::npos || text.size() > copy.size()) return NumberError::not_a_number;
    std::copy(text.begin(), text.end(), copy.begin());
    copy[exponent] = 'e';
    return parse_float({copy.data(), text.size()}, value);
}

}  // namespace

NumberError parse_float(std::string_view text, float& value)
{
    if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::invalid_argument || end != text.data() + text.size()) return parse_unusual(text, value);
    if (error == std::errc::result_out_of_range) return resolve_out_of_range(text, value);
    if (std::isfinite(value)) return NumberError::none;
    // "inf" and "nan" are words; digits that end up infinite are a number that is too large.
    const char first = text[text.front() == '-' ? 1 : 0];
    return first == '.' || (first >= '0' && first <= '9') ? NumberError::too_large : NumberError::not_finite;
}

std::string explain(NumberError error, std::string_view text, std::string_view what)
{
    const std::string subject = std::string(what) + " is ";
    if (text.empty()) return subject + "missing; add it or take the line out";
    switch (error) {
        case NumberError::not_finite:
            return subject + in_quotes(text) + ", which is not finite; write a number, or take it and its faces out";
        case NumberError::too_large:
            return subject + in_quotes(text) + ", which is too large for single precision; scale the mesh down";
        case NumberError::none:
        case NumberError::not_a_number:
            break;
    }
    const std::string remedy = text.find(',') != std::string_view::npos
                                   ? "write decimals with a point, and blanks between numbers"
                                   : "write one";
    return subject + in_quotes(text) + ", which is not a number; " + remedy;
}

TextScanner::TextScanner(const std::filesystem::path& path, std::string_view text, Syntax syntax, ReadingNotes* notes)
    : path_(path), text_(text), syntax_(syntax), notes_(notes)
{
    constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
    if (text_.starts_with(kByteOrderMark)) at_ = kByteOrderMark.size();
}

void TextScanner::skip_line_end()
{
    if (text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n') ++at_;
    ++at_;
    ++line_;
    word_taken_ = false;
}

/// Moves to the next word of the line, or to its end.
void TextScanner::skip_blanks()
{
    while (!at_line_end()) {
        std::size_t at = at_;
        while (at < text_.size() && is_blank(text_[at])) ++at;
        at_ = at;
        if (at_line_end()) return;
        if (is_comment(at_)) {
            while (!at_line_end()) ++at_;
        } else if (is_continuation(at_)) {
            ++at_;
            if (at_ < text_.size()) skip_line_end();
        } else {
            return;
        }
    }
}

bool TextScanner::is_comment(std::size_t at) const
{
    return syntax_.comment != '\0' && text_[at] == syntax_.comment;
}

bool TextScanner::is_continuation(std::size_t at) const
{
    return syntax_.continuations && text_[at] == '\\' &&
           (at + 1 == text_.size() || text_[at + 1] == '\n' || text_[at + 1] == '\r');
}

bool TextScanner::next_line()
{
    if (in_line_) end_line();
    in_line_ = true;
    for (;;) {
        skip_blanks();
        if (at_ == text_.size()) return false;
        if (!at_line_end()) return true;
        skip_line_end();
    }
}

void TextScanner::end_line()
{
    while (!word().empty()) {
    }
    if (at_ < text_.size()) skip_line_end();
    in_line_ = false;
}

std::string_view TextScanner::word()
{
    skip_blanks();
    const std::size_t first = at_, size = text_.size();
    // In a local variable: bytes may alias the members, and reading spends its time in this loop.
    std::size_t at = first;
    for (; at < size; ++at) {
        const char c = text_[at];
        const bool is_plain = static_cast<unsigned char>(c) > ' ' && c != syntax_.comment && c != '\\';
        if (!is_plain && ends_word(first, at)) break;
    }
    at_ = at;
    if (at > first && !word_taken_) {
        word_taken_ = true;
        ++lines_begun_;
    }
    return text_.substr(first, at - first);
}

/// Whether a word that began at `first` ends before this character. The comment sign of 1.#IND is none.
bool TextScanner::ends_word(std::size_t first, std::size_t at) const
{
    const char c = text_[at];
    if (is_blank(c) || c == '\n' || c == '\r' || is_continuation(at)) return true;
    return is_comment(at) && !(at > first && text_[at - 1] == '.' && is_word_of_old_runtime(text_.substr(at)));
}

std::string_view TextScanner::word_of_any_line()
{
    for (;;) {
        skip_blanks();
        if (!at_line_end()) return word();
        if (at_ == text_.size()) return {};
        skip_line_end();
    }
}

void TextScanner::next_record(std::uint64_t left)
{
    skip_blanks();
    if (!at_line_end() && word_taken_) {
        if (!records_have_lines_) records_have_lines_ = lines_left() >= left;
        if (wrapped_from_ && (*records_have_lines_ || records_in_order_)) {
            line_ = *std::exchange(wrapped_from_, std::nullopt);
            fail("it has fewer numbers than the header promises; complete it or export the file again");
        }
        if (*records_have_lines_) {
            end_line();
            ++lines_passed_over_;
        } else {
            records_shared_lines_ = true;
        }
    }
    skip_to_word();
    record_begins_line_ = !word_taken_;
    records_left_ = left;
    wrapped_from_.reset();
}

std::string_view TextScanner::word_of_record_lines()
{
    const std::string_view found = word();
    if (!found.empty()) return found;
    if (records_in_order_ && !wrapped_from_) {
        if (!record_begins_line_) fail("the last of several records on it goes on in the next; export it again");
        wrapped_from_ = line_;
    }
    if (records_have_lines_.value_or(true) && !wrapped_from_) {
        // The line on which the record began ends within it. Lines before it may have had words too many.
        const std::uint64_t lines = lines_left() + 1;
        if (lines > records_left_)
            wrapped_from_ = line_;
        else if (!records_have_lines_)
            records_have_lines_ = lines == records_left_;
        if (!wrapped_from_ && *records_have_lines_) return {};
        records_shared_lines_ = records_shared_lines_ || !wrapped_from_;
    }
    return word_of_any_line();
}

/// Moves to the next word of any line.
void TextScanner::skip_to_word()
{
    for (skip_blanks(); at_line_end() && at_ < text_.size(); skip_blanks()) skip_line_end();
}

void TextScanner::take_records_in_order()
{
    records_in_order_ = records_shared_lines_ = true;
    records_have_lines_ = false;
}

void TextScanner::new_records()
{
    if (records_in_order_) return;
    skip_blanks();
    if (at_line_end() || !word_taken_ || records_have_lines_.value_or(true)) records_have_lines_.reset();
}

void TextScanner::end_records()
{
    next_record(0);
    if (records_shared_lines_) {
        if (const std::string_view found = word_of_any_line(); !found.empty())
            fail(in_quotes(found) + " stands behind the last number that is expected; export it again");
    } else if (notes_ != nullptr) {
        notes_->add("lines behind the last one that is expected passed over", lines_left());
    }
}

/// Lines of which no word was taken yet. O(n) the first time, O(1) then.
std::uint64_t TextScanner::lines_left()
{
    if (!lines_) {
        TextScanner ahead = *this;
        ahead.in_line_ = word_taken_;
        while (ahead.next_line()) ++lines_counted_;
        lines_ = lines_begun_ + lines_counted_;
    }
    return *lines_ - lines_begun_;
}

std::string_view TextScanner::rest()
{
    while (!at_line_end() && is_blank(text_[at_])) ++at_;
    const std::size_t first = at_;
    while (!at_line_end()) ++at_;
    std::size_t last = at_;
    while (last > first && is_blank(text_[last - 1])) --last;
    return text_.substr(first, last - first);
}

float TextScanner::to_float(std::string_view text, std::string_view what) const
{
    float value = 0.0f;
    const NumberError error = parse_float(text, value);
    if (error == NumberError::not_a_number) fail(explain(error, text, what));
    return error == NumberError::none ? value : std::numeric_limits<float>::quiet_NaN();
}

float TextScanner::to_attribute(std::string_view text)
{
    float value = 0.0f;
    return parse_float(text, value) == NumberError::none ? value : std::numeric_limits<float>::quiet_NaN();
}

std::int64_t TextScanner::to_integer(std::string_view text, std::string_view what) const
{
    if (text.empty()) fail(std::string(what) + " is missing; add it or take the line out");
    if (const auto value = integer_if(text)) return *value;
    fail(std::string(what) + " is " + in_quotes(text) + ", which is not an integer that fits; write one");
}

std::optional<std::int64_t> TextScanner::integer_if(std::string_view text) const
{
    const std::string_view digits = text.size() > 1 && text[0] == '+' && text[1] != '-' ? text.substr(1) : text;
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error == std::errc() && end == digits.data() + digits.size()) return value;

    // Up to here doubles are whole numbers without gaps.
    constexpr double kLargest = 9007199254740992.0;
    double wide = 0.0;
    const auto [wide_end, wide_error] = std::from_chars(digits.data(), digits.data() + digits.size(), wide);
    if (wide_error != std::errc() || wide_end != digits.data() + digits.size() || std::trunc(wide) != wide ||
        std::abs(wide) > kLargest)
        return std::nullopt;
    if (notes_ != nullptr) notes_->add("integers written with a point or an exponent read");
    return static_cast<std::int64_t>(wide);
}

void TextScanner::fail(const std::string& reason) const
{
    std::string doubt;
    if (wrapped_from_)
        doubt = " (read as going on from line " + std::to_string(*wrapped_from_) + ": that one may be too short)";
    else if (records_shared_lines_)
        doubt = " (there are fewer lines than vertices and faces: it may be cut off)";
    io::fail(path_, "line " + std::to_string(line_) + ": " + reason + doubt);
}

}  // namespace kerf::core::io
