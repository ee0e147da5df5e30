using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Motion;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>A job that does not begin at its beginning: it goes on where an earlier one ended, by that one's journal, or from a place that was
/// chosen.</summary>
public sealed record ResumeRequest
{
    /// <summary>The default of <see cref="LeadInMm"/>.</summary>
    public const double UsualLeadInMm = 1.0;

    /// <summary>The most that <see cref="LeadInMm"/> may be.</summary>
    public const double LongestLeadInMm = 1000.0;

    /// <summary>Journal of the interrupted job; null where <see cref="Stroke"/> was chosen.</summary>
    public string? Journal { get; init; }

    /// <summary>The first contour that is cut, from 0 in the order of cutting; without a journal.</summary>
    public int Stroke { get; init; }

    /// <summary>Length of the path already cut that is cut again before the place, millimetres.</summary>
    public double LeadInMm { get; init; } = UsualLeadInMm;

    /// <summary>The job goes on at the active work origin though it was begun elsewhere: the operator has set that origin anew at the same place of the
    /// work.</summary>
    public bool AtOrigin { get; init; }
}

/// <summary>What START would cut where it is not the whole drawing: what an interrupted job has left, or the contours from one on. It lasts until it is
/// cut, or drawing, settings or work origin change.</summary>
/// <param name="Shown">What lies before it is shown as done.</param>
/// <param name="Mode">The mode in which it must be run; null for any.</param>
/// <param name="Drawing">The drawing for which it was chosen.</param>
/// <param name="Settings">The settings for which it was chosen.</param>
public sealed record JobPart(ResumeRequest Request, JobPlace Shown, JobMode? Mode, Drawing Drawing, DrawingSettings Settings);

/// <summary>Where a job begins, found before anything moves.</summary>
/// <param name="Place">What lies before it is not cut.</param>
/// <param name="LeadIn">Counts before the place that are cut again.</param>
/// <param name="Origin">Where the drawing's zero lies.</param>
internal sealed record JobBeginning(JobPlace Place, double LeadIn, OriginRequest Origin)
{
    /// <summary>The height to which the machine returns before it cuts, counts of the controller (<see cref="JobOptions.HeightOfCut"/>).</summary>
    public int? HeightOfCut { get; private init; }

    /// <summary>Why the job cannot be resumed; null when it can, or begins at its beginning.</summary>
    public Diagnostic? Refusal { get; private init; }

    /// <summary>Asks the machine what it has kept of an interrupted job, and finds where it is to go on: at the active work origin where the operator has
    /// set one, which must be where the job was
    /// begun; otherwise where the job had it, as long as the controller counts from the same zero. Another place is refused, also where nothing tells
    /// whether the counts of then are those of now, unless the operator
    /// asks for the work origin by name; then, or where the origin was set anew, the height is the operator's too.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public static async Task<JobBeginning> FindAsync(IMachineConnection machine, PreparedJob job, MotionProgram program, MachineRunOptions options, MachineMemory memory, CancellationToken cancellation)
    {
        if (options.Resume is not { } request) return new JobBeginning(default, 0.0, options.Origin);
        var leadIn = program.Profile.Scale.Finer.CountsOf(request.LeadInMm);
        if (request.Journal is not { } journal) return new JobBeginning(ToStroke(program, request.Stroke), 0.0, options.Origin);
        var found = await machine.FindResumeAsync(program, options.Mode, journal, cancellation).ConfigureAwait(false);
        if (JobWords.WhyNotResumed(found, job) is { } why) return Refused(options, PreparationRules.NotResumed.At(default, journal, why));
        if (found.IsUnsealed) options.Told?.Invoke(PreparationRules.JournalUnsealed.At(default, journal));
        var resumed = new JobBeginning(found.Place, leadIn + found.Doubt, options.Origin);
        if (request.AtOrigin) return resumed;
        var then = Shown(Millimetres(program, found.Frame));
        if (options.Origin is not OriginRequest.Work)
        {
            return IsAt(options.Origin, found.Frame, program.Profile.Scale) ? resumed : Refused(options, PreparationRules.NotResumed.At(default, journal, Wording.Get("Resume.OtherPlace", then)));
        }

        if (found.IsSameZero || (program.Profile.Axes.Z?.Homing is not null && memory.WasHomedBy(program.Profile))) resumed = resumed with { HeightOfCut = found.HeightOfCut };
        var isSet = memory.ActiveOrigin is { IsAssumed: false };
        if (!isSet && found.IsSameZero) return resumed with { Origin = new OriginRequest.Given(Millimetres(program, found.Frame)) };
        if ((isSet ? memory.ActiveOrigin!.Plane : default(CountsPoint)) is not { } set || (set.X, set.Y) == (found.Frame.X, found.Frame.Y)) return resumed;
        return Refused(options, PreparationRules.NotResumed.At(default, journal, Wording.Get("Resume.OtherOrigin", then, memory.Active, Shown(Millimetres(program, set)))));
    }

    private static bool IsAt(OriginRequest origin, CountsPoint frame, CountsScale scale) =>
        origin is OriginRequest.Given { Machine: var at } && scale.Holds(Bounds2D.FromCorners(at, at), default) && scale.ToCounts(at) is var place && (place.X, place.Y) == (frame.X, frame.Y);

    private static JobBeginning Refused(MachineRunOptions options, Diagnostic why) => new(default, 0.0, options.Origin) { Refusal = why };

    private static Point2D Millimetres(MotionProgram program, CountsPoint counts) => program.Profile.Scale.ToMillimetres(counts.X, counts.Y);

    private static string Shown(Point2D place) => string.Create(CultureInfo.InvariantCulture, $"{place.X:0.###},{place.Y:0.###}");

    /// <summary>The place before a stroke of a program.</summary>
    public static JobPlace ToStroke(MotionProgram program, int stroke) => new(program.Strokes.Take(stroke).Sum(before => before.Sequences.Sum(sequence => sequence.Segments.Count)), 0.0);

    /// <summary>The program as far as it will be cut; angles as they were planned.</summary>
    public MotionProgram RestOf(MotionProgram program) => Place == default ? program : RemainingProgram.From(program, Place, LeadIn, static angle => angle).Program;

    /// <summary>What an earlier job has cut, for a judge who looks at the whole drawing.</summary>
    public void Tell(ITraceJudge judge, MotionProgram program)
    {
        foreach (var sample in CutPath.Before(program, Place)) judge.Add(sample);
    }
}

/// <summary>The path of a program up to a place, as samples with the tool on.</summary>
internal static class CutPath
{
    /// <summary>A chord leaves its arc by no more than this, counts.</summary>
    private const double Sagitta = 0.2;

    public static IEnumerable<TraceSample> Before(MotionProgram program, JobPlace place)
    {
        var (left, scale) = (place.Segments, program.Profile.Scale);
        foreach (var stroke in program.Strokes)
        {
            if (left < 0 || (left == 0 && place.Along == 0.0)) yield break;
            yield return Sample(scale, new Point2D(stroke.Start.X, stroke.Start.Y), Math.Max(program.Profile.Height?.RetractHeight ?? 0.0, scale.ToMillimetres(stroke.Start.Z)), cutting: false);
            foreach (var sequence in stroke.Sequences)
            {
                var start = sequence.Start;
                foreach (var segment in sequence.Segments)
                {
                    var length = left > 0 ? segment.Length : left == 0 ? place.Along : 0.0;
                    if (length > 0.0)
                    {
                        foreach (var at in Points(new SegmentCourse(start, segment), segment, length)) yield return Sample(scale, at, scale.ToMillimetres(HeightOf(start, segment, at)), cutting: true);
                    }

                    left--;
                    start = segment.End;
                }
            }
        }
    }

    private static IEnumerable<Point2D> Points(SegmentCourse course, VectorSegment segment, double length)
    {
        var chords = segment.Kind == VectorSegmentKind.Line ? 1 : Math.Max(1, (int)Math.Ceiling(length / Math.Sqrt(8.0 * Sagitta * segment.Radius)));
        for (var i = 0; i <= chords; i++) yield return course.At(length * i / chords);
    }

    /// <summary>Counts of the Z axis; a line rises evenly.</summary>
    private static double HeightOf(CountsPoint start, in VectorSegment segment, Point2D at)
    {
        if (start.Z == segment.End.Z) return start.Z;
        var (from, to) = (new Point2D(start.X, start.Y), new Point2D(segment.End.X, segment.End.Y));
        return start.Z + (((double)segment.End.Z - start.Z) * (from == to ? 1.0 : Math.Min(1.0, from.DistanceTo(at) / from.DistanceTo(to))));
    }

    private static TraceSample Sample(CountsScale scale, Point2D at, double height, bool cutting)
    {
        var place = scale.ToMillimetres(at.X, at.Y);
        return new TraceSample(0.0, place.X, place.Y, cutting, height);
    }
}
