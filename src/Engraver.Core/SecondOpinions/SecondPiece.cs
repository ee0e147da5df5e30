namespace Engraver.Core.SecondOpinions;

/// <summary>A smooth piece of a curve: a function of 0 to 1, or the straight way between two points.</summary>
internal readonly struct SecondPiece
{
    private readonly SecondPoint _from;
    private readonly SecondPoint _to;
    private readonly Func<double, SecondPoint>? _curve;

    public SecondPiece(SecondPoint from, SecondPoint to) => (_from, _to) = (from, to);

    public SecondPiece(Func<double, SecondPoint> curve) => _curve = curve;

    public bool IsStraight => _curve is null;

    public SecondPoint At(double t) => _curve is null ? _from + (t * (_to - _from)) : _curve(t);
}
