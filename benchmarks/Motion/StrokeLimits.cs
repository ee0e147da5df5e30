namespace Engraver.Benchmarks.Motion;

/// <summary>Least seconds of a stroke.</summary>
/// <param name="Limit">With one acceleration along the path for the stroke, corners rounded.</param>
/// <param name="Acceleration">The best one, mm/s2.</param>
/// <param name="Unrestricted">With any acceleration along the path, corners rounded.</param>
/// <param name="Stopping">With a stop at every corner, one acceleration between two stops.</param>
internal readonly record struct StrokeLimits(double Limit, double Acceleration, double Unrestricted, double Stopping)
{
    /// <summary>Parts of the largest acceleration among which the best one is searched, and then between its neighbours.</summary>
    private const int Steps = 80;
    private const int FineSteps = 10;
    private const double CornerDegrees = 0.5;

    public static StrokeLimits Of(IReadOnlyList<PathElement> stroke, MotionBounds bounds)
    {
        var grid = new PlaceGrid(CornerRounding.Rounded(stroke, bounds), bounds);
        var (seconds, acceleration) = Best(grid, bounds);
        var stopping = Stops(stroke).Sum(piece => Best(new PlaceGrid(CornerRounding.Sharp(piece, bounds), bounds), bounds).Seconds);
        return new StrokeLimits(seconds, acceleration, grid.SecondsUnrestricted(), stopping);
    }

    private static (double Seconds, double Acceleration) Best(PlaceGrid grid, MotionBounds bounds)
    {
        var most = bounds.Acceleration;
        if (!grid.HasArcs) return (grid.SecondsWith(most), most);
        var best = Enumerable.Range(1, Steps).Select(At).MinBy(found => found.Seconds);
        var width = most / Steps;
        foreach (var _ in Enumerable.Range(0, 2))
        {
            var (centre, around) = (best.Acceleration, width);
            best = Enumerable.Range(-FineSteps, (2 * FineSteps) + 1)
                .Select(step => With(Math.Clamp(centre + (around * step / FineSteps), most * 1e-3, most)))
                .MinBy(found => found.Seconds);
            width /= FineSteps;
        }

        return best;

        (double Seconds, double Acceleration) At(int step) => With(most * step / Steps);
        (double Seconds, double Acceleration) With(double acceleration) => (grid.SecondsWith(acceleration), acceleration);
    }

    private static IEnumerable<IReadOnlyList<PathElement>> Stops(IReadOnlyList<PathElement> stroke)
    {
        var piece = new List<PathElement>();
        foreach (var element in stroke)
        {
            if (piece.Count > 0 && Math.Abs(piece[^1].LastTangent.TurnTo(element.FirstTangent)) > double.DegreesToRadians(CornerDegrees))
            {
                yield return piece;
                piece = [];
            }

            piece.Add(element);
        }

        if (piece.Count > 0) yield return piece;
    }
}
