#!/usr/bin/env python3
"""SSIM of two PNG files by scikit-image, where the whole 11 x 11 window lies in the picture: ssim.py A B"""

import sys

from skimage.metrics import structural_similarity

import pictures

_, full = structural_similarity(pictures.read(sys.argv[1]), pictures.read(sys.argv[2]), gaussian_weights=True, sigma=1.5,
                                use_sample_covariance=False, data_range=255, channel_axis=2, full=True)
print("%.6f" % full[5:-5, 5:-5].mean())
