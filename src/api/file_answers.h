#pragma once

#include <kerf/io.h>

#include <filesystem>
#include <new>
#include <stdexcept>
#include <string>

#include "common/files/file_error.h"

// Where the library's own code throws FileError, the public interface answers.

namespace kerf {

/// What FileBytes hides.
struct FileBytes::Data
{
    std::string text;
};

inline constexpr const char* kNoMemoryForFile = "there is not enough memory for the file; divide it or free some";

/// Calls `call`, and answers for what it throws.
template <class Answer, class Call>
Answer answer_of_file(Call&& call) noexcept
{
    try {
        return call();
    } catch (const core::io::NoMemoryForFile& error) {
        return {Status::out_of_memory, Sentence(error.what())};
    } catch (const core::io::FileError& error) {
        return {Status::unusable_file, Sentence(error.what())};
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {
    } catch (const std::filesystem::filesystem_error& error) {
        return {Status::unusable_file, Sentence(error.what())};
    }
    return {Status::out_of_memory, Sentence(kNoMemoryForFile)};
}

}  // namespace kerf
