"""What the tests have in common."""

import hypothesis

import plumb

hypothesis.settings.register_profile(
    "plumb", max_examples=40, deadline=None, derandomize=True, database=None
)
hypothesis.settings.load_profile("plumb")


def pytest_report_header() -> str:
    return f"plumb {plumb.__version__} from {plumb.__file__}"
