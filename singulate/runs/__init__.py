"""Run directories: the only thing by which a trainer and those who watch it know each other."""

from singulate.runs.control import CONTROL_COMMANDS, ControlInbox, ControlMessage, send_control
from singulate.runs.deleting import delete_run
from singulate.runs.exporting import export_run
from singulate.runs.heartbeat import Heartbeat
from singulate.runs.listing import RunSummary, list_runs
from singulate.runs.lock import RunLock, lock_holder
from singulate.runs.naming import new_run_directory
from singulate.runs.push_record import PushRecord
from singulate.runs.reader import EventRecord, MetricSeries, RunReader, Starts
from singulate.runs.record import RunRecord
from singulate.runs.run_directory import RunDirectory
from singulate.runs.status import RunState, RunStatus, log_tail, read_status

__all__ = [
    "CONTROL_COMMANDS",
    "ControlInbox",
    "ControlMessage",
    "EventRecord",
    "Heartbeat",
    "MetricSeries",
    "PushRecord",
    "RunDirectory",
    "RunLock",
    "RunReader",
    "RunRecord",
    "RunState",
    "RunStatus",
    "RunSummary",
    "Starts",
    "delete_run",
    "export_run",
    "list_runs",
    "lock_holder",
    "log_tail",
    "new_run_directory",
    "read_status",
    "send_control",
]
