using System.Globalization;
using Engraver.Core.Drawings;
using Engraver.Core.Geometry;
using Engraver.Core.Machines;
using Engraver.Core.Posts;
using Engraver.Workbench.Composition;
using Engraver.Workbench.Documents;
using Engraver.Workbench.SerialTexts;
using Engraver.Workbench.Settings;

namespace Engraver.Workbench.Verification;

/// <summary>Post parameters of a program that affect its comparison with the drawing.</summary>
public sealed record PostParameters
{
    /// <summary>The defaults of the posts.</summary>
    public static PostParameters Defaults { get; } = new();

    /// <summary>Position of the drawing's zero in the program; null for a program that starts at the current position, which is the drawing's start.</summary>
    public ProgramOrigin? Origin { get; init; }

    /// <summary>Machine position before the first block, drawing millimetres, for a format that does not contain it; null: the start of the first
    /// stroke.</summary>
    public Point2D? Start { get; init; }

    /// <summary>Allowed corner rounding of the controller, millimetres. Without another tolerance it also joins lines within the same tolerance (rs274-hpgl.md
    /// 1.4), so that twice the value is allowed.</summary>
    public double BlendMm { get; init; }

    /// <summary>What the fields in the texts of the drawing stand for.</summary>
    public PlateValues Values { get; init; } = PlateValues.None;

    /// <summary>Number of the section of the job, from 1, that the program cuts; null: the whole job.</summary>
    public int? Section { get; init; }

    /// <summary>Program content other than the path.</summary>
    public ProgramRequirements Terms { get; init; } = TermsOf(_ => null);

    /// <summary>The motion from which it was posted, if a slow link has changed it; otherwise null.</summary>
    internal MotionProgram? FittedProgram { get; init; }

    internal double AllowedBlendMm => 2.0 * BlendMm;

    /// <summary>The job with which the program is compared.</summary>
    /// <exception cref="SettingException">A named layer is not in the drawing, or the job has no such section.</exception>
    internal PreparedJob JobOf(Drawing drawing, DrawingSettings settings, MotionStyle style, CancellationToken cancellation) =>
        Section is { } number ? SectionJob.Prepare(drawing, settings, style, number, Values, cancellation) : JobPreparation.PrepareUnlessCancelled(drawing, settings, style, cancellation, Values);

    /// <summary>The post options that affect the comparison; the others affect only the notation.</summary>
    public static IReadOnlyList<string> OptionNames { get; } = ["origin", "blend", "work-offset", "tool-switch", "spindle-speed", "pen"];

    /// <summary>Creates the parameters from post options.</summary>
    /// <param name="valueOf">The value of one of <see cref="OptionNames"/>; null if it was not given.</param>
    public static PostParameters Parse(Func<string, string?> valueOf)
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
    private static ProgramRequirements TermsOf(Func<string, string?> valueOf)
    {
        string Value(string name) => valueOf(name) ?? PostTable.Options.First(option => option.Name == name).Default;
        return new ProgramRequirements
        {
            WorkOffset = Value("work-offset"),
            ToolSwitch = Value("tool-switch"),
            SpindleSpeed = Number(Value("spindle-speed"))!.Value,
            Pen = (int)Number(Value("pen"))!.Value,
        };
    }

    private static double? Number(string? value) => value is null ? null : double.Parse(value, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture);
}
