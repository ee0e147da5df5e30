namespace Engraver.Core.Trajectories;

/// <summary>Finds the spacing with the fewest points whose proven bound is within the error: families of profiles, each on the coarsest scale that passes
/// (sace-xps-agie.md 3.5 steps 1 and 5).</summary>
internal sealed class SpacingSearch(SmoothChain chain, double maxError)
{
    /// <summary>Largest ratio of a step to its neighbour.</summary>
    public const double MaxRatio = 4.0;

    /// <summary>The samples must stay below this fraction of the error, because the bound is slightly larger than they are.</summary>
    private const double SampleShare = 0.996;

    private const int Rounds = 12;

    private const double MaxBoost = 1.1;

    /// <summary>Moving points across the chain can at most halve an error: beyond this multiple of the allowed error it does not help.</summary>
    private const double HopelessErrorRatio = 2.5;

    /// <summary>Maximum number of measured steps for any chain, and for each of its points, in the search for fewer points.</summary>
    private const int MeasuredAtLeast = 60_000;
    private const int MeasuredForPoint = 40;

    /// <summary>Finest and coarsest scale of the error that are tried.</summary>
    private const double Finest = 1.0 / 4096.0;
    private const double Coarsest = 100.0;

    private const int MaxTries = 10;

    /// <summary>Equal steps of the whole chain: the smallest and the largest number that are tried.</summary>
    private const double MinEvenSegments = 16.0;
    private const double MaxEvenSegments = 100_000.0;

    /// <summary>Over three halvings of equal steps the error falls by 64 on a smooth curve, and by 8 at a cusp, where further halving does not help.</summary>
    private const double ExpectedErrorRatio = 14.0;

    private const int EvenTries = 4;

    private static readonly double[] Coarser = [1.0, 1.5, 2.5];

    private static readonly double[] Growths = [1.1, 0.5, 1.4];

    private static readonly double[] Softnesses = [0.02, 0.1, 0.2, 0.4, 0.8];

    private readonly SpacingProfile _profile = new(chain);
    private SplineCandidate? _best;

    /// <summary>The last result of the search: the next one is near it.</summary>
    private double _lastScale = 1.0;

    /// <summary>Steps measured so far.</summary>
    private long _measured;

    /// <summary>Work of the search: number of placed knots and measured steps.</summary>
    public long Work { get; private set; }

    public SplineCandidate? Find()
    {
        if (chain.Pieces.Count == 1 && chain.Pieces[0].IsLine) return Straight();
        foreach (var growth in Growths.TakeWhile(_ => CanContinue)) Refine(growth, null);
        if (chain.Pieces.Any(piece => piece.IsFree))
        {
            foreach (var soft in Softnesses.TakeWhile(_ => CanContinue)) Refine(1.1, soft);
        }

        if (_best is null) FindEven();
        return _best;
    }

    /// <summary>For a curve that is long compared with its bends: the families account for the error of fourth order, while along tens of metres the error of
    /// third order and the cells of the profile dominate.</summary>
    private void FindEven()
    {
        var errors = new List<double>();
        for (var steps = MinEvenSegments; steps < MaxEvenSegments && (errors.Count < 4 || errors[^1] * ExpectedErrorRatio < errors[^4]); steps *= 2.0)
        {
            if (TryEven(steps, out var error))
            {
                var (low, high) = (steps / 2.0, steps);
                for (var i = 0; i < EvenTries; i++) (low, high) = TryEven(Math.Sqrt(low * high), out _) ? (low, Math.Sqrt(low * high)) : (Math.Sqrt(low * high), high);
                return;
            }

            errors.Add(error);
        }
    }

    private bool TryEven(double steps, out double error)
    {
        _profile.FillEvenly(chain.Length / steps);
        var knots = Placed();
        var fit = Fitted(knots);
        error = fit.LargestError;
        return IsTaken(fit, knots);
    }

    /// <summary>Two points without a search.</summary>
    private SplineCandidate? Straight()
    {
        List<double> knots = [0.0, chain.Length];
        var fit = new SplineFit(chain, knots);
        var bound = SplineBound.Measure(fit.Spline, chain, knots);
        return bound <= maxError ? new SplineCandidate(fit.Spline, bound, knots) : null;
    }

    /// <summary>Finds the first spline within the error, then reduces the number of points: each trial is the coarsest scale of the family with this
    /// number.</summary>
    private void Refine(double growth, double? soft)
    {
        for (var scale = 1.0; _best is null && scale >= Finest; scale /= 3.0) Try(scale, growth, soft, int.MaxValue);
        if (_best is null) return;
        for (var (fewer, tries) = (1 + (Count / 40), 0); fewer > 0 && tries < MaxTries && CanContinue; tries++) fewer = TryFewer(fewer, growth, soft) ? 2 * fewer : fewer / 2;
    }

    /// <summary>Tries the finest scale that needs correspondingly fewer points, and coarser scales, which repairs make denser where necessary.</summary>
    private bool TryFewer(int fewer, double growth, double? soft)
    {
        var (before, scale) = (Count, ScaleFor(Count - fewer, growth, soft));
        return Coarser.Any(factor => Try(scale * factor, growth, soft, before));
    }

    /// <summary>There is no limit until the first spline is within the error; after that the number of measured steps is limited by the length of the chain, so
    /// that the time is linear in it.</summary>
    private bool CanContinue => _best is null || _measured < MeasuredAtLeast + ((long)MeasuredForPoint * Count);

    /// <summary>Number of points of the best spline so far.</summary>
    private int Count => _best!.Value.Spline.Lines.Count - 2;

    /// <summary>The finest scale at which a family needs no more than a number of points.</summary>
    private double ScaleFor(int points, double growth, double? soft)
    {
        var (low, high) = (_lastScale, _lastScale);
        while (low > Finest && IsEnough(low)) (low, high) = (low / 2.0, low);
        while (high < Coarsest && !IsEnough(high)) (low, high) = (high, high * 2.0);
        while (high > low * 1.01)
        {
            var middle = Math.Sqrt(low * high);
            if (IsEnough(middle)) high = middle;
            else low = middle;
        }

        return _lastScale = high;

        bool IsEnough(double scale)
        {
            _profile.Fill(scale * maxError, growth, soft);
            return !NeedsMoreThan(points) && Placed().Count <= points;
        }
    }

    /// <summary>Tries one scale, made denser where necessary.</summary>
    /// <param name="below">This number of points or more is not useful.</param>
    private bool Try(double scale, double growth, double? soft, int below)
    {
        _profile.Fill(scale * maxError, growth, soft);
        for (var round = 0; round < Rounds && CanContinue; round++)
        {
            if (below < int.MaxValue && NeedsMoreThan(below)) return false;
            var knots = Placed();
            if (knots.Count >= below) return false;
            var fit = Fitted(knots);
            if (IsTaken(fit, knots)) return true;
            if (!Repair(fit, knots)) return false;
        }

        return false;
    }

    private SplineFit Fitted(List<double> knots)
    {
        var fit = new SplineFit(chain, knots);
        fit.Centre(0.9 * maxError, HopelessErrorRatio * maxError);
        _measured += fit.Measured;
        Work += fit.Measured;
        return fit;
    }

    /// <summary>True when the spline is within the error and the best so far.</summary>
    private bool IsTaken(SplineFit fit, List<double> knots)
    {
        if (fit.HasReversal || fit.LargestError > SampleShare * maxError || fit.Spline.SpacingRatio(chain.Closed) > MaxRatio) return false;
        var bound = SplineBound.Measure(fit.Spline, chain, knots, maxError);
        if (bound <= maxError) _best = new SplineCandidate(fit.Spline, bound, knots);
        return bound <= maxError;
    }

    /// <summary>Number of points, computed without placing them: near a cusp a spacing can require millions.</summary>
    private bool NeedsMoreThan(int points) => _profile.Steps(0.0, chain.Length) > points + (2.0 * (_profile.Breaks.Count + 2));

    private List<double> Placed()
    {
        var knots = KnotPlacement.Place(chain, _profile);
        Work += knots.Count;
        return knots;
    }

    /// <summary>Makes points denser where the error is too large, and where a step is too long for its neighbour.</summary>
    private bool Repair(SplineFit fit, List<double> knots)
    {
        var any = false;
        for (var i = 0; i < fit.Spline.Count; i++)
        {
            var over = fit.ErrorOf(i) / (SampleShare * maxError);
            if (over > 4.0) return false;
            if (over > 1.0)
            {
                any = true;
                Boost(knots, i, Math.Min(MaxBoost, Math.Pow(over, 0.5) * 1.01));
            }

            var next = i + 1 < fit.Spline.Count ? i + 1 : chain.Closed ? 0 : i;
            var ratio = fit.Spline.Chord(i) / fit.Spline.Chord(next);
            if (ratio is <= MaxRatio and >= 1.0 / MaxRatio) continue;
            any = true;
            Boost(knots, ratio > 1.0 ? i : next, MaxBoost);
        }

        if (any) return true;
        _profile.Boost(0.0, chain.Length, 1.02);
        return true;
    }

    private void Boost(List<double> knots, int segment, double factor)
    {
        var (from, to) = (knots[segment], knots[segment + 1]);
        if (chain.Closed && from >= chain.Length) (from, to) = (from - chain.Length, to - chain.Length);
        _profile.Boost(from, to, factor);
    }
}

/// <summary>Points with their proven bound, millimetres, and their lengths along the chain.</summary>
internal readonly record struct SplineCandidate(CatmullRomSpline Spline, double Bound, IReadOnlyList<double> Knots);
