using Engraver.Core.Diagnostics;

namespace Engraver.Core.Machines;

/// <summary>How a job ended, in what the controller said and not in what was planned.</summary>
public sealed record JobResult
{
    public required JobOutcome Outcome { get; init; }

    /// <summary>What the job was lost by; null unless it ended with <see cref="JobOutcome.LinkLost"/>.</summary>
    public LinkLoss? Loss { get; init; }

    /// <summary>One sentence for the operator: what happened, where, and what to do.</summary>
    public required string Sentence { get; init; }

    public required int SegmentsSent { get; init; }

    /// <summary>By _CS or seq of the controller.</summary>
    public required int SegmentsExecuted { get; init; }

    /// <summary>Those of them that were counted while the tool was seen off though it should have been on: they have no part in <see cref="LengthByStroke"/>.</summary>
    public int SegmentsUncut { get; init; }

    /// <summary>Controller time, in nominal samples (TM).</summary>
    public required double Seconds { get; init; }

    /// <summary>How often the segment buffer ran dry before the end of a sequence was sent.</summary>
    public required int Underruns { get; init; }

    /// <summary>Number of <c>?</c> replies; buffer full (32) is none.</summary>
    public required int Rejected { get; init; }

    /// <summary>_RPA and _RPB, the controller's own absolute counts; the last known when the link was lost, null when none was ever read.</summary>
    public required CountsPoint? FinalPosition { get; init; }

    /// <summary>Controller counts at the drawing's zero: what was added to the job frame. Null when the job ended before the frame was taken.</summary>
    public required CountsPoint? FrameOrigin { get; init; }

    /// <summary>False when the link was lost before the controller said where it came to rest: it went on with what it had until its watchdog tripped, and may have cut more than is counted here.</summary>
    public bool IsEndKnown { get; init; } = true;

    /// <summary>Why the machine's position is not to be trusted from here on ("an axis could not follow"); empty while it is.</summary>
    public string PositionDoubt { get; init; } = "";

    /// <summary>The refused command that ended the job, when one did.</summary>
    public MachineRefusal? Refusal { get; init; }

    /// <summary>Positions polled during the run, job frame.</summary>
    public required IReadOnlyList<TracePoint> PolledTrace { get; init; }

    /// <summary>Drawing entities with at least one executed segment, in order of cutting.</summary>
    public required IReadOnlyList<int> ExecutedEntityIndices { get; init; }

    /// <summary>Executed segments of each stroke of the motion program.</summary>
    public required IReadOnlyList<int> ExecutedByStroke { get; init; }

    /// <summary>Cut length of each stroke in counts, whole segments only; how far the segment under way was cut is told by the unfinished segment.</summary>
    public required IReadOnlyList<double> LengthByStroke { get; init; }

    /// <summary>What had to be done to the job to run it this way: strokes cut by the controller's memory.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; init; } = [];

    /// <summary>What could not be left as it was found, a sentence each.</summary>
    public IReadOnlyList<string> NotRestored { get; init; } = [];

    /// <summary>A job that ended before the controller was told anything.</summary>
    /// <param name="strokes">Of the program.</param>
    public static JobResult NotStarted(int strokes, string sentence) => new()
    {
        Outcome = JobOutcome.Refused,
        Sentence = sentence,
        SegmentsSent = 0,
        SegmentsExecuted = 0,
        Seconds = 0,
        Underruns = 0,
        Rejected = 0,
        FinalPosition = null,
        FrameOrigin = null,
        PolledTrace = [],
        ExecutedEntityIndices = [],
        ExecutedByStroke = new int[strokes],
        LengthByStroke = new double[strokes],
    };
}

public enum JobOutcome
{
    Complete,

    /// <summary>By the operator; the machine stands.</summary>
    Stopped,

    /// <summary>The controller refused a command, was busy, or ended a motion that it should have finished.</summary>
    Refused,

    /// <summary>What was cut is not the drawing, by what the controller or the simulator's record says: the path left the drawing, or part of it was never cut.</summary>
    Deviated,

    /// <summary>The link failed, or the watchdog in the controller did not hear from this program and stopped the machine.</summary>
    LinkLost,
}

/// <summary>What a job that ended with <see cref="JobOutcome.LinkLost"/> was lost by.</summary>
public enum LinkLoss
{
    /// <summary>The link failed, or the controller fell silent.</summary>
    Link,

    /// <summary>The watchdog in the controller did not hear from this program in time and stopped the machine; the link may stand.</summary>
    Watchdog,
}

/// <summary>How a job is run on the controller (galil-dmc.md F.1).</summary>
public enum JobMode
{
    /// <summary>Vector sequences fed live into the segment buffer; progress by _CS.</summary>
    Stream,

    /// <summary>The paper's way: a program in the controller is called for each entity with assigned variables; progress by seq.</summary>
    Calls,

    /// <summary>The job itself as programs in the controller, one chunk after the other; progress by seq and _CS.</summary>
    Program,
}

/// <summary>Where a job is, from what the controller said last.</summary>
/// <param name="Stroke">Index of the stroke under way.</param>
/// <param name="X">Counts, job frame.</param>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="Outputs">Outputs 1 to 8 (_OP0), bit 0 is output 1; null where nobody asked.</param>
public readonly record struct JobProgress(int Stroke, int SegmentsSent, int SegmentsExecuted, int SegmentCount, int X, int Y, bool ToolOn, double Seconds, int? Outputs = null);

/// <summary>A polled position.</summary>
/// <param name="Seconds">Controller time since the job began.</param>
/// <param name="X">Counts, job frame.</param>
/// <param name="ToolOn">Whether the tool output was on, as the controller said.</param>
public readonly record struct TracePoint(double Seconds, int X, int Y, bool ToolOn)
{
    /// <summary>Segments that were known to be done before this poll: the tool is on the next of them, or further.</summary>
    public int Executed { get; init; }
}

/// <summary>A command that the controller refused.</summary>
/// <param name="Code">The controller's number for the reason; compare this, never the text.</param>
/// <param name="Text">The controller's own words for it.</param>
/// <param name="Command">What was refused.</param>
/// <param name="Sentence">For the operator: what was refused, why, and what that means here.</param>
public sealed record MachineRefusal(int Code, string Text, string Command, string Sentence);
