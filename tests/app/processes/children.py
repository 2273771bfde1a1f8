"""Functions that the tests run in real child processes."""

import os
import time


def echo(connection, prefix=""):
    """Send everything back."""
    while True:
        connection.send((prefix, connection.recv()))


def fail(connection):
    """End with an error once a message arrives."""
    connection.recv()
    raise RuntimeError("the third wheel came off")


def niceness(connection):
    """Tell how nice this process is."""
    connection.send(os.nice(0))
    connection.recv()


def flood(connection):
    """Send without end."""
    number = 0
    while True:
        connection.send((number, b"x" * 1000))
        number += 1


def sleep_without_reading(connection):
    """Never look at the pipe."""
    connection.send(os.getpid())
    time.sleep(600)
