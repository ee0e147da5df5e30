using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Galil.Language;

namespace Engraver.Galil.Jobs.Journal;

/// <summary>Compares the last place that a journal states with the position in the same line, and with what the controller has counted: what is
/// before that place is not cut again.</summary>
/// <remarks>The position may be ahead of the place (a poll later, braking, on the way to the next stroke), never before it.</remarks>
/// <param name="job">Of the journal.</param>
/// <param name="program">The whole program.</param>
internal sealed class JournalWitness(InterruptedJob job, MotionProgram program)
{
    /// <summary>Largest distance of a polled position from its path, counts, without the distance that the machine moves between two readings.</summary>
    private const double OnPath = 2.5;

    /// <summary>The axes are read one after the other, a sample or two apart (galil-dmc.md C).</summary>
    private const double ReadingSeconds = 0.002;

    /// <summary>The position may be this much later than the place, seconds: a poll on a slow serial line.</summary>
    private const double LaterSeconds = 0.5;

    /// <summary>Why the place cannot be at the position that the journal states; empty when it can.</summary>
    public string WhyNotThere()
    {
        var place = job.Place;
        if (job.End?.Outcome.IsSectionEnd() == true) return ""; // then the machine has left the path
        if (IsOfEarlierJob || job.Position is not { } at) return "";
        var here = new Point2D(at.X - job.Header.FrameX, at.Y - job.Header.FrameY);
        if (place.Along >= 0.0 && place.Segments <= program.SegmentCount && (job.EndedByFault ? IsNear(place, here) : IsAhead(place, here))) return "";
        return Wording.Get("Resume.PositionElsewhere", place.Segments, program.SegmentCount, Math.Round(place.Along), at.X, at.Y);
    }

    /// <summary>Why the controller contradicts the place; empty when it does not.</summary>
    /// <param name="sequences">seq, as far as it counts this job; null where it does not.</param>
    public string WhyNotCounted(double? sequences)
    {
        if (IsOfEarlierJob || job.Opened is not { Starts.Count: > 0 } opened) return "";
        var counted = opened.First + (job.Header.Mode switch
        {
            JobMode.Calls when sequences is { } calls => calls > opened.Calls ? 1 : 0,
            JobMode.Program when sequences is { } calls => opened.Starts[(int)Math.Clamp(Math.Ceiling(calls / 2.0), 0.0, opened.Starts.Count - 1)],
            _ => opened.Starts[^1],
        });
        return job.Place.Segments > counted ? Contradicted(new JobPosition(counted, 0.0)) : "";
    }

    /// <summary>Why the place cannot have been reached when the watchdog stopped the machine; empty when it can. What the controller counts is cleared
    /// between two sequences: then only the position shows it.</summary>
    /// <param name="trip">By what the controller counted.</param>
    /// <param name="at">Where it stopped the machine, job frame.</param>
    public string WhyNotReached(JobPosition trip, CountsPoint at) => IsOfEarlierJob || trip >= job.Place || IsAhead(job.Place, new Point2D(at.X, at.Y)) ? "" : Contradicted(trip);

    /// <summary>The place is the one from which this job continued: in its lead-in the machine and what the controller counts are before it.</summary>
    private bool IsOfEarlierJob => job.Place <= new JobPosition(job.Header.FromSegments, job.Header.FromAlong);

    private string Contradicted(JobPosition counted) => Wording.Get("Resume.CountersContradict", job.Place.Segments, Math.Round(job.Place.Along), counted.Segments, Math.Round(counted.Along));

    /// <summary>Where a fault ended the job, its axes may be beside the path by the allowed position error.</summary>
    private bool IsNear(JobPosition place, Point2D here)
    {
        var (start, segment) = program.SegmentAfter(place.Segments) is var (from, next, _) ? (from, next) : (program.SegmentAfter(place.Segments - 1)!.Value.Segment.End, default);
        var there = segment.Length > 0.0 ? new SegmentPath(start, segment).At(place.Along) : new Point2D(start.X, start.Y);
        var allowed = Reach + program.Profile.Scale.Finer.CountsOf(program.Profile.FollowingErrorAt(program.Profile.FastestMmPerSecond));
        return there.DistanceTo(here) <= allowed || IsAhead(place, here);
    }

    /// <summary>Whether the machine is at the place, or a little ahead of it on its path or on its way to the next stroke.</summary>
    private bool IsAhead(JobPosition place, Point2D here)
    {
        var (reach, slack) = (Reach, Slack);
        var before = place is { Segments: > 0, Along: 0.0 } ? program.SegmentAfter(place.Segments - 1) : null;
        var along = place.Along;
        for (var i = place.Segments; reach >= 0.0; i++)
        {
            var next = program.SegmentAfter(i);
            var from = next?.Start ?? program.Finish;
            if (before is var (_, ended, stroke) && (next?.Stroke != stroke) && IsBetween(ended.End, from ?? ended.End, here, slack)) return true;
            if (next is not var (start, segment, _)) return false;
            var course = new SegmentPath(start, segment);
            if (along > segment.Length + slack) return false;
            var passed = course.LengthTo(here, 0.0);
            if (course.DistanceTo(here) <= slack && (IsUpright(start, segment) || (passed >= along - slack && passed <= along + reach + slack))) return true;
            (reach, along, before) = (reach - Math.Max(0.0, segment.Length - along), 0.0, next);
        }

        return false;
    }

    /// <summary>Each axis makes its part of a rapid in its own time.</summary>
    private static bool IsBetween(CountsPoint one, CountsPoint other, Point2D here, double slack) =>
        here.X >= Math.Min(one.X, other.X) - slack && here.X <= Math.Max(one.X, other.X) + slack && here.Y >= Math.Min(one.Y, other.Y) - slack && here.Y <= Math.Max(one.Y, other.Y) + slack;

    private static bool IsUpright(CountsPoint start, in VectorSegment segment) => (start.X, start.Y) == (segment.End.X, segment.End.Y) && segment.Kind == VectorSegmentKind.Line;

    private double Slack => OnPath + (ReadingSeconds * Speed);

    private double Reach => (LaterSeconds * Speed) + (Speed * Speed / (2.0 * Braking));

    /// <summary>The smallest VD of any sequence, counts/s2.</summary>
    private double Braking { get; } = program.LeastAcceleration;

    /// <summary>The fastest that the path may be anywhere, counts/s: the machine may already be in a faster sequence.</summary>
    private double Speed { get; } = program.Strokes.SelectMany(stroke => stroke.Sequences).Select(sequence => sequence.Speed).DefaultIfEmpty().Max() * JobControl.FeedRange.Max;
}
