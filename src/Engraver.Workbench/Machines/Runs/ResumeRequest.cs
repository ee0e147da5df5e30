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

/// <summary>A job that starts in the middle: where an earlier one ended according to its journal, or from a chosen contour.</summary>
public sealed record ResumeRequest
{
    /// <summary>The default of <see cref="LeadInMm"/>.</summary>
    public const double UsualLeadInMm = 1.0;

    /// <summary>The maximum of <see cref="LeadInMm"/>.</summary>
    public const double LongestLeadInMm = 1000.0;

    /// <summary>Journal of the interrupted job; null where <see cref="Stroke"/> was chosen.</summary>
    public string? Journal { get; init; }

    /// <summary>Index of the first contour to cut, from 0 in the order of cutting; used without a journal.</summary>
    public int Stroke { get; init; }

    /// <summary>Length of the path before the resume position that is cut again, millimetres.</summary>
    public double LeadInMm { get; init; } = UsualLeadInMm;

    /// <summary>The job resumes at the active work origin although it was started at another one: the operator has set the origin again at the same point of
    /// the work.</summary>
    public bool AtOrigin { get; init; }
}

/// <summary>The part of the drawing that START cuts: the rest of an interrupted job, or the contours from one on. Valid until it is cut or the drawing, the
/// settings or the work origin change.</summary>
/// <param name="Shown">Start of the part; earlier segments are shown as done.</param>
/// <param name="Strategy">The strategy with which it was started; null where that is not known.</param>
/// <param name="Drawing">The drawing of the part.</param>
/// <param name="Settings">The settings of the part.</param>
public sealed record JobPart(ResumeRequest Request, JobPlace Shown, ExecutionStrategy? Strategy, Drawing Drawing, DrawingSettings Settings);

/// <summary>The start position of a job, determined before any motion.</summary>
/// <param name="Place">Start; earlier segments are not cut.</param>
/// <param name="LeadIn">Counts before the start that are cut again.</param>
/// <param name="Origin">Position of the drawing's zero.</param>
internal sealed record JobBeginning(JobPlace Place, double LeadIn, OriginRequest Origin)
{
    /// <summary>The height to which the machine returns before it cuts, counts of the controller (<see cref="JobOptions.HeightOfCut"/>).</summary>
    public int? HeightOfCut { get; private init; }

    /// <summary>Why the job cannot be resumed; null if it can, or starts from the beginning.</summary>
    public Diagnostic? Refusal { get; private init; }

    /// <summary>Reads the state of an interrupted job from the machine and determines the resume position. If the operator has set a work origin, the job
    /// resumes at the active one, which must be where the job was started. Otherwise it resumes at its own origin if the controller's zero is unchanged. It is
    /// refused elsewhere, or if the zero cannot be confirmed, unless the operator requests the work origin explicitly; then, or if the origin was set again,
    /// the operator also sets the height.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public static async Task<JobBeginning> FindAsync(IMachineConnection machine, PreparedJob job, MotionProgram program, MachineRunOptions options, MachineMemory memory, CancellationToken cancellation)
    {
        if (options.Resume is not { } request) return new JobBeginning(default, 0.0, options.Origin);
        var leadIn = program.Profile.Scale.Finer.CountsOf(request.LeadInMm);
        if (request.Journal is not { } journal) return new JobBeginning(ToStroke(program, request.Stroke), 0.0, options.Origin);
        var found = await machine.FindResumeAsync(program, options.Strategy, journal, cancellation).ConfigureAwait(false);
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

    /// <summary>The position before a stroke of a program.</summary>
    public static JobPlace ToStroke(MotionProgram program, int stroke) => new(program.Strokes.Take(stroke).Sum(before => before.Sequences.Sum(sequence => sequence.Segments.Count)), 0.0);

    /// <summary>The part of the program that will be cut; planned angles are unchanged.</summary>
    public MotionProgram RestOf(MotionProgram program) => Place == default ? program : RemainingProgram.From(program, Place, LeadIn, static angle => angle).Program;

    /// <summary>Passes the part cut by an earlier job to a judge of the whole drawing.</summary>
    public void Tell(ITraceJudge judge, MotionProgram program)
    {
        foreach (var sample in CutPath.Before(program, Place)) judge.Add(sample);
    }
}

/// <summary>The path of a program up to a position, as samples with the tool on.</summary>
internal static class CutPath
{
    /// <summary>Maximum distance of a chord from its arc, counts.</summary>
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

    /// <summary>Z position, counts, interpolated linearly.</summary>
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
