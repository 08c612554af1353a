"""An FMU's functions as C has them: nothing between a test and the library but ctypes.

FMPy's bindings hide what some importers do: NULL where a pointer may be NULL, arrays of no elements, a logger of their
own. A call here returns its status; `Raw.messages` holds what was logged.
"""

import ctypes
import math
from ctypes import CFUNCTYPE, c_bool, c_char_p, c_double, c_int, c_size_t, c_uint32, c_void_p

import _ctypes
from host import STEP, sequence

OK, WARNING, DISCARD, ERROR, FATAL = range(5)
LOGGER2 = CFUNCTYPE(None, c_void_p, c_char_p, c_int, c_char_p, c_char_p, c_char_p)
"""The standard's logger is variadic; where ours are called, `"%s"` and one text follow (System V passes them alike)."""
LOGGER3 = CFUNCTYPE(None, c_void_p, c_int, c_char_p, c_char_p)
INTERMEDIATE = CFUNCTYPE(
    None, c_void_p, c_double, c_bool, c_bool, c_bool, c_bool, ctypes.POINTER(c_bool), ctypes.POINTER(c_double)
)
NEWS = CFUNCTYPE(None, c_void_p)
SIGNAL = CFUNCTYPE(None)
ALLOCATE = CFUNCTYPE(c_void_p, c_size_t, c_size_t)
TYPES2 = {"Real": c_double, "Integer": c_int, "Boolean": c_int, "String": c_char_p}
TYPES3 = {"Boolean": c_bool, "String": c_char_p, "Float32": ctypes.c_float, "Float64": c_double}
TYPES3 |= {
    f"{sign}Int{bits}": getattr(ctypes, f"c_{sign.lower()}int{bits}") for sign in ("", "U") for bits in (8, 16, 32, 64)
}


class Callbacks2(ctypes.Structure):
    """`fmi2CallbackFunctions`; what is left out is NULL."""

    _fields_ = [(name, c_void_p) for name in ("logger", "allocate", "free", "finished", "environment")]


class Library:
    """A loaded library, until `close` unloads it."""

    def __init__(self, fmu):
        self.fmu = fmu
        self.dll = ctypes.CDLL(str(library_path(fmu)))

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()

    def close(self):
        """Unloads it."""
        _ctypes.dlclose(self.dll._handle)


def library_path(fmu):
    """Where the library of this platform was unpacked."""
    suffixes = (".so", ".dylib", ".dll")
    found = [path for path in fmu.folder_path().glob("binaries/*/*") if path.suffix in suffixes]
    assert len(found) == 1, found
    return found[0]


class Raw:
    """An instance. `logger` None is a NULL logger; `callbacks` None is no structure of callbacks at all (FMI 2.0)."""

    def __init__(self, library, kind, name=b"raw", logging=False, logger=True, environment=None, resources=None,
                 callbacks=True, token=None, event_mode=False, visible=False, required=(), intermediate=None,
                 clock_update=None, lock=None, unlock=None):
        self.fmu, self.kind, self.dll = library.fmu, kind, library.dll
        self.prefix = "fmi2" if self.fmu.is_fmi2 else "fmi3"
        self.messages = []
        self.closed = False
        token = (self.fmu.description.guid or "").encode() if token is None else token
        if self.fmu.is_fmi2:
            self._logger = LOGGER2(
                lambda env, name, status, category, form, text: self._log(env, name, status, category, text, form)
            )
            pointer = ctypes.cast(self._logger, c_void_p) if logger else None
            self._callbacks = Callbacks2(logger=pointer, environment=environment)
            passed = ctypes.byref(self._callbacks) if callbacks else None
            make = self._function("Instantiate", c_void_p)
            self.pointer = make(name, int(kind == "CoSimulation"), token, resources, passed, int(visible), int(logging))
        else:
            self._logger = LOGGER3(lambda env, status, category, text: self._log(env, None, status, category, text))
            pointer = self._logger if logger else None
            make = self._function("Instantiate" + kind, c_void_p)
            common = [name, token, resources, c_bool(visible), c_bool(logging)]
            if kind == "CoSimulation":
                # A dangling array of no elements, as fmusim passes it.
                names = (c_uint32 * len(required))(*required) if required else c_void_p(4)
                common += [c_bool(event_mode), c_bool(event_mode), names, c_size_t(len(required))]
                self._intermediate = INTERMEDIATE(intermediate) if intermediate else None
                self.pointer = make(*common, c_void_p(environment), pointer, self._intermediate)
            elif kind == "ScheduledExecution":
                given = [(NEWS, clock_update), (SIGNAL, lock), (SIGNAL, unlock)]
                self._kept = [of(callback) if callback else None for of, callback in given]
                self.pointer = make(*common, c_void_p(environment), pointer, *self._kept)
            else:
                self.pointer = make(*common, c_void_p(environment), pointer)

    def __enter__(self):
        assert self.pointer, self.messages
        return self

    def __exit__(self, *_):
        self.free()

    def free(self):
        """Frees the instance."""
        if self.pointer:
            self._function("FreeInstance", None)(c_void_p(self.pointer))
            self.pointer = None

    def _log(self, environment, name, status, category, text, form=None):
        self.messages.append((environment, name, status, category, text, form))

    def _function(self, name, result=c_int):
        function = getattr(self.dll, self.prefix + name)
        function.restype = result
        return function

    def call(self, name, *arguments):
        """The status of a function of the instance, by its name without `fmi2` or `fmi3`."""
        return self._function(name)(c_void_p(self.pointer), *arguments)

    def texts(self):
        """All messages as one text."""
        return "\n".join((message[4] or b"").decode() for message in self.messages)

    # Values

    def ctype(self, variable):
        """The name of a variable's getter and setter, and its C type."""
        kind = variable.type
        if kind == "Enumeration":
            kind = "Integer" if self.fmu.is_fmi2 else "Int64"
        return kind, (TYPES2 if self.fmu.is_fmi2 else TYPES3)[kind]

    def access(self, verb, variable, values):
        """The status of getting or setting a variable's elements through an array."""
        kind, _ = self.ctype(variable)
        reference = (c_uint32 * 1)(variable.valueReference)
        sizes = [] if self.fmu.is_fmi2 else [c_size_t(len(values))]
        return self.call(verb + kind, reference, c_size_t(1), values, *sizes)

    def set(self, values):
        """Sets variables by name; returns the worst status."""
        worst = OK
        for name, value in values.items():
            variable = self.fmu.variables[name]
            value = list(value) if isinstance(value, (list, tuple)) else [value]
            value = [v.encode() if isinstance(v, str) else v for v in value]
            worst = max(worst, self.access("Set", variable, (self.ctype(variable)[1] * len(value))(*value)))
        return worst

    def get(self, variables=None):
        """The bits of variables by name, of all that are computed unless named."""
        found = {}
        for variable in self.fmu.observed() if variables is None else variables:
            values = (self.ctype(variable)[1] * math.prod(variable.shape or ()))()
            status = self.access("Get", variable, values)
            assert status == OK, (variable.name, status, self.messages)
            found[variable.name] = list(values) if variable.type == "String" else bytes(values)
        return found

    # Life

    def enter_initialization(self, tolerance=None, start=0.0, stop=None):
        """The worst status on the way into Initialization Mode."""
        given = lambda value: (c_int if self.fmu.is_fmi2 else c_bool)(value is not None)
        frame = [given(tolerance), c_double(tolerance or 0.0), c_double(start), given(stop), c_double(stop or 0.0)]
        if self.fmu.is_fmi2:
            return max(self.call("SetupExperiment", *frame), self.call("EnterInitializationMode"))
        return self.call("EnterInitializationMode", *frame)

    def initialize(self, parameters=None, inputs=None, **frame):
        """From instantiated to step mode or event mode; the worst status."""
        worst = self.set(self.fmu.with_files(parameters or {}))
        worst = max(worst, self.enter_initialization(**frame))
        worst = max(worst, self.set(sequence(self.fmu, 0) if inputs is None else inputs))
        return max(worst, self.call("ExitInitializationMode"))

    def step(self, time, size=STEP):
        """The status of a step."""
        if self.fmu.is_fmi2:
            return self.call("DoStep", c_double(time), c_double(size), c_int(1))
        self.flags, self.reached = [c_bool() for _ in range(3)], c_double()
        flags = [ctypes.byref(flag) for flag in self.flags]
        return self.call("DoStep", c_double(time), c_double(size), c_bool(True), *flags, ctypes.byref(self.reached))

    def update(self):
        """The status of one round of an event iteration."""
        if self.fmu.is_fmi2:
            return self.call("NewDiscreteStates", (c_double * 8)())
        return self.call("UpdateDiscreteStates", *[ctypes.byref(c_bool()) for _ in range(5)], ctypes.byref(c_double()))

    def derivatives(self):
        """The status of reading derivatives."""
        n = self.fmu.description.numberOfContinuousStates
        name = "GetDerivatives" if self.fmu.is_fmi2 else "GetContinuousStateDerivatives"
        return self.call(name, (c_double * n)(), c_size_t(n))

    def indicators(self):
        """The status of reading event indicators."""
        n = self.fmu.description.numberOfEventIndicators
        return self.call("GetEventIndicators", (c_double * n)(), c_size_t(n))

    # State

    def take(self):
        """A status and the state taken."""
        state = c_void_p()
        name = "GetFMUstate" if self.fmu.is_fmi2 else "GetFMUState"
        return self.call(name, ctypes.byref(state)), state

    def restore(self, state):
        """The status of going back to a state."""
        return self.call("SetFMUstate" if self.fmu.is_fmi2 else "SetFMUState", state)

    def release(self, state):
        """The status of freeing a state."""
        return self.call("FreeFMUstate" if self.fmu.is_fmi2 else "FreeFMUState", ctypes.byref(state))

    def size(self, state):
        """A status and the size of a serialized state."""
        size = c_size_t()
        name = "SerializedFMUstateSize" if self.fmu.is_fmi2 else "SerializedFMUStateSize"
        return self.call(name, state, ctypes.byref(size)), size.value

    def serialized(self, state):
        """The bytes of a state."""
        status, size = self.size(state)
        assert status == OK
        data = (ctypes.c_ubyte * size)()
        name = "SerializeFMUstate" if self.fmu.is_fmi2 else "SerializeFMUState"
        assert self.call(name, state, data, c_size_t(size)) == OK
        return bytes(data)

    def deserialized(self, data):
        """A status and the state of bytes."""
        state = c_void_p()
        name = "DeSerializeFMUstate" if self.fmu.is_fmi2 else "DeserializeFMUState"
        return self.call(name, data, c_size_t(len(data)), ctypes.byref(state)), state
