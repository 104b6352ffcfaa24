// Who waits where there are fewer processors than threads: the window never, what renders for it, what nobody waits for yet for all others.
#pragma once

namespace lightbench::view {

enum class Priority { rendering, later };

// Of this thread, and of those and of the programs that it starts from now on. Where that is not allowed nothing is lost.
void give_way(Priority priority);

} // namespace lightbench::view
