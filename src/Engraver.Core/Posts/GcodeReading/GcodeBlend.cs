namespace Engraver.Core.Posts.GcodeReading;

/// <summary>Distance by which the path control allows the machine to leave its path, millimetres (rs274-hpgl.md 1.4).</summary>
/// <param name="Corners">P of G64: the amount by which corners are rounded; infinite without it, 0 for an exact path.</param>
/// <param name="Lines">Q of G64: the distance that joined lines may be from the resulting line; 0 for an arc.</param>
internal readonly record struct GcodeBlend(double Corners, double Lines)
{
    /// <summary>G61, G61.1; grbl always.</summary>
    public static GcodeBlend Exact => default;

    /// <summary>G64 alone; also LinuxCNC at its start, unless its settings differ.</summary>
    public static GcodeBlend Unbounded { get; } = new(double.PositiveInfinity, 0.0);

    /// <summary>Allowance of a line, which may be joined to others and whose joints may be rounded.</summary>
    public double Largest => Corners + Lines;

    /// <summary>G64: P of 0 equals no P, and Q equals P unless it is given.</summary>
    /// <param name="unit">Millimetres per unit of a number.</param>
    public static GcodeBlend Of(double? p, double? q, double unit) => new(p > 0.0 ? p.Value * unit : double.PositiveInfinity, (q ?? p ?? 0.0) * unit);
}

/// <summary>The conditions of a motion.</summary>
/// <param name="IsOn">The tool's switch; a tool axis cuts by its height.</param>
/// <param name="Feed">Feed in millimetres per minute; infinite for a rapid.</param>
/// <param name="Line">Line of the program's text.</param>
internal readonly record struct GcodeMotion(bool IsOn, double Feed, GcodeBlend Blend, int Line);
