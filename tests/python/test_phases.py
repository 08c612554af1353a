"""In every phase of every way to live: states can be taken and restored, wrong calls are refused, and a reset mends all."""

import pytest
from phases import LIVES, forbidden, leave, lives, made, observed, onward, reach
from raw import ERROR, OK, Library


def cases(fmu):
    """Ways to live and their phases."""
    return [(life, phase) for life in lives(fmu) for phase in LIVES[life]]


def test_a_state_can_be_taken_in_every_phase_and_restored_from_every_later_one(fmu):
    """What follows is the same to the bit: at once, from the end, after a reset, and in another instance."""
    with Library(fmu) as library:
        for life, phase in cases(fmu):
            with made(library, life) as instance, made(library, life) as other:
                reach(instance, life, phase)
                status, state = instance.take()
                assert status == OK, (life, phase)
                expected = onward(instance, life, phase)
                assert instance.restore(state) == OK
                assert onward(instance, life, phase) == expected, (life, phase)
                assert instance.call("Reset") == OK
                assert instance.restore(state) == OK
                assert onward(instance, life, phase) == expected, (life, phase)
                data = instance.serialized(state)
                status, copy = other.deserialized(data)
                assert (status, other.restore(copy)) == (OK, OK), other.messages
                assert onward(other, life, phase) == expected, (life, phase)
                assert (other.release(copy), instance.release(state)) == (OK, OK)
                assert instance.messages == other.messages == []


def test_a_reset_in_every_phase_gives_a_fresh_instance(fmu):
    """What follows is what a new instance does."""
    with Library(fmu) as library:
        for life, phase in cases(fmu):
            with made(library, life) as fresh:
                expected = onward(fresh, life, "Instantiated")
            with made(library, life) as instance:
                reach(instance, life, phase)
                assert instance.call("Reset") == OK
                assert onward(instance, life, "Instantiated") == expected, (life, phase)


def test_a_wrong_call_is_refused_and_changes_nothing(fmu):
    """Error, and a message that is logged though logging is off; values stay; a restored state goes on; so does a reset."""
    count = 0
    with Library(fmu) as library:
        for life, phase in cases(fmu):
            with made(library, life) as instance:
                reach(instance, life, phase)
                before = observed(instance, phase)
                status, state = instance.take()
                assert status == OK
                expected = onward(instance, life, phase)
                for name, call in forbidden(instance, phase).items():
                    count += 1
                    assert instance.restore(state) == OK
                    del instance.messages[:]
                    assert call() == ERROR, (life, phase, name)
                    assert [message[2] for message in instance.messages] == [ERROR], (life, phase, name)
                    assert observed(instance, phase) == before, (life, phase, name)
                    # An instance that has failed takes nothing but a state or a reset.
                    assert instance.call("Terminate") == ERROR
                assert instance.restore(state) == OK
                assert onward(instance, life, phase) == expected, (life, phase)
                assert instance.release(state) == OK
    assert count > 50


@pytest.mark.parametrize("steps", [0, 1])
def test_a_reset_after_a_wrong_call_gives_a_fresh_instance(fmu, steps):
    """In every phase, after each of the calls that are wrong there; with the first call of its life among them."""
    with Library(fmu) as library:
        for life, phase in cases(fmu):
            with made(library, life) as instance:
                expected = onward(instance, life, "Instantiated")
                for call in list(forbidden(instance, phase).values())[steps::4]:
                    assert instance.call("Reset") == OK
                    reach(instance, life, phase)
                    assert call() == ERROR
                assert instance.call("Reset") == OK
                assert onward(instance, life, "Instantiated") == expected, (life, phase)


def test_an_instance_can_be_freed_in_every_phase(fmu):
    """Also right after a wrong call."""
    with Library(fmu) as library:
        for life, phase in cases(fmu):
            for wrong in (False, True):
                with made(library, life) as instance:
                    reach(instance, life, phase)
                    if wrong:
                        assert instance.call("ExitInitializationMode" if phase != "Initialization" else "Terminate") == ERROR
                    instance.free()
