#include <kerf/status.h>

#include <cstdlib>
#include <cstring>

namespace kerf {

namespace {

// Takes the place of a sentence for which there is no memory. Never freed.
char no_memory[] = "there is not enough memory to say why";

}  // namespace

const char* text(Status status) noexcept
{
    switch (status) {
        case Status::done:
            return "done";
        case Status::missed:
            return "missed";
        case Status::open_section:
            return "open section";
        case Status::invalid_argument:
            return "invalid argument";
        case Status::invalid_mesh:
            return "invalid mesh";
        case Status::out_of_memory:
            return "out of memory";
        case Status::cancelled:
            return "cancelled";
        case Status::unusable_file:
            return "unusable file";
        case Status::not_separated:
            return "not separated";
    }
    return "unknown";
}

Sentence::Sentence(const char* text) noexcept
{
    if (text == nullptr || *text == '\0') return;
    const std::size_t bytes = std::strlen(text) + 1;
    text_ = static_cast<char*>(std::malloc(bytes));
    if (text_ == nullptr)
        text_ = no_memory;
    else
        std::memcpy(text_, text, bytes);
}

Sentence::~Sentence()
{
    if (text_ != no_memory) std::free(text_);
}

}  // namespace kerf
