# -*- coding: utf-8 -*-
"""A talk with a CAIR server on Pepper and NAO: says, listens, and does what is planned."""
