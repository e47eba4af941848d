# Copyright (c) 2026 The Spider developers.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The parts of the report: tables, plots, renderings, and the page's template."""
