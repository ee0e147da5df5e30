using System.Globalization;
using System.Text.RegularExpressions;
using Engraver.Core.Drawings;
using Engraver.Core.Posts;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>Any number in a program of any format: the verification ends with a result or a finding, and does not take longer than for other
/// programs.</summary>
public sealed partial class ExtremeNumberTests
{
    /// <summary>A timeout only: one verification takes a few hundredths of a second.</summary>
    private static readonly TimeSpan s_patience = TimeSpan.FromSeconds(60.0);

    /// <summary>With digits alone too, for formats that know no exponent.</summary>
    private static readonly string[] s_numbers = ["1e308", "-1e308", "1e300", "-1e20", "1e18", "1e15", "1e13", "-1e12", "1e11", "1e9", "-1e9", "360000001", "100000", "1e-9", "-1e-300", "5e-324", "0", "-0", "NaN", "Infinity", "-Infinity", "1e400", "4294967296", "2147483648", "-2147483649", "65536.00001"];

    private static int Cases => TestExtent.Cases(perCommit: 12, full: 150, "ENGRAVER_EXTREME_NUMBERS");

    [Theory]
    [InlineData("galil")]
    [InlineData("galil-calls")]
    [InlineData("cldata")]
    [InlineData("agie")]
    [InlineData("gcode")]
    [InlineData("gcode grbl")]
    [InlineData("hpgl")]
    [InlineData("hpgl aa")]
    [InlineData("xps-linearc")]
    [InlineData("xps-spline")]
    [InlineData("xps-pvt")]
    public async Task A_program_with_an_extreme_number_is_judged_in_bounded_work(string target)
    {
        var entry = PostTable.Find(target.Split(' ')[0]);
        var options = target.Split(' ') is [_, var word] ? new Dictionary<string, string> { [word == "grbl" ? "dialect" : "arcs"] = word } : PostedProgram.NoOptions;
        var text = PostedProgram.Create(Part(), new DrawingSettings(), entry.Post, options).Text!;
        await TryAllAsync(text, target, options.ContainsKey("dialect") ? entry.Dialects["grbl"] : entry.Reader!);
    }

    /// <summary>Points of the drawing in the SACE format.</summary>
    [Fact]
    public Task A_spline_in_places_of_the_drawing_with_an_extreme_number_is_judged_in_bounded_work() =>
        TryAllAsync("-1,0,0\n0,0,0\n1,0.5,0\n2,0,0\n3,-0.5,0\n", "sace", TrajectoryReadBack.ReaderOf(Core.Trajectories.Formats.TrajectoryFormat.Sace));

    private static async Task TryAllAsync(string text, string target, IProgramReader reader)
    {
        var (places, random) = (Number().Matches(text, Math.Max(0, text.IndexOf("ENTITIES", StringComparison.Ordinal))), new Random(31));
        for (var number = 0; number < Cases; number++)
        {
            var (harmed, name) = (text, $"case {number} of {target}");
            foreach (var place in Enumerable.Range(0, random.Next(1, 3)).Select(_ => places[random.Next(places.Count)]).DistinctBy(place => place.Index).OrderByDescending(place => place.Index))
            {
                var extreme = s_numbers[random.Next(s_numbers.Length)];
                var other = random.Next(2) == 0 && double.TryParse(extreme, CultureInfo.InvariantCulture, out var value) && double.IsFinite(value) ? value.ToString("F3", CultureInfo.InvariantCulture) : extreme;
                (harmed, name) = (harmed[..place.Index] + other + harmed[(place.Index + place.Length)..], $"{name}, {place.Value} at {place.Index} became {extreme}");
            }

            await JudgeAsync(harmed, name, reader);
        }
    }

    private static async Task JudgeAsync(string text, string name, IProgramReader reader)
    {
        using var patience = new CancellationTokenSource();
        var judged = Task.Run(() => ProgramVerification.VerifyAsync(ReadBackFile.FromText(text), reader, Part(), new DrawingSettings(), progress: null, patience.Token));
        try
        {
            var report = await judged.WaitAsync(s_patience);
            Assert.True(report.MaxDeviationMm is null or >= 0.0, name);
            Assert.True(report.Ok || report.Diagnostics.Count > 0 || report.ExtraLengthMm > 0.0, name);
        }
        catch (TimeoutException)
        {
            await patience.CancelAsync();
            Assert.Fail($"The verification does not end: {name}");
        }
        catch (Exception fault) when (fault is ArithmeticException or ArgumentException or InvalidOperationException or OutOfMemoryException or IndexOutOfRangeException or FormatException)
        {
            Assert.Fail($"{name}: {fault}");
        }
    }

    /// <summary>One of each kind of curve, as small as possible.</summary>
    private static Drawing Part() => new DrawingBuilder().Line(0, 0, 2, 0).Arc(2, 1, 1, 270, 90).Line(5, 0, 5, 2).Free(FreeCurves.Ellipse(9.0, 0.0, 1.0, 0.5, 0.0, 20.0, 40.0).ToCurve()).Build();

    [GeneratedRegex(@"(?<![\w.])-?\d+(\.\d+)?(E-?\d+)?|(?<=[A-Z=])-?\d+(\.\d+)?")]
    private static partial Regex Number();
}
