using System.Globalization;
using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Core.Motion;
using Engraver.Core.Plots;
using Engraver.Core.Verification;
using Engraver.Workbench.Certificates;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines.Runs;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Reports.Pages;

/// <summary>A job report as a self-contained HTML page: pictures of the path, of the speed and of the run, the summary of times, lengths and costs, the start
/// checks, the certificate, the findings, the settings.</summary>
public static class JobReportPage
{
    /// <summary>Maximum number of characters of one picture; a page has at most two.</summary>
    private const int MaxPictureSegments = 1_500_000;

    /// <summary>Maximum number of listed findings, worst first; the others are counted.</summary>
    private const int MaxFindings = 500;

    /// <summary>The default path of a drawing's report.</summary>
    public static string PathOf(string drawing) => Path.ChangeExtension(drawing, null) + ".report.html";

    /// <summary>Writes the page with LF line ends and invariant numbers. The same report gives the same bytes.</summary>
    /// <param name="here">Time zone of displayed times.</param>
    public static void Write(JobReport report, TimeZoneInfo here, TextWriter output)
    {
        ArgumentNullException.ThrowIfNull(report);
        ArgumentNullException.ThrowIfNull(output);
        using var page = new PageWriter(output);
        page.Begin(Path.GetFileName(report.Job.Drawing.FileName));
        page.Paragraph(Path.GetFullPath(report.Job.Drawing.FileName), "code");
        page.Paragraph(Wording.Get("JobReport.Created", Time(report.Now, here)), "quiet");
        page.Paragraph(Verdict(report), "verdict");
        Pictures(report, page);
        Sheet(report, page);
        if (report.Run is { } run) Run(report, run, here, page);
        else if (report.Journalled is { } told) page.Section("run", Wording.Get("JobReport.Run"), () => Journalled(report, told, page));
        page.Section("certificate", Wording.Get("JobReport.Certificate"), () =>
        {
            Certificate(report.Certificate, here, page);
            if (report.OtherCertificates is [_, ..] others) OtherCertificates(others, here, page);
        });
        page.Section("findings", Wording.Get("JobReport.Findings"), () => Findings(report.Findings, page));
        page.Section("settings", Wording.Get("JobReport.Settings"), () => Settings(report, page));
        page.Finish();
    }

    private static string Verdict(JobReport report) => report switch
    {
        { Run: { RanTrajectories: true } run } => Wording.Get("JobReport.VerdictTrajectories", OutcomeText.DisplayText(run.Outcome), Kind(run.Kind)),
        { Run: { } run, RunDifferences: [_, ..] } => Wording.Get("JobReport.VerdictOtherRun", OutcomeText.DisplayText(run.Outcome), Kind(run.Kind)),
        { Run: { } run } => Wording.Get("JobReport.VerdictRun", OutcomeText.DisplayText(run.Outcome), Kind(run.Kind)),
        { Journalled: { } told } => Wording.Get(report.Journal.IsThisJob ? "JobReport.VerdictRun" : "JobReport.VerdictOtherRun", Outcome(told), Wording.Get(told.IsDryRun ? "JobReport.DryRun" : "JobReport.Run")),
        { Motion: null } => Wording.Get("JobReport.VerdictNothing"),
        _ => Wording.Get("JobReport.VerdictPlanned"),
    };

    private static void Pictures(JobReport report, PageWriter page)
    {
        var (job, title) = (report.Job, Path.GetFileName(report.Job.Drawing.FileName));
        page.Section("path", Wording.Get("JobReport.Path"), () => Picture(PlotModel.FromPath(job.Toolpath, title), page));
        if (report.Motion is { } motion) page.Section("speed", Wording.Get("JobReport.Speed"), () => page.Figure("chart", output => SpeedPicture.Write(motion, output)));
        if (report.Trace is { } trace) page.Section("deviation", Wording.Get("JobReport.Deviation"), () => Deviation(report, trace, title, page));
        else if (report.TraceProblem is { } problem) page.Section("deviation", Wording.Get("JobReport.Deviation"), () => page.Paragraph(Wording.Get("JobReport.TraceNotShown", problem)));
    }

    private static void Deviation(JobReport report, RunTrace trace, string title, PageWriter page)
    {
        Picture(RunPlot.Create(report.Job.Analysed, trace, RunMeasure.Deviation, title), page);
        if (report.Run is { OpenLoop: { Count: > 0 } axes }) page.Paragraph(Wording.Get("JobReport.OpenLoop", string.Join(", ", axes)));
    }

    /// <summary>A picture with too many lines for a browser is simplified to a resolution, which is stated.</summary>
    private static void Picture(PlotModel plot, PageWriter page)
    {
        double? resolution = null;
        page.Figure("picture", output => resolution = SvgPlotWriter.WriteWithin(plot, MaxPictureSegments, output));
        if (resolution is { } millimetres) page.Paragraph(Wording.Get("JobReport.Thinned", plot.Strokes.Sum(stroke => stroke.Segments.Count), millimetres), "quiet");
    }

    /// <summary>The figures have the names of <c>plan --json</c>.</summary>
    private static void Sheet(JobReport report, PageWriter page) => page.Section("sheet", Wording.Get("JobReport.Sheet"), () =>
    {
        page.Inside("sheet", () => Totals(report, page));
        if (report.Shares is { } shares) page.Pairs(Shares(shares));
    });

    /// <summary>One line for each operation and each tool, with the cost as its value.</summary>
    private static IEnumerable<PagePair> Shares(JobShares shares) =>
    [
        .. shares.Operations.Select(one => Share(one.Share, $"operations.{one.Operation.Id}.planned.cost")),
        .. shares.Tools.Select(one => Share(one.Share, string.Create(CultureInfo.InvariantCulture, $"tools.{one.Tool.Number}.planned.cost"))),
        Share(shares.Around, "around.cost"),
    ];

    private static PagePair Share(JobShare share, string key) => new(share.Title, share.Text, key, share.Cost?.Total);

    private static void Totals(JobReport report, PageWriter page)
    {
        var (times, sequence, has) = (report.Times, report.Job.Sequence, report.Program is not null);
        double? Planned(double seconds) => has ? seconds : null;
        MotionPeaks? peaks = report.Program is { } program ? MotionPeaks.From(program) : null;
        page.Inside("", () => page.Pairs(
        [
            PagePair.Of(Wording.Get("JobReport.SecondsTotal"), "seconds.total", Planned(times.Total), "0.0"),
            PagePair.Of(Wording.Get("JobReport.SecondsCutting"), "seconds.cutting", Planned(times.Cutting), "0.0"),
            PagePair.Of(Wording.Get("JobReport.SecondsRapid"), "seconds.rapid", Planned(times.Rapid), "0.0"),
            PagePair.Of(Wording.Get("JobReport.SecondsDwell"), "seconds.dwell", Planned(times.Dwell), "0.0"),
            PagePair.Of(Wording.Get("JobReport.CutLength"), "cutLength", sequence.PathLength, "0.00"),
            PagePair.Of(Wording.Get("JobReport.Travel"), "travel", sequence.Travel, "0.00"),
        ]));
        page.Inside("", () => page.Pairs(
        [
            new PagePair(Wording.Get("JobReport.Contours"), Wording.Get("JobReport.ContourCount", sequence.Contours, sequence.Closed, sequence.Open), Style: "number"),
            PagePair.Of(Wording.Get("JobReport.Segments"), "segments", report.Program?.SegmentCount ?? 0, "0"),
            PagePair.Of(Wording.Get("JobReport.PeakSpeed"), "peakSpeed", peaks?.Speed, "0.00"),
            PagePair.Of(Wording.Get("JobReport.PeakAcceleration"), "peakAxisAcceleration", peaks?.AxisAcceleration, "0"),
            .. report.Cost is { } cost ? Costs(cost) : [],
        ]));
    }

    private static IEnumerable<PagePair> Costs(JobCost cost) =>
    [
        PagePair.Of(Wording.Get("JobReport.Cost"), "cost", cost.Total, "0.00"),
        PagePair.Of(Wording.Get("JobReport.CostTime"), "costParts.time", cost.Time, "0.00"),
        PagePair.Of(Wording.Get("JobReport.CostLength"), "costParts.length", cost.Length, "0.00"),
        PagePair.Of(Wording.Get("JobReport.CostStarts"), "costParts.starts", cost.Starts, "0.00"),
    ];

    private static void Run(JobReport report, Histories.HistoryEntry run, TimeZoneInfo here, PageWriter page)
    {
        page.Section("run", Wording.Get("JobReport.Run"), () =>
        {
            if (report.RunDifferences is [_, ..] differs) page.Paragraph(SettingWording.OnConsole(Wording.Get("JobReport.OtherRun", string.Join(", ", differs.Select(CertificateStatus.PartName)))));
            if (run.RanTrajectories) page.Paragraph(Wording.Get("JobReport.RanTrajectories"));
            if (run.OpenLoop is { Count: > 0 } axes) page.Paragraph(Wording.Get("JobReport.OpenLoop", string.Join(", ", axes)));
            page.Pairs(RunPairs(report, run, here));
        });
        page.Section("checks", Wording.Get("JobReport.Checks"), () =>
        {
            if (run.Checks is not { } checks) page.Paragraph(Wording.Get("JobReport.NoChecks"));
            else page.Table([Wording.Get("JobReport.State"), Wording.Get("JobReport.Check")], checks.Select(check => (string[])[Wording.Get(!check.Ok ? "JobReport.NotOk" : check.Warning ? "JobReport.Warning" : "JobReport.Ok"), check.Sentence]));
        });
    }

    private static string Outcome(JournalledRun told) => told.Outcome is { } outcome ? OutcomeText.DisplayText(outcome) : Wording.Get("Outcome.Begun");

    /// <param name="kind">Kind from the history.</param>
    private static string Kind(string kind) => kind switch
    {
        "dryRun" => Wording.Get("JobReport.DryRun"),
        "simulation" => Wording.Get("JobReport.Simulation"),
        _ => Wording.Get("JobReport.Run"),
    };

    private static void Journalled(JobReport report, JournalledRun told, PageWriter page)
    {
        page.Paragraph(Wording.Get("JobReport.FromJournalOnly"));
        page.Pairs(
        [
            new PagePair(Wording.Get("JobReport.Outcome"), Outcome(told), "outcome"),
            new PagePair(Wording.Get("JobReport.Message"), told.Sentence),
            PagePair.Of(Wording.Get("JobReport.SecondsRun"), "seconds", told.Seconds, "0.0"),
            new PagePair(Wording.Get("JobReport.Journal"), report.Journal.File, Style: "code"),
        ]);
    }

    private static IEnumerable<PagePair> RunPairs(JobReport report, Histories.HistoryEntry run, TimeZoneInfo here) =>
    [
        new PagePair(Wording.Get("JobReport.Date"), Time(run.Date, here)),
        new PagePair(Wording.Get("JobReport.Outcome"), OutcomeText.DisplayText(run.Outcome), "outcome"),
        new PagePair(Wording.Get("JobReport.Message"), run.Sentence),
        .. run.Plate is { } plate ? new[] { new PagePair(Wording.Get("JobReport.Plate"), plate, "plate") } : [],
        new PagePair(Wording.Get("JobReport.Machine"), $"{run.Address} {run.Mode}"),
        PagePair.Of(Wording.Get("JobReport.SecondsRun"), "seconds", run.Seconds, "0.0"),
        PagePair.Of(Wording.Get(run.OpenLoop is null ? "JobReport.MaxDeviation" : "JobReport.CommandedDeviation"), "maxDeviation", run.MaxDeviation, "0.0000"),
        .. CornerDeviation(run.CornerDeviation, "cornerDeviation"),
        PagePair.Of(Wording.Get("JobReport.Tolerance"), "tolerance", RunJudge.Tolerances(report.Job).Deviation, "0.0000"),
        PagePair.Of(Wording.Get("JobReport.Missing"), "missingLength", run.MissingLength, "0.####"),
        .. Measured(run.Operations, "operation"),
        new PagePair(Wording.Get("JobReport.Journal"), run.Journal ?? "–", Style: "code"),
    ];

    /// <param name="deviation">Null where corners may not be rounded.</param>
    private static PagePair[] CornerDeviation(double? deviation, string key) => deviation is null ? [] : [PagePair.Of(Wording.Get("JobReport.CornerDeviation"), key, deviation, "0.0000")];

    /// <param name="operations">Null where nothing was measured.</param>
    /// <param name="key">Before the id of an operation in the keys of the rows.</param>
    private static IEnumerable<PagePair> Measured(IReadOnlyList<MeasuredOperation>? operations, string key) => (operations ?? []).Select(one => new PagePair(
        Wording.Get("JobReport.Operation", one.Title),
        Wording.Get("JobReport.OperationMeasured", one.MaxDeviation, one.MissingLength, one.ExtraLength, one.Feed is { } feed ? NumberText.Rounded(feed, 1) : "–", one.Depths.Count == 0 ? "–" : string.Join(", ", one.Depths.Select(depth => depth is { } deep ? NumberText.Rounded(deep, 3) : "–"))),
        $"{key}.{one.Id}.measured"));

    private static void Certificate(CertificateStatus standing, TimeZoneInfo here, PageWriter page)
    {
        page.Paragraph(SettingWording.OnConsole(standing.Message) + ".");
        if (standing.Certificate is not { } certificate) return;
        page.Pairs(
        [
            new PagePair(Wording.Get("JobReport.Validity"), Wording.Get("CertificateState." + standing.State), "standing"),
            new PagePair(Wording.Get("JobReport.Issued"), $"{Time(certificate.Issued, here)}, {certificate.IssuedBy}"),
            new PagePair(Wording.Get("JobReport.Target"), certificate.Program.Target, "program.target"),
            PagePair.Of(Wording.Get("JobReport.MaxDeviation"), "certificate.maxDeviation", certificate.MaxDeviation, "0.0000"),
            .. CornerDeviation(certificate.CornerDeviation, "certificate.cornerDeviation"),
            PagePair.Of(Wording.Get("JobReport.Tolerance"), "certificate.tolerance", certificate.Tolerance, "0.0000"),
            PagePair.Of(Wording.Get("JobReport.Missing"), "certificate.missingLength", certificate.MissingLength, "0.####"),
            PagePair.Of(Wording.Get("JobReport.Extra"), "certificate.extraLength", certificate.ExtraLength, "0.####"),
            .. Measured(certificate.Operations, "certificate.operation"),
            new PagePair(Wording.Get("JobReport.CutExtents"), certificate.Limits is { } box ? Box(box) : "–"),
            PagePair.Of(Wording.Get("JobReport.SecondsTotal"), "certificate.plannedSeconds", certificate.PlannedSeconds, "0.0"),
            new PagePair(Wording.Get("JobReport.DrawingHash"), certificate.Drawing.Sha256 ?? "–", "drawing.sha256", Style: "code"),
            new PagePair(Wording.Get("JobReport.ProgramHash"), certificate.Program.Sha256, "program.sha256", Style: "code"),
            new PagePair(Wording.Get("JobReport.SettingsHash"), certificate.Settings.Sha256, "settings.sha256", Style: "code"),
            new PagePair(Wording.Get("JobReport.ProfileHash"), certificate.Profile.Sha256, "profile.sha256", Style: "code"),
        ]);
    }

    private static void OtherCertificates(IReadOnlyList<(string Target, CertificateStatus Standing)> others, TimeZoneInfo here, PageWriter page)
    {
        string Figure(double? value) => value?.ToString("0.####", CultureInfo.InvariantCulture) ?? "–";
        page.Paragraph(Wording.Get("JobReport.OtherCertificates"));
        page.Table(
            [Wording.Get("JobReport.Target"), Wording.Get("JobReport.Validity"), Wording.Get("JobReport.Issued"), Wording.Get("JobReport.MaxDeviation"), Wording.Get("JobReport.Tolerance"), Wording.Get("JobReport.ProgramHash")],
            others.Select(one => (string[])[one.Target, Wording.Get("CertificateState." + one.Standing.State), one.Standing.Certificate is { } made ? Time(made.Issued, here) : "–", Figure(one.Standing.Certificate?.MaxDeviation), Figure(one.Standing.Certificate?.Tolerance), one.Standing.Certificate?.Program.Sha256 ?? "–"]));
    }

    private static string Box(CertifiedLimits box)
    {
        var fits = !box.Fits ? Wording.Get("JobReport.FitsNot") : box is { TravelX: null, TravelY: null, TravelZ: null } ? Wording.Get("JobReport.NoTravel") : Wording.Get("JobReport.Fits");
        return box is { MinZ: { } low, MaxZ: { } high } ? Wording.Get("JobReport.BoxWithHeights", box.MinX, box.MaxX, box.MinY, box.MaxY, low, high, fits) : Wording.Get("JobReport.Box", box.MinX, box.MaxX, box.MinY, box.MaxY, fits);
    }

    private static void Findings(IReadOnlyList<Diagnostic> findings, PageWriter page)
    {
        if (findings.Count == 0) page.Paragraph(Wording.Get("JobReport.NoFindings"));
        else page.Table([Wording.Get("JobReport.Id"), Wording.Get("JobReport.Severity"), Wording.Get("JobReport.Line"), Wording.Get("JobReport.Finding")], findings.Take(MaxFindings).Select(found => (string[])[found.Id, Wording.Get("ReportSeverity." + found.Severity), found.Source.Line > 0 ? found.Source.Line.ToString(CultureInfo.InvariantCulture) : "", found.Message]));
        if (findings.Count > MaxFindings) page.Paragraph(Wording.Get("JobReport.MoreFindings", findings.Count - MaxFindings), "quiet");
    }

    private static void Settings(JobReport report, PageWriter page)
    {
        var machine = report.Job.Settings.Machine;
        page.Pairs(
        [
            .. SettingValues.Of(report.Job.Recorded).Where(one => one.Key != SettingTable.Operations.Key).Select(one => new PagePair(SettingTable.Find(one.Key)!.Name, one.Value, "settings." + one.Key)),
            .. OperationSummary.Of(report.Job).Select(one => new PagePair(Wording.Get("JobReport.Operation", one.Operation.Title), Wording.Get("JobReport.OperationFacts", one.Operation.Kind, one.Tool.Title, one.Operation.Depth ?? 0.0, one.Feed, one.Curves, one.Strokes, one.Length), "operation." + one.Operation.Id)),
            .. report.Job.Fonts.Select((font, i) => new PagePair(Wording.Get("JobReport.Font", font.Requested), Wording.Get("JobReport.FontTaken", font.Font, font.Sha256), string.Create(CultureInfo.InvariantCulture, $"font.{i}"))),
            .. report.Job.Settings.Operations is null ? [new PagePair(Wording.Get("JobReport.Feed"), string.Create(CultureInfo.InvariantCulture, $"{machine.FeedMmPerMinute:0.###}"))] : (PagePair[])[],
            new PagePair(Wording.Get("JobReport.Rapid"), string.Create(CultureInfo.InvariantCulture, $"{machine.RapidMmPerMinute:0.###}")),
            new PagePair(Wording.Get("JobReport.Counts"), string.Create(CultureInfo.InvariantCulture, $"{machine.Scale.X.CountsPerMillimetre:0.###} × {machine.Scale.Y.CountsPerMillimetre:0.###}")),
            new PagePair(Wording.Get("JobReport.ProfileHash"), JobIdentity.OfProfile(machine), "profile", Style: "code"),
        ]);
    }

    private static string Time(DateTimeOffset moment, TimeZoneInfo here) => Wording.Get("JobReport.Moment", TimeZoneInfo.ConvertTime(moment, here));
}
