"""The panels beside the table: one file each, made of viser's widgets, fed with snapshots."""
