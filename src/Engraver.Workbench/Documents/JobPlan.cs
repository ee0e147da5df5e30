using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Documents;

/// <summary>Plans a job before a machine is connected: its motion style, its feed over the link, its time.</summary>
public static class JobPlan
{
    /// <summary>The style in which a job must be prepared for a mode.</summary>
    public static MotionStyle StyleOf(JobMode mode) => mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous;

    /// <summary>The program as it will be run over this link: on a serial line that is too slow for its feed it is cut slower, and the finding says so
    /// before the start.</summary>
    /// <param name="address">Null when no link is known: nothing limits the feed.</param>
    public static LinkFeedFit FitToLink(MotionProgram program, ControllerAddress? address, JobMode mode, Drawing drawing) => MachineFamilies.Driver.FitToLink(program, address, mode, drawing.SourceOf);

    /// <summary>The same for the frame of a job, whose slower feed is no finding.</summary>
    public static MotionProgram FitFrameToLink(MotionProgram frame, ControllerAddress? address) => MachineFamilies.Driver.FitToLink(frame, address, JobMode.Stream, sourceOf: null).Program;

    /// <summary>How long the program will take over this link.</summary>
    /// <param name="program">Made fit for the link (<see cref="FitToLink"/>).</param>
    /// <param name="address">Null for none: as over a network.</param>
    public static MotionTimes PlannedTimes(MotionProgram program, ControllerAddress? address, JobMode mode) => MachineFamilies.Driver.PlannedTimes(program, address, mode);

    /// <summary>How long the program takes when the host leads it over a network.</summary>
    public static MotionTimes NetworkTimes(MotionProgram program) => MotionTime.Calculate(program, MachineFamilies.Driver.NetworkTimes);

    /// <summary>The moves of the program and its waits for the tool, without the time of commands.</summary>
    /// <param name="start">Where the machine stands before, counts of the job frame.</param>
    public static IReadOnlyList<PaceMove> Pace(MotionProgram program, CountsPoint start, ProgramParts parts) => MotionPace.Of(program, start, MachineFamilies.Driver.NetworkTimes, parts);
}
