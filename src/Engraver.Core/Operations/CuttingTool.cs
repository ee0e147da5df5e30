namespace Engraver.Core.Operations;

/// <summary>A tool of the library. Lengths in millimetres.</summary>
/// <param name="Number">From 1; operations name the tool by it.</param>
/// <param name="Diameter">Above 0: of the shank of a cutter, of the cut of a beam.</param>
public sealed record CuttingTool(int Number, double Diameter)
{
    /// <summary>The name that is shown; empty for none.</summary>
    public string Name { get; init; } = "";

    public ToolKind Kind { get; init; }

    /// <summary>Full angle of the tip of an engraving tool or drill, degrees; null where it has none or it is unknown.</summary>
    public double? AngleDegrees { get; init; }

    /// <summary>Width of the flat end of the tip of an engraving tool; 0 for a point.</summary>
    public double Tip { get; init; }

    /// <summary>Number of cutting edges; null where it is unknown.</summary>
    public int? Flutes { get; init; }

    /// <summary>Length of the cutting edges: the tool cuts no deeper; null: unknown.</summary>
    public double? MaxDepth { get; init; }

    /// <summary>Cutting speed, mm/min; null: none stated.</summary>
    public double? Feed { get; init; }

    /// <summary>Speed straight down, mm/min; null: none stated.</summary>
    public double? Plunge { get; init; }

    /// <summary>Turns per minute; null: none stated.</summary>
    public double? Spindle { get; init; }

    /// <summary>Depth at which the tool cuts a groove of a width at the surface, mm.</summary>
    /// <param name="width">Above <see cref="Tip"/>; the angle is stated.</param>
    internal double DepthOf(double width) => (width - Tip) / (2.0 * Math.Tan(AngleDegrees!.Value / 2.0 * Math.PI / 180.0));

    /// <summary>Name and number, for messages.</summary>
    public string Title => Name.Length > 0 ? $"{Name} ({Number})" : FormattableString.Invariant($"{Number}");
}
