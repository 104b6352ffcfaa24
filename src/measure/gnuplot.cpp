#include "measure/gnuplot.h"

#include "gpu/errors.h"
#include "measure/text.h"

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <system_error>
#include <unistd.h>

namespace lightbench {
namespace {

constexpr unsigned kSeconds = 30; // a plot takes a tenth of one
constexpr int kNotFound = 127;

// A file without a name, for one stream of the child: nothing can block on it, as it could on a pipe.
class Stream {
  public:
    explicit Stream(const char* name) : file(::memfd_create(name, MFD_CLOEXEC)) {
        if (file < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
    }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;
    ~Stream() { ::close(file); }
    int descriptor() const { return file; }

    void fill(const std::string& text) const {
        for (std::size_t done = 0; done < text.size();) {
            const ssize_t n = ::write(file, text.data() + done, text.size() - done);
            if (n < 0 && errno != EINTR) throw std::system_error(errno, std::generic_category(), "script for gnuplot");
            if (n > 0) done += static_cast<std::size_t>(n);
        }
        ::lseek(file, 0, SEEK_SET);
    }

    std::string text() const {
        std::string all(static_cast<std::size_t>(::lseek(file, 0, SEEK_END)), '\0');
        if (::pread(file, all.data(), all.size(), 0) != static_cast<ssize_t>(all.size())) all.clear();
        return all;
    }

  private:
    int file;
};

// Only what may follow fork() in a process with threads. The alarm survives exec, and gnuplot leaves its default action: the end.
[[noreturn]] void be_gnuplot(const Stream& in, const Stream& out, const Stream& err) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::dup2(in.descriptor(), STDIN_FILENO), ::dup2(out.descriptor(), STDOUT_FILENO), ::dup2(err.descriptor(), STDERR_FILENO);
    std::signal(SIGALRM, SIG_DFL);
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::alarm(kSeconds);
    ::execlp("gnuplot", "gnuplot", "-d", static_cast<const char*>(nullptr));
    ::_exit(kNotFound);
}

int wait_for(pid_t child) {
    int status = 0;
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

} // namespace

std::string gnuplot_style(unsigned width, unsigned height) {
    std::string style = fmt::format("set encoding utf8\nset terminal svg size {},{} dynamic noenhanced background '#ffffff' "
                                    "font 'DejaVu Sans,Helvetica,Arial,sans-serif,14' linewidth 1.2\n",
                                    width, height);
    int number = 0;
    for (const char* color : {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000", "#a6761d"})
        style += fmt::format("set linetype {} linecolor rgb '{}'\n", ++number, color);
    return style + "set grid linecolor rgb '#dddddd' linewidth 0.6\nset border linecolor rgb '#666666'\nset tics textcolor rgb '#222222'\n";
}

std::string run_gnuplot(const std::string& script) {
    const Stream in("script"), out("picture"), err("complaints");
    in.fill(script);
    const pid_t child = ::fork();
    if (child == 0) be_gnuplot(in, out, err);
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    const int status = wait_for(child);
    if (WIFEXITED(status) && WEXITSTATUS(status) == kNotFound)
        throw gpu::EnvironmentError("gnuplot, which draws the SVG plots, cannot be run; Debian's package is gnuplot-nox");
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGALRM)
        throw gpu::EnvironmentError(fmt::format("gnuplot took more than {} s for a plot and was ended", kSeconds));
    std::string picture = out.text();
    const std::string complaints = err.text();
    if (status != 0 || !complaints.empty() || picture.find("</svg>") == std::string::npos)
        throw gpu::EnvironmentError(fmt::format("gnuplot drew no plot: {}", complaints.empty() ? "it ended early" : printable(complaints)));
    return picture;
}

} // namespace lightbench
