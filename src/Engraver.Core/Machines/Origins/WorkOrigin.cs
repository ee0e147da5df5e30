namespace Engraver.Core.Machines.Origins;

/// <summary>A work origin: the place by the controller's own zero at which the drawing's point 0,0 lies, counts. An axis that was never set is null.</summary>
/// <param name="X">Of the axis of the drawing's X.</param>
/// <param name="Y">Of the axis of the drawing's Y.</param>
/// <param name="Z">Of the tool's axis, where the machine has one.</param>
public sealed record WorkOrigin(long? X, long? Y, int? Z = null)
{
    /// <summary>Nobody set it: the controller's position was 0 when the first job began, as behind power-on.</summary>
    public bool IsAssumed { get; init; }

    /// <summary>Of the machine profile by which each axis was set; nothing for an assumed origin, which lies where the controller counts 0 by every profile.</summary>
    public KeptAxes Axes { get; init; }

    /// <summary>The place of both plane axes; null while one of them is not set. A height that is not set counts 0.</summary>
    public CountsPoint? Plane => X is { } x && Y is { } y ? new CountsPoint(x, y, Z ?? 0) : null;
}

/// <summary>The names of work origins, as G-code has them.</summary>
public static class WorkOriginNames
{
    public const string First = "G54";

    /// <summary>In the order in which they are listed.</summary>
    public static IReadOnlyList<string> All { get; } = [First, "G55", "G56", "G57", "G58", "G59"];

    /// <summary>The name as it is written, whatever its case; null when it is none.</summary>
    public static string? Find(string text) => All.FirstOrDefault(name => name.Equals(text, StringComparison.OrdinalIgnoreCase));
}
