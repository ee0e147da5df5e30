using Engraver.Core.Drawings;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Documents;

/// <summary>Plans a job before a machine is connected: its motion style, feed over the link and duration.</summary>
public static class JobPlan
{
    /// <summary>The motion style required by a mode.</summary>
    public static MotionStyle StyleOf(JobMode mode) => mode == JobMode.Calls ? MotionStyle.Calls : MotionStyle.Continuous;

    /// <summary>The program as run over this link: a serial line that is too slow for the feed reduces the feed, which a finding reports before the
    /// start.</summary>
    /// <param name="address">Null if no link is known: the feed is not limited.</param>
    public static LinkFeedFit FitToLink(MotionProgram program, ControllerAddress? address, JobMode mode, Drawing drawing) => MachineFamilies.Driver.FitToLink(program, address, mode, drawing.SourceOf);

    /// <summary>The same for a frame run, without a finding for the reduced feed.</summary>
    public static MotionProgram FitFrameToLink(MotionProgram frame, ControllerAddress? address) => MachineFamilies.Driver.FitToLink(frame, address, JobMode.Stream, sourceOf: null).Program;

    /// <summary>Duration of the program over this link.</summary>
    /// <param name="program">With feeds limited to the link (<see cref="FitToLink"/>).</param>
    /// <param name="address">Null: as over a network.</param>
    public static MotionTimes PlannedTimes(MotionProgram program, ControllerAddress? address, JobMode mode) => MachineFamilies.Driver.PlannedTimes(program, address, mode);

    /// <summary>Duration of the program when the host streams it over a network.</summary>
    public static MotionTimes NetworkTimes(MotionProgram program) => MotionTime.Calculate(program, MachineFamilies.Driver.NetworkTimes);

    /// <summary>The moves and tool waits of the program, without command times.</summary>
    /// <param name="start">Start position of the machine, counts of the job frame.</param>
    public static IReadOnlyList<PaceMove> Pace(MotionProgram program, CountsPoint start, ProgramParts parts) => MotionPace.Of(program, start, MachineFamilies.Driver.NetworkTimes, parts);
}
