using Engraver.App.Canvas.Overlays;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Workbench.Documents;
using Engraver.Workbench.LetteredDrawings;
using Engraver.Workbench.Playback;

namespace Engraver.App.Desk;

/// <summary>Computes what the overlays show besides the job: planned speeds, points of findings. For a thread of the pool.</summary>
internal static class OverlayInputBuilder
{
    /// <summary>Maximum number of moves for which speeds are computed; with more of them the colours cannot be distinguished.</summary>
    private const int MaxSpeeds = 200_000;

    /// <summary>Maximum number of findings: handles are searched one by one, and more marks would overlap anyway.</summary>
    private const int MaxFindings = 300;

    public static OverlayInputs From(DerivedDocument derived) => new()
    {
        LazyMoveSpeeds = () => derived is { Motion: { } motion, Job.Toolpath: { } path } && path.Strokes.Sum(stroke => stroke.Moves.Count) is var moves and <= MaxSpeeds ? SpeedsOf(motion, moves) : [],
        Findings = derived.State.Drawing is { } drawing ? PlacesOf(derived, ShownDrawing.Of(drawing)) : [],
    };

    /// <summary>Speed in the middle of each move, as a fraction of the fastest.</summary>
    private static double[] SpeedsOf(PlannedMotion motion, int moves)
    {
        var speeds = new double[moves];
        for (var move = 0; move < moves; move++)
        {
            var start = motion.TimeOfMove(move);
            var end = move + 1 < moves ? motion.TimeOfMove(move + 1) : motion.DurationSeconds;
            if (start is { } from && end is { } to) speeds[move] = motion.At((from + to) / 2.0).Speed;
        }

        var fastest = moves == 0 ? 0.0 : speeds.Max();
        for (var move = 0; move < moves && fastest > 0.0; move++) speeds[move] /= fastest;
        return speeds;
    }

    private static List<Point2D> PlacesOf(DerivedDocument derived, Drawing drawing)
    {
        var places = new List<Point2D>();
        foreach (var finding in derived.Findings.Take(MaxFindings))
        {
            if (finding.Place is { } place)
            {
                if (finding.Id != SequencingRules.SmallGap.Id) places.Add(drawing.Scale.ToDrawing(place)); // the gaps of the job are added separately
            }
            else if (finding.Source.Handle is { } handle && drawing.IndexOfHandle(handle) is { } entity && drawing.Entities[entity].PartCount > 0) places.Add(drawing.SegmentOf(drawing.Parts[drawing.Entities[entity].FirstPart]).Start);
        }

        return places;
    }
}
