#include "app/view/priority.h"

#include <sys/resource.h>
#include <unistd.h>

namespace lightbench::view {

// Linux gives a third to a thread that is 5 nicer than another, and a tenth to one that is 10 nicer. It knows niceness of threads.
void give_way(Priority priority) {
    const auto thread = static_cast<id_t>(::gettid());
    const int more = priority == Priority::rendering ? 5 : 10;
    ::setpriority(PRIO_PROCESS, thread, ::getpriority(PRIO_PROCESS, thread) + more);
}

} // namespace lightbench::view
