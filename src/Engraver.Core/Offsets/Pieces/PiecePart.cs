namespace Engraver.Core.Offsets.Pieces;

/// <summary>A part of a piece, by fractions of its length or lengths along it.</summary>
internal readonly record struct PiecePart(double From, double To)
{
    public static PiecePart Empty => new(double.PositiveInfinity, double.NegativeInfinity);

    public static PiecePart Whole => new(0.0, 1.0);

    public bool IsEmpty => !(From < To);

    public PiecePart Hull(PiecePart other) => IsEmpty ? other : other.IsEmpty ? this : new PiecePart(Math.Min(From, other.From), Math.Max(To, other.To));

    public PiecePart Common(PiecePart other) => new(Math.Max(From, other.From), Math.Min(To, other.To));

    public PiecePart Scaled(double length) => new(From / length, To / length);
}
