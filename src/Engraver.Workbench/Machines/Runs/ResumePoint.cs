using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Origins;
using Engraver.Core.Motion;
using Engraver.Core.Verification;
using Engraver.Workbench.Documents;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The start position of a job, determined before any motion.</summary>
/// <param name="Place">Start; earlier segments are not cut.</param>
/// <param name="LeadIn">Counts before the start that are cut again.</param>
/// <param name="Origin">Position of the drawing's zero.</param>
internal sealed record ResumePoint(JobPosition Place, double LeadIn, OriginRequest Origin)
{
    /// <summary>The height to which the machine returns before it cuts, counts of the controller (<see cref="JobOptions.HeightOfCut"/>).</summary>
    public int? HeightOfCut { get; private init; }

    /// <summary>Why the job cannot be resumed; null if it can, or starts from the beginning.</summary>
    public Diagnostic? Refusal { get; private init; }

    /// <summary>Reads the state of an interrupted job from the machine and determines the resume position. If the operator has set a work origin, the job
    /// resumes at the active or the named one, which must be where the job was started. Otherwise it resumes at its own origin if the controller's zero is
    /// unchanged. It is refused elsewhere, or if the zero cannot be confirmed, unless the operator requests the work origin explicitly; then, or if the
    /// origin was set again, the operator also sets the height.</summary>
    /// <exception cref="ControllerException">The link failed.</exception>
    public static async Task<ResumePoint> FindAsync(IMachineConnection machine, PreparedJob job, MotionProgram program, MachineRunOptions options, StoredMachineState memory, CancellationToken cancellation)
    {
        if (options.Resume is not { } request) return new ResumePoint(default, 0.0, options.Origin);
        var leadIn = program.Profile.Scale.Finer.CountsOf(request.LeadInMm);
        if (request.Journal is not { } journal) return new ResumePoint(ToStroke(program, request.Stroke), 0.0, options.Origin);
        var found = await machine.FindResumeAsync(program, options.Strategy, journal, cancellation).ConfigureAwait(false);
        if (JournalSettings.ResumeRefusal(found, job) is { } why) return Refused(options, PreparationRules.NotResumed.At(default, journal, why));
        if (found.IsUnsealed) options.FindingReported?.Invoke(PreparationRules.JournalUnsealed.At(default, journal));
        var resumed = new ResumePoint(found.Place, leadIn + found.Doubt, options.Origin);
        if (!found.IsToolChange && JobSection.At(job, program, found.Place) is { Number: > 1, Tool.Repeat: null } section && found.Place == new JobPosition(section.From, 0.0)) options.FindingReported?.Invoke(OperationRules.ToolNotChanged.At(default, journal, section.Tool.Tool.Title));
        if (request.AtOrigin) return resumed;
        if (options.Origin is OriginRequest.NamedOrigin { Name: var name }) memory = memory with { Active = name };
        var then = Format(Millimetres(program, found.Frame));
        if (options.Origin is not (OriginRequest.ActiveOrigin or OriginRequest.NamedOrigin))
        {
            return IsAt(options.Origin, found.Frame, program.Profile.Scale) ? resumed : Refused(options, PreparationRules.NotResumed.At(default, journal, Wording.Get("Resume.OtherPlace", then)));
        }

        if (found.IsSameZero || (program.Profile.Axes.Z?.Homing is not null && memory.WasHomedBy(program.Profile))) resumed = resumed with { HeightOfCut = found.HeightOfCut };
        var isSet = memory.ActiveOrigin is { IsAssumed: false };
        if (!isSet && found.IsSameZero) return resumed with { Origin = new OriginRequest.MachinePoint(Millimetres(program, found.Frame)) };
        if ((isSet ? memory.ActiveOrigin!.Plane : default(CountsPoint)) is not { } set || (set.X, set.Y) == (found.Frame.X, found.Frame.Y)) return resumed;
        return Refused(options, PreparationRules.NotResumed.At(default, journal, Wording.Get("Resume.OtherOrigin", then, memory.Active, Format(Millimetres(program, set)))));
    }

    private static bool IsAt(OriginRequest origin, CountsPoint frame, CountsScale scale) =>
        origin is OriginRequest.MachinePoint { Machine: var at } && scale.IsInRange(Bounds2D.FromCorners(at, at), default) && scale.ToCounts(at) is var place && (place.X, place.Y) == (frame.X, frame.Y);

    private static ResumePoint Refused(MachineRunOptions options, Diagnostic why) => new(default, 0.0, options.Origin) { Refusal = why };

    private static Point2D Millimetres(MotionProgram program, CountsPoint counts) => program.Profile.Scale.ToMillimetres(counts.X, counts.Y);

    private static string Format(Point2D place) => string.Create(CultureInfo.InvariantCulture, $"{place.X:0.###},{place.Y:0.###}");

    /// <summary>The position before a stroke of a program.</summary>
    public static JobPosition ToStroke(MotionProgram program, int stroke) => new(program.Strokes.Take(stroke).Sum(before => before.Sequences.Sum(sequence => sequence.Segments.Count)), 0.0);

    /// <summary>The part of a program that will be cut; planned angles are unchanged.</summary>
    public MotionProgram RestOf(MotionProgram program) => Place == default ? program : RemainingProgram.From(program, Place, LeadIn, static angle => angle).Program;

    /// <summary>Passes the part cut by an earlier job to a judge of the drawing, or of the strokes of one tool.</summary>
    /// <param name="section">The section that is judged; null for the whole job.</param>
    public void FeedJudge(ITraceJudge judge, MotionProgram program, JobSection? section)
    {
        var (part, place) = section is null ? (program, Place) : (section.Of(program), new JobPosition(Place.Segments - section.From, Place.Along));
        foreach (var sample in CutPath.SamplesBefore(part, place)) judge.Add(sample);
        judge.BeginRun();
    }
}
