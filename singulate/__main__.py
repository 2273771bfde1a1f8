"""``python -m singulate``."""

import sys

from singulate.cli import main

sys.exit(main())
