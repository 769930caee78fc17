"""The workbook as pages in a browser: a folder of files that needs no server and no network.

:mod:`lesson_code.course.site.build` makes it. The text, the outputs and the still figures are those
that the notebooks hold, live figures among them. Navigation, search, dark and light come from
Sphinx and Furo.
"""
