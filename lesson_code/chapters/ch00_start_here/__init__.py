"""Start here.

Name the stages of every collision; read a check.
"""
