"""Talks with people who are not there: simulated users, what is measured of a talk, the bars."""
