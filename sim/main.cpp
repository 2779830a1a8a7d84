#include "sim/command/commands.h"

int main(int argc, char** argv) { return artu::sim::main_command(argc, argv); }
