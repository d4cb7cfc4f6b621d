#include <kerf/c.h>
#include <kerf/status.h>
#include <kerf/version.h>

#include "c_api/calls.h"
#include "c_api/handles.h"

static_assert(KERF_NOT_SEPARATED == kerf::c_api::to_c(kerf::Status::not_separated) && KERF_NONE == kerf::kNone);

const char* kerf_version(void)
{
    return kerf::version();
}

uint32_t kerf_bits_version(void)
{
    return kerf::bits_version();
}

const char* kerf_status_text(kerf_status status)
{
    // Numbers of other types must not become good ones.
    constexpr kerf_status kMost = 255;
    return kerf::text(static_cast<kerf::Status>(0 <= status && status <= kMost ? status : kMost));
}

void kerf_free(void* handle)
{
    delete static_cast<kerf::c_api::Handle*>(handle);
}
