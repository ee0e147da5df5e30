namespace Engraver.Core.Posts.Gcode;

/// <summary>The properties of an RS-274 controller that the post needs (rs274-hpgl.md 1 and 2).</summary>
/// <param name="Name">Name as in the option.</param>
/// <param name="Decimals">Decimals of a coordinate in millimetres.</param>
/// <param name="LargestRadius">Largest radius of an arc, millimetres; a larger arc is written as chords, because the arithmetic of the controller is not
/// precise enough for it.</param>
/// <param name="HasPercent">The file begins and ends with %.</param>
/// <param name="HasOutputs">M64 and M65 switch digital outputs.</param>
/// <param name="HasBlending">G64 P rounds corners within a tolerance.</param>
/// <param name="HasLaserMode">In its laser mode M4 makes the power of a beam proportional to the speed, and the beam is on only after G1, G2 and G3.</param>
/// <param name="HasToolChange">M6 changes the tool, and G43 takes its length from the tool table.</param>
internal sealed record GcodeDialect(string Name, int Decimals, double LargestRadius, bool HasPercent, bool HasOutputs, bool HasBlending, bool HasLaserMode, bool HasToolChange)
{
    /// <summary>Double precision throughout.</summary>
    public static GcodeDialect LinuxCnc { get; } = new("linuxcnc", 6, 50_000.0, HasPercent: true, HasOutputs: true, HasBlending: true, HasLaserMode: false, HasToolChange: true);

    /// <summary>Single precision: 24 bits hold 1000 mm to 0.00006 mm, so four decimals are sufficient.</summary>
    public static GcodeDialect Grbl { get; } = new("grbl", 4, 1_000.0, HasPercent: false, HasOutputs: false, HasBlending: false, HasLaserMode: true, HasToolChange: false);

    public static IReadOnlyList<GcodeDialect> All { get; } = [LinuxCnc, Grbl];

    public static GcodeDialect Find(string name) => All.First(one => one.Name == name);
}
