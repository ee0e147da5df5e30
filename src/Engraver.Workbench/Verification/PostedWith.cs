using System.Globalization;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;

namespace Engraver.Workbench.Verification;

/// <summary>Post parameters of a program that affect its comparison with the drawing.</summary>
public sealed record PostedWith
{
    /// <summary>The defaults of the posts.</summary>
    public static PostedWith Defaults { get; } = new();

    /// <summary>Position of the drawing's zero in the program; null for a program that starts at the current position, which is the drawing's start.</summary>
    public ProgramOrigin? Origin { get; init; }

    /// <summary>Machine position before the first block, drawing millimetres, for a format that does not contain it; null: the start of the first
    /// stroke.</summary>
    public Point2D? Start { get; init; }

    /// <summary>Allowed corner rounding of the controller, millimetres. Without another tolerance it also joins lines within the same tolerance (rs274-hpgl.md
    /// 1.4), so that twice the value is allowed.</summary>
    public double BlendMm { get; init; }

    /// <summary>Program content other than the path.</summary>
    public ProgramTerms Terms { get; init; } = TermsOf(_ => null);

    /// <summary>The motion from which it was posted, if a slow link has changed it; otherwise null.</summary>
    internal MotionProgram? Fitted { get; init; }

    internal double AllowedBlendMm => 2.0 * BlendMm;

    /// <summary>The post options that affect the comparison; the others affect only the notation.</summary>
    public static IReadOnlyList<string> OptionNames { get; } = ["origin", "blend", "work-offset", "tool-switch", "spindle-speed", "pen"];

    /// <summary>Creates the parameters from post options.</summary>
    /// <param name="valueOf">The value of one of <see cref="OptionNames"/>; null if it was not given.</param>
    public static PostedWith Parse(Func<string, string?> valueOf)
    {
        ArgumentNullException.ThrowIfNull(valueOf);
        return new()
        {
            Origin = valueOf("origin") is { } origin ? ProgramOrigin.TryParse(origin) : null,
            BlendMm = Number(valueOf("blend")) ?? 0.0,
            Terms = TermsOf(valueOf),
        };
    }

    /// <summary>The terms of options of posts; an option that was not given has the default of its post.</summary>
    private static ProgramTerms TermsOf(Func<string, string?> valueOf)
    {
        string Value(string name) => valueOf(name) ?? PostTable.Options.First(option => option.Name == name).Default;
        return new ProgramTerms
        {
            WorkOffset = Value("work-offset"),
            ToolSwitch = Value("tool-switch"),
            SpindleSpeed = Number(Value("spindle-speed"))!.Value,
            Pen = (int)Number(Value("pen"))!.Value,
        };
    }

    private static double? Number(string? value) => value is null ? null : double.Parse(value, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture);
}

/// <summary>Position of the drawing's zero in a program, mm relative to the controller's zero.</summary>
/// <param name="Z">Null: the tool height at the start of the program.</param>
public sealed record ProgramOrigin(double X, double Y, double? Z)
{
    /// <summary>Parses two or three finite numbers separated by commas; null for any other text.</summary>
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

    /// <summary>Position of the controller's zero in the frame of the drawing, counts.</summary>
    internal CountsPoint Beginning(CountsScale scale) => new(Counts(scale.X.Exact(-X)), Counts(scale.Y.Exact(-Y)), (int)Math.Clamp(Counts(scale.Z.Exact(-(Z ?? 0.0))), int.MinValue, int.MaxValue));

    /// <summary>Time of the rapid from the controller's zero to the drawing's.</summary>
    internal TimeSpan Way(MachineProfile machine) => TimeSpan.FromMinutes((Math.Abs(X) + Math.Abs(Y) + Math.Abs(Z ?? 0.0)) / machine.RapidMmPerMinute);

    private static long Counts(double value) => (long)Math.Clamp(Math.Round(value), -CountsScale.MostCounts, CountsScale.MostCounts);
}
