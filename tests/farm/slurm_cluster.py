"""A Slurm cluster of three nodes on this machine, which draws 500 pictures while one of its nodes dies.

    python3 slurm_cluster.py SOFTGL SCRIPT FOLDER

SOFTGL is the program, SCRIPT the job script of reference/farm, FOLDER an empty one for all files. Needs root, munge and
Slurm; says "SKIPPED: ..." where they are missing or cannot start. All daemons are its children's children in one
folder, and gone when it ends.
"""
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time

NODES = 3
SHARDS = 6
PICTURES = 500


class TooLate(Exception):
    """The node died when its shard was drawn already: nothing is tested."""


class CannotStart(Exception):
    """Slurm does not work on this machine: no fault of softgl."""


def free_ports(count):
    sockets = [socket.socket() for _ in range(count)]
    for each in sockets:
        each.bind(("127.0.0.1", 0))
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def processes():
    """Number, parent and command line of each process."""
    for name in os.listdir("/proc"):
        if not name.isdigit():
            continue
        try:
            with open(f"/proc/{name}/stat", encoding="utf8", errors="replace") as stat:
                parent = int(stat.read().rpartition(")")[2].split()[1])
            with open(f"/proc/{name}/cmdline", encoding="utf8", errors="replace") as words:
                yield int(name), parent, words.read().replace("\0", " ")
        except (OSError, IndexError):
            continue  # it is gone


def family(roots):
    """These processes and all below them."""
    below = list(processes())
    members = set(roots)
    while True:
        more = {process for process, parent, _ in below if parent in members} - members
        if not more:
            return members
        members |= more


def kill(members):
    for process in members:
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass


class Cluster:
    def __init__(self, folder):
        self.folder = folder
        self.daemons = {}  # processes by name
        self.environment = dict(os.environ, SLURM_CONF=f"{folder}/slurm.conf")
        for name in ("SLURM_JOB_ID", "SLURM_ARRAY_TASK_ID"):
            self.environment.pop(name, None)

    def start(self):
        for program in ("munged", "slurmctld", "slurmd", "sbatch", "squeue", "scontrol"):
            if not self.path_of(program):
                raise CannotStart(f"there is no {program}")
        if os.geteuid() != 0:
            raise CannotStart("Slurm's daemons need root")
        os.chmod(self.folder, 0o755)
        self.write_files()
        munge = f"{self.folder}/munge"
        self.run_daemon("munged", ["munged", "--foreground", "--force", f"--socket={munge}/socket", f"--key-file={munge}/key",
                                   f"--log-file={munge}/log", f"--pid-file={munge}/pid", f"--seed-file={munge}/seed"])
        self.wait_for(lambda: os.path.exists(f"{munge}/socket"), 10, "munged")
        self.run_daemon("slurmctld", ["slurmctld", "-D", "-c"])
        for node in range(1, NODES + 1):
            self.run_daemon(f"n{node}", ["slurmd", "-D", "-N", f"n{node}"])
        self.wait_for(lambda: self.ask("sinfo", "-h", "-o", "%T %D").split() == ["idle", str(NODES)], 30, "Slurm")

    def write_files(self):
        folder, host = self.folder, socket.gethostname().split(".")[0]
        for name in ("munge", "state", *(f"n{node}" for node in range(1, NODES + 1))):
            os.makedirs(f"{folder}/{name}", mode=0o755)
        with open(os.open(f"{folder}/munge/key", os.O_WRONLY | os.O_CREAT, 0o400), "wb") as key:
            key.write(os.urandom(1024))
        ports = free_ports(NODES + 1)
        lines = f"""ClusterName=softgl
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CryptoType=crypto/munge
AuthInfo=socket={folder}/munge/socket,cred_expire=5
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdPidFile={folder}/%n/slurmd.pid
SlurmdLogFile={folder}/%n/slurmd.log
SlurmdSpoolDir={folder}/%n
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1
ReturnToService=2
JobRequeue=1
SlurmdTimeout=10
SlurmctldTimeout=30
MessageTimeout=10
KillWait=5
InactiveLimit=0
MinJobAge=600
""".splitlines()
        lines += [f"NodeName=n{node} NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[node]} CPUs=1 State=UNKNOWN"
                  for node in range(1, NODES + 1)]
        lines.append("PartitionName=farm Nodes=ALL Default=YES MaxTime=INFINITE State=UP")
        with open(f"{folder}/slurm.conf", "w", encoding="utf8") as file:
            file.write("\n".join(lines) + "\n")

    @staticmethod
    def path_of(program):
        return shutil.which(program, path="/usr/sbin:/sbin:" + os.environ.get("PATH", "/usr/bin"))

    def run_daemon(self, name, words):
        with open(f"{self.folder}/{name}.out", "wb") as out:
            self.daemons[name] = subprocess.Popen([self.path_of(words[0]), *words[1:]], stdin=subprocess.DEVNULL,
                                                  stdout=out, stderr=out, env=self.environment, cwd=self.folder)

    def ask(self, program, *words):
        result = subprocess.run([self.path_of(program), *words], env=self.environment, cwd=self.folder, text=True,
                                stdin=subprocess.DEVNULL, capture_output=True, timeout=30, check=False)
        return result.stdout

    def wait_for(self, condition, seconds, what):
        end = time.monotonic() + seconds
        while not condition():
            if time.monotonic() > end or any(daemon.poll() is not None for daemon in self.daemons.values()):
                raise CannotStart(f"{what} does not start here: {self.last_words()}")
            time.sleep(0.1)

    def last_words(self):
        words = []
        for name in self.daemons:
            with open(f"{self.folder}/{name}.out", encoding="utf8", errors="replace") as out:
                words += [f"{name}: {line.strip()}" for line in out.readlines() if "error" in line.lower()][-2:]
        return "; ".join(words) or "no reason given"

    def job_on(self, node):
        """The number of the job that runs there."""
        return self.ask("squeue", "-h", "-t", "R", "-w", node, "-o", "%A").strip()

    def kill_node(self, node):
        """slurmd first, then its steps, as when the machine loses power."""
        job = self.job_on(node)
        daemon = self.daemons.pop(node)
        steps = [process for process, _, words in processes() if f"[{job}." in words and "slurmstepd" in words]
        kill(family([daemon.pid, *steps]))
        daemon.wait()
        return job

    def stop(self):
        """All that was started here, also what has lost its parent: it names this folder."""
        for daemon in self.daemons.values():
            kill(family([daemon.pid]))
            daemon.wait()
        for _ in range(50):
            rest = []
            for process, _, words in processes():
                try:
                    with open(f"/proc/{process}/environ", encoding="utf8", errors="replace") as environment:
                        mine = f"SLURM_CONF={self.folder}/slurm.conf" in environment.read()
                except OSError:
                    mine = False
                if process != os.getpid() and (mine or self.folder in words) and "slurm_cluster.py" not in words:
                    rest.append(process)
            if not rest:
                return
            kill(family(rest))
            time.sleep(0.1)
        raise SystemExit(f"processes stay: {rest}")


def write_models(folder):
    """A fan around a point, whose height and number of corners tell it from others."""
    os.makedirs(folder)
    for i in range(PICTURES):
        corners = 5 + i % 11
        with open(f"{folder}/{i:03}.obj", "w", encoding="utf8") as file:
            file.write(f"v 0 {1 + i % 13} 0\n")
            for k in range(corners):
                file.write(f"v {(k * 7 + i) % 10 - 4.5} {k % 3} {(k * 3 + i) % 8 - 3.5}\n")
            for k in range(corners):
                file.write(f"f 1 {k + 2} {(k + 1) % corners + 2}\n")


def draw_on_cluster(cluster, softgl, script):
    """Returns the number of pictures of the shard when its node died, and the number of its jobs' restarts."""
    folder = cluster.folder
    with open(f"{folder}/jobs.tsv", "w", encoding="utf8") as jobs:
        jobs.writelines(f"{folder}/models/{i:03}.obj\t--view front\t{folder}/farm/{i:03}.png\n" for i in range(PICTURES))
    environment = {"SOFTGL": softgl, "JOBS": f"{folder}/jobs.tsv", "LOG": f"{folder}/log",
                   "OPTIONS": "--up +Y --size 512x512 --aa 4"}
    cluster.environment.update(environment)
    said = cluster.ask("sbatch", "--parsable", f"--array=1-{SHARDS}", f"--output={folder}/%a.out", script)
    if not said.strip().isdigit():
        raise SystemExit(f"sbatch: {said}")
    # The first shard that has drawn something loses its node.
    end = time.monotonic() + 120
    node = None
    while not node:
        if time.monotonic() > end:
            raise SystemExit("no task draws")
        for i in range(1, NODES + 1):
            job = cluster.job_on(f"n{i}")
            task = cluster.ask("squeue", "-h", "-j", job, "-o", "%K").strip() if job else ""
            log = f"{folder}/log/{task}-of-{SHARDS}.jsonl"
            if os.path.exists(log) and os.path.getsize(log) > 0:
                node = f"n{i}"
                break
    job = cluster.kill_node(node)
    with open(log, encoding="utf8") as lines:
        before = len(lines.readlines())
    end = time.monotonic() + 300
    while cluster.ask("squeue", "-h", "-o", "%T").strip():
        if time.monotonic() > end:
            raise SystemExit("not finished after 300 s: " + cluster.ask("squeue"))
        time.sleep(0.2)
    shown = dict(word.split("=", 1) for word in cluster.ask("scontrol", "-o", "show", "job", job).split() if "=" in word)
    print(f"{node} died with task {task} after {before} pictures; restarts {shown.get('Restarts')}, "
          f"then on {shown.get('NodeList')}, {shown.get('JobState')}")
    # A machine that is very busy may take another node for dead, too.
    if int(shown.get("Restarts", 0)) < 1 or shown.get("JobState") != "COMPLETED" or shown.get("NodeList") == node:
        raise SystemExit("the shard of the dead node was not drawn again")
    return before, log


def check_pictures(folder, softgl, before, log):
    single = subprocess.run([softgl, f"{folder}/models", "-o", f"{folder}/single/{{model}}.png", "--up", "+Y", "--size",
                             "512x512", "--aa", "4", "--view", "front", "-q"], check=False)
    if single.returncode:
        raise SystemExit("the single run failed")
    expected, drawn = sorted(os.listdir(f"{folder}/single")), sorted(os.listdir(f"{folder}/farm"))
    if len(expected) != PICTURES or drawn != expected:
        raise SystemExit(f"{len(drawn)} files instead of {len(expected)}")
    for name in expected:
        with open(f"{folder}/single/{name}", "rb") as one, open(f"{folder}/farm/{name}", "rb") as other:
            if one.read() != other.read():
                raise SystemExit(f"{name} differs")
    jobs = 0
    for name in os.listdir(f"{folder}/log"):
        with open(f"{folder}/log/{name}", encoding="utf8") as lines:
            whole = [json.loads(line) for line in lines if line.endswith("}\n")]
        if any(line["exit_code"] for line in whole):
            raise SystemExit(f"{name}: a job failed")
        if f"{folder}/log/{name}" == log and before >= len({line["output"] for line in whole}):
            raise TooLate
        jobs += len({line["output"] for line in whole})
    if jobs != PICTURES:
        raise SystemExit(f"the reports have {jobs} jobs")
    print(f"{PICTURES} pictures are those of a single run")


def run(softgl, script, folder):
    write_models(f"{folder}/models")
    cluster = Cluster(folder)
    try:
        cluster.start()
        before, log = draw_on_cluster(cluster, softgl, script)
    except CannotStart as reason:
        print(f"SKIPPED: {reason}")
        return
    finally:
        cluster.stop()
    check_pictures(folder, softgl, before, log)


def main():
    softgl, script, folder = sys.argv[1:]
    for attempt in ("1", "2", "3"):
        os.mkdir(f"{folder}/{attempt}")
        try:
            return run(softgl, script, f"{folder}/{attempt}")
        except TooLate:
            print(f"attempt {attempt}: the node died too late to test anything")
    raise SystemExit("three times too late")


if __name__ == "__main__":
    main()
