namespace Engraver.Core.Posts.Gcode;

/// <summary>What a controller that reads RS-274 takes, as far as the post must know it (rs274-hpgl.md 1 and 2).</summary>
/// <param name="Name">As the option has it.</param>
/// <param name="Decimals">Of a coordinate in millimetres.</param>
/// <param name="LargestRadius">Of an arc, millimetres; a wider one is written as chords. The controller's own arithmetic would lose it.</param>
/// <param name="HasPercent">The file begins and ends with %.</param>
/// <param name="HasOutputs">M64 and M65 switch digital outputs.</param>
/// <param name="HasBlending">G64 P rounds corners within a tolerance.</param>
internal sealed record GcodeDialect(string Name, int Decimals, double LargestRadius, bool HasPercent, bool HasOutputs, bool HasBlending)
{
    /// <summary>Double precision throughout.</summary>
    public static GcodeDialect LinuxCnc { get; } = new("linuxcnc", 6, 50_000.0, HasPercent: true, HasOutputs: true, HasBlending: true);

    /// <summary>Single precision: 24 bits hold 1000 mm to 0.00006 mm, so four decimals say all of it.</summary>
    public static GcodeDialect Grbl { get; } = new("grbl", 4, 1_000.0, HasPercent: false, HasOutputs: false, HasBlending: false);

    public static IReadOnlyList<GcodeDialect> All { get; } = [LinuxCnc, Grbl];

    public static GcodeDialect Find(string name) => All.First(one => one.Name == name);
}
