using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.TestKit;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Settings;
using Engraver.Workbench.Verification;

namespace Engraver.Workbench.Tests.Verification;

/// <summary>A random drawing, machine and post options, which are passed to the verification too.</summary>
/// <param name="Target">Name of a post, optionally followed by a dialect.</param>
internal sealed record RandomJob(string Target, Drawing Drawing, DrawingSettings Settings, IReadOnlyDictionary<string, string> Options)
{
    private string _shapes = "";

    private PostEntry Entry => PostTable.Find(Target.Split(' ')[0]);

    public static RandomJob Of(Random random, string target)
    {
        var (drawing, shapes) = Draw(random);
        var settings = new DrawingSettings { Start = random.Next(3) == 0 ? new Point2D(random.Next(-50, 50), random.Next(-50, 50) / 8.0) : default, Machine = Machine(random) };
        return new RandomJob(target, drawing, settings, OptionsOf(random, target)) { _shapes = shapes };
    }

    /// <summary>The program; null if the post refuses the job, which requires a reason, and if strokes are shorter than a count (MOT0004), which no program
    /// cuts.</summary>
    public string? Post()
    {
        var posted = PostedProgram.Create(Drawing, Settings, Entry.Post, Options);
        if (posted.Text is null) Assert.Contains(posted.Diagnostics, finding => finding.Severity == Core.Diagnostics.Severity.Error);
        return posted.Diagnostics.Any(finding => finding.Id == "MOT0004") ? null : posted.Text;
    }

    public Task<VerificationReport> VerifyAsync(string text) => ProgramVerification.VerifyAsync(
        ReadBackFile.FromText(text), Target.EndsWith(" grbl", StringComparison.Ordinal) ? Entry.Dialects["grbl"] : Entry.Reader!, Drawing, Settings, progress: null, CancellationToken.None, PostParameters.Parse(name => name == "origin" && Options.GetValueOrDefault(name) == "here" ? null : Options.GetValueOrDefault(name)));

    public override string ToString()
    {
        var machine = Settings.Machine;
        return $"{Target} {string.Join(' ', Options.Select(option => $"--{option.Key} {option.Value}"))} of {_shapes} from {Settings.Start.X}, {Settings.Start.Y} by {machine.Scale.X.CountsPerMillimetre} x {machine.Scale.Y.CountsPerMillimetre}, feed {machine.FeedMmPerMinute}, rapid {machine.RapidMmPerMinute}, settle {machine.ToolSettleSeconds}, {machine.ToolOffSettleSeconds}, {machine.Spindle}";
    }

    private static Dictionary<string, string> OptionsOf(Random random, string target)
    {
        var options = new Dictionary<string, string>();
        if (target.EndsWith(" grbl", StringComparison.Ordinal)) options["dialect"] = "grbl";
        if (target.StartsWith("galil", StringComparison.Ordinal))
        {
            options["memory"] = $"{(random.Next(4) == 0 ? 1000 : random.Next(100, 260))}";
            options["unattended"] = random.Next(3) == 0 ? "yes" : "no";
            if (random.Next(3) == 0) options["origin"] = $"{random.Next(-100, 100)},{random.Next(-100, 100)}";
        }

        if (target == "hpgl" && random.Next(2) == 0) (options["units-per-mm"], options["arcs"]) = ("1000", random.Next(2) == 0 ? "aa" : "chords");
        if (target == "agie" && random.Next(2) == 0) options["start-mark"] = "own-line";
        if (target == "gcode" && random.Next(2) == 0) options["program-end"] = "m30";
        return options;
    }

    private static MachineProfile Machine(Random random)
    {
        var scale = random.Next(6) switch { 0 => (1000.0, 800.0), 1 => (-400.0, 400.0), 2 => (40.0, 40.0), _ => (1000.0, 1000.0) };
        var isMill = random.Next(8) == 0;
        return new MachineProfile
        {
            Axes = Typed(MachineAxes.FromScale(scale.Item1, scale.Item2), scale.Item1 == 40.0 ? 2.0 : null) with { Z = isMill ? new MachineAxis('C', 1000.0) : null },
            Height = isMill ? new HeightDrive { CutDepth = 0.5 } : null,
            FeedMmPerMinute = random.Next(3) == 0 ? random.Next(60, 3000) : 1200.0,
            RapidMmPerMinute = random.Next(3) == 0 ? random.Next(600, 6000) : 3000.0,
            ToolActiveLow = random.Next(4) == 0,
            ToolOutput = random.Next(1, 4),
            ToolSettleSeconds = random.Next(3) switch { 0 => 0.0, 1 => random.Next(1, 800) / 1000.0, _ => 0.1 },
            ToolOffSettleSeconds = random.Next(3) switch { 0 => 0.0, 1 => random.Next(1, 800) / 1000.0, _ => null },
            Spindle = random.Next(5) == 0 ? new Spindle { Output = 5, SpinUpSeconds = random.Next(0, 3) } : null,
        };
    }

    private static MachineAxes Typed(MachineAxes axes, double? motor) => axes with { X = axes.X with { MotorType = motor }, Y = axes.Y with { MotorType = motor } };

    /// <summary>One to three shapes of very different kinds and sizes, apart from each other or one over the other.</summary>
    private static (Drawing Drawing, string Shapes) Draw(Random random)
    {
        var (drawing, names) = (new DrawingBuilder(), new List<string>());
        for (var count = random.Next(1, 4); count > 0; count--)
        {
            var (x, y, size) = (random.Next(-40, 40), random.Next(-400, 400) / 10.0, Math.Pow(10.0, (random.NextDouble() * 2.5) - 1.0));
            var kind = random.Next(8);
            names.Add($"{kind} ({size:0.###})");
            Shape(drawing, random, kind, x, y, size);
        }

        return (drawing.Build(), string.Join(", ", names));
    }

    private static void Shape(DrawingBuilder drawing, Random random, int kind, double x, double y, double size)
    {
        switch (kind)
        {
            case 0: // corners, each a stop
                for (var i = random.Next(1, 150); i > 0; i--) drawing.Line(x, y, x += size * random.NextDouble(), y += size * (random.NextDouble() - 0.5));
                break;
            case 1: // bends without a stop
                for (var (i, turn) = (random.Next(2, 300), 0.0); i > 0; i--) drawing.Line(x, y, x += size / 8.0 * Math.Cos(turn += 0.12 * (random.NextDouble() - 0.4)), y += size / 8.0 * Math.Sin(turn));
                break;
            case 2:
                drawing.Circle(x, y, size);
                break;
            case 3: // half turns, each round a larger radius
                for (var (i, radius) = (random.Next(2, 40), size / 20.0); i > 0; i--) drawing.Arc(x += i % 2 == 0 ? -size / 20.0 : size / 20.0, y, radius += size / 20.0, i % 2 * 180.0, 180.0 + (i % 2 * 180.0));
                break;
            case 4:
                drawing.Free(FreeCurves.Ellipse(x, y, size, 0.05 + random.NextDouble(), random.Next(360), random.Next(360), random.Next(2) == 0 ? 360.0 : random.Next(20, 340)).ToCurve());
                break;
            case 5:
                Point2D[] controls = [.. Enumerable.Range(0, random.Next(4, 12)).Select(i => new Point2D(x + (i * size / 3.0), y + (size * random.NextDouble())))];
                drawing.Free(FreeCurves.Spline(3, controls, [.. controls.Select(_ => 1.0)]));
                break;
            case 6: // a slot
                drawing.Line(x, y, x + size, y).Arc(x + size, y + size, size, 270, 90).Line(x + size, y + (2 * size), x, y + (2 * size)).Arc(x, y + size, size, 90, 270);
                break;
            default: // many strokes
                for (var i = random.Next(2, 40); i > 0; i--) drawing.Square(x + (i * size / 5.0), y + (i % 3 * size / 4.0), size / 10.0);
                break;
        }
    }
}
