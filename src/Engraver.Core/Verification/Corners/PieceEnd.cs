using Engraver.Core.Geometry;

namespace Engraver.Core.Verification.Corners;

/// <summary>An end of a drawn piece.</summary>
/// <param name="Place">Millimetres.</param>
/// <param name="Z">Its height, millimetres; 0 where heights do not count.</param>
/// <param name="Along">Direction in which the piece leaves it, length 1.</param>
/// <param name="Piece">Number of the piece.</param>
/// <param name="IsStart">True for the start of the piece.</param>
internal readonly record struct PieceEnd(Point2D Place, double Z, Vector2D Along, int Piece, bool IsStart)
{
    /// <summary>Both ends of every piece that has ends and a length.</summary>
    /// <param name="heightOf">The height of a piece at its start (true) or end; null where heights do not count.</param>
    public static PieceEnd[] AllOf(Segment[] pieces, Func<int, bool, double>? heightOf)
    {
        var ends = new List<PieceEnd>(2 * pieces.Length);
        for (var i = 0; i < pieces.Length; i++)
        {
            if (pieces[i].Kind == SegmentKind.Circle || pieces[i].StartTangent == default) continue;
            ends.Add(Of(pieces, i, isStart: true) with { Z = heightOf?.Invoke(i, true) ?? 0.0 });
            ends.Add(Of(pieces, i, isStart: false) with { Z = heightOf?.Invoke(i, false) ?? 0.0 });
        }

        return [.. ends];
    }

    /// <summary>An end of a piece, without its height.</summary>
    public static PieceEnd Of(Segment[] pieces, int piece, bool isStart) => isStart
        ? new PieceEnd(pieces[piece].Start, 0.0, pieces[piece].StartTangent, piece, true)
        : new PieceEnd(pieces[piece].End, 0.0, -pieces[piece].EndTangent, piece, false);

    /// <summary>Left turn from this direction to that of another end, radians from -pi to pi.</summary>
    public double LeftTurnTo(in PieceEnd other) => Math.Atan2(Along.Cross(other.Along), Along.Dot(other.Along));
}
