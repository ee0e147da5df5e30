using Engraver.Core.Diagnostics;

namespace Engraver.Core.Posts;

/// <summary>Compares the feeds at which a program cuts with those of the job, while it is read: a level cut runs at the feed, and a descent is not faster than
/// the plunge feed.</summary>
/// <param name="feed">Feed of the job along the path, mm/min.</param>
/// <param name="plunge">Feed of the tool axis straight down, mm/min; null when no axis moves the tool.</param>
public sealed class FeedJudge(double feed, double? plunge)
{
    /// <summary>Fraction of a feed that the rounding of the text can change.</summary>
    private const double Rounding = 0.001;

    /// <summary>A move that falls by this fraction of its length is straight down, at the plunge feed, which can be above the feed of the path.</summary>
    private const double StraightDown = 1.0 - 1e-9;

    /// <summary>The slowest cut so far, mm/min; null when it is unknown.</summary>
    public double? Slowest { get; private set; }

    /// <summary>The fastest cut so far, mm/min; null when it is unknown.</summary>
    public double? Fastest { get; private set; }

    /// <summary>The lowest height of a cut, millimetres above the drawing's height 0; null when it is unknown.</summary>
    public double? Lowest { get; private set; }

    /// <summary>The first cut at a feed other than that of the job; null for none.</summary>
    public Diagnostic? Finding { get; private set; }

    /// <summary>Called for each cut.</summary>
    /// <param name="line">Line of the program's text.</param>
    /// <param name="mmPerMinute">Feed along the path; infinite for a rapid.</param>
    /// <param name="length">Length of the cut, millimetres.</param>
    /// <param name="fall">Height of the start above the end, millimetres; below 0 for a rise.</param>
    /// <param name="quantum">Step of a feed in the format, mm/min.</param>
    /// <param name="strokes">The strokes that the cut may be, whose feeds count instead of those of the job; null or empty: unknown.</param>
    public void Add(int line, double mmPerMinute, double length, double fall = 0.0, double quantum = 0.0, IReadOnlyList<StrokeRequirement>? strokes = null)
    {
        if (!(length > 0.0)) return;
        if (double.IsFinite(mmPerMinute)) (Slowest, Fastest) = (Math.Min(Slowest ?? mmPerMinute, mmPerMinute), Math.Max(Fastest ?? mmPerMinute, mmPerMinute));
        if (Finding is not null) return;
        List<(double Least, double Most)> ranges = [.. strokes is { Count: > 0 } ? strokes.Select(stroke => Range(stroke.Feed, plunge is null ? null : stroke.Plunge ?? plunge, length, fall)) : [Range(feed, plunge, length, fall)]];
        if (!ranges.Any(range => IsWithin(range.Least, range.Most))) Finding = Other(line, mmPerMinute, ranges[0].Least, ranges[0].Most);

        bool IsWithin(double least, double most) => (most * Rounding) + quantum is var within && mmPerMinute <= most + within && mmPerMinute >= least - within && mmPerMinute > 0.0;
    }

    private static (double Least, double Most) Range(double feed, double? plunge, double length, double fall)
    {
        var most = plunge is { } down && fall > 0.0 ? fall >= length * StraightDown ? down : Math.Min(feed, down * length / fall) : feed;
        return (fall == 0.0 ? feed : 0.0, most);
    }

    private static Diagnostic Other(int line, double mmPerMinute, double least, double most)
    {
        var feed = double.IsFinite(mmPerMinute) ? Wording.Get("FeedJudge.Feed", FactText.Of(mmPerMinute)) : Wording.Get("FeedJudge.RapidSpeed");
        var expected = least == most ? Wording.Get("FeedJudge.Feed", FactText.Of(most)) : Wording.Get("FeedJudge.FeedRange", FactText.Of(least), FactText.Of(most));
        return VerificationRules.OtherFeed.At(new SourceRef(line), feed, FactText.Of(line), expected);
    }

    /// <summary>Called when a cut reaches this height.</summary>
    public void Reach(double height) => Lowest = Math.Min(Lowest ?? height, height);
}
