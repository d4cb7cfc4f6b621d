#pragma once

#include <kerf/section.h>

#include <cstdint>
#include <memory>
#include <vector>

#include "api/convert.h"
#include "common/sections/loop_nesting.h"
#include "common/sections/section_fill.h"

namespace kerf {

/// What finding a section needs besides: one for many sections, of one thread.
struct SectionScratch
{
    core::LoopNesting nesting;
    core::SectionFill fill;
    std::unique_ptr<core::PlaneSection::Scratch> of_back_end;
};

/// What a Section hides.
struct Section::Data
{
    core::PlaneSection found;
    std::vector<std::uint32_t> parents;  ///< of each path; none if they were not asked for
    std::vector<std::uint32_t> corners;  ///< of triangles, if they were asked for
    CutStatistics statistics;
    std::unique_ptr<SectionScratch> scratch;  ///< of a section that is filled by itself
};

struct SectionMaker
{
    /// What is wrong with the arguments, or null.
    static const char* fault_of(const Object& object, const SectionOptions& options);

    /// Leaves no paths, and says why.
    static Status refuse(Section& section, Status status, const char* refusal);

    /// A plane of a stack that is searched as a whole.
    struct InStack
    {
        const core::StackSearch& search;
        std::size_t number = 0;
    };

    /// Fills a section. Without a scratch it takes its own, which it keeps. Its status may be `out_of_memory`.
    ///
    /// @param in_stack  the same plane, for a back end that searches stacks; null: by itself
    static Status fill(const Object& object, const core::Plane& plane, const SectionOptions& options,
                       SectionScratch* scratch, Section& section, const InStack* in_stack = nullptr) noexcept;

private:
    static void clear(Section& section);
    static Status fill_clear(const Object& object, const core::Plane& plane, const SectionOptions& options,
                             SectionScratch* scratch, Section& section, const InStack* in_stack);
    static void close(const Object& object, const core::Plane& plane, const SectionOptions& options,
                      SectionScratch& scratch, Section& section);
};

}  // namespace kerf
