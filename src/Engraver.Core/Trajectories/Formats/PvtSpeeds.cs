namespace Engraver.Core.Trajectories.Formats;

/// <summary>Speed along a chain from rest to rest: at the requested speed, slower where the curvature or the ends require it, within the allowed
/// acceleration.</summary>
internal sealed class PvtSpeeds
{
    /// <summary>Fraction of the acceleration used for turning; the rest is for speeding up and slowing down.</summary>
    private const double TurningShare = 0.5;

    /// <summary>Target, as a fraction of the limits, for an element that exceeds its limits.</summary>
    private const double TargetShare = 0.98;

    /// <summary>Largest slowdown of an element in one step, because its requirement can be infinite when its time is rounded to 0.</summary>
    private const double MaxAtOnce = 1e4;

    /// <summary>Number of passes in which elements are slowed down individually; after these, all are slowed down.</summary>
    private const int MaxRounds = 60;

    private readonly double _along;
    private double[] _at;
    private double[] _squared;

    public PvtSpeeds(SmoothChain chain, double velocity, double acceleration)
    {
        var (at, squared) = (new List<double>(), new List<double>());
        foreach (var piece in chain.Pieces)
        {
            for (var i = 0; i <= 16; i++)
            {
                var place = piece.At(i / 16.0);
                at.Add(piece.ArcLengthAt(i / 16.0));
                squared.Add(Math.Min(velocity * velocity, TurningShare * acceleration / Math.Max(Math.Abs(place.Curvature), 1e-12)));
            }
        }

        (_at, _squared) = ([.. at], [.. squared]);
        _along = 2.0 * (1.0 - TurningShare) * acceleration;
        var (up, down, half) = (_squared[0] / _along, _squared[^1] / _along, chain.Length / 2.0);
        Ramps = up < half && down < half ? [up, chain.Length - down] : [half];
        InsertRamps();
        (_squared[0], _squared[^1]) = (0.0, 0.0);
        for (var i = 1; i < _at.Length; i++) _squared[i] = Math.Min(_squared[i], _squared[i - 1] + (_along * (_at[i] - _at[i - 1])));
        for (var i = _at.Length - 2; i >= 0; i--) _squared[i] = Math.Min(_squared[i], _squared[i + 1] + (_along * (_at[i + 1] - _at[i])));
    }

    /// <summary>Lengths at which the speed reaches the speed of travel, and at which it starts to fall.</summary>
    public IReadOnlyList<double> Ramps { get; }

    /// <summary>Speed at a length, mm/s.</summary>
    public double At(double length)
    {
        var found = Array.BinarySearch(_at, length);
        if (found >= 0) return Math.Sqrt(_squared[found]);
        var next = Math.Clamp(~found, 1, _at.Length - 1);
        var share = (length - _at[next - 1]) / Math.Max(_at[next] - _at[next - 1], double.Epsilon);
        return Math.Sqrt(_squared[next - 1] + (Math.Clamp(share, 0.0, 1.0) * (_squared[next] - _squared[next - 1])));
    }

    /// <summary>The speeds at knots, from rest to rest. An element that exceeds its limits is slowed down, and its neighbours so that its speed can be
    /// reached.</summary>
    /// <param name="knots">Knots as lengths in order.</param>
    /// <param name="excess">Requirement of an element divided by its limit, by its number and the speeds at its ends; it falls with the square of the speeds.
    /// Above 1: too much.</param>
    public double[] AtKnots(IReadOnlyList<double> knots, Func<int, double, double, double> excess)
    {
        var squared = knots.Select((knot, i) => i == 0 || i == knots.Count - 1 ? 0.0 : At(knot) * At(knot)).ToArray();
        for (var round = 0; ; round++)
        {
            var needs = Enumerable.Range(1, knots.Count - 1).Select(i => excess(i, Math.Sqrt(squared[i - 1]), Math.Sqrt(squared[i]))).ToArray();
            var most = needs.Max();
            if (!(most > 1.0)) return [.. squared.Select(Math.Sqrt)];
            for (var i = 0; i < squared.Length; i++)
            {
                var need = round >= MaxRounds ? most : Math.Max(i > 0 ? needs[i - 1] : 0.0, i < needs.Length ? needs[i] : 0.0);
                if (need > 1.0) squared[i] *= TargetShare / Math.Min(need, MaxAtOnce);
            }

            if (round >= MaxRounds) return [.. squared.Select(Math.Sqrt)];
            for (var i = 1; i < squared.Length; i++) squared[i] = Math.Min(squared[i], squared[i - 1] + (_along * (knots[i] - knots[i - 1])));
            for (var i = squared.Length - 2; i >= 0; i--) squared[i] = Math.Min(squared[i], squared[i + 1] + (_along * (knots[i + 1] - knots[i])));
        }
    }

    /// <summary>Adds the ends of the ramps to the table, because the squared speed is linear between its entries.</summary>
    private void InsertRamps()
    {
        foreach (var ramp in Ramps)
        {
            var found = Array.BinarySearch(_at, ramp);
            if (found >= 0) continue;
            var next = Math.Clamp(~found, 1, _at.Length - 1);
            var squared = Math.Min(_squared[next - 1], _squared[next]);
            _at = [.. _at[..next], ramp, .. _at[next..]];
            _squared = [.. _squared[..next], squared, .. _squared[next..]];
        }
    }
}
