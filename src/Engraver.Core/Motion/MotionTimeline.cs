using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>A motion program laid out in time, by the same trapezoids, settle times and command times as <see cref="MotionTime"/>.</summary>
/// <remarks>The tool is on from the settle before the first to the settle after the last sequence of a stroke.</remarks>
public sealed class MotionTimeline
{
    private readonly SpanColumn _spans;

    /// <summary>For each stroke its first sequence among those of all strokes; one more than there are strokes.</summary>
    private readonly int[] _firstSequences;

    /// <summary>For each sequence the span in which it is cut; 0 where it takes no time.</summary>
    private readonly int[] _cuts;
    private readonly CommandTimes _commands;

    private MotionTimeline(MotionProgram program, CommandTimes commands)
    {
        (Program, _commands) = (program, commands);
        _firstSequences = new int[program.Strokes.Count + 1];
        for (var stroke = 0; stroke < program.Strokes.Count; stroke++) _firstSequences[stroke + 1] = _firstSequences[stroke] + program.Strokes[stroke].Sequences.Count;
        (_spans, _cuts) = (new SpanColumn(program, _firstSequences), new int[_firstSequences[^1]]);
    }

    public MotionProgram Program { get; }

    /// <summary>Speed over time of X and of Y in a rapid, counts.</summary>
    public IReadOnlyList<SpeedTrapezoid> RapidOf(in MotionSpan span)
    {
        var (from, to, profile) = (span.From, span.To, Program.Profile);
        return [.. profile.Axes.All.Take(2).Select((axis, i) => new SpeedTrapezoid(Math.Abs((double)to[i] - from[i]), _commands.RapidSpeed(profile, axis), profile.RapidAcceleration(axis)))];
    }

    /// <summary>Without gaps, in the order of time; spans without duration are left out.</summary>
    public IReadOnlyList<MotionSpan> Spans => _spans;

    /// <summary>Seconds of the whole job; 0 when there is nothing to cut.</summary>
    public double Seconds => _spans.End;

    /// <param name="commands">The times at rest, and the speeds of the machine.</param>
    public static MotionTimeline From(MotionProgram program, CommandTimes commands, CancellationToken cancellation)
    {
        var timeline = new MotionTimeline(program, commands);
        var at = program.Start;
        if (program is { Strokes.Count: > 0, Profile.Height: not null } && MotionTime.ToolAt(at, on: false, null, program, commands) is var raise) timeline.Add(SpanColumn.SpanPart.Raise, raise.Dwell + raise.Rapid, 0, 0);
        for (var stroke = 0; stroke < program.Strokes.Count; stroke++)
        {
            cancellation.ThrowIfCancellationRequested();
            timeline.AddStroke(stroke, at);
            at = program.Strokes[stroke].Sequences[^1].End;
        }

        if (program is { Finish: { } finish, Strokes.Count: > 0 }) timeline.AddFinish(at, finish);
        return timeline;
    }

    /// <summary>The span at a time; times before and after the job belong to the first and the last.</summary>
    /// <returns>Its index; -1 when there is none.</returns>
    public int SpanAt(double seconds) => _spans.At(seconds);

    /// <summary>The span in which a sequence is cut.</summary>
    /// <param name="sequence">Index among the sequences of all strokes.</param>
    public MotionSpan CutOf(int sequence) => _spans[_cuts[sequence]];

    private void AddStroke(int index, CountsPoint from)
    {
        var stroke = Program.Strokes[index];
        var rapid = MotionTime.RapidTo(stroke.Start, from, Program, _commands) + MotionTime.Ready(from, stroke.Terms, _commands);
        Add(SpanColumn.SpanPart.Wait, rapid.Dwell, index, 0);
        Add(SpanColumn.SpanPart.Rapid, rapid.Rapid, index, 0);
        var on = MotionTime.ToolAt(stroke.Start, on: true, stroke.Terms, Program, _commands);
        for (var i = 0; i < stroke.Sequences.Count; i++)
        {
            var cut = MotionTime.Cut(stroke.Sequences[i], Program, _commands);
            Add(SpanColumn.SpanPart.Load, cut.Dwell, index, i);
            if (i == 0) Add(SpanColumn.SpanPart.ToolOn, on.Dwell + on.Rapid, index, 0);
            if (cut.Cutting > 0.0) _cuts[_firstSequences[index] + i] = _spans.Count;
            Add(SpanColumn.SpanPart.Cut, cut.Cutting, index, i);
        }

        var last = stroke.Sequences.Count - 1;
        Add(SpanColumn.SpanPart.Dwell, MotionTime.Dwell(stroke.Sequences[last].End, stroke.Terms, _commands).Dwell, index, last);
        var off = MotionTime.ToolAt(stroke.Sequences[last].End, on: false, stroke.Terms, Program, _commands);
        Add(SpanColumn.SpanPart.ToolOff, off.Dwell + off.Rapid, index, last);
    }

    /// <summary>The move to the finish of the program belongs to its last sequence.</summary>
    private void AddFinish(CountsPoint from, CountsPoint finish)
    {
        var (stroke, sequence) = (Program.Strokes.Count - 1, Program.Strokes[^1].Sequences.Count - 1);
        var rapid = MotionTime.RapidTo(finish, from, Program, _commands);
        Add(SpanColumn.SpanPart.ToolOff, rapid.Dwell, stroke, sequence); // it waits at the end of the last sequence
        Add(SpanColumn.SpanPart.Finish, rapid.Rapid, stroke, sequence);
    }

    private void Add(SpanColumn.SpanPart part, double seconds, int stroke, int sequence)
    {
        if (seconds > 0.0) _spans.Add(part, seconds, _firstSequences[stroke] + sequence);
    }
}
