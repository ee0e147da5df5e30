using Engraver.Simulator.Motion;
using Engraver.Simulator.Motion.Following;
using Engraver.Simulator.Values;

namespace Engraver.Simulator;

/// <summary>The state that BN and BV save and RS restores (galil-dmc.md A.6): parameters, variables, arrays and the cam table. CF, VR, targets and positions
/// are not burned.</summary>
internal sealed class BurnedState(Machine machine)
{
    private (AxisSetup[] Axes, (double Speed, double Acceleration, double Deceleration)[] Planes, int[] Polarity) _motion = MotionOf(Prepared(machine));
    private (int Marking, int WhenBlocked, bool Echo, bool Trace, byte Outputs) _ports = PortsOf(machine);
    private (NumberFormat Position, NumberFormat Variable, bool StripZeros, int Sample) _formats = FormatsOf(machine);
    private KeyValuePair<string, FixedPoint>[] _variables = [];
    private KeyValuePair<string, FixedPoint[]>[] _arrays = [];
    private CamTable? _cam;

    /// <summary>Saves the parameters: BN.</summary>
    public void BurnParameters()
    {
        _motion = MotionOf(machine);
        _ports = PortsOf(machine);
        _formats = FormatsOf(machine);
    }

    /// <summary>Saves the variables, the arrays and the cam table: BV.</summary>
    public void BurnVariables()
    {
        _variables = [.. machine.Variables.Variables];
        _arrays = [.. machine.Variables.Arrays.Select(a => KeyValuePair.Create(a.Key, (FixedPoint[])a.Value.Clone()))];
        _cam = new CamTable(machine.Motion.Cam);
    }

    /// <summary>Restores the saved state: RS. The caller must have stopped all motion and all programs.</summary>
    public void Restore()
    {
        var motion = machine.Motion;
        for (var i = 0; i < motion.Axes.Length; i++) _motion.Axes[i].ApplyTo(motion.Axes[i], motion);
        for (var i = 0; i < motion.Planes.Length; i++) Apply(_motion.Planes[i], motion.Planes[i]);
        _motion.Polarity.CopyTo(motion.Polarity.Fields, 0);
        (machine.Messages.Marking, machine.Messages.WhenBlocked, machine.Serial.Echo) = (_ports.Marking, _ports.WhenBlocked, _ports.Echo);
        machine.Threads.IsTracing = _ports.Trace;
        machine.SetOutputs(_ports.Outputs);
        (machine.PositionFormat, machine.VariableFormat, machine.StripLeadingZeros, machine.SampleMicroseconds) = _formats;
        foreach (var (name, value) in _variables) machine.Variables.Write(name, value);
        foreach (var (name, values) in _arrays) machine.Variables.Arrays[name] = (FixedPoint[])values.Clone();
        _cam?.ApplyTo(motion.Cam);
    }

    /// <summary>Applies <see cref="SimulatorOptions.Burned"/> before the first command, so that the constructor saves it as the burned state.</summary>
    private static Machine Prepared(Machine machine)
    {
        if (machine.Options.Burned is not { } given) return machine;
        foreach (var axis in machine.Motion.Axes)
        {
            (axis.Acceleration, axis.Deceleration) = (given.Acceleration, given.Acceleration);
            if (axis.Index < given.AxisSpeeds.Count && given.AxisSpeeds[axis.Index] is { } speed) axis.CruiseSpeed = speed;
        }

        foreach (var plane in machine.Motion.Planes) Apply((given.VectorSpeed, given.Acceleration, given.Acceleration), plane);
        return machine;
    }

    private static void Apply((double Speed, double Acceleration, double Deceleration) burned, VectorPlane plane)
    {
        plane.Profile.SetSpeed(burned.Speed);
        (plane.Profile.Acceleration, plane.Profile.Deceleration, plane.Profile.SpeedRatio) = (burned.Acceleration, burned.Deceleration, 1);
        plane.Clear();
    }

    private static (AxisSetup[] Axes, (double Speed, double Acceleration, double Deceleration)[] Planes, int[] Polarity) MotionOf(Machine machine) =>
    (
        [.. machine.Motion.Axes.Select(a => new AxisSetup(a))],
        [.. machine.Motion.Planes.Select(p => (p.Profile.VectorSpeed, p.Profile.Acceleration, p.Profile.Deceleration))],
        [.. machine.Motion.Polarity.Fields]);

    private static (int Marking, int WhenBlocked, bool Echo, bool Trace, byte Outputs) PortsOf(Machine machine) =>
        (machine.Messages.Marking, machine.Messages.WhenBlocked, machine.Serial.Echo, machine.Threads.IsTracing, machine.Io.Outputs);

    private static (NumberFormat Position, NumberFormat Variable, bool StripZeros, int Sample) FormatsOf(Machine machine) =>
        (machine.PositionFormat, machine.VariableFormat, machine.StripLeadingZeros, machine.SampleMicroseconds);
}
