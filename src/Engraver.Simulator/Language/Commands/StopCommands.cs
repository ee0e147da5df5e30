using Engraver.Simulator.Motion;

namespace Engraver.Simulator.Language.Commands;

/// <summary>ST and AB with their side effects (galil-dmc.md A.7, B.8).</summary>
internal static class StopCommands
{
    public static IEnumerable<CommandEntry> Entries { get; } =
    [
        new("ST", CommandScope.Both, Stop),
        new("AB", CommandScope.Both, Abort),
    ];

    /// <summary>ST without axes stops every axis and plane and, from a host only, also ends the programs.</summary>
    private static void Stop(StatementReader reader)
    {
        var machine = reader.Machine;
        var selection = reader.TakeAxes();
        IEnumerable<Axis> axes = selection.IsEmpty ? machine.Motion.Axes : selection.Axes;
        IEnumerable<VectorPlane> planes = selection.IsEmpty ? machine.Motion.Planes : selection.Planes;
        foreach (var plane in planes) plane.Stop(StopCode.Stopped);

        foreach (var axis in axes)
        {
            machine.Motion.ReleaseAxis(axis, StopCode.Stopped);
            axis.Stop(StopCode.Stopped);
        }

        if (selection.IsEmpty && !reader.Context.IsProgram) machine.Threads.HaltAll();
    }

    private static void Abort(StatementReader reader)
    {
        var motionOnly = !reader.IsAtEnd && reader.TakeExpression().Integer == 1;
        reader.ExpectEnd();
        reader.Machine.Abort(!motionOnly, StopCode.Aborted);
    }
}
