"""Twin delayed deep deterministic policy gradient over continuous pushes."""
