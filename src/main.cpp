// The program's door.
#include "app/commands.h"

int main(int argc, char** argv) {
    return lightbench::run(argc, argv);
}
