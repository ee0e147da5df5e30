using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Posts.AgieReading;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Stages;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>A posted AGIE program is read back correctly, and every corruption is detected or harmless.</summary>
public class AgieVerificationTests
{
    private const string Row = "%\t001\t01\t000\t000\t+001000\t+000000\t02\t02\n";

    /// <summary>Largest allowed distance of a cut from the drawing, and of the drawing from a cut, mm; the second including the gaps between samples.</summary>
    private const double Tolerance = 0.0036;
    private const double Coverage = 0.0056;

    public static TheoryData<string> Samples => [.. Directory.GetFiles(RepositoryFolder.Samples, "*.dxf").Select(path => Path.GetFileNameWithoutExtension(path)!)];

    [Theory]
    [MemberData(nameof(Samples))]
    public async Task Every_samples_program_cuts_the_drawing_and_nothing_else(string sample)
    {
        var drawing = DrawingFile.Open(Path.Combine(RepositoryFolder.Samples, sample + ".dxf"), new DrawingSettings(), CancellationToken.None);
        var report = await VerifyAsync(drawing, Post(drawing));

        Assert.Empty(report.Diagnostics);
        Assert.True(report.Ok);
        Assert.InRange(report.MaxDeviationMm!.Value, 0.0, 0.0011 + 0.001);
        Assert.Equal((0.0, 0.0), (report.MissingLengthMm, report.ExtraLengthMm));
    }

    [Theory]
    [InlineData("", "VER0001", 0)]
    [InlineData("\n\n", "VER0001", 0)]
    [InlineData("#JOB\nEN\n", "PST0001", 1)]
    [InlineData("%\n", "PST0001", 1)]
    [InlineData("%\n%\n", "PST0001", 2)]
    [InlineData("%\t002\t01\t000\t000\t+001000\t+000000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t04\t000\t000\t+001000\t+000000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t01\t010\t000\t+001000\t+000000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t03\t360\t090\t+001000\t+001000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t03\t000\t000\t+001000\t+001000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t03\t000\t090\t+001000\t+001001\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t03\t000\t090\t-001000\t-001000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t03\t000\t090\t+001000\t+001000\t01\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t01\t000\t000\t001000\t+000000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t01\t000\t000\t+01000\t+000000\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t01\t000\t000\t+001000\t+000000\t03\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t01\t000\t000\t+001000\t+000000\t02\t01\n", "PST0001", 1)]
    [InlineData("%\t001\t01\t000\t000\t+001000\t+000000\t02\t02\t02\n", "PST0001", 1)]
    [InlineData("%\t001\t01\t000\t000\t+001000\t+000000\t02\n", "PST0001", 1)]
    [InlineData(Row + "\t002\t01\t000\t000\t+001000\t+000000\t02\t02\n", "PST0001", 2)]
    [InlineData("\t001\t01\t000\t000\t+001000\t+000000\t02\t02\n", "PST0001", 1)]
    public async Task A_program_that_is_not_in_the_form_is_one_finding_at_its_line(string text, string id, long line)
    {
        var report = await VerifyAsync(new DrawingBuilder().Line(0, 0, 1, 0).Build(), text);

        Assert.False(report.Ok);
        var finding = Assert.Single(report.Diagnostics);
        Assert.Equal((id, line), (finding.Id, finding.Source.Line));
    }

    [Theory]
    [InlineData(Row)]
    [InlineData("%\n\t001\t01\t000\t000\t+001000\t+000000\t02\t02\n")]
    [InlineData("\n\n%\t001\t01\t000\t000\t+001000\t+000000\t02\t02\r\n\n")]
    [InlineData("%\t001\t01\t000\t000\t+000400\t+000000\t02\t02\n%\t001\t01\t000\t000\t+000600\t+000000\t02\t02\n")]
    public async Task What_is_in_the_form_is_read(string text) => Assert.True((await VerifyAsync(new DrawingBuilder().Line(0, 0, 1, 0).Build(), text)).Ok);

    [Fact]
    public async Task A_program_in_whole_degrees_is_found_to_leave_the_drawing_as_far_as_was_foretold()
    {
        var drawing = Parts();
        var posted = PostedProgram.Create(drawing, new DrawingSettings(), PostTable.Find("agie").Post, new Dictionary<string, string> { ["style"] = "paper" });
        var report = await VerifyAsync(drawing, posted.Text!);

        Assert.False(report.Ok);
        Assert.InRange(posted.Forecast!.MaxError, 0.01, 0.5);
        Assert.Equal(posted.Forecast.MaxError, report.MaxDeviationMm!.Value, 1e-4);
    }

    /// <summary>Seeded corruptions of one character or one number. The test computes independently whether a corruption matters.</summary>
    [Fact]
    public async Task Corruptions_are_noticed_or_do_no_harm()
    {
        var (random, drawing) = (new Random(200), Parts());
        var settings = new DrawingSettings();
        var (text, start) = (Post(drawing), JobPreparation.To<PathJob>(drawing, settings).Toolpath.Strokes[0].Start);
        var drawn = JobPreparation.Analyse(drawing, settings).ToSegments();
        Assert.True(DoesNoHarm(text, start, drawn));
        var (cases, unnoticed) = (TestExtent.Cases(perCommit: 60, full: 200, "ENGRAVER_AGIE_CASES"), 0);
        for (var number = 0; number < cases; number++)
        {
            var bad = number % 2 == 0 ? WithOtherCharacter(random, text) : WithOtherNumber(random, text);
            var report = await VerifyAsync(drawing, bad);
            Assert.Equal(report.Ok, report.Diagnostics.Count == 0 && report.ExtraLengthMm == 0.0);
            if (!report.Ok) continue;
            unnoticed++;
            Assert.True(DoesNoHarm(bad, start, drawn), $"corruption {number} was not noticed:\n{bad}");
        }

        Assert.InRange(unnoticed, 0, cases / 10);
    }

    private static bool DoesNoHarm(string text, Point2D start, IReadOnlyList<Segment> drawn)
    {
        if (TabProgram.Paths(text, start) is not { } run) return false;
        Segment[] cuts = [.. run.Where(block => block.Cutting).Select(block => block.Path)];
        return TabProgram.Farthest(cuts, drawn, 0.05) <= Tolerance && TabProgram.Farthest(drawn, cuts, 0.02) <= Coverage;
    }

    private static string WithOtherCharacter(Random random, string text)
    {
        var place = random.Next(text.Length);
        return random.Next(3) switch
        {
            0 => text.Remove(place, 1),
            1 => text.Insert(place, text[random.Next(text.Length)].ToString()),
            _ => text[..place] + "0123456789+-%\t\n xE"[random.Next(18)] + text[(place + 1)..],
        };
    }

    /// <summary>Another number of the same form in one field, often close to the original.</summary>
    private static string WithOtherNumber(Random random, string text)
    {
        var rows = text.Split('\n');
        var row = random.Next(rows.Length - 1);
        var fields = rows[row].Split('\t');
        var field = random.Next(1, fields.Length);
        var (sign, digits) = fields[field][0] is '+' or '-' ? (fields[field][..1], fields[field][1..]) : ("", fields[field]);
        var old = int.Parse(digits, System.Globalization.CultureInfo.InvariantCulture);
        var other = random.Next(2) == 0 ? Math.Abs(old + random.Next(1, 12)) : random.Next((int)Math.Pow(10.0, digits.Length));
        fields[field] = sign + other.ToString(new string('0', digits.Length), System.Globalization.CultureInfo.InvariantCulture);
        rows[row] = string.Join('\t', fields);
        return string.Join('\n', rows);
    }

    /// <summary>A slot with an entry, a circle and a belt: whole angles and others.</summary>
    private static Drawing Parts()
    {
        var belt = Math.Acos(5.0 / 30.0) * 180.0 / Math.PI;
        var (sine, cosine) = (Math.Sin(belt * Math.PI / 180.0), Math.Cos(belt * Math.PI / 180.0));
        return new DrawingBuilder()
            .Line(-2, 0, 0, 0).Line(0, 0, 20, 0).Arc(20, 5, 5, 270, 90).Line(20, 10, 0, 10).Line(0, 10, 0, 0)
            .Circle(55, 0, 3)
            .Arc(0, 40, 10, belt, 360.0 - belt).Line(10 * cosine, 40 - (10 * sine), 30 + (5 * cosine), 40 - (5 * sine)).Arc(30, 40, 5, 360.0 - belt, belt).Line(30 + (5 * cosine), 40 + (5 * sine), 10 * cosine, 40 + (10 * sine))
            .Build();
    }

    private static string Post(Drawing drawing) => PostedProgram.Create(drawing, new DrawingSettings(), PostTable.Find("agie").Post, PostedProgram.NoOptions).Text!;

    private static Task<VerificationReport> VerifyAsync(Drawing drawing, string text) => ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), new AgieReader(), drawing, new DrawingSettings(), progress: null, CancellationToken.None);
}
