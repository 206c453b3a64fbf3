#!/usr/bin/python3
"""rival_scipy.py [COUNT]: scipy's RBFInterpolator (dense), kernel r, on the first COUNT (10,000) constraints of the
contour stack of star_stack.h."""
import math
import resource
import sys
import time

import numpy
import scipy
from scipy.interpolate import RBFInterpolator


def star_point(angle, z):
    radius = 100 + 20 * math.cos(5 * angle + 0.02 * z)
    return radius * math.cos(angle), radius * math.sin(angle)


def star_stack(count):
    steps, points, slice_index = 20000, [], 0
    while len(points) < count:
        z, walked = 5.0 * slice_index, 1.0
        for i in range(steps):
            here = star_point(2 * math.pi * i / steps, z)
            following = star_point(2 * math.pi * (i + 1) / steps, z)
            along = (following[0] - here[0], following[1] - here[1])
            length = math.hypot(*along)
            if walked >= 1:
                points += [(*here, z), (here[0] - along[1] / length, here[1] + along[0] / length, z)]
                walked -= 1
            walked += length
        slice_index += 1
    return numpy.array(points[:count]), numpy.arange(count) % 2.0


count = int(sys.argv[1]) if len(sys.argv) > 1 else 10000
points, values = star_stack(count)
start = time.perf_counter()
interpolator = RBFInterpolator(points, values, kernel="linear", degree=1)
seconds = time.perf_counter() - start
peak_gb = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e9
residual = numpy.abs(interpolator(points) - values).max()
print(f"constraints {count}\nseconds {seconds:.2f}\npeak_gb {peak_gb:.2f}\nresidual {residual:.1e}")
print(f"remark scipy {scipy.__version__}")
