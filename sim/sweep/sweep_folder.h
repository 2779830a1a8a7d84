// The folder of a sweep: points that are finished, whole, and nothing of the others.
//
//   DIR/sweep.json               what is varied (plan.h)
//   DIR/points/0007-1a2b3c4d/    as `artu run` leaves it; or error.json and config.toml
//   DIR/points.partial/          points that are being simulated
//   DIR/points.csv, .sqlite      the table
#pragma once

#include <memory>
#include <string>

#include "sim/report/folder_lock.h"
#include "sim/report/interruption.h"

namespace artu::sim {

class SweepFolder {
 public:
  enum class Begin {
    fresh,     // the folder must not exist
    replace,   // an earlier sweep's is removed
    resume,    // goes on where the sweep was; begins it if there is none
    share,     // the same, and leaves what other processes have not finished
    take_part  // several at the same time: sweep.json must be there, nothing is cleaned up
  };

  /// `description` is sweep.json.  Throws InputError where the folder is another sweep's, and while another process
  /// works on it.
  SweepFolder(const std::string& name, const std::string& description, Begin begin);
  ~SweepFolder();  // removes what is unfinished
  SweepFolder(const SweepFolder&) = delete;
  SweepFolder& operator=(const SweepFolder&) = delete;

  const std::string& name() const { return name_; }
  std::string file(const std::string& name) const { return name_ + "/" + name; }
  std::string point(const std::string& name) const { return name_ + "/points/" + name; }
  bool finished(const std::string& point) const;
  /// Where a process writes a point's folder before publish().
  std::string unfinished(const std::string& point) const { return work_ + "/" + point; }
  /// Puts the point where it belongs, on the disk.  If another process was faster, its result, the same, stays.
  void publish(const std::string& point) const;
  /// What processes have left that were killed; not what others are at work on.
  void remove_unfinished() const;

 private:
  void lock();
  bool others_work() const;
  void compare(const std::string& description) const;

  const std::string name_;
  std::string work_;
  std::unique_ptr<FolderLock> lock_, work_lock_;  // on the whole, and on what this process has not finished
  std::unique_ptr<RemoveOnInterrupt> guard_;
};

/// Throws InputError where SweepFolder would for what is there already, without changing anything.
void check_sweep_folder(const std::string& name, SweepFolder::Begin begin);

}  // namespace artu::sim
