"""Browser tests: a package, so that its page and its Chromium end with it."""
