#!/bin/sh
# Runs a program on a screen of its own with software GL, so that windows and 3D views are real without hardware.
export LIBGL_ALWAYS_SOFTWARE=1 QT_QPA_PLATFORM=xcb
exec xvfb-run -a -s "-screen 0 1600x1000x24" "$@"
