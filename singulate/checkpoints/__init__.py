"""Saved agents: safetensors and a checked manifest, written atomically, read without pickle."""

from singulate.checkpoints.latest import checkpoint_name, latest_checkpoint, list_checkpoints, prune
from singulate.checkpoints.manifest import FileEntry, Manifest
from singulate.checkpoints.reading import Checkpoint, read_checkpoint, verify_checkpoint
from singulate.checkpoints.saving import check_replaceable, save_checkpoint
from singulate.checkpoints.tensors import Tensors, decode_tensors, encode_tensors

__all__ = [
    "Checkpoint",
    "FileEntry",
    "Manifest",
    "Tensors",
    "check_replaceable",
    "checkpoint_name",
    "decode_tensors",
    "encode_tensors",
    "latest_checkpoint",
    "list_checkpoints",
    "prune",
    "read_checkpoint",
    "save_checkpoint",
    "verify_checkpoint",
]
