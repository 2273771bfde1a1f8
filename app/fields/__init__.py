"""Pictures of fields over the table: arrays in, colours and small pieces of HTML out."""
