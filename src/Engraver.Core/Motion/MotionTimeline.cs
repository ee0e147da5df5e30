using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>A motion program laid out in time, by the same trapezoids, settle times and command times as <see cref="MotionTime"/>.</summary>
/// <remarks>The tool is on from the settle before the first to the settle after the last sequence of a stroke.</remarks>
public sealed class MotionTimeline
{
    private readonly List<MotionSpan> _spans = [];

    private readonly CommandTimes _commands;

    private MotionTimeline(MotionProgram program, CommandTimes commands) => (Program, _commands) = (program, commands);

    public MotionProgram Program { get; }

    /// <summary>Speed over time of X and of Y in a rapid, counts.</summary>
    public IReadOnlyList<SpeedTrapezoid> RapidOf(in MotionSpan span)
    {
        var (from, to, profile) = (span.From, span.To, Program.Profile);
        return [.. profile.Axes.All.Take(2).Select((axis, i) => new SpeedTrapezoid(Math.Abs((double)to[i] - from[i]), _commands.RapidSpeed(profile, axis), profile.AccelerationCounts))];
    }

    /// <summary>Without gaps, in the order of time; spans of no time are left out.</summary>
    public IReadOnlyList<MotionSpan> Spans => _spans;

    /// <summary>Seconds of the whole job; 0 when there is nothing to cut.</summary>
    public double Seconds => _spans.Count == 0 ? 0.0 : _spans[^1].End;

    /// <param name="commands">How long the machine stands, and how fast it travels.</param>
    public static MotionTimeline From(MotionProgram program, CommandTimes commands, CancellationToken cancellation)
    {
        var timeline = new MotionTimeline(program, commands);
        var at = program.Start;
        if (program is { Strokes.Count: > 0, Profile.Height: not null } && MotionTime.ToolAt(at, on: false, program, commands) is var raise) timeline.Add(MotionSpanKind.Dwell, raise.Dwell + raise.Rapid, 0, 0, at, at, toolOn: false);
        for (var stroke = 0; stroke < program.Strokes.Count; stroke++)
        {
            cancellation.ThrowIfCancellationRequested();
            timeline.AddStroke(stroke, at);
            at = program.Strokes[stroke].Sequences[^1].End;
        }

        if (program is { Finish: { } finish, Strokes.Count: > 0 }) timeline.AddFinish(at, finish);
        return timeline;
    }

    /// <summary>The span at a moment; moments before and after the job belong to the first and the last.</summary>
    /// <returns>Its index; -1 when there is none.</returns>
    public int SpanAt(double seconds)
    {
        var (low, high) = (0, _spans.Count - 1);
        while (low < high)
        {
            var middle = (low + high + 1) / 2;
            if (_spans[middle].Start <= seconds) low = middle;
            else high = middle - 1;
        }

        return high;
    }

    private void AddStroke(int index, CountsPoint from)
    {
        var stroke = Program.Strokes[index];
        var rapid = MotionTime.RapidTo(stroke.Start, from, Program, _commands);
        Add(MotionSpanKind.Dwell, rapid.Dwell, index, 0, from, from, toolOn: false);
        Add(MotionSpanKind.Rapid, rapid.Rapid, index, 0, from, stroke.Start, toolOn: false);
        var on = MotionTime.ToolAt(stroke.Start, on: true, Program, _commands);
        for (var i = 0; i < stroke.Sequences.Count; i++)
        {
            var sequence = stroke.Sequences[i];
            var cut = MotionTime.Cut(sequence, Program, _commands);
            Add(MotionSpanKind.Dwell, cut.Dwell, index, i, sequence.Start, sequence.Start, toolOn: i > 0);
            if (i == 0) Add(MotionSpanKind.Dwell, on.Dwell + on.Rapid, index, 0, sequence.Start, sequence.Start, toolOn: true);
            Add(MotionSpanKind.Cut, cut.Cutting, index, i, sequence.Start, sequence.End, toolOn: true);
        }

        var last = stroke.Sequences.Count - 1;
        var off = MotionTime.ToolAt(stroke.Sequences[last].End, on: false, Program, _commands);
        Add(MotionSpanKind.Dwell, off.Dwell + off.Rapid, index, last, stroke.Sequences[last].End, stroke.Sequences[last].End, toolOn: false);
    }

    /// <summary>The way to where the program finishes belongs to its last sequence.</summary>
    private void AddFinish(CountsPoint from, CountsPoint finish)
    {
        var (stroke, sequence) = (Program.Strokes.Count - 1, Program.Strokes[^1].Sequences.Count - 1);
        var rapid = MotionTime.RapidTo(finish, from, Program, _commands);
        Add(MotionSpanKind.Dwell, rapid.Dwell, stroke, sequence, from, from, toolOn: false);
        Add(MotionSpanKind.Rapid, rapid.Rapid, stroke, sequence, from, finish, toolOn: false);
    }

    private void Add(MotionSpanKind kind, double seconds, int stroke, int sequence, CountsPoint from, CountsPoint to, bool toolOn)
    {
        if (seconds > 0.0) _spans.Add(new MotionSpan(kind, Seconds, seconds, stroke, sequence, from, to, toolOn));
    }
}
