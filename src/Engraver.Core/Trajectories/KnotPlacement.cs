namespace Engraver.Core.Trajectories;

/// <summary>The lengths along a chain of the visited points: the number of steps between fixed places is rounded up (sace-xps-agie.md 3.5 step 2).</summary>
internal static class KnotPlacement
{
    /// <summary>Fraction of a step that may be missing before another step is added.</summary>
    private const double Missing = 0.02;

    /// <summary>Minimum number of steps of a closed chain: with fewer, the ends of a periodic spline would be their own neighbours.</summary>
    private const int MinPerRound = 4;

    /// <returns>Increasing; of a closed chain the last is the first plus one round.</returns>
    public static List<double> Place(SmoothChain chain, SpacingProfile profile)
    {
        var breaks = Fixed(chain, profile);
        var knots = new List<double>();
        for (var i = 0; i + 1 < breaks.Count; i++) Add(profile, chain, breaks[i], breaks[i + 1], breaks.Count == 2, knots);
        if (chain.Closed) knots.Add(knots[0] + chain.Length);
        else knots.Add(chain.Length);
        return knots;
    }

    private static List<KnotBreak> Fixed(SmoothChain chain, SpacingProfile profile)
    {
        if (!chain.Closed) return [new KnotBreak(0.0, 0.0), .. profile.Breaks.Where(one => one.At > 0.0 && one.At < chain.Length), new KnotBreak(chain.Length, 0.0)];
        var breaks = profile.Breaks.Count == 0 ? [new KnotBreak(0.0, 0.0)] : profile.Breaks.ToList();
        breaks.Add(breaks[0] with { At = breaks[0].At + chain.Length });
        return breaks;
    }

    private static void Add(SpacingProfile profile, SmoothChain chain, KnotBreak from, KnotBreak to, bool alone, List<double> knots)
    {
        var wraps = to.At > chain.Length;
        var steps = wraps ? profile.Steps(from.At, chain.Length) + profile.Steps(0.0, to.At - chain.Length) : profile.Steps(from.At, to.At);
        var offset = Math.Abs(to.Phase - from.Phase);
        var count = Math.Max(offset + Math.Ceiling(steps - offset - Missing), offset > 0.0 ? offset : 1.0);
        if (alone && chain.Closed) count = Math.Max(count, MinPerRound);
        var first = from.Phase == 0.0 ? 0.0 : 1.0 - from.Phase;
        if (!wraps)
        {
            knots.AddRange(profile.Places(from.At, to.At, first, count));
            return;
        }

        var share = count * profile.Steps(from.At, chain.Length) / steps;
        knots.AddRange(profile.Places(from.At, chain.Length, first, share));
        var rest = Math.Ceiling(share - first - 1e-9) + first - share;
        knots.AddRange(profile.Places(0.0, to.At - chain.Length, Math.Max(0.0, rest), count - share).Select(place => place + chain.Length));
    }
}
