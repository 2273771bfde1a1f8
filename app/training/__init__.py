"""The laboratory's view of training: run directories and control messages, nothing else."""
