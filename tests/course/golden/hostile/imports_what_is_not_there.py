"""An import that fails, before anything else."""

import a_package_that_does_not_exist
