using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;

namespace Engraver.Workbench.Verification;

/// <summary>How a program was posted, as far as it decides what it is compared with.</summary>
public sealed record PostedWith
{
    /// <summary>With what the posts choose where nothing is said.</summary>
    public static PostedWith Defaults { get; } = new();

    /// <summary>The drawing's zero by the program's own; null for a program that begins where the machine stands, at the drawing's start.</summary>
    public ProgramOrigin? Origin { get; init; }

    /// <summary>Where the machine stands before the first block, drawing millimetres, for a form that does not say it; null: where the first stroke of the
    /// job begins.</summary>
    public Point2D? Start { get; init; }

    /// <summary>By how much the controller was allowed to round corners, millimetres. Where no other tolerance is said it joins lines within the same
    /// (rs274-hpgl.md 1.4), so that both together are allowed.</summary>
    public double BlendMm { get; init; }

    /// <summary>What it says beside the way.</summary>
    public ProgramTerms Terms { get; init; } = ProgramTerms.Default;

    /// <summary>The motion that it was posted from, where a slow link made it another than the job's own; null for none.</summary>
    internal MotionProgram? Fitted { get; init; }

    internal double AllowedBlendMm => 2.0 * BlendMm;

    /// <summary>The options of posts that decide what a program is compared with; the others say only how it is written.</summary>
    public static IReadOnlyList<string> OptionNames { get; } = ["origin", "blend", "work-offset", "tool-switch", "spindle-speed", "pen"];

    /// <summary>From options that the post would take.</summary>
    /// <param name="valueOf">The value of one of <see cref="OptionNames"/>; null for one that was not given.</param>
    public static PostedWith Parse(Func<string, string?> valueOf)
    {
        ArgumentNullException.ThrowIfNull(valueOf);
        var usual = ProgramTerms.Default;
        return new()
        {
            Origin = valueOf("origin") is { } origin ? ProgramOrigin.TryParse(origin) : null,
            BlendMm = Number(valueOf("blend")) ?? 0.0,
            Terms = new ProgramTerms
            {
                WorkOffset = valueOf("work-offset") ?? usual.WorkOffset,
                ToolSwitch = valueOf("tool-switch") ?? usual.ToolSwitch,
                SpindleSpeed = Number(valueOf("spindle-speed")) ?? usual.SpindleSpeed,
                Pen = (int)(Number(valueOf("pen")) ?? usual.Pen),
            },
        };
    }

    private static double? Number(string? value) => value is null ? null : double.Parse(value, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture);
}

/// <summary>Where a program takes the drawing's zero to be, mm by the controller's own zero.</summary>
/// <param name="Z">Null: the height at which the tool stands when the program begins.</param>
public sealed record ProgramOrigin(double X, double Y, double? Z)
{
    /// <summary>Two or three finite numbers apart by commas; null for any other text.</summary>
    public static ProgramOrigin? TryParse(string text)
    {
        ArgumentNullException.ThrowIfNull(text);
        var numbers = text.Split(',').Select(word => double.TryParse(word, NumberStyles.AllowDecimalPoint | NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out var number) ? number : double.NaN).ToList();
        if (!numbers.TrueForAll(double.IsFinite)) return null;
        return numbers switch
        {
            [var x, var y] => new ProgramOrigin(x, y, null),
            [var x, var y, var z] => new ProgramOrigin(x, y, z),
            _ => null,
        };
    }

    /// <summary>Where the machine stands in the frame of the drawing while it stands on the controller's zero, counts.</summary>
    internal CountsPoint Beginning(CountsScale scale) => new(Counts(scale.X.Exact(-X)), Counts(scale.Y.Exact(-Y)), (int)Math.Clamp(Counts(scale.Z.Exact(-(Z ?? 0.0))), int.MinValue, int.MaxValue));

    /// <summary>Time of the rapid from the controller's zero to the drawing's.</summary>
    internal TimeSpan Way(MachineProfile machine) => TimeSpan.FromMinutes((Math.Abs(X) + Math.Abs(Y) + Math.Abs(Z ?? 0.0)) / machine.RapidMmPerMinute);

    private static long Counts(double value) => (long)Math.Clamp(Math.Round(value), -CountsScale.MostCounts, CountsScale.MostCounts);
}
