# SPDX-License-Identifier: GPL-3.0-or-later
"""Tiprub in Python: read responses, read and write models, hand over matrices, run cases and studies, and draw.

Units are those of the files: SI, with frequencies in Hz. Speeds of rotation that a caller gives are in rpm. h5py and numpy
suffice for models; xarray and pandas are needed for responses, scipy for matrices, matplotlib for plots, and the installed
programs and make for runs.
"""
from . import plots
from .models import Model, ModelError
from .responses import Response, open_response
from .runs import RunError, run, study
from .sector_matrices import matrices
from .units import mm, rad_per_s, rpm

__all__ = ["Model", "ModelError", "Response", "RunError", "matrices", "mm", "open_response", "plots", "rad_per_s", "rpm", "run", "study"]
__version__ = "0.1.0"
