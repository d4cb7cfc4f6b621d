#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/io/reading_notes.h"
#include "common/support/reason.h"

// Words and numbers of text formats, with the line that a message names.

namespace kerf::core::io {

/// Why a piece of text is not a number that fits.
enum class NumberError : std::uint8_t
{
    none,
    not_a_number,
    not_finite,
    too_large
};

/// The float nearest to a decimal number, ties to even; a number too small for a float is 0. All of `text` is the
/// number. The exponent may be Fortran's (1.0D+02). A number that is not finite may be a word (nan, -inf) or spelt as
/// by old Windows programs (-1.#IND).
NumberError parse_float(std::string_view text, float& value);

/// A sentence about a number that parse_float() refused, with the remedy. `what` names it: "a coordinate".
std::string explain(NumberError error, std::string_view text, std::string_view what);

/// Walks over the lines and the words of a text file, and reports errors with file and line. A line ends with LF, CR LF
/// or CR. Holds a view: the text must outlive it.
class TextScanner
{
public:
    struct Syntax
    {
        char comment = '\0';         ///< starts a comment that runs to the end of the line; '\0': there are none
        bool continuations = false;  ///< a backslash at the end of a line joins the next one to it
    };

    /// @param notes  receives what is put right here, if given
    TextScanner(const std::filesystem::path& path, std::string_view text, Syntax syntax, ReadingNotes* notes = nullptr);

    /// Moves to the start of the next line that has a word. False at the end of the file.
    bool next_line();

    /// The next word of this line; empty at its end.
    std::string_view word();

    /// The next word of this line or of a later one; empty at the end of the file.
    std::string_view word_of_any_line();

    /// The rest of the line without white space around it. Comments and continuations are not looked for: it is a name.
    std::string_view rest();

    /// Moves to the next of `left` records. Each begins on a line of its own and may have more words on it than are
    /// needed, which are passed over. But if there are fewer lines than records, records share lines, and have no words
    /// too many. That is decided at the first record with words behind it; the lines are counted once, in O(n).
    /// @throws FileError  the last record went on in a later line, and has words behind it all the same: its first line
    ///                    is too short
    void next_record(std::uint64_t left);

    /// Lines are not counted from here on: records follow one another up to the last word of the text. One that goes on
    /// in a later line must begin and end with a line, or the numbers of a line that is too short would come from the
    /// next one. Call it before the first record.
    void take_records_in_order();

    /// Records of another kind follow: whether they share lines is decided again, unless the line goes on with them.
    void new_records();

    /// Notes lines behind the last record.
    /// @throws FileError  there are words behind the last of records that share lines: they were told apart wrongly
    void end_records();

    /// The next word of this record: of this line, or of any if records share lines.
    std::string_view record_word() { return records_have_lines_.value_or(true) ? word() : word_of_any_line(); }

    /// The same if records may also take several lines, which they do if there are more lines than records. Empty at
    /// the end of the file, and of a line that is one record.
    std::string_view word_of_record_lines();

    /// Whether it is known that each record of this kind has a line of its own, and this one does not go on in others.
    bool records_have_lines() const { return records_have_lines_.value_or(false) && !wrapped_from_; }

    /// Lines whose last words next_record() passed over.
    std::uint64_t lines_passed_over() const { return lines_passed_over_; }

    /// Lines counted to tell whether records share them, at most as many as there are. Tests bound the cost by it.
    std::uint64_t lines_counted() const { return lines_counted_; }

    /// A word as an integer; 8.0 is one, and is noted.
    std::int64_t to_integer(std::string_view text, std::string_view what) const;

    /// The same, and nothing if it is none.
    std::optional<std::int64_t> integer_if(std::string_view text) const;

    /// A word as a number that the surface does not need: NaN if it is not a finite number.
    static float to_attribute(std::string_view text);

    /// A word as a number that the surface may or may not need: NaN if it is not finite in single precision. `what`
    /// names it in the error: "a coordinate".
    float to_float(std::string_view text, std::string_view what) const;

    /// Leaves the line: moves behind its end.
    void end_line();

    /// Number of the line, counted from 1; readers that start in the middle of a file say where.
    std::size_t line() const { return line_; }
    void set_line(std::size_t line) { line_ = line; }

    std::size_t bytes_left() const { return text_.size() - at_; }

    /// @throws FileError  "FILE: line N: REASON"
    [[noreturn]] void fail(const std::string& reason) const;

private:
    std::uint64_t lines_left();
    void skip_to_word();
    bool at_line_end() const { return at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '\r'; }
    bool is_comment(std::size_t at) const;
    bool is_continuation(std::size_t at) const;
    bool ends_word(std::size_t first, std::size_t at) const;
    void skip_line_end();
    void skip_blanks();

    const std::filesystem::path& path_;
    std::string_view text_;
    Syntax syntax_;
    ReadingNotes* notes_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    bool in_line_ = false;                ///< next_line() was called: the current line must be left first
    bool word_taken_ = false;             ///< of the current line
    std::uint64_t lines_begun_ = 0;       ///< lines of which a word was taken
    std::optional<std::uint64_t> lines_;  ///< with words, in the whole text
    std::uint64_t lines_counted_ = 0;
    std::optional<bool> records_have_lines_;
    bool records_in_order_ = false;            ///< take_records_in_order()
    bool record_begins_line_ = true;           ///< this one
    std::uint64_t records_left_ = 0;           ///< with the one that we are in
    std::optional<std::size_t> wrapped_from_;  ///< line on which this record began if it went on in a later one
    bool records_shared_lines_ = false;        ///< somewhere
    std::uint64_t lines_passed_over_ = 0;
};

using core::in_quotes;

}  // namespace kerf::core::io
