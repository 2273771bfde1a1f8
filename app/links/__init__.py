"""The laboratory's ends of its processes: what was last heard, and what to ask next."""
