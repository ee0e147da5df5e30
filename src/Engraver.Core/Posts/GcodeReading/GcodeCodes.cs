using System.Globalization;

namespace Engraver.Core.Posts.GcodeReading;

/// <summary>The codes of the two controllers, in tenths, and their groups: one code of a group is allowed in a line (rs274-hpgl.md 1.2). Codes that move to
/// positions that the program does not state (probes, stored places, offsets, canned cycles, cutter compensation, other planes) are not among them.</summary>
internal static class GcodeCodes
{
    /// <summary>M0: the program stops until the operator continues it.</summary>
    public const int Stop = 0;

    /// <summary>M6.</summary>
    public const int ToolChange = 60;

    public const int Dwell = 40;
    public const int ToolLength = 430;
    public const int Inch = 200;
    public const int Millimetre = 210;
    public const int ExactPath = 610;
    public const int ExactStop = 611;
    public const int Blending = 640;
    public const int UsualWorkOffset = 540;
    public const int NoMotion = 800;
    public const int Absolute = 900;
    public const int AbsoluteCentre = 901;
    public const int Incremental = 910;
    public const int IncrementalCentre = 911;

    private static readonly int[][] s_both = [[0, 10, 20, 30, NoMotion], [Dwell], [170], [Inch, Millimetre], [400], [490], [540, 550, 560, 570, 580, 590], [610], [Absolute, Incremental], [IncrementalCentre], [940]];
    private static readonly int[][] s_linuxCnc = [[0, 10, 20, 30, NoMotion], [Dwell], [170], [Inch, Millimetre], [400], [ToolLength, 490], [540, 550, 560, 570, 580, 590, 591, 592, 593], [610, 611, Blending], [Absolute, Incremental], [AbsoluteCentre, IncrementalCentre], [940], [980, 990]];
    private static readonly int[][] s_grblMachine = [[0, 10, 20, 300], [30, 40, 50], [70, 80, 90]];
    private static readonly int[][] s_linuxCncMachine = [[0, 10, 20, 300], [ToolChange], [30, 40, 50], [70, 80, 90], [480, 490], [620, 630, 640, 650]];

    /// <summary>The group of a code of the letter G or M, from 0; -1 for an unknown code.</summary>
    public static int GroupOf(char letter, int code, GcodeController controller)
    {
        var groups = (letter, controller) switch
        {
            ('G', GcodeController.Grbl) => s_both,
            ('G', _) => s_linuxCnc,
            (_, GcodeController.Grbl) => s_grblMachine,
            _ => s_linuxCncMachine,
        };
        return Array.FindIndex(groups, group => group.Contains(code));
    }

    public static bool IsMotion(int code) => code is 0 or 10 or 20 or 30 or NoMotion;

    public static bool IsWorkOffset(int code) => code is >= 540 and <= 593;

    /// <summary>The code as in a program: G54, G59.1.</summary>
    public static string WorkOffsetText(int code) => string.Create(CultureInfo.InvariantCulture, $"G{code / 10.0:0.#}");
}
