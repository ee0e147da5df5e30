using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Posts;
using Engraver.TestKit;
using Engraver.TestKit.Programs;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>For every target, seeded corruptions of one character or one number are detected by the verification or are harmless: an independent reader of the
/// test finds exactly the drawing as cut, and the same tool, frame, speeds, waits, pen, heights and times as in the posted program.</summary>
public sealed class TargetCorruptionTests : IDisposable
{
    /// <summary>Slow targets: their curves are read as many chords, which takes a second each time.</summary>
    private static int CasesOf(string target) => TestExtent.Cases(perCommit: target is "xps-spline" or "xps-pvt" ? 2 : 10, full: 200, "ENGRAVER_CORRUPTIONS");

    private readonly DirectoryInfo _folder = Directory.CreateTempSubdirectory("engraver-corrupt-");

    /// <summary>Corners are not rounded, as in every other format.</summary>
    private static readonly DrawingSettings s_stopping = new() { CornerToleranceMm = 0.0 };

    [Theory]
    [InlineData("galil", "")]
    [InlineData("galil-calls", "")]
    [InlineData("cldata", "")]
    [InlineData("gcode", "linuxcnc")]
    [InlineData("gcode", "grbl")]
    [InlineData("hpgl", "")]
    [InlineData("xps-linearc", "")]
    [InlineData("xps-spline", "")]
    [InlineData("xps-pvt", "")]
    public async Task Every_corruption_is_noticed_or_does_no_harm(string target, string dialect)
    {
        var (entry, drawing, random) = (PostTable.Find(target), Parts(), new Random(15));
        var options = dialect.Length == 0 ? PostedProgram.NoOptions : new Dictionary<string, string> { ["dialect"] = dialect };
        var reader = dialect.Length == 0 ? entry.Reader! : entry.Dialects[dialect];
        var text = PostedProgram.Create(drawing, s_stopping, entry.Post, options).Text!;
        var drawn = JobPreparation.Analyse(drawing, s_stopping).ToSegments();
        Assert.True((await VerifyAsync(drawing, text, reader)).Ok);
        var acts = ProgramActions.Of(text, target)!;
        Assert.Equal(target != "cldata", acts.Count > 0);
        Assert.True(DoesNoHarm(text, target, drawn, reader, acts));
        for (var number = 0; number < CasesOf(target); number++)
        {
            var bad = Corruption.Of(random, text, number);
            var report = await VerifyAsync(drawing, bad, reader);
            Assert.Equal(report.Ok, report.Diagnostics.Count == 0 && report.ExtraLengthMm == 0.0);
            if (report.Ok && bad != text) Assert.True(DoesNoHarm(bad, target, drawn, reader, acts), $"corruption {number} of {target} was not noticed: {Difference(text, bad)}; {ProgramActions.FirstOther(acts, ProgramActions.Of(bad, target))}");
        }
    }

    public void Dispose() => _folder.Delete(recursive: true);

    private static Task<VerificationReport> VerifyAsync(Drawing drawing, string text, IProgramReader reader) =>
        ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), reader, drawing, s_stopping, progress: null, CancellationToken.None);

    /// <summary>Cuts coincide with the drawing within the rounding of the format.</summary>
    private bool DoesNoHarm(string text, string target, IReadOnlyList<Segment> drawn, IProgramReader reader, IReadOnlyList<(string Name, double Value)> acts)
    {
        var cuts = target switch
        {
            "galil" or "galil-calls" => DmcLines.Cuts(text),
            "gcode" => GcodeLines.Cuts(text),
            "hpgl" => HpglLines.Cuts(text),
            "cldata" => DxfCuts(text),
            _ => TrajectoryLines.Cuts(text, target),
        };
        var allowed = Math.Max(0.0036, reader.Rounding + 0.0011);
        if (!ProgramActions.AreSame(acts, ProgramActions.Of(text, target))) return false;
        return cuts is { Count: > 0 } && TabProgram.Farthest(cuts, drawn, 0.1) <= allowed && TabProgram.Farthest(drawn, cuts, 0.05) <= allowed + 0.002;
    }

    /// <summary>As read by the DXF reader, which the verification does not use.</summary>
    private Segment[] DxfCuts(string text)
    {
        var file = Path.Combine(_folder.FullName, "cl.dxf");
        File.WriteAllText(file, text);
        var settings = new DrawingSettings();
        return JobPreparation.Analyse(DrawingFile.Open(file, settings, CancellationToken.None), settings).ToSegments();
    }

    private static string Difference(string text, string bad)
    {
        var at = text.Zip(bad).TakeWhile(pair => pair.First == pair.Second).Count();
        return $"...{bad[Math.Max(0, at - 30)..Math.Min(bad.Length, at + 30)]}...";
    }

    /// <summary>A slot, a circle, and a belt of arcs that end between whole degrees.</summary>
    private static Drawing Parts()
    {
        var belt = Math.Acos(5.0 / 30.0) * 180.0 / Math.PI;
        var (sine, cosine) = (Math.Sin(belt * Math.PI / 180.0), Math.Cos(belt * Math.PI / 180.0));
        return new DrawingBuilder()
            .Line(0, 0, 20, 0).Arc(20, 5, 5, 270, 90).Line(20, 10, 0, 10).Line(0, 10, 0, 0)
            .Circle(35, 5, 3)
            .Arc(0, 30, 10, belt, 360.0 - belt).Line(10 * cosine, 30 - (10 * sine), 30 + (5 * cosine), 30 - (5 * sine)).Arc(30, 30, 5, 360.0 - belt, belt).Line(30 + (5 * cosine), 30 + (5 * sine), 10 * cosine, 30 + (10 * sine))
            .Build();
    }
}
