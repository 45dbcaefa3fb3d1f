"""The shipped damper tests are those that their program makes."""

from examples.dampers.make_dyno import DAMPERS, RECORDINGS, write_recordings


def test_the_shipped_recordings_can_be_made_again(tmp_path):
    write_recordings(tmp_path)
    for recording in RECORDINGS:
        assert (tmp_path / recording.name).read_bytes() == (DAMPERS / recording.name).read_bytes()
