"""A robot's side of a talk with a CAIR server, for ROS."""
