"""The laboratory's processes: spawned, watched, restarted; they die with the page's server."""
