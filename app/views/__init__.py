"""What is drawn in three dimensions: the table and all that stands, moves or lies on it."""
