using Engraver.Core.Diagnostics;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts;

/// <summary>Adds up how much a program cuts, which no distance from the drawing tells: what is cut over again lies on the drawing too.</summary>
public sealed class LengthJudge : ITraceJudge
{
    /// <summary>Part of the length that roundings of the form may add along a curve.</summary>
    private const double Share = 0.001;

    /// <summary>The same of a form that rounds places coarsely: chords go from one side of the curve to the other.</summary>
    private const double CoarseShare = 0.02;

    private readonly double _expected;
    private readonly double _allowed;
    private TraceSample? _last;

    /// <param name="path">What is to be cut, each stroke once.</param>
    /// <param name="deviation">By how much an end of a move may be moved, millimetres.</param>
    /// <param name="isCoarse">The form rounds places to more than the machine counts.</param>
    public LengthJudge(Toolpath path, double deviation, bool isCoarse)
    {
        ArgumentNullException.ThrowIfNull(path);
        var moves = 0;
        foreach (var stroke in path.Strokes)
        {
            var place = stroke.Start;
            foreach (var move in stroke.Moves)
            {
                _expected += place.DistanceTo(move.Segment.Start) + move.Segment.Length; // a gap within the join tolerance is bridged
                place = move.Segment.End;
            }

            moves += stroke.Moves.Count + 1;
        }

        _allowed = (2.0 * deviation * moves) + ((isCoarse ? CoarseShare : Share) * _expected);
    }

    /// <summary>Millimetres so far.</summary>
    public double Length { get; private set; }

    /// <summary>Null while no more was cut than the job is long.</summary>
    public Diagnostic? Finding => Length <= _expected + _allowed ? null : VerificationRules.CutTwice.At(default, FactText.Of(Math.Round(Length, 4)), FactText.Of(Math.Round(_expected, 4)));

    public void Add(in TraceSample sample)
    {
        if (sample.Cutting && _last is { Cutting: true } before) Length += before.Place.DistanceTo(sample.Place);
        _last = sample;
    }

    public void Add(in TraceSpan span)
    {
        if (span.Cutting) Length += span.Path.Length;
        _last = span.At(1.0);
    }

    public TraceVerdict Verdict() => throw new NotSupportedException("A length alone is no verdict.");
}
