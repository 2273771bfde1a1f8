"""The dashboard: a viser page over the laboratory's processes."""
