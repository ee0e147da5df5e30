using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Machines.Moves;
using Engraver.Core.Posts;
using Engraver.Core.Toolpaths;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Certificates;

/// <summary>Reads a job's program back and creates the certificate.</summary>
public static class Certification
{
    /// <summary>Posts the job unless a program is given, reads it back with the target's reader, and compares both with the drawing.</summary>
    /// <returns>Without a certificate when there is no program to read; a certificate that is not ok when the program differs from the drawing.</returns>
    /// <exception cref="SettingException">A named layer or the entry entity is not in the drawing.</exception>
    /// <exception cref="ArgumentException">There is no reader for this target.</exception>
    /// <exception cref="OperationCanceledException">The caller cancelled.</exception>
    public static async Task<CertificationResult> CertifyAsync(CertificationRequest request, IProgress<ReplayProgress>? progress, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(request);
        var (drawing, settings, post) = (request.Drawing, request.Settings, request.Target.Post);
        var reader = request.Reader ?? throw new ArgumentException($"Nothing reads programs of {post.Name}.", nameof(request));
        var job = JobPreparation.PrepareUnlessCancelled(drawing, settings, post.Motion ?? MotionStyle.Continuous, cancellation, request.Values);
        var (posted, fitted) = Posted(request, job);
        if (posted.Text is not { } text) return new CertificationResult(null, posted.Diagnostics) { NoProgramReason = posted.NoProgramReason };
        var report = await ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), reader, drawing, settings, progress, cancellation, (request.PostParameters ?? PostParameters.Defaults) with { FittedProgram = fitted, Values = request.Values }).ConfigureAwait(false);
        IReadOnlyList<Diagnostic> findings = [.. posted.Diagnostics, .. report.Diagnostics];
        return new CertificationResult(Certificate(request, job, fitted, text, report, findings), findings);
    }

    /// <summary>The identity of the job of a request. Its program is the given one, or the one that would be posted now.</summary>
    public static JobIdentity IdentityOf(CertificationRequest request)
    {
        ArgumentNullException.ThrowIfNull(request);
        return JobIdentity.Of(request.Drawing, request.Settings, request.Target.Post.Name, Program) with { Drawing = request.DrawingHash, Dialect = request.Dialect };

        string? Program()
        {
            var job = JobPreparation.Prepare(request.Drawing, request.Settings, request.Target.Post.Motion ?? MotionStyle.Continuous, request.Values);
            return Posted(request, job).Posted.Text is { } text ? ContentHash.OfText(text) : null;
        }
    }

    /// <returns>The program, and its motion with feeds limited to the link if the machine of the profile runs it.</returns>
    private static (PostedProgram Posted, MotionProgram? Fitted) Posted(CertificationRequest request, PreparedJob job)
    {
        var (drawing, settings, post) = (request.Drawing, request.Settings, request.Target.Post);
        var fit = post.Motion is not null && job.Motion.Program is { } program ? JobPlan.FitToLink(program, request.Address, request.Strategy, drawing) : null;
        if (request.Program is { } given) return (new PostedProgram(given.Text, job.Diagnostics), fit?.Program);
        if (post.Motion is null) return (PostedProgram.Create(drawing, settings, post, request.Options, request.Values), null);
        return (PostedProgram.FromJob(fit is null ? job : job with { Motion = job.Motion with { Program = fit.Program } }, post, request.Options, withoutStops: true), fit?.Program);
    }

    private static JobCertificate Certificate(CertificationRequest request, PreparedJob job, MotionProgram? fitted, string text, VerificationReport report, IReadOnlyList<Diagnostic> findings)
    {
        var (machine, words) = (request.Settings.Machine, SettingValues.Of(request.Settings.AsOpened(request.Drawing)));
        return new JobCertificate
        {
            Issued = request.Now,
            IssuedBy = $"CncEngraver {ProgramVersion}",
            Drawing = new CertifiedDrawing(Path.GetFileName(request.Drawing.FileName), request.DrawingHash, request.Drawing.Bytes),
            Program = new CertifiedProgram(request.Target.Post.Name, request.Program is { } given ? Path.GetFileName(given.File) : null, ContentHash.OfText(text), text.Count(letter => letter == '\n')) { Dialect = request.Dialect },
            Settings = new CertifiedSettings(JobIdentity.OfSettings(words), words),
            Profile = new CertifiedProfile(JobIdentity.OfProfile(machine), machine.Scale.X.CountsPerMillimetre, machine.Scale.Y.CountsPerMillimetre, machine.FeedMmPerMinute, machine.RapidMmPerMinute),
            Plate = request.Values.IsNone ? null : request.Values.ToString(),
            Fonts = job.Fonts,
            Ok = report.Ok,
            MaxDeviation = report.MaxDeviationMm,
            CornerDeviation = report.CornerDeviationMm,
            Tolerance = report.ToleranceMm,
            MissingLength = report.MissingLengthMm,
            ExtraLength = report.ExtraLengthMm,
            Operations = report.Operations.Count == 0 ? null : report.Operations,
            Limits = Limits(job, request.Reader is { ReportsHeights: true }),
            PlannedSeconds = fitted is null ? null : JobPlan.PlannedTimes(fitted, request.Address, request.Strategy).Total,
            Findings = [.. findings.OrderByDescending(found => found.Severity).Select(Finding)],
        };
    }

    private static CertifiedLimits? Limits(PreparedJob job, bool tellsHeights)
    {
        var (box, axes) = (FrameOutline.BoundsOf(job.Toolpath), job.Settings.Machine.Axes);
        if (box.IsEmpty) return null;
        var (x, y) = (Length(axes.X), Length(axes.Y));
        var limits = new CertifiedLimits(box.MinX, box.MinY, box.MaxX, box.MaxY, x, y, !(box.Width > x) && !(box.Height > y));
        if (!tellsHeights || axes.Z is not { } axis || job.Motion.Program is not { } program || MotionExtents.Of(program).Heights(program.Profile, dryRun: false) is not { } heights) return limits;
        var (one, other, z) = (axis.Scale.ToMillimetres(heights.Min), axis.Scale.ToMillimetres(heights.Max), Length(axis));
        return limits with { MinZ = Math.Min(one, other), MaxZ = Math.Max(one, other), TravelZ = z, Fits = limits.Fits && !(Math.Abs(one - other) > z) };
    }

    private static double? Length(MachineAxis axis) => axis.Travel is { } travel ? travel.Max - travel.Min : null;

    private static CertifiedFinding Finding(Diagnostic found) =>
        new(found.Id, found.Severity.ToString().ToLower(CultureInfo.InvariantCulture), found.Source.Line > 0 ? (int)found.Source.Line : null, found.Sentence);

    private static string ProgramVersion => typeof(Certification).Assembly.GetName().Version?.ToString(3) ?? "";
}

/// <summary>Result of a certification.</summary>
/// <param name="Certificate">Null when there is no program.</param>
/// <param name="Diagnostics">Findings of all stages, the post and the reader.</param>
public sealed record CertificationResult(JobCertificate? Certificate, IReadOnlyList<Diagnostic> Diagnostics)
{
    /// <summary>Why there is no program, without a full stop.</summary>
    public string NoProgramReason { get; init; } = "";
}
