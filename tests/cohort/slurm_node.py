"""A Slurm cluster of one node, this machine, for as long as a test runs."""
import contextlib
import ctypes
import os
import pwd
import shutil
import signal
import socket
import subprocess
import time

NEEDED = ("slurmctld", "slurmd", "sbatch", "scontrol", "sinfo")

CONFIGURATION = """ClusterName=isostack
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmdPort={node_port}
AuthType=auth/none
CredType=cred/none
SlurmUser={user}
SlurmdUser={user}
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={megabytes} State=UNKNOWN
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class CannotStart(Exception):
    pass


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def end_with_parent():
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)  # PR_SET_PDEATHSIG: no daemon outlives the test


def is_idle():
    run = subprocess.run(["sinfo", "--noheader", "--format=%t"], capture_output=True, text=True, check=False)
    return run.stdout.strip() == "idle"


@contextlib.contextmanager
def slurm_node(folder):
    """Its configuration is in SLURM_CONF meanwhile. CannotStart with a sentence where it does not come up."""
    missing = [name for name in NEEDED if not shutil.which(name, path=os.environ["PATH"] + ":/usr/sbin")]
    if missing:
        raise CannotStart(f"Slurm is not installed ({', '.join(missing)})")
    for name in ("state", "spool"):
        (folder / name).mkdir(parents=True)
    megabytes = os.sysconf("SC_PHYS_PAGES") * os.sysconf("SC_PAGE_SIZE") // 2**20
    configuration = folder / "slurm.conf"
    host = socket.gethostname().split(".")[0]
    configuration.write_text(CONFIGURATION.format(
        host=host, controller_port=free_port(), node_port=free_port(), user=pwd.getpwuid(os.getuid()).pw_name,
        folder=folder, cpus=os.cpu_count(), megabytes=megabytes))
    os.environ["SLURM_CONF"] = str(configuration)
    os.environ["PATH"] += ":/usr/sbin"
    daemons = []
    try:
        for command in (["slurmctld", "-D", "-c"], ["slurmd", "-D", "-N", host]):
            daemons.append(subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                            preexec_fn=end_with_parent))
        deadline = time.monotonic() + 60
        while not is_idle():
            if time.monotonic() > deadline or any(daemon.poll() is not None for daemon in daemons):
                logs = "".join(path.read_text()[-500:] for path in folder.glob("slurm*.log"))
                raise CannotStart(f"Slurm does not start here: {logs}")
            time.sleep(0.5)
        yield
        subprocess.run(["scancel", "--user", pwd.getpwuid(os.getuid()).pw_name], check=False)
    finally:
        for daemon in reversed(daemons):
            daemon.terminate()
        for daemon in daemons:
            try:
                daemon.wait(timeout=20)
            except subprocess.TimeoutExpired:
                daemon.kill()
                daemon.wait()
