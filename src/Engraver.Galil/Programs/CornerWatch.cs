using Engraver.Core.Geometry;

namespace Engraver.Galil.Programs;

/// <summary>Says where the path turns too sharply to be cut without a stop. It looks at the drawn tangents: rounded counts would see corners in any run of short pieces.</summary>
/// <remarks>Moves that vanish in counts are seen too, so that a bend made of many of them is smooth, and a speck of another direction inside a straight is no corner.</remarks>
/// <param name="sharpDegrees">A turn above this is a corner.</param>
internal sealed class CornerWatch(double sharpDegrees)
{
    /// <summary>Turns of exactly the limit (a regular polygon) must not depend on the last bit of an arc tangent.</summary>
    private const double RoundingDegrees = 1e-6;

    private Vector2D _lastCut;
    private Vector2D _lastSeen;
    private double _sharpest;

    /// <summary>True when the path must stand still before this move, which will be cut.</summary>
    public bool IsCornerBefore(in Segment move)
    {
        See(move);
        return _sharpest > sharpDegrees + RoundingDegrees && Turn(_lastCut, move.StartTangent) > sharpDegrees + RoundingDegrees;
    }

    /// <summary>The move was cut: the next corner is measured from its end.</summary>
    public void Cut(in Segment move)
    {
        var tangent = move.EndTangent;
        if (tangent == default) return;
        (_lastCut, _lastSeen, _sharpest) = (tangent, tangent, 0.0);
    }

    /// <summary>The move is too small to be cut.</summary>
    public void Skip(in Segment move)
    {
        See(move);
        if (move.EndTangent != default) _lastSeen = move.EndTangent;
    }

    private void See(in Segment move) => _sharpest = Math.Max(_sharpest, Turn(_lastSeen, move.StartTangent));

    private static double Turn(Vector2D from, Vector2D to) => from.TurnTo(to).Abs().Degrees;
}
