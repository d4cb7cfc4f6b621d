#include <algorithm>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "api/back_end_choice.h"
#include "api/mesh_data.h"
#include "api/no_memory.h"
#include "api/section_maker.h"
#include "back_ends/back_ends.h"

namespace kerf {

/// What a SectionStack hides.
struct SectionStack::Data
{
    std::vector<Section> sections;  ///< those behind `count` were used before
    std::size_t count = 0;
    std::vector<std::uint32_t> order;  ///< numbers of the sections, by height
};

namespace {

/// What threads share that work at a stack.
struct Work
{
    const Object& object;
    const Plane& level;  ///< through the origin
    std::span<const double> heights;
    const SectionOptions& options;
    SectionStack::Data& data;
    const core::StackSearch* search;  ///< null: each section is found by itself
    std::atomic<std::size_t> next{0}, done{0};
    std::atomic<bool> is_stopped{false}, has_no_memory{false};
};

/// Threads take so many heights at a time that are next to one another: their sections are near in memory, too.
constexpr std::size_t kAtATime = 4;

/// Takes heights until none is left. `goes_on` is asked after each section.
template <class GoesOn>
void work_at(Work& work, GoesOn goes_on)
{
    SectionScratch scratch;
    for (;;) {
        const std::size_t first = work.next.fetch_add(kAtATime), count = work.heights.size();
        if (first >= count) return;
        for (std::size_t i = first; i < std::min(first + kAtATime, count); ++i) {
            if (work.is_stopped) return;
            const std::uint32_t number = work.data.order[i];
            const Plane plane = work.level.moved(work.heights[number]).value_or(work.level);
            std::optional<SectionMaker::InStack> in_stack;
            if (work.search != nullptr) in_stack.emplace(SectionMaker::InStack{*work.search, number});
            const Status status = SectionMaker::fill(work.object, to_core(plane), work.options, &scratch,
                                                     work.data.sections[number], in_stack ? &*in_stack : nullptr);
            if (status == Status::out_of_memory) work.has_no_memory = true;
            ++work.done;
            if (work.has_no_memory || !goes_on()) {
                work.is_stopped = true;
                return;
            }
        }
    }
}

/// The helpers of a thread: as many as there are to be had. They end with their work.
class Helpers
{
public:
    Helpers(Work& work, std::uint32_t count)
    {
        try {
            threads_.reserve(count);
            for (std::uint32_t i = 0; i < count; ++i)
                threads_.emplace_back([&work] {
                    try {
                        work_at(work, [] { return true; });
                    } catch (const std::bad_alloc&) {
                        work.has_no_memory = work.is_stopped = true;
                    }
                });
        } catch (const std::system_error&) {
        } catch (const std::bad_alloc&) {
        }
    }
    ~Helpers()
    {
        for (std::thread& thread : threads_) thread.join();
    }
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;

private:
    std::vector<std::thread> threads_;
};

bool are_finite(std::span<const double> heights)
{
    return std::ranges::all_of(heights, [](double height) { return std::isfinite(height); });
}

const char* fault_of(const Object& object, const std::optional<Plane>& level, std::span<const double> heights,
                     const StackOptions& options)
{
    if (const char* fault = SectionMaker::fault_of(object, options.section)) return fault;
    if (!level) return "the normal must have a direction";
    if (!are_finite(heights)) return "the heights must be finite";
    return nullptr;
}

}  // namespace

struct StackMaker
{
    static Status refuse(SectionStack& stack, Status status, const char* refusal = "")
    {
        if (stack.data_ != nullptr) stack.data_->count = 0;
        stack.refusal_ = refusal;
        return stack.status_ = status;
    }

    /// Of the time that a stack takes, if it is searched as a whole.
    static constexpr double kShareOfSearch = 0.5;

    static std::unique_ptr<core::StackSearch> search_of(const Object& object, const Plane& level,
                                                        std::span<const double> heights,
                                                        const core::ProgressOfStep& progress)
    {
        std::vector<double> offsets;
        offsets.reserve(heights.size());
        for (const double height : heights) offsets.push_back(level.moved(height).value_or(level).offset());
        return object.inside()->search_stack(to_core(level).normal, offsets, progress);
    }

    /// May throw std::bad_alloc.
    static Status fill(const Object& object, const Plane& level, std::span<const double> heights,
                       const StackOptions& options, SectionStack& stack)
    {
        if (stack.data_ == nullptr) stack.data_ = new SectionStack::Data;
        SectionStack::Data& data = *stack.data_;
        data.count = 0;
        if (data.sections.size() < heights.size()) data.sections.resize(heights.size());
        data.order.resize(heights.size());
        std::iota(data.order.begin(), data.order.end(), 0u);
        std::sort(data.order.begin(), data.order.end(), [&](std::uint32_t a, std::uint32_t b) {
            return std::pair(heights[a], a) < std::pair(heights[b], b);
        });
        const auto goes_on = [&](double share) {
            return options.progress == nullptr || options.progress(options.user, share);
        };
        if (!goes_on(0.0)) return refuse(stack, Status::cancelled);
        std::unique_ptr<core::StackSearch> search;
        try {
            search = search_of(object, level, heights, {{options.progress, options.user}, 0.0, kShareOfSearch});
        } catch (const core::Cancelled&) {
            return refuse(stack, Status::cancelled);
        }
        const double searched = search ? kShareOfSearch : 0.0;
        Work work{object, level, heights, options.section, data, search.get()};
        {
            const std::uint32_t wanted = options.threads != 0 ? options.threads : std::thread::hardware_concurrency();
            const std::size_t useful = (heights.size() + kAtATime - 1) / kAtATime;
            const auto threads = static_cast<std::uint32_t>(std::min<std::size_t>(std::max(1u, wanted), useful));
            const Helpers helpers(work, threads > 0 ? threads - 1 : 0);
            try {
                work_at(work, [&] {
                    return goes_on(searched + (1.0 - searched) * double(work.done) / double(heights.size()));
                });
            } catch (...) {
                work.is_stopped = true;
                throw;
            }
        }
        if (work.has_no_memory) return refuse(stack, Status::out_of_memory);
        if (work.is_stopped || !goes_on(1.0)) return refuse(stack, Status::cancelled);
        data.count = heights.size();
        stack.refusal_ = "";
        return stack.status_ = Status::done;
    }
};

Status sections(const Object& object, Normal normal, std::span<const double> heights, SectionStack& stack,
                const StackOptions& options) noexcept
{
    const std::optional<Plane> level = Plane::at(Point(0, 0, 0), normal);
    if (const char* fault = fault_of(object, level, heights, options))
        return StackMaker::refuse(stack, Status::invalid_argument, fault);
    const Status status =
        answer_or(Status::out_of_memory, [&] { return StackMaker::fill(object, *level, heights, options, stack); });
    return status == Status::out_of_memory ? StackMaker::refuse(stack, status) : status;
}

BackEnd quicker_for_sections(const Mesh& mesh, Normal normal, std::span<const double> heights) noexcept
{
    const std::optional<Plane> level = Plane::at(Point(0, 0, 0), normal);
    const bool has_meaning = !mesh.is_empty() && level && are_finite(heights);
    if (!has_meaning || core::find_back_end("halfedge") == nullptr) return BackEnd::linear;
    try {
        const bool pays = preparing_pays(mesh.data()->mesh(), to_core(*level).normal, heights);
        return pays ? BackEnd::halfedge : BackEnd::linear;
    } catch (const std::bad_alloc&) {
        return BackEnd::linear;
    }
}

SectionStack sections(const Object& object, Normal normal, std::span<const double> heights,
                      const StackOptions& options) noexcept
{
    SectionStack stack;
    static_cast<void>(sections(object, normal, heights, stack, options));
    return stack;
}

SectionStack::SectionStack() noexcept = default;

SectionStack::SectionStack(SectionStack&& other) noexcept
{
    *this = std::move(other);
}

SectionStack& SectionStack::operator=(SectionStack&& other) noexcept
{
    if (this == &other) return *this;
    delete std::exchange(data_, std::exchange(other.data_, nullptr));
    status_ = std::exchange(other.status_, Status::done);
    refusal_ = std::exchange(other.refusal_, "");
    return *this;
}

SectionStack::~SectionStack()
{
    delete data_;
}

const char* SectionStack::reason() const noexcept
{
    switch (status_) {
        case Status::invalid_argument:
            return refusal_;
        case Status::cancelled:
            return "the caller asked to stop; there are no sections";
        case Status::out_of_memory:
            return "there is not enough memory for the sections; ask for fewer at a time";
        default:
            return "";
    }
}

std::span<const Section> SectionStack::all() const& noexcept
{
    if (data_ == nullptr) return {};
    return std::span<const Section>(data_->sections).first(data_->count);
}

}  // namespace kerf
