"""The exercises' tasks, wrong models, isolation of student code, reports."""
