using Engraver.Core.Diagnostics;
using Engraver.Core.Toolpaths;
using Engraver.Core.Verification;

namespace Engraver.Core.Posts;

/// <summary>Adds up the length that a program cuts, which distances from the drawing do not show: repeated cuts are also on the drawing.</summary>
public sealed class LengthJudge : ITraceJudge
{
    /// <summary>Fraction of the length that rounding in the format can add along a curve.</summary>
    private const double Share = 0.001;

    /// <summary>The same for a format with coarse rounding: chords alternate between both sides of the curve.</summary>
    private const double CoarseShare = 0.02;

    private readonly double _expected;
    private readonly double _allowed;
    private readonly bool _isWhole;
    private TraceSample? _last;

    /// <param name="path">The path to cut, each stroke once.</param>
    /// <param name="deviation">Largest shift of an end of a move, millimetres.</param>
    /// <param name="isWhole">The program must cut the whole length: a path that it does not repeat is not otherwise found.</param>
    /// <param name="isCoarse">True when the format rounds positions to more than one machine count.</param>
    public LengthJudge(Toolpath path, double deviation, bool isCoarse, bool isWhole)
    {
        _isWhole = isWhole;
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

    /// <summary>Length cut so far, millimetres.</summary>
    public double Length { get; private set; }

    /// <summary>The error; null while the cut length does not exceed the length of the job, and, where it is exact, is not below it.</summary>
    public Diagnostic? Finding => _isWhole && Length < _expected - _allowed ? OperationRules.PassMissing.At(default, FactText.Of(Math.Round(Length, 4)), FactText.Of(Math.Round(_expected, 4))) :
        Length <= _expected + _allowed ? null : VerificationRules.CutTwice.At(default, FactText.Of(Math.Round(Length, 4)), FactText.Of(Math.Round(_expected, 4)));

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
