"""Who may open the page, and what a browser may send."""

from app.security.access import AccessPolicy, answer_request
from app.security.connection import GuardedConnection
from app.security.messages import is_acceptable

__all__ = ["AccessPolicy", "GuardedConnection", "answer_request", "is_acceptable"]
