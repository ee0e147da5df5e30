using Engraver.Simulator.Motion;
using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language.Commands;

/// <summary>Begin and motor state (galil-dmc.md B.1, C).</summary>
internal static class IndependentCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("BG", CommandScope.Both, Begin),
        new("SH", CommandScope.Both, r => SwitchMotors(r, off: false)),
        new("MO", CommandScope.Both, r => SwitchMotors(r, off: true)),
    ];

    private static void Begin(StatementReader reader)
    {
        var motion = reader.Machine.Motion;
        var selection = reader.TakeAxes();
        Axis[] axes = [.. selection.AxesOrAll];
        foreach (var axis in axes) CheckAxis(motion, axis);

        foreach (var plane in selection.Planes) CheckPlane(motion, plane);

        // Everything is checked before anything starts: BG is one command, not one per axis.
        selection.Planes.ForEach(p => p.Begin());
        Array.ForEach(axes, a => a.Begin());
    }

    /// <summary>BG is refused with TC 20, 21, 22 or 29 (A.8).</summary>
    public static void CheckAxis(MotionKernel motion, Axis axis)
    {
        Refuse(axis.MotorOff && axis.Index < Axis.Real, Tc.MotorOff);
        Refuse(axis.IsMoving || axis.IsSmoothing, Tc.BeginWhileRunning);
        Refuse(motion.IsCoordinated(axis), Tc.CoordinatedMove);
        CheckModes(motion, axis);
        var heading = axis.PendingHeading();
        Refuse(heading != 0 && axis.RunsIntoLimit(heading, out _), Tc.BeginAtLimit);
        Refuse(axis.PendingTarget() is { } end && (IsBeyond(end, axis)), Tc.BeginAtLimit);
    }

    /// <summary>Refuses other motion of an axis in contour mode (TC 18) or on the cam (TC 104).</summary>
    public static void CheckModes(MotionKernel motion, Axis axis)
    {
        Refuse(motion.Contour.Drives(axis), Tc.NotWhileContouring);
        Refuse(motion.IsOnCam(axis), Tc.NotOnCamSlave);
    }

    /// <summary>The move's target is beyond a software limit; such a move does not start (C, BL/FL).</summary>
    private static bool IsBeyond(long target, Axis axis) => target > axis.ForwardSoftLimit || target < axis.ReverseSoftLimit;

    private static void CheckPlane(MotionKernel motion, VectorPlane plane)
    {
        Refuse(plane.IsActive, Tc.BeginWhileRunning);
        Refuse(plane.Buffer.IsEmpty, Tc.NoSequence);
        foreach (var axis in plane.Axes)
        {
            Refuse(axis.MotorOff && axis.Index < Axis.Real, Tc.MotorOff);
            Refuse(axis.IsMoving || axis.IsSmoothing, Tc.BeginWhileRunning);
            CheckModes(motion, axis);
        }
    }

    private static void SwitchMotors(StatementReader reader, bool off)
    {
        Axis[] axes = [.. reader.TakeAxes().AxesOrAll];
        Refuse(Array.Exists(axes, reader.Machine.Motion.IsBusy), Tc.NotWhileRunning);
        foreach (var axis in axes)
        {
            // SH sets the commanded position to the motor position (C, SH).
            if (!off && axis.MotorOff) axis.TakeMotorPosition();
            axis.MotorOff = off;
        }
    }

    private static void Refuse(bool condition, int code)
    {
        if (condition) throw new CommandRefusedException(code);
    }
}
