#!/usr/bin/env python3
"""LDR-FLIP of two PNG files, written from the paper (Andersson et al. 2020) apart from sim/compare/flip.cpp: flip.py A B

Filters are whole two-dimensional kernels here, summed neighbour by neighbour; prints the mean.
"""

import sys

import numpy as np

import pictures

PPD = 3840 * np.pi / 180
WHITE = np.array([0.950428545, 1.0, 1.088900371])
RGB_TO_XYZ = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                       [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                       [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])


def linear(codes):
    c = codes / 255.0
    return np.where(c > 0.04045, ((c + 0.055) / 1.055) ** 2.4, c / 12.92)


def relative_xyz(rgb):
    return rgb @ RGB_TO_XYZ.T / WHITE


def opponents(v):
    return np.stack([116 * v[..., 1] - 16, 500 * (v[..., 0] - v[..., 1]), 200 * (v[..., 1] - v[..., 2])], -1)


def rgb_of_ycxcz(c):
    y = (c[..., 0] + 16) / 116
    xyz = np.stack([y + c[..., 1] / 500, y, y - c[..., 2] / 200], -1) * WHITE
    return xyz @ np.linalg.inv(RGB_TO_XYZ).T


def hunt_lab(rgb):
    v = relative_xyz(rgb)
    lab = opponents(np.where(v > (6 / 29) ** 3, np.cbrt(v), v / (3 * (6 / 29) ** 2) + 4 / 29))
    return np.concatenate([lab[..., :1], 0.01 * lab[..., :1] * lab[..., 1:]], -1)


def convolved(plane, kernel):
    r = kernel.shape[0] // 2
    padded = np.pad(plane, r, mode="edge")
    out = np.zeros_like(plane)
    height, width = plane.shape
    for dy in range(2 * r + 1):
        for dx in range(2 * r + 1):
            out += kernel[dy, dx] * padded[dy:dy + height, dx:dx + width]
    return out


def grid(radius):
    return np.meshgrid(np.arange(-radius, radius + 1), np.arange(-radius, radius + 1))


def sensitivity(*terms):
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * PPD))
    x, y = grid(radius)
    d2 = (x / PPD) ** 2 + (y / PPD) ** 2
    kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * d2 / b) for a, b in terms)
    return kernel / kernel.sum()


CSF = [sensitivity((1, 0.0047)), sensitivity((1, 0.0053)), sensitivity((34.1, 0.04), (13.5, 0.025))]


def features(plane, second):
    sd = 0.5 * 0.082 * PPD
    x, y = grid(int(np.ceil(3 * sd)))
    kernel = (x ** 2 / sd ** 2 - 1 if second else -x) * np.exp(-(x ** 2 + y ** 2) / (2 * sd ** 2))
    kernel = np.where(kernel < 0, kernel / -kernel[kernel < 0].sum(), kernel / kernel[kernel > 0].sum())
    return np.hypot(convolved(plane, kernel), convolved(plane, kernel.T))


def seen(codes):
    c = opponents(relative_xyz(linear(codes)))
    blurred = np.stack([convolved(c[..., i], CSF[i]) for i in range(3)], -1)
    y = (c[..., 0] + 16) / 116
    return hunt_lab(np.clip(rgb_of_ycxcz(blurred), 0, 1)), features(y, False), features(y, True)


def distance(a, b):
    d = a - b
    return (np.abs(d[..., 0]) + np.hypot(d[..., 1], d[..., 2])) ** 0.7


def flip(a, b):
    (color_a, edge_a, point_a), (color_b, edge_b, point_b) = seen(a), seen(b)
    largest = distance(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1])))
    knee, d = 0.4 * largest, distance(color_a, color_b)
    color = np.where(d < knee, 0.95 / knee * d, 0.95 + (d - knee) / (largest - knee) * 0.05)
    feature = (np.maximum(np.abs(edge_a - edge_b), np.abs(point_a - point_b)) / np.sqrt(2)) ** 0.5
    return color ** (1 - feature)


if __name__ == "__main__":
    print("%.6f" % flip(pictures.read(sys.argv[1]), pictures.read(sys.argv[2])).mean())
