using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Documents;

/// <summary>Plans a job before a machine is connected: its feed over the link, its time. The driver is that of the program's machine profile.</summary>
public static class JobPlan
{
    /// <summary>The program as it will be run over this link: on a serial line that is too slow for its feed it is cut more slowly, and the finding reports it
    /// start.</summary>
    /// <param name="address">Null when no link is known: the feed is not limited.</param>
    public static LinkFeedFit FitToLink(MotionProgram program, ControllerAddress? address, ExecutionStrategy strategy, Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return DriverOf(program).LimitFeedToLink(program, address, strategy, drawing.SourceOf);
    }

    /// <summary>The same for the frame of a job, whose slower feed is not a finding.</summary>
    public static MotionProgram FitFrameToLink(MotionProgram frame, ControllerAddress? address)
    {
        var driver = DriverOf(frame);
        return driver.LimitFeedToLink(frame, address, driver.DefaultStrategy, sourceOf: null).Program;
    }

    /// <summary>The load of a link by each sequence of a program, as <see cref="IMachineDriver.LinkLoad"/>; null if the link has no limit.</summary>
    /// <param name="address">Null: a network.</param>
    public static Func<VectorSequence, double?>? LinkLoad(MotionProgram program, ControllerAddress? address, ExecutionStrategy strategy)
    {
        var driver = DriverOf(program);
        return address is null ? null : sequence => driver.LinkLoad(sequence, address, strategy);
    }

    /// <summary>Planned duration of the program over this link.</summary>
    /// <param name="program">Adapted to the link (<see cref="FitToLink"/>).</param>
    /// <param name="address">Null: as over a network.</param>
    public static MotionTimes PlannedTimes(MotionProgram program, ControllerAddress? address, ExecutionStrategy strategy) => StrokeTimes(program, address, strategy).Total;

    /// <summary>Planned duration of the program over this link, by its strokes.</summary>
    /// <param name="program">Adapted to the link (<see cref="FitToLink"/>).</param>
    /// <param name="address">Null: as over a network.</param>
    public static StrokeTimes StrokeTimes(MotionProgram program, ControllerAddress? address, ExecutionStrategy strategy) => MotionTime.ByStroke(program, DriverOf(program).LinkTimes(address, strategy));

    /// <summary>Duration of the program when the host runs it over a network.</summary>
    public static MotionTimes NetworkTimes(MotionProgram program) => MotionTime.Calculate(program, DriverOf(program).NetworkTimes);

    /// <summary>The moves and tool waits of the program, without command times.</summary>
    /// <param name="start">Position of the machine before, counts of the job frame.</param>
    public static IReadOnlyList<ScheduledMove> Pace(MotionProgram program, CountsPoint start, ProgramParts parts) => MotionSchedule.Of(program, start, DriverOf(program).NetworkTimes, parts);

    private static IMachineDriver DriverOf(MotionProgram program)
    {
        ArgumentNullException.ThrowIfNull(program);
        return MachineFamilies.DriverOf(program.Profile);
    }
}
