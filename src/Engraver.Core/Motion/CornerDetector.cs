using Engraver.Core.Geometry;
using Engraver.Core.Machines;

namespace Engraver.Core.Motion;

/// <summary>Detects where the path turns too sharply to be cut without a stop. It uses the drawn tangents: rounded counts would show corners in any run of
/// short pieces.</summary>
/// <remarks>Moves shorter than a count are included, so that a bend of many such moves is smooth, and a tiny move of another direction inside a straight is not
/// a corner. A bend so small that the controller would pass it between two of its samples is also a corner, however smooth it was drawn; near a standstill the
/// tool is slow, and it is not one.</remarks>
/// <param name="vectorSpeed">Counts/s along the path, as the controller accepts it.</param>
public sealed class CornerDetector(MachineProfile profile, double vectorSpeed)
{
    /// <summary>Allowance, so that turns of exactly the limit (a regular polygon) do not depend on the last bit of an arc tangent.</summary>
    private const double RoundingDegrees = 1e-6;

    /// <summary>Time between two samples of the motors by the controller.</summary>
    private const double SampleSeconds = 0.001;

    /// <summary>Counts by which a motor sample may deviate to the inside of a bend: the same as the general tolerance against the drawing.</summary>
    private const double CountsBesideBend = 2.5;

    private Vector2D _lastCut;
    private Vector2D _lastSeen;
    private double _sharpest;
    private double _bend;
    private double _countsSinceStop;

    /// <summary>A stroke begins: there are no moves before it.</summary>
    public void Begin() => (_lastCut, _lastSeen, _sharpest, _bend, _countsSinceStop) = (default, default, 0.0, 0.0, 0.0);

    /// <summary>True when the path must stop before this move, which will be cut.</summary>
    public bool IsCornerBefore(in Segment move)
    {
        See(move);
        var turn = Turn(_lastCut, move.StartTangent);
        var isSharp = _sharpest > profile.SharpCornerDegrees + RoundingDegrees && turn > profile.SharpCornerDegrees + RoundingDegrees;
        if (isSharp || IsBend(turn, move)) _countsSinceStop = 0.0;
        return _countsSinceStop == 0.0;
    }

    /// <summary>Records a move that was cut: the next corner is measured from its end.</summary>
    public void Cut(in Segment move)
    {
        var tangent = move.EndTangent;
        if (tangent == default) return;
        var distance = DistanceOfSample(_countsSinceStop);
        _bend = _countsSinceStop == 0.0 || Counts(move) >= distance ? BendOf(move, distance) : _bend + Turn(_lastCut, move.StartTangent) + BendOf(move, distance);
        _countsSinceStop += Counts(move);
        (_lastCut, _lastSeen, _sharpest) = (tangent, tangent, 0.0);
    }

    /// <summary>Records a move that is too small to be cut.</summary>
    public void Skip(in Segment move)
    {
        See(move);
        if (move.EndTangent != default) _lastSeen = move.EndTangent;
    }

    /// <summary>True when a motor sample may be too far inside: for a bend of angle b within one sample's distance w it is up to w/2 sin(b/2).</summary>
    private bool IsBend(double turn, in Segment move)
    {
        var distance = DistanceOfSample(_countsSinceStop);
        var bend = _bend + turn + BendOf(move, distance);
        return bend > profile.SharpCornerDegrees + RoundingDegrees && distance / 2.0 * Angle.FromDegrees(Math.Min(180.0, bend) / 2.0).Sin() > CountsBesideBend;
    }

    /// <summary>Distance that the tool travels between two samples, counts.</summary>
    private double DistanceOfSample(double countsSinceStop) => SampleSeconds * Math.Min(vectorSpeed, Math.Sqrt(2.0 * profile.AccelerationCounts * countsSinceStop));

    /// <summary>Turn of the move within one sample's distance, degrees.</summary>
    private double BendOf(in Segment move, double distance) =>
        move.Kind == SegmentKind.Line ? 0.0 : Math.Abs(move.Arc.Sweep.Degrees) * Math.Min(1.0, distance / Counts(move));

    private double Counts(in Segment move) => profile.Scale.Finer.CountsOf(move.Length);

    private void See(in Segment move) => _sharpest = Math.Max(_sharpest, Turn(_lastSeen, move.StartTangent));

    private static double Turn(Vector2D from, Vector2D to) => from.TurnTo(to).Abs().Degrees;
}
