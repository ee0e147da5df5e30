using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>The moves of a motion program one after the other, each with its duration and with the time that the machine waits before it after the last
/// switching; commands take no time here. For a tool that an output switches.</summary>
/// <remarks>A program that is loaded in parts may lift the tool where a part ends in the middle of a stroke, and starts the spindle again in each
/// part.</remarks>
public sealed class MotionSchedule
{
    /// <summary>A part ends at a segment's end where the machine came to rest this near to it, counts: after arcs its position may differ from whole
    /// counts.</summary>
    private const double AtEnd = 2.0;

    /// <summary>Times that differ by less than this do not decide which of two segments' ends it was: samples of the controller.</summary>
    private const double SimilarSeconds = 0.003;

    private readonly MotionProgram _program;
    private readonly CommandTimes _commands;
    private readonly ProgramParts _parts;
    private readonly List<ScheduledMove> _moves = [];
    private double _wait;

    private MotionSchedule(MotionProgram program, CommandTimes commands, ProgramParts parts) => (_program, _commands, _parts) = (program, commands, parts);

    /// <param name="start">Position of the machine before the first move, counts of the job frame.</param>
    /// <param name="commands">The speeds of the machine.</param>
    /// <param name="parts">The parts into which the program was divided.</param>
    public static IReadOnlyList<ScheduledMove> Of(MotionProgram program, CountsPoint start, CommandTimes commands, ProgramParts parts)
    {
        ArgumentNullException.ThrowIfNull(program);
        ArgumentNullException.ThrowIfNull(commands);
        ArgumentNullException.ThrowIfNull(parts);
        return new MotionSchedule(program, commands, parts).From(start);
    }

    private List<ScheduledMove> From(CountsPoint at)
    {
        var profile = _program.Profile;
        foreach (var stroke in _program.Strokes)
        {
            if (_parts.BeginAfter(_moves.Count)) _wait += profile.Spindle?.SpinUpSeconds ?? 0.0;
            Add(MotionTime.RapidTo(stroke.Start, at, _program, _commands).Rapid, stroke.Start);
            _wait = profile.ToolSettleSeconds + (stroke.Terms?.PierceSeconds ?? 0.0); // from the last switch on, also where there is no rapid between two strokes
            foreach (var sequence in stroke.Sequences) Cut(sequence, stroke.Terms);
            at = stroke.Sequences[^1].End;
            _wait += profile.OffSettleSeconds;
        }

        return _moves;
    }

    /// <summary>One sequence, divided as the parts of the program divide it.</summary>
    private void Cut(VectorSequence sequence, StrokeTerms? terms)
    {
        for (VectorSequence? rest = sequence; rest is not null;)
        {
            if (_parts.BeginAfter(_moves.Count)) _wait = _program.Profile.ToolSettleSeconds + (terms?.PierceSeconds ?? 0.0);
            var head = _parts.LastBefore(_moves.Count + 1) is { } last ? UpTo(last, rest) : rest;
            Add(Seconds(head), head.End, head.Segments.Count);
            rest = head.Segments.Count == rest.Segments.Count ? null : rest with { Start = head.End, Segments = [.. rest.Segments.Skip(head.Segments.Count)] };
        }
    }

    /// <summary>The part of a sequence up to the point where a move ended: where the path reaches that point several times, the part with a similar duration,
    /// of these the nearest. The whole sequence where there is none.</summary>
    private VectorSequence UpTo(ScheduledMove last, VectorSequence sequence)
    {
        var end = _program.Profile.Scale.Exact(last.End);
        double Away(CountsPoint place) => double.Hypot(end.X - place.X, end.Y - place.Y);
        var heads = Enumerable.Range(1, sequence.Segments.Count)
            .Where(count => Away(sequence.Segments[count - 1].End) <= AtEnd)
            .Select(count => count == sequence.Segments.Count ? sequence : sequence with { Segments = [.. sequence.Segments.Take(count)] })
            .Select(head => (Sequence: head, Other: Math.Abs(Seconds(head) - last.Seconds)))
            .ToList();
        if (heads.Count == 0) return sequence;
        var similar = heads.Min(head => head.Other) + SimilarSeconds;
        return heads.Where(head => head.Other <= similar).MinBy(head => Away(head.Sequence.End)).Sequence;
    }

    private double Seconds(VectorSequence sequence) => MotionTime.Cut(sequence, _program, _commands).Cutting;

    private void Add(double seconds, CountsPoint end, int segments = 0)
    {
        if (!(seconds > 0.0)) return;
        _moves.Add(new ScheduledMove(seconds, _wait, _program.Profile.Scale.ToMillimetres(end.X, end.Y)) { Segments = segments });
        _wait = 0.0;
    }
}
