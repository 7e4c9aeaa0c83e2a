#include "common/sandbox.h"

#include "common/program_error.h"

#if defined(__linux__) && defined(__x86_64__)

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <sys/prctl.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace softgl::cli {
namespace {

// Landlock by its numbers: the headers of a system may be older than its kernel.
constexpr long kCreateRuleset = 444, kAddRule = 445, kRestrictSelf = 446;
constexpr uint64_t kExecute = 1, kWriteFile = 1 << 1, kReadFile = 1 << 2, kReadFolder = 1 << 3,
                   kRemoveFile = 1 << 5, kMakeFolder = 1 << 7, kMakeFile = 1 << 8, kLastOfFirst = 1 << 12,
                   kMove = 1 << 13, kTruncate = 1 << 14, kDeviceControl = 1 << 15;

struct RulesetAttributes {
  uint64_t files, network, scopes;
};
struct [[gnu::packed]] PathRule {
  uint64_t allowed;
  int32_t parent;
};

class Landlock {
public:
  explicit Landlock(int version) {
    RulesetAttributes handled{};
    files_ = 2 * kLastOfFirst - 1;
    if (version >= 2) files_ |= kMove;
    if (version >= 3) files_ |= kTruncate;
    if (version >= 5) files_ |= kDeviceControl;
    handled.files = files_;
    if (version >= 4) handled.network = 3; // to bind and to connect
    if (version >= 6) handled.scopes = 3;  // abstract sockets and signals
    const size_t size = version >= 6 ? 24 : version >= 4 ? 16 : 8;
    ruleset_ = int(::syscall(kCreateRuleset, &handled, size, 0));
  }
  ~Landlock() {
    if (ruleset_ >= 0) ::close(ruleset_);
  }
  Landlock(const Landlock&) = delete;
  Landlock& operator=(const Landlock&) = delete;

  void allow(const std::string& path, uint64_t rights) {
    const int place = ::open(path.c_str(), O_PATH | O_CLOEXEC);
    if (place < 0) return;
    struct stat status {};
    PathRule rule{rights & files_, place};
    if (::fstat(place, &status) == 0) {
      if (!S_ISDIR(status.st_mode)) rule.allowed &= kReadFile | kWriteFile | kTruncate | kExecute;
      if (rule.allowed) ::syscall(kAddRule, ruleset_, 1, &rule, 0);
    }
    ::close(place);
  }

  bool enforce() const { return ruleset_ >= 0 && ::syscall(kRestrictSelf, ruleset_, 0) == 0; }

private:
  int ruleset_ = -1;
  uint64_t files_ = 0;
};

bool limit_files(const SandboxPaths& paths) {
  const int version = landlock_version();
  if (version < 1) return false;
  Landlock landlock(version);
  const uint64_t reading = kReadFile | kReadFolder;
  for (const char* library :
       {"/lib", "/lib64", "/usr/lib", "/usr/lib64", "/usr/local/lib", "/etc/ld.so.cache"})
    landlock.allow(library, reading);
  for (const std::string& path : paths.read) landlock.allow(path, reading);
  for (const std::string& folder : paths.write)
    landlock.allow(folder, reading | kWriteFile | kTruncate | kRemoveFile | kMakeFile | kMakeFolder);
  return landlock.enforce();
}

// System calls by what needs them.
constexpr long kAllowed[] = {
    // files
    SYS_read, SYS_write, SYS_readv, SYS_writev, SYS_pread64, SYS_pwrite64, SYS_close, SYS_close_range,
    SYS_lseek, SYS_open, SYS_openat, SYS_stat, SYS_fstat, SYS_lstat, SYS_newfstatat, SYS_statx, SYS_statfs,
    SYS_fstatfs, SYS_access, SYS_faccessat, 439 /* faccessat2 */, SYS_readlink, SYS_readlinkat,
    SYS_getdents64, SYS_getcwd, SYS_mkdir, SYS_mkdirat, SYS_rename, SYS_renameat, SYS_renameat2, SYS_unlink,
    SYS_unlinkat, SYS_fchmod, SYS_flock, SYS_ftruncate, SYS_fsync, SYS_fcntl, SYS_dup, SYS_poll, SYS_ppoll,
    SYS_fadvise64,
    // Within the process: UBSan finds out by a pipe whether memory can be read.
    SYS_pipe, SYS_pipe2,
    // memory
    SYS_mmap, SYS_mprotect, SYS_munmap, SYS_mremap, SYS_madvise, SYS_brk,
    // threads
    SYS_futex, SYS_set_robust_list, SYS_get_robust_list, SYS_rseq, SYS_set_tid_address, SYS_gettid,
    SYS_getpid, SYS_sched_yield, SYS_sched_getaffinity, SYS_sched_setaffinity, SYS_getcpu, SYS_membarrier,
    SYS_exit, SYS_exit_group,
    // signals and time
    SYS_rt_sigaction, SYS_rt_sigprocmask, SYS_rt_sigreturn, SYS_sigaltstack, SYS_restart_syscall,
    SYS_setitimer, SYS_clock_gettime, SYS_clock_getres, SYS_clock_nanosleep, SYS_nanosleep, SYS_gettimeofday,
    SYS_time,
    // the machine
    SYS_getrusage, SYS_getrlimit, SYS_sysinfo, SYS_uname, SYS_getrandom, SYS_getuid, SYS_geteuid, SYS_getgid,
    SYS_getegid, SYS_times};

class Filter {
public:
  // Everything that is not named fails with EPERM, as a call does that the user has no right to.
  Filter() {
    load(offsetof(seccomp_data, arch));
    jump_unless(BPF_JEQ, AUDIT_ARCH_X86_64, 1, true);
    end(SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
    // The calls of the x32 interface, under other numbers.
    jump_unless(BPF_JGE, 0x40000000, 1);
    end(kRefuse);
    for (const long call : kAllowed) allow(call);
    // Threads, but no processes. The flags of clone3 are out of sight: the C library then takes clone.
    allow_bits(SYS_clone, 0, CLONE_THREAD | CLONE_VM);
    jump_unless(BPF_JEQ, SYS_clone3, 1);
    end(SECCOMP_RET_ERRNO | ENOSYS);
    allow_argument(SYS_ioctl, 1, {TCGETS, TIOCGWINSZ});          // is it a terminal?
    allow_argument(SYS_prctl, 0, {PR_SET_NAME, 0x53564d41});     // of threads; of memory
    allow_argument(SYS_tgkill, 0, {uint32_t(::getpid())});       // abort()
    allow_argument(SYS_prlimit64, 0, {0, uint32_t(::getpid())}); // its own limits
    end(kRefuse);
  }

  bool install() {
    const sock_fprog program{static_cast<unsigned short>(code_.size()), code_.data()};
    return ::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
           ::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0;
  }

private:
  static constexpr uint32_t kRefuse = SECCOMP_RET_ERRNO | EPERM;

  void add(int code, uint32_t value, size_t if_true = 0, size_t if_false = 0) {
    code_.push_back({uint16_t(code), uint8_t(if_true), uint8_t(if_false), value});
  }
  void load(size_t offset) { add(BPF_LD | BPF_W | BPF_ABS, uint32_t(offset)); }
  void load_argument(size_t number) { load(offsetof(seccomp_data, args) + 8 * number); } // its lower half
  void end(uint32_t action) { add(BPF_RET | BPF_K, action); }
  // Over so many instructions, unless the comparison holds; with `when`, if it holds.
  void jump_unless(int comparison, uint32_t value, size_t count, bool when = false) {
    add(BPF_JMP | comparison | BPF_K, value, when ? count : 0, when ? 0 : count);
  }

  void allow(long call) {
    jump_unless(BPF_JEQ, uint32_t(call), 1);
    end(SECCOMP_RET_ALLOW);
  }
  void allow_argument(long call, size_t number, std::initializer_list<uint32_t> values) {
    jump_unless(BPF_JEQ, uint32_t(call), 2 + 2 * values.size());
    load_argument(number);
    for (const uint32_t value : values) allow(value);
    end(kRefuse);
  }
  // With all of these bits set.
  void allow_bits(long call, size_t number, uint32_t bits) {
    jump_unless(BPF_JEQ, uint32_t(call), 5);
    load_argument(number);
    add(BPF_ALU | BPF_AND | BPF_K, bits);
    allow(bits);
    end(kRefuse);
  }

  std::vector<sock_filter> code_;
};

} // namespace

int landlock_version() {
  const long version = ::syscall(kCreateRuleset, nullptr, 0, 1);
  return version < 0 ? 0 : int(version);
}

std::vector<std::string> enter_sandbox(const SandboxPaths& paths) {
  std::vector<std::string> lacking;
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || !limit_files(paths))
    lacking.emplace_back("--sandbox: the kernel has no Landlock; which files are read is not limited");
  if (!Filter().install())
    throw ProgramError(kUsageError, "--sandbox: the kernel has no filter of system calls (seccomp)");
  return lacking;
}

} // namespace softgl::cli

#else

namespace softgl::cli {

int landlock_version() { return 0; }

std::vector<std::string> enter_sandbox(const SandboxPaths&) {
  throw ProgramError(kUsageError,
                     "--sandbox: this program was built without it; it is there for Linux on x86-64");
}

} // namespace softgl::cli

#endif
