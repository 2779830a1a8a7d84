// The options of every command, a file each.
#pragma once

namespace artu::sim {

struct CommandLine;

void add_run(CommandLine& line);
void add_check(CommandLine& line);
void add_import(CommandLine& line);
void add_precision(CommandLine& line);
void add_sampling(CommandLine& line);
void add_scaling(CommandLine& line);
void add_sweep(CommandLine& line);
void add_quality(CommandLine& line);
void add_bench(CommandLine& line);
void add_report_page(CommandLine& line);
void add_explain(CommandLine& line);
void add_reuse(CommandLine& line);
void add_diff(CommandLine& line);
void add_stress(CommandLine& line);
void add_torture(CommandLine& line);
void add_completion(CommandLine& line);
void add_man(CommandLine& line);

}  // namespace artu::sim
