"""The authoring admin: where experts write, test and publish what the robot says."""
